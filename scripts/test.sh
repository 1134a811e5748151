#!/usr/bin/env bash
# test.sh [PRESET...]
# Installs what is needed, builds and runs every test: as users run it (release), then under the
# address and undefined-behaviour sanitizers (asan), then those of several threads under the thread
# sanitizer (tsan).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program tests

presets=("$@")
[ ${#presets[@]} -gt 0 ] || presets=(release asan tsan)
for preset in "${presets[@]}"; do
  echo "== $preset"
  targets=()
  [ "$preset" != tsan ] || targets=(limn_threaded_tests)
  scripts/build.sh "$preset" -DLIMN_BUILD_TESTS=ON "${targets[@]}"
  ctest --preset "$preset"
done
