//! Warnings about pictures that show only the background, or only the inside of the object around the camera.

use super::{first_shape_and_span, has_finite_box, hit_shape_and_span, is_visible_to_camera, vector_in_scene_syntax};
use crate::camera::Projection;
use crate::diagnostic::{Diagnostic, codes};
use crate::math::{Aabb, DMat3, DVec3, Range, Ray, next_coprime};
use crate::render;
use crate::source::Span;
use crate::world::{Intersection, PlacedSolid, World};
use rustc_hash::FxHashSet;

/// Number of rays that sample the visible objects.
const SAMPLES: usize = 200;
/// Offset of a pixel's centre from the pixel's top left corner.
const CENTRE: f64 = 0.5;

/// Returns the warning about a picture that shows only the background, or only the inside of objects around the camera;
/// `None` if a ray hits another object.
pub(super) fn no_object_visible_warning(world: &World, options: &render::Options) -> Option<Diagnostic> {
    let (eye, at_eye) = (world.eye.frame.origin, opaque_objects_containing(world, world.eye.frame.origin));
    // Rays of some cameras have their own origins.
    let is_around = |ray: &Ray, object: &u32| match ray.origin == eye {
        true => at_eye.contains(object),
        false => opaque_objects_containing(world, ray.origin).contains(object),
    };
    let mut inside = None;
    // Anti-aliasing also samples between the centres of the pixels.
    let between = options.antialias.map(|_| rays_through_pixels(world, options, 0.0));
    for ray in rays_through_pixels(world, options, CENTRE).chain(between.into_iter().flatten()) {
        match first_visible_hit(world, &ray) {
            Some(found) if !is_around(&ray, &found.object) => return None,
            found => inside = inside.or(found),
        }
    }
    match inside {
        // A single object is the subject of the picture.
        Some(_) if world.geometry.items().all(|item| at_eye.contains(&item.object())) => None,
        Some(found) => Some(camera_inside_warning(world, &found)),
        // A scene without objects and lights is no picture.
        None if world.geometry.is_empty() && world.lights.is_empty() => None,
        None => Some(nothing_visible_warning(world, options)),
    }
}

/// Returns the first hits of sample rays all over the picture.
pub(super) fn sampled_first_hits<'a>(
    world: &'a World,
    options: &render::Options,
) -> impl Iterator<Item = Intersection<'a>> {
    rays_through_pixels(world, options, CENTRE).take(SAMPLES).filter_map(|ray| first_visible_hit(world, &ray))
}

/// Returns rays through all pixels, at `offset_from_pixel_corner` from the pixels' top left corners, in an order in
/// which consecutive rays are far from each other.
fn rays_through_pixels(
    world: &World,
    options: &render::Options,
    offset_from_pixel_corner: f64,
) -> impl Iterator<Item = Ray> + use<> {
    let (width, total) = (options.width.max(1), options.width * options.height);
    let view = world.eye.view(options.width, options.height);
    // A step that is coprime to the number of pixels visits each pixel once.
    let step = next_coprime(total * 618 / 1000 + 1, total);
    let places = (0..total).scan(total / 2, move |at, _| {
        *at = (*at + step) % total;
        Some(((*at % width) as f64 + offset_from_pixel_corner, (*at / width) as f64 + offset_from_pixel_corner))
    });
    places.filter_map(move |(x, y)| view.ray_at_pixel_position(x, y))
}

fn first_visible_hit<'a>(world: &'a World, ray: &Ray) -> Option<Intersection<'a>> {
    let range = Range { min: world.epsilon.surface, max: f64::INFINITY };
    world.geometry.closest(ray, range, |id| is_visible_to_camera(world, id))
}

/// Returns the indices of the opaque objects that contain a point and are visible to the camera.
fn opaque_objects_containing(world: &World, point: DVec3) -> FxHashSet<u32> {
    let mut out = FxHashSet::default();
    world.geometry.visit_containing(point, &mut |item| {
        if world.objects.get(item.object() as usize).is_some_and(|o| o.image && o.opaque) {
            out.insert(item.object());
        }
    });
    out
}

fn camera_inside_warning(world: &World, found: &Intersection) -> Diagnostic {
    let (word, source) = hit_shape_and_span(world, found);
    let (message, help) = if word == "plane" {
        let message = "the camera is behind this `plane` and shows only its back";
        (message.to_string(), "move `location` to the side that the plane's normal points to".to_string())
    } else {
        let message = format!("the camera is inside of this `{word}` and shows only its inside");
        (message, "move `location` out of it, or make the object smaller".to_string())
    };
    Diagnostic::new(codes::CAMERA_INSIDE, source, message).also(world.camera_source, "the camera").help(help)
}

fn nothing_visible_warning(world: &World, options: &render::Options) -> Diagnostic {
    let message = "the picture shows nothing but the background";
    let items: Vec<PlacedSolid> =
        world.geometry.items().filter(|item| is_visible_to_camera(world, item.object())).collect();
    let eye = world.eye.frame.origin;
    let distance = |item: &PlacedSolid| item.bounds().min.max(eye).min(item.bounds().max).distance(eye);
    let finite = items.iter().filter(|item| has_finite_box(item));
    let nearest = finite.min_by(|a, b| distance(a).total_cmp(&distance(b)));
    if let Some(item) = nearest
        && let Some((word, source)) = first_shape_and_span(world, *item)
    {
        let seen = InvisibilityReason::classify(world, options, &item.bounds());
        let label = format!("the nearest object, this `{word}`, is {}", seen.description());
        let d = Diagnostic::new(codes::NOTHING_SEEN, source, message).label(label);
        return d.also(world.camera_source, "seen from here").help(seen.help(world, &item.bounds()));
    }
    match items.iter().find_map(|item| first_shape_and_span(world, *item)) {
        Some((word, source)) => Diagnostic::new(codes::NOTHING_SEEN, source, message)
            .label(format!("no ray from the camera hits this `{word}`"))
            .also(world.camera_source, "seen from here")
            .help("turn the camera with `look_at`"),
        None => {
            Diagnostic::new(codes::NOTHING_SEEN, Span::NONE, "the picture shows nothing: the scene contains no object")
                .help("a declared object is not part of the scene yet: `object { Name }` adds it")
        }
    }
}

/// Reason for which an object is not visible in the picture.
enum InvisibilityReason {
    Behind,
    Beside(&'static str),
    /// The object is inside the picture, but small: its size in pixels.
    Small(f64),
    /// The object is inside the picture, but all rays miss it.
    Missed,
}

impl InvisibilityReason {
    /// Returns the reason for which the picture does not show an object with these bounds.
    fn classify(world: &World, options: &render::Options, bounds: &Aabb) -> Self {
        let (width, height) = (options.width as f64, options.height as f64);
        let view = world.eye.view(options.width, options.height);
        let Some(window) = view.window_of_unperturbed_rays() else { return InvisibilityReason::Missed };
        let (right, down) = (window.across * width, window.down * height);
        let ahead = window.corner + (right + down) * 0.5;
        // p = origin + depth · (ahead + x·right + y·down)
        let into = DMat3::from_cols(right, down, ahead).inverse();
        let corners = (0..8).map(|i| {
            let pick = |axis: usize| if i >> axis & 1 == 0 { bounds.min[axis] } else { bounds.max[axis] };
            into * (DVec3::new(pick(0), pick(1), pick(2)) - window.origin)
        });
        let ahead: Vec<DVec3> = corners.filter(|p| p.z > 0.0).map(|p| p / p.z).collect();
        let seen = Aabb::from_points(ahead.iter().copied());
        match ahead.len() {
            0 => InvisibilityReason::Behind,
            // The object extends behind the camera, where the projection of its corners has no meaning.
            1..8 => InvisibilityReason::Missed,
            _ if seen.min.x > 0.5 => InvisibilityReason::Beside("beside the picture, to the right"),
            _ if seen.max.x < -0.5 => InvisibilityReason::Beside("beside the picture, to the left"),
            _ if seen.min.y > 0.5 => InvisibilityReason::Beside("below the picture"),
            _ if seen.max.y < -0.5 => InvisibilityReason::Beside("above the picture"),
            _ => {
                let size = seen.size();
                let pixels = (size.x * width).max(size.y * height);
                if pixels < 2.0 { InvisibilityReason::Small(pixels) } else { InvisibilityReason::Missed }
            }
        }
    }

    fn description(&self) -> String {
        match self {
            InvisibilityReason::Behind => "behind the camera".into(),
            InvisibilityReason::Beside(place) => (*place).into(),
            InvisibilityReason::Small(pixels) if *pixels >= 0.01 => {
                format!("too small to be visible: {pixels:.2} pixels")
            }
            InvisibilityReason::Small(_) => "too small to be visible: less than a hundredth of a pixel".into(),
            InvisibilityReason::Missed => "missed by all rays: it is beside the picture or thinner than a pixel".into(),
        }
    }

    fn help(&self, world: &World, bounds: &Aabb) -> String {
        match (self, &world.eye.projection) {
            (InvisibilityReason::Small(_), _) => {
                "move the camera closer, or make the object larger with `scale`".into()
            }
            (_, Projection::Lecture { .. }) => {
                format!("`center {}` in the camera turns the camera to it", vector_in_scene_syntax(bounds.center()))
            }
            _ => format!("`look_at {}` in the camera turns the camera to it", vector_in_scene_syntax(bounds.center())),
        }
    }
}
