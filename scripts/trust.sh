#!/usr/bin/env bash
# trust.sh
# Measures what Limn promises about files (some ten minutes) and writes docs/reliability.md: hostile
# files, sizes, round trips, kills, full disks, limits, hardening, coverage, and half a minute of
# fuzzing for each reader. Fails where a promise is broken.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program tests
scripts/build.sh release -DLIMN_BUILD_TESTS=ON limn limn_format_trust limn_saves_trust

out=build/trust
mkdir -p "$out"
broken=0
measure() { # NAME COMMAND...: keeps what the command prints, a promise a line.
  local name=$1
  shift
  echo "== $name"
  "$@" | tee "$out/$name.tsv" || broken=1
}

hardening() {
  local program=build/release/bin/limn
  tell() { # PROMISE FIGURE KEPT
    printf '%s\t%s\t%s\t%s\n' "$1" "$2" yes "$([ "$3" = 0 ] && echo kept || echo BROKEN)"
  }
  local state
  check() { # PROMISE COMMAND...
    local promise=$1
    shift
    state=0
    "$@" >/dev/null || state=1
    tell "$promise" "$([ $state = 0 ] && echo yes || echo no)" $state
  }
  check "Loaded at an address of its own each time (PIE)" sh -c "readelf -h $program | grep -q 'Type:.*DYN'"
  check "Links are bound at the start and read-only" sh -c "readelf -d $program | grep -q 'NOW' && readelf -l $program | grep -q GNU_RELRO"
  check "Stacks are protected" sh -c "readelf --dyn-syms -W $program | grep -q __stack_chk_fail"
  check "Buffers of the C library are checked" sh -c "readelf --dyn-syms -W $program | grep -q '_chk@'"
  check "Indices of the standard library are checked" sh -c "readelf --dyn-syms -W $program | grep -q '__glibcxx_assert_fail'"
}

coverage() {
  local lines branches
  scripts/coverage.sh >"$out/coverage.txt"
  lines=$(awk '$1 == "lines" { print $2 }' "$out/coverage.txt")
  branches=$(awk '$1 == "branches" { print $2 }' "$out/coverage.txt")
  for pair in "Lines:$lines" "Branches:$branches"; do
    printf '%s of src/mesh, src/document and src/files that tests reach\t%s\tat least 90 %%\t%s\n' \
      "${pair%%:*}" "${pair##*:}" \
      "$(awk -v share="${pair##*:}" 'BEGIN { print (share + 0 >= 90 ? "kept" : "BROKEN") }')"
  done
}

fuzzing() {
  scripts/build.sh asan -DLIMN_BUILD_TESTS=ON limn_fuzz_seeds \
    limn_fuzz_obj limn_fuzz_ply limn_fuzz_off limn_fuzz_stl limn_fuzz_project >&2
  build/asan/bin/limn_fuzz_seeds "$out/seeds"
  for target in obj ply off stl project; do
    mkdir -p "$out/learnt/$target"
    local state=0
    "build/asan/bin/limn_fuzz_$target" -max_total_time=30 -timeout=10 -rss_limit_mb=2048 \
      -max_len=8192 -print_final_stats=1 -print_funcs=0 -verbosity=0 -dict=tests/fuzz/formats.dict \
      -artifact_prefix="$out/found-$target-" "$out/learnt/$target" "$out/seeds/$target" \
      >"$out/fuzz-$target.log" 2>&1 || state=1
    printf 'Half a minute of fuzzing: %s\t%s inputs\tno find\t%s\n' "$target" \
      "$(awk '/number_of_executed_units/ { print $NF }' "$out/fuzz-$target.log")" \
      "$([ $state = 0 ] && echo kept || echo BROKEN)"
  done
}

measure reading build/release/bin/limn_format_trust
measure saving build/release/bin/limn_saves_trust
measure hardening hardening
measure coverage coverage
measure fuzzing fuzzing

table() { # NAME
  printf '| Promise | Measured | Bound | |\n| --- | --- | --- | --- |\n'
  awk -F'\t' '{ printf "| %s | %s | %s | %s |\n", $1, $2, $3, $4 }' "$out/$1.tsv"
}
{
  cat <<'TEXT'
# Reliability

What Limn promises about files and work, and what was measured of each promise. `scripts/trust.sh`
measures all of it and writes this page; the tests hold it to the same promises with fewer rounds,
every time they run. What becomes of a mesh that is no surface is written in
[include/limn/mesh/build.h](../include/limn/mesh/build.h), what each format holds in
[formats.md](formats.md).

TEXT
  printf 'Measured on %s, %s cores, %s, on %s.\n' \
    "$(awk -F': ' '/^model name/ { print $2; exit }' /proc/cpuinfo)" "$(nproc)" \
    "$(awk '/^MemTotal/ { printf "%.0f GiB", $2 / 1048576 }' /proc/meminfo)" "$(date +%Y-%m-%d)"
  printf '\n## Reading and writing meshes\n\n'
  table reading
  printf '\n## Saving, recovery and limits\n\n'
  table saving
  printf '\n## Fuzzing\n\nUnder the address and undefined-behaviour sanitizers. What a reader takes is written, read again\nand compared. `scripts/fuzz.sh` goes on for longer.\n\n'
  table fuzzing
  printf '\n## Hardening\n\nOf the program that users run. The engine (src/subdivision) checks neither its indices nor its\nstacks there: it computes on meshes that were checked when they were built, and checks would take\nup to a quarter of its speed.\n\n'
  table hardening
  printf '\n## Coverage\n\n'
  table coverage
} >docs/reliability.md
echo "The report: docs/reliability.md"
exit $broken
