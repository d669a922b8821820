#!/bin/sh
# The long version of tests/suite/resume.rs: a still, a region and an animation, each killed (twice) at 20 moments.
cd "$(dirname "$0")/.." && DURER_KILLS="${1:-20}" cargo test --test suite resume:: -- --nocapture
