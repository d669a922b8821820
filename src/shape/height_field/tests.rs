use super::*;
use crate::shape::testing::{all_hits, assert_packets_match_single_rays};

/// Creates a test height field with three by three heights, in steps of 1/8.
fn field_of_nine_heights(smooth: bool, water_level: f64) -> HeightField {
    let eighths = [1, 2, 3, 4, 8, 2, 0, 3, 1];
    HeightField::new(3, eighths.map(|h| h * 8191).to_vec(), smooth, water_level)
}

const EIGHTH: f64 = 8191.0 / 65536.0;

#[test]
fn heights_of_corners_and_triangles() {
    let down = |x: f64, z: f64, h: &HeightField| {
        let hits = all_hits(h, &Ray::new(DVec3::new(x, 9.0, z), DVec3::NEG_Y));
        (hits.len(), hits.first().map_or(f64::NAN, |hit| (9.0 - hit.t) / EIGHTH))
    };
    let h = field_of_nine_heights(false, 0.0);
    let close = |found: (usize, f64), want: f64| assert!(found.0 == 1 && (found.1 - want).abs() < 1e-9, "{found:?}");
    close(down(0.5, 0.5, &h), 8.0);
    // The diagonal of a cell is from its lower right to its upper left corner.
    close(down(0.25, 0.25, &h), 3.0);
    close(down(0.125, 0.125, &h), 1.0 + 0.25 + 0.75);
    close(down(0.375, 0.375, &h), 8.0 - 0.25 * 4.0 - 0.25 * 6.0);
    assert_eq!(down(1.01, 0.5, &h).0, 0);
    // Below the water there is an inside but no surface.
    let wet = field_of_nine_heights(false, 3.5 * EIGHTH);
    assert_eq!(down(0.25, 0.25, &wet).0, 0);
    assert!(wet.inside(DVec3::new(0.25, 0.1, 0.25)) && wet.inside(DVec3::new(0.25, 3.1 * EIGHTH, 0.25)));
    assert!(!wet.inside(DVec3::new(0.25, 3.6 * EIGHTH, 0.25)) && !wet.inside(DVec3::new(0.25, 0.0, -0.01)));
    assert!((wet.bounds().min.y - 3.5 * EIGHTH).abs() < 2e-8);
}

#[test]
fn packets_match_single_rays() {
    let (width, depth) = (43, 30);
    let heights: Vec<u16> = (0..width * depth).map(|k| (k * 7919 % 65521) as u16).collect();
    for (water_level, smooth) in [(0.0, false), (0.4, true)] {
        assert_packets_match_single_rays(&HeightField::new(width, heights.clone(), smooth, water_level));
    }
    assert_packets_match_single_rays(&field_of_nine_heights(false, 0.0));
}

#[test]
fn no_ray_misses_the_height_field() {
    // Between a point high above and one deep below there is an odd number of hits.
    let (width, depth) = (23, 17);
    let heights = (0..width * depth).map(|k| (k * 7919 % 65521) as u16).collect();
    let h = HeightField::new(width, heights, false, 0.0);
    for k in 0..20_000 {
        let at = |m: usize| (k * m % 9973) as f64 / 9973.0;
        // Some rays along edges and diagonals, and through corners.
        let snap = |x: f64| if k % 3 == 0 { (x * 22.0).round() / 22.0 } else { x };
        let from = DVec3::new(snap(at(13)), 1.5, at(29));
        let to = DVec3::new(snap(at(31)), -0.5, at(17));
        let ray = Ray::new(from, to - from);
        let hits: Vec<Hit> = all_hits(&h, &ray).into_iter().filter(|hit| (0.0..1.0).contains(&hit.t)).collect();
        assert!(hits.len() % 2 == 1, "{ray:?} {hits:?}");
        for hit in &hits {
            let p = ray.at(hit.t);
            let n = h.normal(p, hit).normalize();
            assert!(h.inside(p - n * 1e-7) || h.inside(p - DVec3::Y * 1e-6), "{p} {n}");
            assert!(!h.inside(p + DVec3::Y * 1e-9) || p.y < 1e-8);
        }
        let first = h.closest(&ray, Range::FORWARD);
        assert_eq!(first.map(|hit| hit.t), hits.first().map(|hit| hit.t));
    }
}

#[test]
fn smooth_normals_as_povray_has_them() {
    // POV-Ray's trace() of a picture of 3 by 3 gray bytes (first row: 0 40 250; then 90 200 10; 30 60 120).
    let bytes = [30, 60, 120, 90, 200, 10, 0, 40, 250];
    let h = HeightField::new(3, bytes.map(|b: u16| b * 257).to_vec(), true, 0.0);
    for (x, z, want) in [
        (0.125_75, 0.125_75, [-0.412_719, 0.684_754, -0.600_645]),
        (0.5, 0.5, [0.160_210, 0.986_395, 0.036_835]),
        (0.999, 0.999, [-0.658_664, 0.000_004, -0.752_437]),
        (0.749_5, 0.375_25, [0.595_747, 0.785_451, -0.167_786]),
    ] {
        let ray = Ray::new(DVec3::new(x, 5.0, z), DVec3::NEG_Y);
        let hit = h.closest(&ray, Range::FORWARD).unwrap();
        let n = h.normal(ray.at(hit.t), &hit).normalize();
        assert!(n.distance(DVec3::from_array(want)) < 1e-4, "{x} {z}: {n}");
    }
}

#[test]
fn heights_follow_from_pixels() {
    use crate::image_io::{Pixels, Samples, Stored};
    let picture = |channels: usize, samples: Samples, indices: Option<Vec<u8>>| {
        let pixels = Pixels { width: 1, height: 2, channels, samples };
        Picture { pixels, stored: Stored::Unsaid, indices, gray_bytes: false }
    };
    // The last row is the first of the field.
    let two_bytes = picture(3, Samples::U8(vec![1, 2, 3, 209, 84, 115]), None);
    assert_eq!(heights::picture_heights_bottom_up(&two_bytes, None), [209 * 256 + 84, 258]);
    let gray = picture(1, Samples::U8(vec![0, 255]), None);
    assert_eq!(heights::picture_heights_bottom_up(&gray, None), [65535, 0]);
    let colors = picture(3, Samples::U16(vec![10_000, 30_000, 60_000, 7, 7, 7]), None);
    assert_eq!(heights::picture_heights_bottom_up(&colors, None), [7, 27_480]);
    let palette = picture(3, Samples::U8(vec![0; 6]), Some(vec![5, 2]));
    assert_eq!(heights::picture_heights_bottom_up(&palette, None), [512, 1280]);
    assert_eq!([-0.25, 0.5, 1.4, f64::NAN].map(heights::unit_to_wrapping_u16), [49_153, 32_767, 26_213, 0]);
}

#[test]
fn heights_follow_from_both_halves_of_a_pot_file() {
    // POV-Ray: 9 and 15 make 2304 + 15.
    assert_eq!(
        heights::heights_of_pot_picture(&[9 << 8, 10 << 8, 0, 15 << 8, 1 << 8, 2 << 8, 3 << 8, 4 << 8], 4),
        [2304, 2575, 259, 516]
    );
}
