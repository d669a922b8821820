//! For tests of shapes: all hits in order, and a reader of numbers and words without an interpreter.

use crate::color::{Color, Gamma};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::image_io::Picture;
use crate::math::packet::{Flags, Numbers, PACKET, RayPacket};
use crate::math::registers::testing::for_all_registers;
use crate::math::registers::wide_versions;
use crate::math::{DVec2, DVec3, Lanes, Range, Ray, Transform, rng};
use crate::mesh_io::MeshMaterial;
use crate::shape::{Crossing, End, Hit, Hits, Kernel, PacketCrossings, PacketHits, Paints};
use crate::source::Span;
use crate::value::{FloatOrColor, Language, Next, Readable, Reader, Solid, Thing, Value, VecN};
use std::collections::VecDeque;
use std::sync::Arc;

/// Returns all hits of a ray's whole line on a shape, ascending.
pub fn all_hits(shape: &impl Kernel, ray: &Ray) -> Vec<Hit> {
    let mut hits = Hits::new();
    shape.hits(ray, Range::ALL, &mut hits);
    hits.sort_by(|a, b| a.t.total_cmp(&b.t));
    hits.into_vec()
}

/// Asserts that hits have these `t`, to rounding, and parts.
pub fn assert_hits(found: &[Hit], want: &[(f64, u32)]) {
    let same = |(h, w): (&Hit, &(f64, u32))| (h.t - w.0).abs() <= 1e-12 * (1.0 + w.0.abs()) && h.part == w.1;
    assert!(found.len() == want.len() && found.iter().zip(want).all(same), "found {found:?}, want {want:?}");
}

/// Asserts that the rays of packets have the hits, normals and intervals that they have one by one. The shape must be near the origin, about
/// one unit large, and trace packets.
pub fn assert_packets_match_single_rays(shape: &impl Kernel) {
    let random =
        |i: usize, n: u64| DVec3::from_array([0, 1, 2].map(|axis| rng::random_unit(&[i as u64, n, axis]) * 2.0 - 1.0));
    // Rays to the shape and beside it, along axes, and along a plane through the origin; some begin within the shape
    let ray = |i: usize| {
        let (from, to) = (random(i, 1) * [3.0, 0.5][i % 2], random(i, 2) * 1.5);
        let axis = DVec3::AXES[i / 5 % 3];
        match i % 5 {
            0 => Ray::new(to - axis * 4.0, axis),
            1 => Ray::new(to + axis * 4.0, -axis * 0.7),
            2 => Ray::new((from - to) * (DVec3::ONE - axis), to * (DVec3::ONE - axis)),
            _ => Ray::new(from, to - from),
        }
    };
    let mut n_hits = 0;
    for packet in 0..400 {
        let rays: [Ray; PACKET] = std::array::from_fn(|lane| ray(packet * PACKET + lane));
        let lanes = RayPacket::new(PACKET, |i| rays[i]);
        let max = Lanes(std::array::from_fn(|i| [f64::INFINITY, 1.0, 2.5, 0.3][(packet + i) % 4]));
        let min = [1e-4, 0.0, 0.4][packet % 3];
        for_all_registers(|registers| {
            let found = closest_of_packet(shape, &lanes, min, &max);
            let hits = std::array::from_fn(|i| Hit::on_piece(found.t.0[i], found.part[i]));
            let normals = shape.normals_of_packet(&lanes.at(found.t), &hits, found.is_hit.bits());
            let crossings = crossings_of_packet(shape, &lanes);
            for (i, ray) in rays.iter().enumerate() {
                if shape.crosses_packets() {
                    assert_eq!(crossing_of_lane(&crossings, i), shape.crossing(ray), "{registers:?} {ray:?}");
                }
                let alone = shape.closest(ray, Range { min, max: max.0[i] });
                let in_packet = (found.is_hit.bits() >> i & 1 == 1).then_some(hits[i]);
                assert_eq!(in_packet, alone, "{registers:?} {ray:?} {min} {}", max.0[i]);
                if let Some(hit) = alone {
                    assert_eq!(normals.lane(i), shape.normal(ray.at(hit.t), &hit));
                    n_hits += 1;
                }
            }
        });
    }
    assert!(shape.traces_packets() && n_hits > 300, "{n_hits}");
}

/// Calls [`Kernel::closest_of_packet`] as compiled for the registers that are in use.
fn closest_of_packet<S: Kernel>(shape: &S, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
    wide_versions! {
        fn closest<'a; S: (Kernel)>(shape: &'a S, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
            shape.closest_of_packet(rays, min, max)
        }
    }
    closest(shape, rays, min, max)
}

/// Calls [`Kernel::crossings_of_packet`] as compiled for the registers that are in use.
fn crossings_of_packet<S: Kernel>(shape: &S, rays: &RayPacket) -> PacketCrossings {
    wide_versions! {
        fn crossings<'a; S: (Kernel)>(shape: &'a S, rays: &RayPacket) -> PacketCrossings {
            shape.crossings_of_packet(rays)
        }
    }
    crossings(shape, rays)
}

/// Returns the interval of one line.
fn crossing_of_lane(all: &PacketCrossings, i: usize) -> Crossing {
    let has = |flags: Flags| flags.bits() >> i & 1 == 1;
    let ends = [0, 1].map(|end| End::on_piece(all.t[end].0[i], all.part[end][i]));
    match (has(all.is_known), ends[0].t <= ends[1].t, has(all.is_around)) {
        (false, ..) => Crossing::Unknown,
        (true, true, false) => Crossing::Through(ends),
        (true, true, true) => Crossing::Around(ends),
        (true, false, false) => Crossing::Misses,
        (true, false, true) => Crossing::Stays,
    }
}

/// Reads a shape from words separated by blanks; returns the diagnostics too.
pub fn read_shape<S: Readable + Kernel>(text: &str) -> (Result<S>, Vec<Diagnostic>) {
    let mut r = NumberWordReader { left: text.split_whitespace().map(String::from).collect(), reports: vec![] };
    let shape = read_whole_shape::<S>(&mut r);
    (shape, r.reports)
}

fn read_whole_shape<S: Readable + Kernel>(r: &mut NumberWordReader) -> Result<S> {
    let mut shape = S::read(r)?;
    loop {
        let next = r.peek_next()?;
        if !shape.read_own(next, r)? && !shape.read_textured(next, r, &mut NoPaints)? {
            break;
        }
    }
    shape.complete_and_check(Span::new(1, 2), r)?;
    assert!(r.left.is_empty(), "left over: {:?}", r.left);
    Ok(shape)
}

/// Reader of embedded textures for tests, which accepts none.
struct NoPaints;

impl Paints for NoPaints {
    fn read_embedded_texture(&mut self, _: &mut u32, _: Next, _: &mut dyn Reader) -> Result<bool> {
        Ok(false)
    }

    fn read_listed_texture(&mut self, _: Next, _: &mut dyn Reader) -> Result<Option<u32>> {
        Ok(None)
    }

    fn add_mesh_material(&mut self, _: &MeshMaterial, _: Option<&Arc<Picture>>, _: &mut dyn Reader) -> Result<u32> {
        Ok(0)
    }

    fn transform(&mut self, _: &mut u32, _: &Transform) {}
}

struct NumberWordReader {
    left: VecDeque<String>,
    reports: Vec<Diagnostic>,
}

impl Reader for NumberWordReader {
    fn peek_next(&mut self) -> Result<Next> {
        Ok(match self.left.front() {
            None => Next::End,
            Some(w) if w.starts_with(|c: char| c.is_ascii_alphabetic()) => Next::Word(w.clone().leak()),
            Some(_) => Next::Value,
        })
    }

    fn span(&mut self) -> Span {
        Span::new(1, 2)
    }

    fn take_token(&mut self) -> Result<Span> {
        self.left.pop_front();
        Ok(self.span())
    }

    fn leave_block(&mut self) -> Result<()> {
        Ok(())
    }

    fn value(&mut self) -> Result<(Value, Span)> {
        let Some(text) = self.left.pop_front() else { return Err(self.unexpected("a value").into()) };
        let list: Vec<f64> = text.trim_matches(['<', '>']).split(',').map(|n| n.parse().unwrap()).collect();
        let value = if list.len() == 1 { Value::Float(list[0]) } else { Value::Vector(VecN::from_slice(&list)) };
        Ok((value, self.span()))
    }

    fn take_thing(&mut self) -> Result<(Arc<dyn Thing>, Span)> {
        unreachable!()
    }

    fn float(&mut self) -> Result<f64> {
        match self.value()?.0 {
            Value::Float(x) => Ok(x),
            _ => Err(self.unexpected("a number").into()),
        }
    }

    fn optional_float(&mut self) -> Result<Option<f64>> {
        if Reader::peek_next(self)? == Next::Value { self.float().map(Some) } else { Ok(None) }
    }

    fn peek_next_unless_separated(&mut self) -> Result<Next> {
        Reader::peek_next(self)
    }

    fn float_or_color(&mut self) -> Result<FloatOrColor> {
        unreachable!()
    }

    fn may_be_at_color(&mut self) -> Result<bool> {
        unreachable!()
    }

    fn transform(&mut self) -> Result<Option<Box<Transform>>> {
        unreachable!()
    }

    fn vector(&mut self) -> Result<DVec3> {
        match self.value()?.0 {
            Value::Float(x) => Ok(DVec3::splat(x)),
            Value::Vector(v) if v.len == 3 => Ok(v.xyz()),
            _ => Err(self.unexpected("a vector").into()),
        }
    }

    fn unchecked_vector(&mut self) -> Result<DVec3> {
        self.vector()
    }

    fn vector2(&mut self) -> Result<DVec2> {
        self.vector().map(|v| v.truncate())
    }

    fn numbers_in_angle_brackets(&mut self, n: usize) -> Result<Vec<f64>> {
        let Some(text) = self.left.pop_front() else { return Err(self.unexpected("numbers").into()) };
        let list: Vec<f64> = text.trim_matches(['<', '>']).split(',').map(|n| n.parse().unwrap()).collect();
        if list.len() == n { Ok(list) } else { Err(self.unexpected("numbers").into()) }
    }

    fn numbers_in_parentheses(&mut self, n: usize) -> Result<Vec<f64>> {
        self.numbers_in_angle_brackets(n)
    }

    fn read_colon(&mut self) -> Result<()> {
        Ok(())
    }

    fn color(&mut self) -> Result<Color> {
        unreachable!()
    }

    fn text(&mut self) -> Result<String> {
        match self.left.pop_front() {
            Some(word) => Ok(word.trim_matches('"').to_string()),
            None => Err(self.unexpected("a text").into()),
        }
    }

    fn flag(&mut self) -> Result<bool> {
        Ok(self.left.pop_front().is_none_or(|w| w == "on"))
    }

    fn language(&self) -> Language {
        Language {
            version: 370,
            bare_textures: false,
            random_media: false,
            untinted_layers: false,
            ordered_cameras: false,
            bare_operators: true,
            assumed_gamma: None,
            other_gamma: Gamma::Power(1.0),
            srgb_files: true,
        }
    }

    fn read_pigment_pattern(&mut self) -> Result<Arc<dyn Thing>> {
        Err(self.unexpected("no pigment").into())
    }

    fn read_solid(&mut self) -> Result<Arc<dyn Solid>> {
        Err(self.unexpected("no object").into())
    }

    fn read_mesh_file(&mut self, _: crate::value::BuildMesh) -> Result<Arc<dyn Thing>> {
        Err(self.unexpected("no file").into())
    }

    fn open_picture(&mut self, _: &str, _: Span, _: Option<&str>) -> Result<Arc<crate::image_io::Picture>> {
        Err(self.unexpected("no picture").into())
    }

    fn read_function_if_sized(&mut self) -> Result<Option<([usize; 2], Arc<dyn Thing>)>> {
        Ok(None)
    }

    fn files(&self) -> &dyn crate::source::Files {
        &crate::source::Disk
    }

    fn find_file(&mut self, _: &str, _: Span) -> Result<Option<std::path::PathBuf>> {
        unreachable!()
    }

    fn find_font_or_substitute(&mut self, _: &str, _: Span) -> Result<Arc<crate::font::Font>> {
        Ok(Arc::new(crate::font::Font::built_in()))
    }

    fn skip_item(&mut self) -> Result<()> {
        unreachable!()
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        self.reports.push(diagnostic);
    }

    fn unexpected(&mut self, expected: &str) -> Diagnostic {
        Diagnostic::new(codes::SYNTAX, Span::new(1, 2), format!("expected {expected}"))
    }

    fn unknown_word(&mut self, block: &str, _: &[&'static str]) -> Diagnostic {
        self.unexpected(block)
    }
}
