//! CSG, compared with closed forms and with POV-Ray's output.

use durer::math::rng::Stream;
use durer::math::{Aabb, DVec2, DVec3, Range, Ray, Transform};
use durer::shape::*;
use durer::world::{Geometry, Intersections, Leaf, SolidNode};

fn leaf(shape: Shape, id: u32) -> SolidNode {
    SolidNode::leaf(Leaf::new(shape, &Transform::IDENTITY, id), id)
}

fn sphere(x: f64, radius: f64, id: u32) -> SolidNode {
    leaf(Shape::from(Sphere { center: DVec3::X * x, radius }), id)
}

fn half_space(normal: DVec3) -> SolidNode {
    leaf(Shape::from(Plane::new(normal, 0.0).unwrap()), 9)
}

/// t and leaf of all hits, ascending.
fn ids(node: &SolidNode, ray: &Ray) -> Vec<(f64, u32)> {
    let mut all = Intersections::new();
    node.hits(ray, Range::ALL, &mut all);
    all.sort_by(|a, b| a.t().total_cmp(&b.t()));
    all.iter().map(|f| (f.t(), f.leaf.id)).collect()
}

/// Along x through two unit balls around 0 and 1.
const ALONG: Ray = Ray { origin: DVec3 { x: -5.0, y: 0.0, z: 0.0 }, dir: DVec3::X };

#[test]
fn operations_keep_the_right_surfaces() {
    let two = || vec![sphere(0.0, 1.0, 1), sphere(1.0, 1.0, 2)];
    assert_eq!(ids(&SolidNode::union(two(), 0), &ALONG), [(4.0, 1), (5.0, 2), (6.0, 1), (7.0, 2)]);
    assert_eq!(ids(&SolidNode::merge(two(), 0), &ALONG), [(4.0, 1), (7.0, 2)]);
    assert_eq!(ids(&SolidNode::intersection(two(), 0), &ALONG), [(5.0, 2), (6.0, 1)]);
    assert_eq!(ids(&SolidNode::difference(two(), 0), &ALONG), [(4.0, 1), (5.0, 2)]);
    let empty = SolidNode::intersection(vec![sphere(0.0, 1.0, 1), sphere(9.0, 1.0, 2)], 0);
    assert!(empty.bounds().is_empty() && ids(&empty, &ALONG).is_empty());
}

#[test]
fn infinite_and_open_shapes() {
    let half = SolidNode::intersection(vec![sphere(0.0, 1.0, 1), half_space(DVec3::X)], 0);
    assert_eq!(ids(&half, &ALONG), [(4.0, 1), (5.0, 9)]);
    assert!(half.bounds().is_finite());
    let tube = leaf(Shape::from(Cylinder::new(-DVec3::Y, DVec3::Y, 0.5, true)), 3);
    let drilled = SolidNode::difference(vec![sphere(0.0, 1.0, 1), tube], 0);
    assert_eq!(ids(&drilled, &ALONG), [(4.0, 1), (4.5, 3), (5.5, 3), (6.0, 1)]);
}

#[test]
fn subtracted_surfaces_face_inwards() {
    let shell = SolidNode::difference(vec![sphere(0.0, 1.0, 1), sphere(0.0, 0.5, 2)], 7);
    let ray = Ray::new(DVec3::ZERO, DVec3::Z);
    let found = shell.closest(&ray, Range::FORWARD).unwrap();
    assert_eq!((found.t(), found.leaf.id, found.object, found.is_on_inverted_shape()), (0.5, 2, 7, true));
    assert_eq!(found.surface(&ray).normal, -DVec3::Z, "as POV-Ray's trace() has it");
}

#[test]
fn inverse_applies_to_leaves() {
    let ball = || sphere(0.0, 10.0, 3);
    let two = || vec![sphere(0.0, 1.0, 1), sphere(1.0, 1.0, 2)];
    // As in POV-Ray: a union that is subtracted has no surfaces inside the union …
    let cut = SolidNode::difference(vec![ball(), SolidNode::union(two(), 0)], 0);
    assert_eq!(ids(&cut, &ALONG), [(-5.0, 3), (4.0, 1), (7.0, 2), (15.0, 3)]);
    // … and a subtracted intersection has none outside the intersection.
    let cut = SolidNode::difference(vec![ball(), SolidNode::intersection(two(), 0)], 0);
    assert_eq!(ids(&cut, &ALONG), [(-5.0, 3), (5.0, 2), (6.0, 1), (15.0, 3)]);
}

#[test]
fn clipping_survives_inverse() {
    // Each row is POV-Ray's inside() at: kept half, cut half, outside below, outside above.
    let at = |node: &SolidNode| [-0.5, 0.5, -5.0, 5.0].map(|y| node.inside(DVec3::Y * y));
    let clipped = || sphere(0.0, 1.0, 1).clipped(vec![half_space(DVec3::Y)]);
    assert_eq!(at(&clipped()), [true, false, false, false]);
    assert_eq!(at(&clipped().inverted()), [false, false, true, false]);
    assert_eq!(at(&sphere(0.0, 1.0, 1).inverted().clipped(vec![half_space(DVec3::Y)])), [false, false, true, false]);
    let both = sphere(0.0, 1.0, 1).clipped(vec![half_space(DVec3::Y)]).clipped(vec![half_space(DVec3::X)]);
    let corners = [(-0.1, -0.1), (0.1, -0.1), (-0.1, 0.1)].map(|(x, y)| both.inside(DVec3::new(x, y, 0.0)));
    assert_eq!(corners, [true, false, false]);
    // An open half ball without a lid.
    assert_eq!(ids(&clipped(), &Ray::new(DVec3::Y * 5.0, -DVec3::Y)), [(6.0, 1)]);
}

#[test]
fn patches_have_no_inside_even_inverted() {
    // As in POV-Ray: a subtracted triangle remains as a surface, and the solid's own surface vanishes.
    let t = Triangle::new(DVec3::new(0.2, -2.0, -2.0), DVec3::new(0.2, 2.0, -2.0), DVec3::new(0.2, 0.0, 4.0));
    let pair = || vec![sphere(0.0, 1.0, 1), leaf(Shape::from(t), 5)];
    assert_eq!(ids(&SolidNode::difference(pair(), 0), &ALONG), [(5.2, 5)]);
    assert_eq!(ids(&SolidNode::intersection(pair(), 0), &ALONG), [(5.2, 5)]);
    assert_eq!(ids(&SolidNode::merge(pair(), 0), &ALONG), [(4.0, 1), (6.0, 1)]);
}

#[test]
fn subtracted_discs_act_as_half_spaces() {
    // (In POV-Ray, rays that miss its box do not hit it: tests/light_cases/csg_disc_halves.)
    let disc = |inverse: bool| {
        let disc = leaf(Shape::from(Disc::new(DVec3::ZERO, DVec3::new(0.0, 1.0, -1.0), 0.5, 0.0)), 5);
        SolidNode::intersection(vec![sphere(0.0, 1.0, 1), if inverse { disc.inverted() } else { disc }], 0)
    };
    let seen = |node: &SolidNode, x: f64, y: f64| {
        let ray = Ray::new(DVec3::new(x, y, -5.0), DVec3::Z);
        node.closest(&ray, Range::FORWARD).map(|f| f.leaf.id)
    };
    assert_eq!(seen(&disc(false), 0.0, 0.1), Some(5));
    assert_eq!(seen(&disc(false), 0.8, -0.1), Some(1));
    assert_eq!(seen(&disc(true), 0.8, -0.1), Some(1));
    assert_eq!(seen(&disc(true), 0.0, -0.9), None);
}

#[test]
fn transformed_object() {
    // A unit ball stretched three times along x, then moved: its tip is at x = 3 + 1.
    let m = Transform::scale(DVec3::new(3.0, 1.0, 1.0)).unwrap().then(&Transform::translate(DVec3::X));
    let shape = Shape::from(Sphere { center: DVec3::ZERO, radius: 1.0 });
    let node = SolidNode::leaf(Leaf::new(shape, &m, 1), 1);
    let found = node.closest(&Ray::new(DVec3::X * 10.0, -DVec3::X), Range::FORWARD).unwrap();
    assert!((found.t() - 6.0).abs() < 1e-14, "the distance is one of world space");
    // Half way up: x²/9 + y² = 1 at y = 1/2; the normal is the gradient (x/9, y), not M·n.
    let ray = Ray::new(DVec3::new(20.0, 0.5, 0.0), -DVec3::X);
    let found = node.closest(&ray, Range::FORWARD).unwrap();
    let x = 3.0 * 0.75_f64.sqrt();
    let surface = found.surface(&ray);
    assert!((found.t() - (19.0 - x)).abs() < 1e-13);
    assert!(surface.point.distance(DVec3::new(1.0 + x, 0.5, 0.0)) < 1e-14);
    assert!(surface.object_point.distance(DVec3::new(x / 3.0, 0.5, 0.0)) < 1e-14);
    assert!(surface.normal.distance(DVec3::new(x / 9.0, 0.5, 0.0).normalize()) < 1e-14);
    assert!(
        found.uv(surface.object_point).distance(DVec2::new(0.0, 0.5 + 0.5_f64.asin() / std::f64::consts::PI)) < 1e-14
    );
    assert!((node.bounds().max.x - 4.0).abs() < 1e-7 && node.bounds().max.x >= 4.0);
}

#[test]
fn containing_objects_of_a_point() {
    let geometry = Geometry::new(vec![
        SolidNode::union(vec![sphere(0.0, 1.0, 1), sphere(0.5, 1.0, 2), sphere(5.0, 1.0, 3)], 0),
        half_space(DVec3::Y),
        sphere(40.0, 1.0, 4).inverted(),
    ]);
    let at = |p: DVec3| {
        let mut found = vec![];
        geometry.visit_containing(p, &mut |item| found.push(item.object()));
        found.sort();
        found
    };
    assert_eq!(at(DVec3::new(0.3, -0.1, 0.0)), [1, 2, 4, 9]);
    assert_eq!(at(DVec3::new(5.0, 0.1, 0.0)), [3, 4]);
    assert!(at(DVec3::new(40.0, 0.1, 0.0)).is_empty());
}

#[test]
fn bounds_hide_surfaces_from_rays_that_miss_them() {
    let seen = |node: &SolidNode, from: DVec3, to: DVec3| ids(node, &Ray::new(from, to)).len();
    let two = || SolidNode::union(vec![sphere(0.0, 1.0, 1), sphere(3.0, 1.0, 2)], 0);
    let half = leaf(Shape::from(Cuboid::new(DVec3::new(-2.0, 0.0, -2.0), DVec3::new(0.0, 2.0, 2.0))), 9);
    let bounded = two().bounded([half.clone()]);
    // A ray that hits the bounds, misses them, begins inside, has them behind it (as in POV-Ray's trace()).
    assert_eq!(seen(&bounded, DVec3::new(-5.0, 0.1, 0.0), DVec3::X), 4);
    assert_eq!(seen(&bounded, DVec3::new(-5.0, -0.1, 0.0), DVec3::X), 0);
    assert_eq!(seen(&bounded, DVec3::new(-0.1, 0.1, 0.0), -DVec3::Y), 2);
    assert_eq!(seen(&bounded, DVec3::new(9.0, 0.1, 0.0), DVec3::X), 0);
    assert!(bounded.inside(DVec3::Y * -0.5), "a point asks for no bounds");
    // Split into parts, each part keeps its bounds; those of the whole have no effect.
    let apart = Geometry::new(vec![bounded]);
    let meets = |geometry: &Geometry, y: f64| {
        geometry.closest(&Ray::new(DVec3::new(-5.0, y, 0.0), DVec3::X), Range::FORWARD, |_| true).is_some()
    };
    assert!(meets(&apart, 0.1) && !meets(&apart, -0.1));
    let around = Geometry::new(vec![two().bounded([sphere(0.0, 9.0, 9)])]);
    assert!(meets(&around, -0.1));
    // A bounded part of a difference loses its own surface only.
    let part = SolidNode::intersection(vec![sphere(0.0, 1.0, 1).bounded([half]), half_space(DVec3::X)], 0);
    assert_eq!(ids(&part, &Ray::new(DVec3::new(-5.0, -0.1, 0.0), DVec3::X)), [(5.0, 9)]);
}

#[test]
fn cut_quadrics_have_finite_boxes() {
    let neck = Quadric::new(DVec3::new(1.0, -1.0, 1.0), DVec3::ZERO, DVec3::ZERO, -1.0);
    let turned = Leaf::new(Shape::from(neck), &Transform::rotate(DVec3::Y * 33.0), 1);
    let cut = |side: f64| leaf(Shape::from(Plane::new(DVec3::Y * side, 2.0).unwrap()), 2);
    let whole = SolidNode::intersection(vec![SolidNode::leaf(turned.clone(), 1), cut(1.0), cut(-1.0)], 0);
    let clipped = SolidNode::leaf(turned, 1).clipped(vec![cut(1.0), cut(-1.0)]);
    let reach = DVec3::new(5f64.sqrt(), 2.0, 5f64.sqrt());
    for node in [whole, clipped] {
        assert!(node.bounds().max.distance(reach) < 1e-6 && node.bounds().min.distance(-reach) < 1e-6);
    }
}

/// Returns distances of the hits on each part that are inside all other parts, ascending; of the first part's hits alone if
/// `of_first` is true.
fn hits_inside_others(parts: &[SolidNode], of_first: bool, ray: &Ray) -> Vec<f64> {
    let mut all = vec![];
    for (i, part) in parts.iter().enumerate().take(if of_first { 1 } else { parts.len() }) {
        let mut hits = Intersections::new();
        part.hits(ray, Range::FORWARD, &mut hits);
        let others = |p: DVec3| parts.iter().enumerate().all(|(j, other)| j == i || other.inside(p));
        all.extend(hits.iter().map(|hit| hit.t()).filter(|t| others(ray.at(*t))));
    }
    all.sort_by(f64::total_cmp);
    all
}

#[test]
fn quadrics_between_planes_are_bounded_however_they_are_rotated() {
    let turn = Transform::rotate(DVec3::new(20.0, 30.0, 40.0));
    let m = Transform::scale(DVec3::new(3.0, 2.0, 3.0)).unwrap().then(&turn).then(&Transform::translate(DVec3::ONE));
    let placed = |shape: Shape| SolidNode::leaf(Leaf::new(shape, &m, 0), 0);
    let plane = |height: f64| placed(Plane::new(DVec3::Y, height).unwrap().into());
    // x² + z² ≤ y² with 0.5 ≤ y ≤ 2
    let cone = || placed(Quadric::new(DVec3::new(1.0, -1.0, 1.0), DVec3::ZERO, DVec3::ZERO, 0.0).into());
    let cuts = || vec![plane(2.0), plane(0.5).inverted()];
    let parts: Vec<_> = std::iter::once(cone()).chain(cuts()).collect();
    let around = m.transform_aabb(&Aabb::from_corners(DVec3::new(-2.0, 0.5, -2.0), DVec3::new(2.0, 2.0, 2.0)));
    let mut random = Stream::new(&[23]);
    for (solid, is_clipped) in [(cone().clipped(cuts()), true), (SolidNode::intersection(parts.clone(), 0), false)] {
        let larger = around.grown(1e-6);
        assert_eq!(larger.union(solid.bounds()), larger);
        let mut n_hits = 0;
        for _ in 0..2000 {
            let mut any = |size: f64| DVec3::from_array([(); 3].map(|()| size * (random.next_random() - 0.5)));
            let (from, to) = (any(30.0), any(8.0));
            let ray = Ray::new(from, (to - from).normalize());
            let expected = hits_inside_others(&parts, is_clipped, &ray);
            let mut found = Intersections::new();
            solid.hits(&ray, Range::FORWARD, &mut found);
            let mut found: Vec<f64> = found.iter().map(|hit| hit.t()).collect();
            found.sort_by(f64::total_cmp);
            assert_eq!(found, expected, "{ray:?}");
            assert_eq!(solid.any(&ray, Range::FORWARD), !expected.is_empty());
            assert_eq!(solid.closest(&ray, Range::FORWARD).map(|hit| hit.t()), expected.first().copied());
            n_hits += found.len();
        }
        assert!(n_hits > 300, "{n_hits}");
    }
}
