#!/usr/bin/env bash
# build.sh PRESET [-DOPTION=VALUE...] [TARGET...]
# Configures a preset of CMakePresets.json where that is needed, with ccache where it is installed,
# and builds it. Options given here stick in the build folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=$1
shift
options=()
targets=()
for word in "$@"; do
  case $word in
    -D*) options+=("$word") ;;
    *) targets+=("$word") ;;
  esac
done

if [ ! -f "build/$preset/build.ninja" ]; then
  if command -v ccache >/dev/null; then
    options+=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  cmake --preset "$preset" --log-level=WARNING "${options[@]}"
elif [ ${#options[@]} -gt 0 ]; then
  cmake --preset "$preset" --log-level=WARNING "${options[@]}" >/dev/null
fi
[ ${#targets[@]} -eq 0 ] || targets=(--target "${targets[@]}")
cmake --build --preset "$preset" "${targets[@]}"
