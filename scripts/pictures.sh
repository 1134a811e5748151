#!/usr/bin/env bash
# pictures.sh
# Makes pictures of the documentation anew: the painted creature and its refinement by `limn render`,
# a screenshot of a classroom's window on a display of its own, and the schemes. scripts/guide.sh
# draws the guide's and the README's window.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program tests
options=()
[ -f build/release/build.ninja ] || options=(-DLIMN_BUILD_TESTS=OFF)
scripts/build.sh release "${options[@]}" limn
limn=$PWD/build/release/bin/limn
mkdir -p docs
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# One level where the face is seen from the front, one along what is bent, one more where it is bent
# sharply: ears, eyes and toes.
"$limn" refine creature --view front --paint visible:+1 --paint 'dihedral>28:+1' \
  --paint 'dihedral>50:+1' -o "$scratch/creature.limn"
"$limn" refine "$scratch/creature.limn" --view three-quarter --size 916x742 -o "$scratch/creature.limn"
look=(--view three-quarter --size 960x720 --light-theme)
"$limn" render "$scratch/creature.limn" "${look[@]}" --show control -o docs/painted.png
"$limn" render "$scratch/creature.limn" "${look[@]}" --show refined -o docs/refined.png
scripts/classroom_picture.py "$limn" docs/classroom.png
scripts/scheme_pictures.sh "$limn"
ls -l docs/*.png
