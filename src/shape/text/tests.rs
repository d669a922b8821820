use super::glyph::{curve_is_crossed_oddly, curve_point};
use super::row::Letter;
use super::*;
use crate::math::rng::Stream;
use crate::math::solve_quadratic;
use crate::shape::testing::all_hits;

fn text(string: &str) -> Text {
    crate::shape::testing::read_shape::<Text>(&format!("ttf \"roboto\" \"{string}\" 0.5 0")).0.unwrap()
}

#[test]
fn hits_come_in_pairs_and_agree_with_inside() {
    let shape = text("Og8&");
    let mut met = 0;
    for k in 0..4000 {
        let at = |m: usize| (k * m % 997) as f64 / 997.0;
        let from = DVec3::new(at(13) * 3.0, at(29) - 0.2, at(5) - 0.2);
        let ray = Ray::new(from, DVec3::new(at(7) - 0.5, at(11) - 0.5, at(3) - 0.5));
        let hits = all_hits(&shape, &ray);
        assert!(hits.len().is_multiple_of(2), "{ray:?}: {hits:?}");
        met += hits.len();
        for pair in hits.windows(2) {
            let p = ray.at((pair[0].t + pair[1].t) / 2.0);
            let before = hits.iter().filter(|hit| hit.t < (pair[0].t + pair[1].t) / 2.0).count();
            assert!(pair[1].t - pair[0].t < 1e-9 || shape.inside(p) == (before % 2 == 1), "{ray:?}");
        }
        for hit in &hits {
            assert!(shape.bounds().grown(1e-9).contains(ray.at(hit.t)));
            assert!(shape.normal(ray.at(hit.t), hit).length() > 0.0);
        }
    }
    assert!(met > 2000, "{met}");
}

#[test]
fn walls_point_inwards() {
    let shape = text("l");
    let hit = shape.closest(&Ray::new(DVec3::new(-1.0, 0.3, 0.2), DVec3::X), Range::FORWARD).unwrap();
    assert!(shape.normal(DVec3::ZERO, &hit).x > 0.0 && (hit.t - 1.0).abs() < 1e-5, "{hit:?}");
}

#[test]
fn letters_lean() {
    // POV-Ray's `trace`
    let shape = text("l");
    let middle = shape.bounds().center();
    let hit = shape.closest(&Ray::new(middle.with_z(-9.0), DVec3::Z), Range::FORWARD).unwrap();
    let n = shape.normal(DVec3::ZERO, &hit) * 1e5;
    assert!((hit.t - 9.0 - 1.745_33e-5 * (middle.y - middle.x)).abs() < 1e-9, "{hit:?}");
    assert!((n - DVec3::new(-1.745_360, 1.745_299, -99_999.999_970)).length() < 1e-5, "{n}");
}

#[test]
fn of_a_negative_depth_only_the_ends_are_left() {
    let shape = crate::shape::testing::read_shape::<Text>("ttf \"roboto\" \"l\" -0.5 0").0.unwrap();
    let middle = shape.bounds().center();
    let hits = all_hits(&shape, &Ray::new(middle.with_z(-5.0), DVec3::Z));
    assert!(hits.len() == 2 && (hits[0].t - 4.5).abs() < 1e-4 && (hits[1].t - 5.0).abs() < 1e-4, "{hits:?}");
    assert!(all_hits(&shape, &Ray::new(middle.with_x(-5.0), DVec3::X)).is_empty() && !shape.inside(middle));
    // Both ends exist even without depth (quirk: `text_without_depth`).
    let flat = crate::shape::testing::read_shape::<Text>("ttf \"roboto\" \"l\" 0 0").0.unwrap();
    assert_eq!(all_hits(&flat, &Ray::new(middle.with_z(-5.0), DVec3::Z)).len(), 2);
}

#[test]
fn nothing_to_show() {
    assert_eq!(crate::shape::testing::read_shape::<Text>("ttf \"a\" \"\" 1 0").1[0].code, codes::NO_SURFACE);
}

/// [`Glyph::outline_contains`] by all curves of the outline.
fn outline_contains_by_all_curves(glyph: &Glyph, p: DVec2) -> bool {
    if p.y < glyph.min.y || p.y > glyph.max.y || p.x < glyph.min.x || p.x > glyph.max.x {
        return false;
    }
    let is_crossed = |number: &usize| curve_is_crossed_oddly(glyph.curve(*number).map(|q| q - p));
    (0..glyph.curve_count()).filter(is_crossed).count() % 2 == 1
}

/// Appends the hits on one letter by all curves of its outline.
fn add_letter_hits_by_all_curves(depth: f64, letter: &Letter, ray: &Ray, range: Range, out: &mut Vec<Hit>) {
    let (o, d) = (ray.origin - letter.at, ray.dir);
    let mut push = |t: f64, part: u32, s: f64| {
        if range.contains(t) {
            out.push(Hit { t, part: letter.first_part + part, uv: DVec2::new(s, 0.0) });
        }
    };
    for (part, z) in [(FRONT, 0.0), (BACK, depth)] {
        let t = (z - o.z) / d.z;
        if t.is_finite() && outline_contains_by_all_curves(&letter.glyph, (o + d * t).truncate()) {
            push(t, part, 0.0);
        }
    }
    let across = d.truncate();
    for number in 0..letter.glyph.curve_count() {
        let from = letter.glyph.curve(number).map(|p| p - o.truncate());
        let [a, b, c] = from.map(|p| across.perp_dot(p));
        let Some((s1, s2)) = solve_quadratic(a - 2.0 * b + c, 2.0 * (b - a), a) else { continue };
        for s in [s1, s2].into_iter().filter(|s| across != DVec2::ZERO && (0.0..1.0).contains(s)) {
            let t = across.dot(curve_point(from, s)) / across.length_squared();
            let z = o.z + d.z * t;
            if z >= 0.0 && z <= depth {
                push(t, WALLS + number as u32, s);
            }
        }
    }
}

/// Returns the hits on all letters by all curves of their outlines.
fn hits_by_all_curves(text: &Text, ray: &Ray, range: Range) -> Vec<Hit> {
    let ray = text.tilt.inverse_transform_ray(ray);
    let mut out = vec![];
    for letter in text.row.letters.iter().filter(|letter| letter.bounds.slabs(&ray, range).is_some()) {
        add_letter_hits_by_all_curves(text.depth, letter, &ray, range, &mut out);
    }
    out
}

#[test]
fn bands_agree_with_all_curves() {
    let shape = text("Og8&%Ql-ix");
    let mut stream = Stream::new(&[1525]);
    let mut random = || stream.next_random();
    for letter in &shape.row.letters {
        let glyph = &letter.glyph;
        let corners: Vec<DVec2> = (0..glyph.curve_count()).flat_map(|number| *glyph.curve(number)).collect();
        let mut inside_count = 0;
        for k in 0..3000 {
            let mut p = glyph.min + DVec2::new(random(), random()) * 1.1 * (glyph.max - glyph.min) - 0.03;
            // Ties: points at the height of the ends of curves, and at the ends themselves.
            let corner = corners[k % corners.len()];
            match k % 5 {
                0 => p.y = corner.y,
                1 => p.x = corner.x,
                2 => p = corner,
                _ => {}
            }
            let inside = glyph.outline_contains(p);
            assert_eq!(inside, outline_contains_by_all_curves(glyph, p), "{p}");
            inside_count += usize::from(inside);
        }
        assert!(inside_count > 300, "{inside_count}");
    }
}

/// Asserts that all kinds of queries along random rays agree with all curves of all letters.
fn assert_hits_agree_with_all_curves(shape: &Text) {
    let mut stream = Stream::new(&[1525]);
    let mut random = || stream.next_random();
    let mut count = 0;
    for k in 0..4000 {
        let mut vector = |size: DVec3| (DVec3::new(random(), random(), random()) - 0.5) * size;
        let aim = shape.row.letters[k % shape.row.letters.len()].bounds.grown(0.05);
        let from = aim.center() + vector(aim.size() * [1.5, 4.0, 40.0][k % 3]);
        let mut dir = aim.center() + vector(aim.size()) - from;
        match k % 7 {
            0 => dir.z *= 1e-8,
            1 => dir = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::Z, DVec3::NEG_Z][k % 5],
            // Parallel to the front, exactly or to rounding.
            2 => dir = shape.tilt.transform_vector(dir.with_z(0.0)),
            _ => {}
        }
        let ray = Ray::new(from, dir);
        let middle = hits_by_all_curves(shape, &ray, Range::ALL).first().map_or(0.5, |hit| hit.t);
        for range in [Range::ALL, Range::FORWARD, Range { min: 1e-4, max: middle }, Range { min: middle, max: 2.0 }] {
            let wanted = hits_by_all_curves(shape, &ray, range);
            let mut found = Hits::new();
            shape.hits(&ray, range, &mut found);
            assert_eq!(found.as_slice(), wanted, "{ray:?} {range:?}");
            let closest = wanted.iter().min_by(|a, b| a.t.total_cmp(&b.t)).copied();
            assert_eq!(shape.closest(&ray, range), closest, "{ray:?} {range:?}");
            assert_eq!(shape.any_hit(&ray, range), closest.is_some(), "{ray:?} {range:?}");
            count += wanted.len();
        }
    }
    assert!(count > 1500, "{count}");
}

#[test]
fn hits_agree_with_all_curves_of_all_letters() {
    // A row, letters in a diagonal, overlapping letters from right to left, and letters without depth.
    for rest in ["0.3 0", "0.1 <0.2,-0.9,0>", "2 <-0.6,0.1,0>", "0 0"] {
        let line = format!("ttf \"roboto\" \"Durer-1525,AVA&gi\" {rest}");
        assert_hits_agree_with_all_curves(&crate::shape::testing::read_shape::<Text>(&line).0.unwrap());
    }
}
