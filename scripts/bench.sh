#!/usr/bin/env bash
# bench.sh [--quick] [OPTION...]
# Installs what is needed, builds the benchmarks as users' programs are built, runs all of them (some
# five minutes, on a machine that should be quiet) and writes docs/performance.md and its plot.
# With --quick the most important ones take less than a minute, and the report goes to build/.
# Options are Google Benchmark's, such as --benchmark_filter=^uniform/asteroid_15k.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program bench
options=(-DLIMN_BUILD_BENCH=ON)
[ -f build/release/build.ninja ] || options+=(-DLIMN_BUILD_TESTS=OFF)
scripts/build.sh release "${options[@]}" limn_bench

folder=docs
for option in "$@"; do
  case $option in --quick | --benchmark_filter=*) folder=build ;; esac
done
build/release/bin/limn_bench --benchmark_out=build/performance.json --benchmark_out_format=json "$@"
python3 -B bench/report build/performance.json "$folder"
echo "The report: $folder/performance.md"
