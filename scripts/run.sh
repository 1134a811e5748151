#!/usr/bin/env bash
# run.sh [MESH]
# Everything from a fresh Debian 12 to the open program. Without a display it paints and subdivides
# the mesh headless and says where the pictures, the mesh and the numbers are.
set -euo pipefail
start=$PWD
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/scripts/install-packages.sh" program
options=()
[ -f "$root/build/release/build.ninja" ] || options=(-DLIMN_BUILD_TESTS=OFF)
"$root/scripts/build.sh" release "${options[@]}" limn
limn=$root/build/release/bin/limn

mesh=${1:-creature}
if [ -n "${DISPLAY:-}" ]; then
  exec "$limn" "$mesh"
fi

name=$(basename "${mesh%.*}")
out=$start/limn-$name
mkdir -p "$out"
# What an artist might paint first: one level everywhere, one more on what the camera sees, one
# more along sharp edges.
rules=(--paint all:+1 --paint visible:+1 --paint 'dihedral>35:+1')
echo "No display (DISPLAY is not set): painting and subdividing $mesh without a window."
"$limn" render "$mesh" "${rules[@]}" --show control --wireframe --legend -o "$out/painted.png"
"$limn" render "$mesh" "${rules[@]}" --show refined --wireframe --legend -o "$out/refined.png"
"$limn" refine "$mesh" "${rules[@]}" --json -o "$out/refined.obj" > "$out/numbers.json"
echo "The painted control mesh:  $out/painted.png"
echo "The refined mesh:          $out/refined.png and $out/refined.obj"
echo "The numbers:               $out/numbers.json"
cat "$out/numbers.json"
