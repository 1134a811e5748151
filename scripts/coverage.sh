#!/usr/bin/env bash
# coverage.sh
# Builds the library with counters (Clang), runs the tests of meshes, files and documents, and prints
# the lines and branches that they reach, file by file and in all. A branch is a condition that comes
# out true, and one that comes out false. Last come the two sums, as "lines PERCENT" and "branches
# PERCENT".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program tests
programs=(limn_mesh_test limn_bundled_tests limn_files_test limn_document_test)
scripts/build.sh coverage -DLIMN_BUILD_TESTS=ON "${programs[@]}" >&2

out=build/coverage/counts
rm -rf "$out"
mkdir -p "$out"
objects=()
for program in "${programs[@]}"; do
  LLVM_PROFILE_FILE="$out/$program.profraw" "build/coverage/bin/$program" --gtest_brief=1 >&2
  objects+=(${objects:+-object} "build/coverage/bin/$program")
done
llvm-profdata merge -o "$out/all.profdata" "$out"/*.profraw
llvm-cov report "${objects[@]}" -instr-profile="$out/all.profdata" \
  -show-branch-summary -show-region-summary=false src/mesh src/document src/files |
  tee "$out/report.txt"
awk '$1 == "TOTAL" { print "lines " $7; print "branches " $10 }' "$out/report.txt"
