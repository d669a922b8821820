//! Tests of the program and its library: one module a subject, one binary for all of them, since each binary links the whole
//! program. `cargo test --test suite cli::` runs those of one module.
//!
//! Tests that are rows of tables or files of folders are in `tests/cases`.

#![allow(clippy::disallowed_methods, clippy::unwrap_used)]

mod animation;
mod architecture;
mod area_lights;
mod cameras;
mod cli;
mod commands;
mod csg;
mod deps_query_new;
mod drawing;
mod editors;
mod every_shape;
mod format;
mod function_internals;
mod geometry;
mod light;
mod light_cases;
mod light_files;
mod lossless_syntax_tree;
mod lowering;
mod lsp;
mod memory;
#[path = "../support/mutate.rs"]
mod mutate;
mod noise;
mod packets;
mod photons;
mod pick;
mod quirks;
mod radiosity;
mod resume;
mod scene_builder;
mod scene_contents;
mod scratch;
mod shards;
mod single_layer;
mod subsurface;
mod token_granularity;
mod watch;
