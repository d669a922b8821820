#![no_main]

durer_fuzz::target!(durer_fuzz::readers::picture_tiff);
