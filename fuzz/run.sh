#!/usr/bin/env bash
# Runs fuzzers, two at a time: fuzz/run.sh SECONDS [TARGET…]. Prints the number of executions of each target, and ends with code 1 if one
# of them found a fault, whose input is then in fuzz/artifacts/TARGET/. JOBS=1 runs one at a time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

seconds=$1
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || mapfile -t targets < <(basename -s .rs fuzz_targets/*.rs)

# Without a sanitizer of memory: durer has no unsafe code outside of its allocator, and runs twice as fast.
# (`-O` leaves debug assertions to the profile in Cargo.toml.)
cargo +nightly fuzz build -O -s none --codegen-units 16
bash seed.sh
programs=${CARGO_TARGET_DIR:-target}/x86_64-unknown-linux-gnu/release
logs=$(mktemp -d)

run() {
    local target=$1 words=$1 dictionary=() log=$logs/$1
    mkdir -p "corpus/$target" "artifacts/$target"
    case $target in parse | format | interpret | render) words=language ;; esac
    [ ! -f "dictionaries/$words.dict" ] || dictionary=("-dict=dictionaries/$words.dict")
    if "$programs/$target" "corpus/$target" "${dictionary[@]}" "-artifact_prefix=artifacts/$target/" \
        "-max_total_time=$seconds" -timeout=30 -rss_limit_mb=4096 -print_final_stats=1 >"$log" 2>&1; then
        printf '%-20s %10s executions\n' "$target" "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")"
    else
        printf '%-20s FAULT\n' "$target"
        grep -v '^#\|^INFO\|^Dictionary' "$log" | grep -m1 -A3 panicked || true
        grep -v '^#\|^INFO\|^Dictionary' "$log" | tail -40
        return 1
    fi
}
export -f run
export logs programs seconds
printf '%s\n' "${targets[@]}" | xargs -P "${JOBS:-2}" -I{} bash -c 'run {}'
rm -r "$logs"
