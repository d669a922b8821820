//! Benches of durer: `cargo bench -p durer-benches`. A package of its own, so that `cargo test` need not build criterion.
