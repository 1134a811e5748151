#!/usr/bin/env bash
# sweep-tolerance.sh [FILE-OR-FOLDER...]
# Chooses depths by tolerance for every mesh file given, or of the corpus ($LIMN_CORPUS, or
# ../shared/corpus), and measures what comes out: at 0.01 and 0.002 diagonals, with vertices on the
# limit surface and at positions of the level. Prints the tightest, and fails where the distance
# that was measured is anywhere above the tolerance. Takes hours for a large corpus; $SECONDS_A_MESH
# (120) bounds each, and what takes longer is counted.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program bench
options=(-DLIMN_BUILD_BENCH=ON)
[ -f build/release/build.ninja ] || options+=(-DLIMN_BUILD_TESTS=OFF)
scripts/build.sh release "${options[@]}" limn_tolerance_sweep

[ $# -gt 0 ] || set -- "${LIMN_CORPUS:-../shared/corpus}"
mapfile -t files < <(find "$@" -type f \( -name '*.obj' -o -name '*.ply' -o -name '*.off' -o -name '*.stl' \) -size -400k | sort)
[ ${#files[@]} -gt 0 ] || { echo "sweep-tolerance.sh: no mesh files in $*" >&2; exit 2; }

failed=0
for points in limit level; do
  for tolerance in 0.01 0.002; do
    log=build/sweep-$points-$tolerance.log
    : >"$log"
    for file in "${files[@]}"; do
      # A program that fails has said why; one that crashes or takes too long says so here.
      code=0
      timeout "${SECONDS_A_MESH:-120}" build/release/bin/limn_tolerance_sweep "$tolerance" "$points" "$file" >>"$log" || code=$?
      [ $code -ne 124 ] || echo "slow     $file" >>"$log"
      [ $code -le 1 ] || [ $code -eq 124 ] || echo "CRASHED  $file" >>"$log"
    done
    echo "tolerance $tolerance, positions $points: $(grep -c '^holds' "$log" || true) hold," \
      "$(grep -c '^short' "$log" || true) would need more levels than there are," \
      "$(grep -c '^large' "$log" || true) were too large and $(grep -c '^slow' "$log" || true) too slow to measure," \
      "$(grep -c '^refused' "$log" || true) are no meshes; tightest:"
    grep '^holds' "$log" | sort -k2,2nr | head -3 || true
    if grep -E '^(ABOVE|CRASHED)' "$log"; then
      failed=1
    fi
  done
done
exit $failed
