#!/usr/bin/env bash
# faces.sh [--quick]
# Installs what is needed, builds, finds out how many faces meshes need for the same distance to
# their limit surfaces (some ten minutes) and writes docs/faces.md and its plots. With --quick the
# bundled meshes alone, and the report goes to build/.
# Control meshes of the corpus ($LIMN_CORPUS, or ../shared/corpus) are looked at where they are.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program tests bench
options=(-DLIMN_BUILD_BENCH=ON)
[ -f build/release/build.ninja ] || options+=(-DLIMN_BUILD_TESTS=OFF)
scripts/build.sh release "${options[@]}" limn_faces_bench

folder=docs
[ $# -eq 0 ] || folder=build
build/release/bin/limn_faces_bench --corpus="${LIMN_CORPUS:-../shared/corpus}" "$@" >build/faces.json
python3 -B bench/report/faces.py build/faces.json "$folder"
echo "The report: $folder/faces.md"
