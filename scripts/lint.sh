#!/usr/bin/env bash
# lint.sh [FILE...]
# Checks layout (clang-format) and names and common mistakes (clang-tidy) of the files given, or of
# all of ours. Prints what it finds and a summary; fails where there is anything to mend.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program tests bench developers

# clang-tidy needs what the compiler would: the commands of every file, and the generated headers.
scripts/build.sh dev -DLIMN_BUILD_APP=ON -DLIMN_BUILD_TESTS=ON -DLIMN_BUILD_BENCH=ON limn_glad limn_generated

files=("$@")
[ ${#files[@]} -gt 0 ] || mapfile -t files < <(git ls-files '*.h' '*.inl' '*.cpp')
# Headers are checked with the sources that include them; the consumer is a project of its own.
mapfile -t sources < <(printf '%s\n' "${files[@]}" | grep '\.cpp$' | grep -v '^tests/consumer/' || true)

format_faults=0
clang-format --dry-run -Werror "${files[@]}" || format_faults=1

log=$(mktemp)
trap 'rm -f "$log"' EXIT
tidy_faults=0
if [ ${#sources[@]} -gt 0 ]; then
  # GCC knows warning options that clang does not; "N warnings generated" counts those of others' headers.
  printf '%s\0' "${sources[@]}" |
    xargs -0 -P "$(nproc)" -n 1 clang-tidy -p build/dev --quiet --extra-arg=-Wno-unknown-warning-option \
      2> >(grep -v '^[0-9]* warnings\? generated\.$' >&2) |
    tee "$log" || tidy_faults=1
fi

# A header's findings come once for each source that includes it.
findings=$(grep -E '^[^ ]+:[0-9]+:[0-9]+: (error|warning): ' "$log" | sort -u | wc -l || true)
echo "lint.sh: ${#files[@]} files for clang-format, ${#sources[@]} for clang-tidy: $findings findings of clang-tidy," \
  "layout $([ $format_faults -eq 0 ] && echo sound || echo to be mended)"
[ $format_faults -eq 0 ] && [ $tidy_faults -eq 0 ]
