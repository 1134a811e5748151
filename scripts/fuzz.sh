#!/usr/bin/env bash
# fuzz.sh [SECONDS [TARGET...]]
# Fuzzes the readers and the project file (obj ply off stl project) for so many seconds each, 600 if
# none are given, on every core, from the seeds and from what earlier runs have learnt. A find stops
# its target and is left in build/asan/fuzz, for a test to be made of it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=${1:-600}
shift || true
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(obj ply off stl project)

scripts/install-packages.sh program tests
scripts/build.sh asan -DLIMN_BUILD_TESTS=ON limn_fuzz_seeds "${targets[@]/#/limn_fuzz_}"
out=build/asan/fuzz
build/asan/bin/limn_fuzz_seeds "$out/seeds"
failed=()
for target in "${targets[@]}"; do
  echo "== $target"
  mkdir -p "$out/corpus/$target"
  "build/asan/bin/limn_fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -fork="$(nproc)" -dict=tests/fuzz/formats.dict -artifact_prefix="$out/found-$target-" \
    "$out/corpus/$target" "$out/seeds/$target" || failed+=("$target")
done
[ ${#failed[@]} -eq 0 ] || { echo "Found something: ${failed[*]}" >&2; exit 1; }
