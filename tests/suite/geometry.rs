//! Properties of shapes, CSG and the hierarchy, on random scenes.

mod dice;

use dice::Dice;
use durer::math::packet::{PACKET, RayPacket};
use durer::math::{DVec3, Lanes, Mask, Range, Ray, Transform};
use durer::shape::*;
use durer::world::{
    ClosestHits, Coherence, Geometry, Intersection, Intersections, Leaf, PlacedSolid, ShadowRole, SolidNode,
    surfaces_of_packet,
};
use proptest::prelude::*;
use std::ops::ControlFlow;

fn hits(shape: &Shape, ray: &Ray, range: Range) -> Vec<Hit> {
    let mut all = Hits::new();
    shape.hits(ray, range, &mut all);
    all.sort_by(|a, b| a.t.total_cmp(&b.t));
    all.into_vec()
}

fn node_hits<'a>(node: &'a SolidNode, ray: &Ray, range: Range) -> Intersections<'a> {
    let mut all = Intersections::new();
    node.hits(ray, range, &mut all);
    all.sort_by(|a, b| a.t().total_cmp(&b.t()));
    all
}

/// True if the solid is locally flat around the point: full on one side of the plane across n, empty on the other.
fn is_flat_at(shape: &Shape, p: DVec3, n: DVec3, step: f64) -> bool {
    let (e1, e2) = n.any_orthonormal_pair();
    let around = [e1, -e1, e2, -e2, e1 + e2, e1 - e2].map(|e| p + e * (2.0 * step));
    let side = |q: &DVec3, sign: f64| shape.inside(*q + n * (sign * step));
    let [above, below] = [1.0, -1.0].map(|sign| side(&around[0], sign));
    above != below && around.iter().all(|q| side(q, 1.0) == above && side(q, -1.0) == below)
}

/// True if the inside ends within a billionth of a point.
fn on_surface(inside: &dyn Fn(DVec3) -> bool, p: DVec3) -> bool {
    let here = inside(p);
    DVec3::AXES.iter().any(|axis| [1e-9, -1e-9].iter().any(|step| inside(p + *axis * *step) != here))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn hits_are_in_bounds_and_have_normals(seed: u64) {
        let mut dice = Dice::new(seed);
        let (shape, m) = (dice.shape(), dice.transform());
        let node = SolidNode::leaf(Leaf::new(shape.clone(), &m, 1), 1);
        for _ in 0..20 {
            let ray = dice.ray();
            let scale = 1.0 + ray.origin.length();
            for hit in hits(&shape, &ray, Range::ALL) {
                let p = ray.at(hit.t);
                prop_assert!(shape.bounds().grown(1e-12 * scale).contains(p), "{shape:?} {ray:?} {hit:?}");
                let n = shape.normal(p, &hit);
                prop_assert!(n.is_finite() && n.length() > 0.0, "{shape:?} {hit:?} {n}");
                prop_assert!(shape.uv(p, &hit).is_finite(), "{shape:?} {hit:?}");
            }
            for found in node_hits(&node, &ray, Range::ALL) {
                let surface = found.surface(&ray);
                prop_assert!(node.bounds().grown(1e-11 * scale).contains(surface.point));
                prop_assert!(surface.point.distance(ray.at(found.t())) < 1e-9 * scale);
                prop_assert!((surface.normal.length() - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn inside_agrees_with_hits(seed: u64) {
        let mut dice = Dice::new(seed);
        let shape = dice.solid();
        for _ in 0..20 {
            let ray = dice.ray();
            let all = hits(&shape, &ray, Range::ALL);
            prop_assert!(all.len().is_multiple_of(2), "{shape:?} {ray:?} {all:?}");
            let size = ray.dir.length();
            let middle = -ray.origin.dot(ray.dir) / (size * size);
            for k in -30..30 {
                let t = middle + f64::from(k) * 0.0987 / size;
                // (A ray may graze a flat side.)
                if on_surface(&|p| shape.inside(p), ray.at(t)) || all.iter().any(|h| (h.t - t).abs() * size < 1e-6) {
                    continue;
                }
                let behind = all.iter().filter(|h| h.t > t).count();
                prop_assert_eq!(shape.inside(ray.at(t)), behind % 2 == 1, "{:?} {:?} {} {:?}", shape, ray, t, all);
            }
            for hit in &all {
                // The normal points outwards: a step along it leaves the solid, a step back is inside. Except at edges.
                let (p, step) = (ray.at(hit.t), 1e-5);
                let n = shape.normal(p, hit).normalize();
                let out = !shape.inside(p + n * step) && shape.inside(p - n * step);
                // (The direction of the curve decides the side of these normals.)
                let by_curve = matches!(shape, Shape::Lathe(_) | Shape::Prism(_));
                let out = out || by_curve && shape.inside(p + n * step) && !shape.inside(p - n * step);
                prop_assert!(out || !is_flat_at(&shape, p, n, step), "{shape:?} {ray:?} {hit:?}");
            }
        }
    }

    #[test]
    fn closest_hit_is_the_first_of_all_hits(seed: u64) {
        let mut dice = Dice::new(seed);
        let (shape, node) = (dice.shape(), dice.tree(3));
        for _ in 0..20 {
            let (ray, range) = (dice.ray(), dice.range());
            let first = hits(&shape, &ray, range).first().map(|h| h.t);
            prop_assert_eq!(shape.closest(&ray, range).map(|h| h.t), first, "{:?} {:?}", shape, ray);
            prop_assert!(first.is_none_or(|t| range.contains(t)));
            let first = node_hits(&node, &ray, range).first().map(Intersection::t);
            prop_assert_eq!(node.closest(&ray, range).map(|f| f.t()), first, "{:?} {:?}", node, ray);
            prop_assert!(first.is_none_or(|t| range.contains(t)));
        }
    }

    #[test]
    fn transforms_and_inverses_cancel(seed: u64) {
        let mut dice = Dice::new(seed);
        let m = (0..4).fold(Transform::IDENTITY, |m, _| m.then(&dice.transform()));
        let (p, v) = (dice.vector(5.0), dice.vector(5.0));
        // An anisotropic M magnifies rounding errors.
        let stretch = DVec3::AXES.map(|e| m.transform_vector(e).length()).iter().sum::<f64>();
        let shrink = DVec3::AXES.map(|e| m.inverse_transform_vector(e).length()).iter().sum::<f64>();
        let tolerance = 1e-13 * (1.0 + stretch) * (1.0 + shrink) * 100.0;
        prop_assert!(m.inverse_transform_point(m.transform_point(p)).distance(p) < tolerance);
        prop_assert!(m.transform_vector(m.inverse_transform_vector(v)).distance(v) < tolerance);
        // A normal stays perpendicular to its surface.
        let w = v.any_orthogonal_vector();
        let cosine = m.transform_normal(v).normalize().dot(m.transform_vector(w).normalize());
        prop_assert!(cosine.abs() < tolerance, "{cosine}");
    }

    /// A fractal has hits exactly where its inside begins and ends. (Which parts thinner than 1/`precision` are hit
    /// depends on the ray's origin: hence the largest precision, which avoids nearly all such parts.)
    #[test]
    fn fractal_hits_are_at_the_boundary_of_the_inside(seed: u64) {
        let mut dice = Dice::new(seed);
        let mut fractal = JuliaFractal::new(std::array::from_fn(|_| dice.between(-0.7, 0.7)));
        fractal.algebra = [Algebra::Quaternion, Algebra::Hypercomplex][dice.below(2)];
        fractal.function = [durer::shape::Function::Sqr, durer::shape::Function::Cube][dice.below(2)];
        fractal.max_iteration = 2 + dice.below(6);
        fractal.precision = 1000.0;
        let fractal = Shape::from(fractal);
        for _ in 0..4 {
            let ray = dice.ray();
            let all = hits(&fractal, &ray, Range::ALL);
            prop_assert!(all.len().is_multiple_of(2), "{fractal:?} {ray:?} {all:?}");
            let first = all.iter().map(|h| h.t).find(|t| *t > 0.0);
            let closest = fractal.closest(&ray, Range::FORWARD).map(|h| h.t);
            let near = |a: f64, b: f64| (a - b).abs() * ray.dir.length() < 1e-9 * (1.0 + ray.origin.length());
            prop_assert!(first.zip(closest).is_none_or(|(a, b)| near(a, b)), "{fractal:?} {ray:?} {first:?} {closest:?}");
            for hit in &all {
                let (p, step) = (ray.at(hit.t), ray.dir.normalize() * 1e-8);
                prop_assert!(fractal.bounds().contains(p) && fractal.normal(p, hit).is_finite());
                let differ = fractal.inside(p + step) != fractal.inside(p - step);
                prop_assert!(differ || p.length() > 0.99, "{fractal:?} {ray:?} {hit:?}");
            }
        }
    }

    /// Along a ray, a tree of closed solids has hits exactly where its inside begins or ends.
    #[test]
    fn tree_hits_are_at_the_boundary_of_the_inside(seed: u64) {
        let mut dice = Dice::new(seed);
        let tree = dice.tree_of(3, 6, Dice::solid);
        for _ in 0..10 {
            let ray = dice.ray();
            let all = node_hits(&tree, &ray, Range::ALL);
            let size = ray.dir.length();
            let at = |k: i32| -ray.origin.dot(ray.dir) / (size * size) + f64::from(k) * 0.0371 / size;
            for k in -100..100 {
                let (a, b) = (tree.inside(ray.at(at(k))), tree.inside(ray.at(at(k + 1))));
                let near = |f: &Intersection| f.t() > at(k) - 1e-6 / size && f.t() < at(k + 1) + 1e-6 / size;
                let grazes = || [k, k + 1].iter().any(|k| on_surface(&|p| tree.inside(p), ray.at(at(*k))));
                prop_assert!(a == b || all.iter().any(near) || grazes(), "{tree:?} {ray:?}: {a} {b} at {} without a hit", at(k));
            }
            for found in &all {
                prop_assert!(tree.bounds().contains(ray.at(found.t())), "{tree:?} {ray:?} {found:?}");
            }
        }
    }

    /// Intersections of slanted planes and walls: all hits and all inside points are in their box.
    #[test]
    fn intersections_of_planes_are_in_their_box(seed: u64) {
        let mut dice = Dice::new(seed);
        let m = dice.transform();
        let count = 1 + dice.below(9);
        let plane = |dice: &mut Dice| {
            // Mostly outwards from near the centre; sometimes through it, or along an axis.
            let normal = if dice.below(6) == 0 { DVec3::AXES[dice.below(3)] } else { dice.vector(1.0) };
            Shape::from(Plane::new(normal, dice.between(-0.2, 1.0).max(0.0)).unwrap())
        };
        let mut part = |i: usize| {
            let shape = if i > 3 && dice.below(5) == 0 { dice.solid() } else { plane(&mut dice) };
            let m = if dice.below(3) == 0 { m.then(&dice.transform()) } else { m };
            let leaf = SolidNode::leaf(Leaf::new(shape, &m, i as u32), 0);
            if dice.below(9) == 0 { leaf.inverted() } else { leaf }
        };
        let parts: Vec<SolidNode> = (0..count).map(&mut part).collect();
        let more: Vec<SolidNode> = (0..2).map(&mut part).collect();
        let tree = match dice.below(3) {
            0 => SolidNode::intersection(parts, 0),
            1 => SolidNode::intersection(vec![SolidNode::intersection(parts, 0), SolidNode::difference(more, 0)], 0),
            _ => SolidNode::union(more, 0).clipped(parts),
        };
        // The inside without bounding boxes, child by child.
        fn inside(node: &SolidNode, p: DVec3) -> bool {
            use durer::world::SolidKind;
            match node.kind() {
                SolidKind::Leaf(_) => node.inside(p),
                SolidKind::Intersection(children) => children.iter().all(|c| inside(c, p)),
                SolidKind::Union(children) | SolidKind::Merge(children) => children.iter().any(|c| inside(c, p)),
            }
        }
        fn surviving(node: &SolidNode, ray: &Ray) -> Vec<f64> {
            let durer::world::SolidKind::Intersection(children) = node.kind() else {
                return node_hits(node, ray, Range::ALL).iter().map(|f| f.t()).collect();
            };
            let others = |i: usize, p: DVec3| children.iter().enumerate().all(|(j, c)| j == i || inside(c, p));
            let each = children.iter().enumerate().map(|(i, c)| (i, surviving(c, ray)));
            each.flat_map(|(i, hits)| hits.into_iter().filter(move |t| others(i, ray.at(*t)))).collect()
        }
        let is_clipped = matches!(tree.kind(), durer::world::SolidKind::Union(_));
        for _ in 0..30 {
            let ray = Ray { origin: m.transform_point(dice.vector(2.0)), ..dice.ray() };
            let kept = surviving(&tree, &ray);
            for t in &kept {
                prop_assert!(tree.bounds().contains(ray.at(*t)), "{tree:?} {ray:?} {t}");
            }
            prop_assert!(is_clipped || node_hits(&tree, &ray, Range::ALL).len() == kept.len(), "{tree:?} {ray:?}");
            for k in -20..20 {
                let p = ray.at(f64::from(k) * 0.1);
                prop_assert!(is_clipped || tree.inside(p) == inside(&tree, p), "{tree:?} {p}");
            }
        }
    }
}

// Each case tests many trees with many rays.
proptest! {
    #![proptest_config(ProptestConfig { cases: 120, failure_persistence: None, ..ProptestConfig::default() })]

    /// A node with many children has a hierarchy of its own; a chain of pairs has none. Both have the same hits.
    #[test]
    fn hierarchies_of_children_match_chains_of_pairs(seed: u64) {
        let mut dice = Dice::new(seed);
        let parts: Vec<SolidNode> = (0..40).map(|_| dice.tree_of(seed as usize % 2, 6, Dice::solid)).collect();
        let big = |dice: &mut Dice| Shape::from(Sphere { center: dice.vector(1.0), radius: dice.between(2.0, 3.0) });
        let leaf = |shape| SolidNode::leaf(Leaf::new(shape, &Transform::IDENTITY, 7), 7);
        let balls: Vec<SolidNode> = (0..12).map(|_| leaf(big(&mut dice))).collect();
        let one_by_one = |make: fn(Vec<SolidNode>, u32) -> SolidNode, parts: &[SolidNode]| {
            let (first, rest) = parts.split_first().unwrap();
            rest.iter().fold(first.clone(), |node, part| make(vec![node, part.clone()], 0))
        };
        let carved: Vec<SolidNode> = balls[..1].iter().chain(&parts).cloned().collect();
        type Make = fn(Vec<SolidNode>, u32) -> SolidNode;
        let makers: [(Make, &Vec<SolidNode>); 4] =
            [(SolidNode::union, &parts), (SolidNode::merge, &parts), (SolidNode::intersection, &balls), (SolidNode::difference, &carved)];
        let pairs = makers.map(|(make, parts)| (make(parts.clone(), 0), one_by_one(make, parts)));
        for (many, few) in &pairs {
            for _ in 0..20 {
                let (ray, range) = (dice.ray(), dice.range());
                let list = |node| {
                    let mut list: Vec<_> = node_hits(node, &ray, range).iter().map(|f| (f.t(), f.leaf.id)).collect();
                    list.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
                    list
                };
                prop_assert_eq!(list(many), list(few), "{:?}", ray);
                prop_assert_eq!(many.closest(&ray, range).map(|f| f.t()), few.closest(&ray, range).map(|f| f.t()));
                prop_assert_eq!(many.any(&ray, range), !list(many).is_empty(), "{:?}", ray);
                prop_assert_eq!(few.any(&ray, range), !list(few).is_empty(), "{:?}", ray);
                let p = dice.vector(3.0);
                prop_assert_eq!(many.inside(p), few.inside(p), "{}", p);
            }
        }
    }

    #[test]
    fn hierarchy_matches_brute_force(seed: u64, count in prop_oneof![0usize..8, 20usize..60]) {
        let mut dice = Dice::new(seed);
        let nodes: Vec<SolidNode> = (0..count).map(|_| dice.tree(2)).collect();
        let geometry = Geometry::new(nodes.clone());
        for _ in 0..40 {
            let (ray, range) = (dice.ray(), dice.range());
            let sorted = |mut list: Vec<(f64, u32)>| {
                list.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
                list
            };
            let each = nodes.iter().flat_map(|n| node_hits(n, &ray, range));
            let want = sorted(each.map(|f| (f.t(), f.leaf.id)).collect());
            let mut found = vec![];
            let flow = geometry.visit_hits(&ray, range, |_| true, &mut |f| {
                found.push((f.t(), f.leaf.id));
                ControlFlow::Continue(())
            });
            prop_assert!(flow.is_continue());
            prop_assert_eq!(&sorted(found), &want, "{:?} {:?}", ray, range);
            let first = geometry.closest(&ray, range, |_| true);
            prop_assert_eq!(first.map(|f| f.t()), want.first().map(|w| w.0));
            prop_assert_eq!(geometry.any(&ray, range, |_| true), !want.is_empty());
            prop_assert!(geometry.closest(&ray, range, |_| false).is_none());
            if let Some(first) = first {
                let next = geometry.closest(&ray, range, |object| object != first.object);
                prop_assert!(next.is_none_or(|f| f.object != first.object && f.t() >= first.t()));
            }
        }
        for _ in 0..20 {
            let p = dice.vector(3.0);
            let mut inside = vec![];
            geometry.visit_containing(p, &mut |item| inside.push(item.object()));
            // For a disc, or a ball that is solid outside, points beyond the box are unspecified.
            let plate = |n: &PlacedSolid| matches!(n.node().kind(), durer::world::SolidKind::Leaf(l) if l.shape.is_solid_unbounded());
            let all = |n: &PlacedSolid| n.inside(p) && !plate(n);
            let mut want: Vec<u32> = geometry.items().filter(all).map(|n| n.object()).collect();
            let plates: Vec<u32> = geometry.items().filter(|n| plate(n)).map(|n| n.object()).collect();
            inside.retain(|object| !plates.contains(object));
            want.retain(|object| !plates.contains(object));
            inside.sort();
            want.sort();
            prop_assert_eq!(inside, want);
        }
    }

    /// Rays of packets, near each other or not, have the hits that they have one by one, with the same bits.
    #[test]
    fn packets_have_the_hits_of_single_rays(seed: u64, count in prop_oneof![1usize..8, 20usize..60]) {
        let mut dice = Dice::new(seed);
        let geometry = Geometry::new((0..count).map(|i| dice.tree(i % 2)).collect());
        let accepts = |object: u32| !object.is_multiple_of(7);
        let mut coherence = [Coherence::default(), Coherence::default()];
        for number in 0..10 {
            let (first, to) = (dice.ray(), dice.vector(0.5));
            let rays: Vec<Ray> = (0..PACKET).map(|_| match number % 2 {
                0 => dice.ray(),
                _ => Ray::new(first.origin, first.dir + to * dice.vector(0.1)),
            }).collect();
            let packet = RayPacket::new(PACKET, |i| rays[i]);
            let range = Range { min: 1e-4, max: dice.between(0.1, 9.0) };
            let mut hits = ClosestHits::default();
            let found = (&mut hits, &mut coherence[0]);
            geometry.find_closest_of_packet(&packet, Mask::from_bits(0xff), range, accepts, found);
            let lanes = (0..PACKET).filter(|i| hits[*i].is_some()).fold(0, |lanes, i| lanes | 1 << i);
            let surfaces = surfaces_of_packet(&packet, &hits, lanes);
            let role = |object: u32| if accepts(object) { ShadowRole::Occludes } else { ShadowRole::Ignored };
            let (all, max) = (Mask::from_bits(0xff), Lanes::splat(range.max));
            let hints = (&mut None, &mut coherence[1]);
            let occlusion = geometry.occlusion_of_packet(&packet, all, (range.min, &max), role, hints);
            for (i, ray) in rays.iter().enumerate() {
                let alone = geometry.closest(ray, range, accepts);
                let [found, want] = [&hits[i], &alone].map(|hit| hit.as_ref().map(|hit| (hit.hit, hit.leaf.id)));
                prop_assert_eq!(found, want, "{:?} {:?}", ray, range);
                prop_assert_eq!(occlusion.occluded.bits() >> i & 1 == 1, geometry.any(ray, range, accepts), "{:?}", ray);
                if let Some(hit) = alone {
                    prop_assert_eq!(surfaces.lane(i), hit.surface(ray), "{:?}", ray);
                }
            }
        }
    }
}
