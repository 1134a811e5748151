#!/usr/bin/env bash
# bench.sh [--quick] [OPTION...]
# Installs what is needed, builds the benchmarks as users' programs are built, runs all of them (some
# five minutes, on a machine that should be quiet) and writes docs/performance.md and its plot.
# With --quick the most important ones take less than a minute. The report of a part goes to build/.
# Further options: --mesh=FILE.obj:LEVELS, a mesh of your own to refine uniformly; and Google
# Benchmark's, such as --benchmark_filter=^uniform/asteroid_15k.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program bench
options=(-DLIMN_BUILD_BENCH=ON)
[ -f build/release/build.ninja ] || options+=(-DLIMN_BUILD_TESTS=OFF)
scripts/build.sh release "${options[@]}" limn_bench

folder=docs
meshes=()
if [ $# -gt 0 ]; then
  folder=build
else
  # Control meshes by artists, where they are at hand.
  corpus=${LIMN_CORPUS:-../shared/corpus}
  for mesh in jdupuy/Bigguy jdupuy/Monsterfrog common3d/spot_quadrangulated; do
    [ ! -f "$corpus/$mesh.obj" ] || meshes+=("--mesh=$corpus/$mesh.obj:5")
  done
fi
build/release/bin/limn_bench "${meshes[@]}" "$@" \
  --benchmark_out=build/performance.json --benchmark_out_format=json
python3 -B bench/report build/performance.json "$folder"
echo "The report: $folder/performance.md"
