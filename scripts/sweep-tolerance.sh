#!/usr/bin/env bash
# sweep-tolerance.sh [FILE-OR-FOLDER...]
# sweep-tolerance.sh --report
# Chooses depths by tolerance for every mesh file given, or of the corpus ($LIMN_CORPUS, or
# ../shared/corpus), and measures what comes out: at 0.01 and 0.002 diagonals, with vertices on the
# limit surface, at positions of the level, and on the limit surface with depths that are measured
# while they are chosen. Prints the tightest, and fails where the distance that was measured is
# anywhere above the tolerance. Of the corpus it writes docs/tolerances.md; with --report it does so
# again, from what the last run left. Takes an hour for some hundreds of meshes; $SECONDS_A_MESH
# (120) bounds each, and what takes longer is counted.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
ways=(limit level measured)
tolerances=(0.01 0.002)

log_of() { echo "build/sweep-$1-$2.log"; }
count() { grep -c "^$2" "$1" || true; }
tightest() { grep '^holds' "$1" | sort -k2,2nr | head -1 | awk '{print $2}'; }

report() {
  cat <<'TEXT'
# Tolerances are kept

Depths chosen by a tolerance, in diagonals, for every mesh of a collection of models, test shapes and broken files, and the distance to the limit surface that is measured then, in both directions. Written by
`scripts/sweep-tolerance.sh`. *Tightest* is the greatest distance measured, in tolerances; above 1 would be a tolerance that is not kept. *Too deep*: the deepest level there is does not suffice, which the program says. *Too large*:
more than 1.5 million faces; *too slow*: minutes of measuring; *no meshes*: refused with a reason.

| vertices | tolerance | kept | above | tightest | too deep | too large | too slow | no meshes |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
TEXT
  local way tolerance log
  for way in "${ways[@]}"; do
    for tolerance in "${tolerances[@]}"; do
      log=$(log_of "$way" "$tolerance")
      case $way in
        limit) words='on the limit surface' ;;
        level) words='where the last level has them' ;;
        measured) words='on the limit surface, measured while choosing' ;;
      esac
      echo "| $words | $tolerance | $(count "$log" holds) | $(count "$log" ABOVE) | $(tightest "$log") |" \
        "$(count "$log" short) | $(count "$log" large) | $(count "$log" slow) | $(count "$log" refused) |"
    done
  done
}

if [ "${1:-}" = --report ]; then
  report >docs/tolerances.md
  exit
fi

scripts/install-packages.sh program bench
options=(-DLIMN_BUILD_BENCH=ON)
[ -f build/release/build.ninja ] || options+=(-DLIMN_BUILD_TESTS=OFF)
scripts/build.sh release "${options[@]}" limn_tolerance_sweep

is_corpus=no
[ $# -gt 0 ] || { set -- "${LIMN_CORPUS:-../shared/corpus}"; is_corpus=yes; }
mapfile -t files < <(find "$@" -type f \( -name '*.obj' -o -name '*.ply' -o -name '*.off' -o -name '*.stl' \) | sort)
[ ${#files[@]} -gt 0 ] || { echo "sweep-tolerance.sh: no mesh files in $*" >&2; exit 2; }

failed=0
for way in "${ways[@]}"; do
  for tolerance in "${tolerances[@]}"; do
    log=$(log_of "$way" "$tolerance")
    : >"$log"
    for file in "${files[@]}"; do
      # A program that fails has said why; one that crashes or takes too long says so here.
      code=0
      timeout "${SECONDS_A_MESH:-120}" build/release/bin/limn_tolerance_sweep "$tolerance" "$way" "$file" >>"$log" || code=$?
      [ $code -ne 124 ] || echo "slow     $file" >>"$log"
      [ $code -le 1 ] || [ $code -eq 124 ] || echo "CRASHED  $file" >>"$log"
    done
    echo "tolerance $tolerance, $way: $(count "$log" holds) hold," \
      "$(count "$log" short) would need more levels than there are," \
      "$(count "$log" large) were too large and $(count "$log" slow) too slow to measure," \
      "$(count "$log" refused) are no meshes; tightest:"
    grep '^holds' "$log" | sort -k2,2nr | head -3 || true
    if grep -E '^(ABOVE|CRASHED)' "$log"; then
      failed=1
    fi
  done
done
[ $is_corpus = no ] || report >docs/tolerances.md
exit $failed
