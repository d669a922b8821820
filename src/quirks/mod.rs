//! POV-Ray's quirks: behaviour that no clean model would have, but that POV-Ray 3.7 shows and scenes rely on.
//!
//! Each quirk is one row of a table below: an id, one sentence, and the evidence. Code that obeys a quirk cites its id
//! in a comment
//! (`quirk: shadow_min_distance`); the text of a comment needs no other reference to measurements. The manual's page
//! "What POV-Ray 3.7
//! really does" is generated from the tables.
//!
//! To add a quirk: add a row to the topic's file, in alphabetical order of ids, and cite the id where the code obeys
//! it.
//! `tests/suite/quirks.rs` checks that ids are unique, that every emulated quirk is cited, that every cited id exists,
//! and that all evidence exists.

mod atmosphere;
mod camera;
mod csg;
mod image;
mod language;
mod light;
mod media;
mod options;
mod pattern;
mod shape;
mod surface;
mod texture;

/// One behaviour of POV-Ray 3.7.
#[derive(Clone, Copy, Debug)]
pub struct Quirk {
    /// Name by which code and tests cite the quirk, in snake case.
    pub id: &'static str,
    /// Behaviour of POV-Ray 3.7: one or two sentences in Markdown for users, with a full stop.
    pub summary: &'static str,
    /// Places with POV-Ray's own numbers that prove the behaviour, see [`Evidence`].
    pub evidence: Evidence,
    /// Relation of durer to the quirk: emulated, or different on purpose.
    pub status: Status,
}

/// Places that hold POV-Ray's numbers for a quirk, each in one of these forms:
///
/// - `light_cases/NAME`: the pixels of `tests/light_cases/NAME.pov`;
/// - `tests/PATH`: any other file with POV-Ray's output, such as `tests/lang/rules.scene`;
/// - `src/PATH.rs::FUNCTION`: a unit test that holds POV-Ray's numbers;
/// - `conformance/SCENE`: one of POV-Ray's own scenes, whose verdict in `tests/conformance.json` is `same` or `close`.
pub type Evidence = &'static [&'static str];

/// Behaviour of durer where POV-Ray has a quirk.
#[derive(Clone, Copy, Debug)]
pub enum Status {
    /// durer does the same as POV-Ray.
    Emulated,
    /// durer differs from POV-Ray's quirk on purpose: what it does instead, and why, in one sentence.
    Differs(&'static str),
}

/// Quirks of POV-Ray about one topic.
#[derive(Clone, Copy, Debug)]
pub struct Topic {
    /// Heading of the topic in the manual.
    pub title: &'static str,
    /// Quirks of the topic in alphabetical order of ids.
    pub quirks: &'static [Quirk],
}

/// All topics of quirks, in the order of the manual.
pub const TOPICS: &[Topic] = &[
    Topic { title: "Language", quirks: language::QUIRKS },
    Topic { title: "Shapes", quirks: shape::QUIRKS },
    Topic { title: "CSG, clipping, bounding", quirks: csg::QUIRKS },
    Topic { title: "Patterns", quirks: pattern::QUIRKS },
    Topic { title: "Pigments, normals, textures", quirks: texture::QUIRKS },
    Topic { title: "Surfaces: finish, reflection, refraction", quirks: surface::QUIRKS },
    Topic { title: "Lights and shadows", quirks: light::QUIRKS },
    Topic { title: "Sky, fog, rainbows", quirks: atmosphere::QUIRKS },
    Topic { title: "Media", quirks: media::QUIRKS },
    Topic { title: "Cameras and sampling", quirks: camera::QUIRKS },
    Topic { title: "Pictures in and out", quirks: image::QUIRKS },
    Topic { title: "Command line and INI files", quirks: options::QUIRKS },
];

/// Creates the row of a quirk that durer emulates.
const fn emulated_quirk(id: &'static str, summary: &'static str, evidence: Evidence) -> Quirk {
    Quirk { id, summary, evidence, status: Status::Emulated }
}

/// Creates the row of a quirk that durer does not emulate; `instead` is what durer does, and why.
const fn differing_quirk(id: &'static str, summary: &'static str, instead: &'static str, evidence: Evidence) -> Quirk {
    Quirk { id, summary, evidence, status: Status::Differs(instead) }
}
