//! Media: smoke, fire, dust.

use super::{Quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "area_illumination_in_media",
        "Media scatter the light of an area light with `area_illumination` without `fade_distance` and without the soft \
         edge of a spotlight or cylinder light, whose beam ends sharply at its outer edge.",
        &["light_cases/media_area_illumination"],
    ),
    emulated_quirk(
        "endless_media",
        "Along a ray that hits nothing more, the media of an interior do not count, for example of a `plane` that holds \
         the camera. Media of the whole scene do.",
        &["light_cases/media_endless"],
    ),
    emulated_quirk(
        "light_inside_media",
        "On the way to a light, the media of an interior count up to the surface where the way leaves the interior. A \
         light inside of the medium shines without loss.",
        &["light_cases/media_light_inside"],
    ),
    emulated_quirk(
        "media_attenuation_needs_interaction",
        "Neither fog nor media of the whole scene attenuate lights with `media_interaction off`, even with \
         `media_attenuation on`.",
        &["light_cases/media_attenuation_without_interaction"],
    ),
    emulated_quirk(
        "media_confidence",
        "Methods 1 and 2 stop after n of at most m samples if in each channel the variance of the mean light, times the \
         squared length of the interval, is at most `variance` χ²(n) / χ²(m - 1), with the quantiles of the chi-square \
         distribution for 1 - `confidence`.",
        &["src/transport/media.rs::sampling_stops_where_pov_ray_does"],
    ),
    emulated_quirk(
        "media_defaults",
        "The manual's defaults are not the program's: without `samples` there are 10 samples and `aa_level` is 3. \
         Before version 3.5 the method is 1 with one sample.",
        &["light_cases/media_method_2", "light_cases/media_version_35", "light_cases/media_version_31_method_2"],
    ),
    emulated_quirk(
        "media_in_front",
        "The media of the whole scene are in front of those of interiors, along each stretch between two surfaces; fog is \
         in front of both, and rainbows are behind the media of the whole scene.",
        &["light_cases/media_atmosphere_and_fog", "light_cases/media_rainbow"],
    ),
    emulated_quirk(
        "media_in_solid_shadow",
        "On the way to a light with `media_attenuation`, media of the whole scene also attenuate the light inside \
         objects that are not `hollow`, up to the last surface before the light. Fog and the media of interiors do not.",
        &["light_cases/media_in_solid_shadow"],
    ),
    emulated_quirk(
        "media_in_tube",
        "A cylinder light illuminates the media along a ray where the ray is within the tube, if the ray leaves the tube \
         in front of the light; from the ray's start on, if it enters the tube behind the light. It illuminates nothing \
         along a ray that leaves the tube behind the light or that is parallel to its axis.",
        &["light_cases/media_in_tube", "light_cases/media_in_tube_from_inside"],
    ),
    emulated_quirk(
        "media_intervals",
        "If only spotlights and cylinder lights illuminate a medium, their beams divide the ray, and `ratio` distributes \
         the intervals over lit and dark parts. A `parallel` spotlight shines at full strength within its cone alone. \
         Without densities, a ray that meets no beam, or a scene without lights, has one interval, whatever `intervals` \
         says.",
        &[
            "src/transport/media_intervals.rs::intervals_are_distributed_by_ratio",
            "light_cases/media_spotlight_ratio",
            "light_cases/media_spotlight_homogeneous",
            "light_cases/media_parallel_spotlight",
            "light_cases/media_parallel_spotlight_and_point",
        ],
    ),
    emulated_quirk(
        "media_lights",
        "Along a ray, media scatter the lights of the object that the ray hits next: those of its `light_group`, if it is \
         in one, and not those of the object that holds the media.",
        &["light_cases/media_light_group", "light_cases/media_light_group_behind"],
    ),
    emulated_quirk(
        "media_of_several",
        "Several media at one place are sampled together, with the method and the numbers of the one with the most \
         `intervals`, the first of several; but `aa_threshold` is the least of all.",
        &[
            "light_cases/media_several",
            "light_cases/media_overlapping",
            "light_cases/media_several_intervals",
            "light_cases/media_several_thresholds",
            "light_cases/media_several_shadow",
        ],
    ),
    emulated_quirk(
        "media_sampling",
        "Method 3 takes samples at equal distances from the beginning of an interval on, `samples`/2 + 2 per interval \
         and at least 3, but none at its end. Between two samples there is always a third; each half counts two thirds \
         for its end and one for the middle, and is halved again if their light, times the length of the interval and \
         summed over the channels, differs by more than `aa_threshold`. Light is attenuated by what is in front of the \
         two samples. Methods 1 and 2 attenuate each sample by its own density from the beginning of the interval on.",
        &["light_cases/media_method_3_levels", "light_cases/media_method_3_intervals", "light_cases/media_method_2"],
    ),
    emulated_quirk(
        "phase_functions",
        "Scattering of types 2 to 4 is multiplied by 0.576656, 0.495716 and 0.799372, so that light is neither lost nor \
         doubled as the physical laws demand. `eccentricity` above 0 scatters forwards.",
        &[
            "light_cases/media_scattering_2",
            "light_cases/media_scattering_3",
            "light_cases/media_scattering_4",
            "light_cases/media_scattering_5_forward",
        ],
    ),
    emulated_quirk(
        "phase_of_several",
        "Where several media overlap, all scatter by the mean of their phase functions; a medium that scatters nothing \
         counts as type 1.",
        &["light_cases/media_several_phases"],
    ),
    emulated_quirk(
        "scattered_lights",
        "Media do not scatter the light of `shadowless` lights.",
        &["light_cases/media_light_flags"],
    ),
];
