#!/usr/bin/env bash
# lint.sh [FILE...]
# Checks layout (clang-format) and names and common mistakes (clang-tidy) of the files given, or of all of ours.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program tests developers
scripts/build.sh dev >/dev/null

files=("$@")
[ ${#files[@]} -gt 0 ] || mapfile -t files < <(git ls-files '*.h' '*.cpp')
clang-format --dry-run -Werror "${files[@]}"
printf '%s\n' "${files[@]}" | grep '^\(src\|tests\)/.*\.cpp$' | grep -v '^tests/consumer' |
  xargs -r -P "$(nproc)" -n 4 clang-tidy -p build/dev --quiet 2>/dev/null
