// Gathered light of both sides, gray_threshold, brightness, max_sample.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { gray_threshold 0.25 brightness 1.5 max_sample 0.4 } }
background { rgb <0.5, 0.2, 0> }
camera { location <0, 5, 0> look_at 0 right x up z sky z }
plane { y, 0 pigment { rgbt <1, 0.9, 0.8, 0.25> } finish { diffuse 0.4, 0.2 ambient 0.1 } }
