#!/usr/bin/env bash
# scheme_pictures.sh LIMN
# Makes the pictures and tables of docs/schemes.md anew, with the program given.
set -euo pipefail
limn=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p docs/schemes
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
look=(--size 320x280 --light-theme)

# One mesh under every scheme.
for scheme in $("$limn" schemes --json | python3 -c 'import json, sys; print(*(s["name"] for s in json.load(sys.stdin)))'); do
  "$limn" render cube --scheme "$scheme" --fit --levels 3 --show both "${look[@]}" -o "docs/schemes/$scheme.png"
done

# Adaptive Loop.
adaptive=(sphere --paint faces=0-3:=3 --adaptive loop --view iso "${look[@]}")
"$limn" render "${adaptive[@]}" --show control -o docs/schemes/adaptive_painted.png
"$limn" render "${adaptive[@]}" -o docs/schemes/adaptive_refined.png

# The triangulated cube as it was cut, split and flipped; seen from below, along the space diagonal that flipping prefers.
from_diagonal() {  # DISTANCE
  printf '{"target": [0, 0, 0], "distance": %s, "yaw": 225, "pitch": -35.26438968275465, "fov_degrees": 35, "orthographic": false}' "$1"
}
from_diagonal 7.0 > "$scratch/cubes.json"
from_diagonal 4.9 > "$scratch/surfaces.json"
cp assets/meshes/cube_triangulated.obj "$scratch/cut.obj"
for by in split flip flip-alternately; do
  "$limn" symmetrise cube_triangulated --by "$by" -o "$scratch/$by.obj"
done
for cube in cut split flip flip-alternately; do
  "$limn" render "$scratch/$cube.obj" --show control --camera "$scratch/cubes.json" "${look[@]}" -o "docs/schemes/cube_$cube.png"
  "$limn" render "$scratch/$cube.obj" --scheme loop --levels 4 --camera "$scratch/surfaces.json" "${look[@]}" \
    -o "docs/schemes/cube_${cube}_loop.png"
done

# The tables, between the marks that name them.
"$limn" compare sphere --json > "$scratch/sphere.json"
"$limn" compare sphere cube --scheme all --json > "$scratch/schemes.json"
python3 - docs/schemes.md "$scratch" <<'PYTHON'
import json
import re
import sys

page, scratch = sys.argv[1:]


def table(head, rows):
    # Words to the left, numbers to the right.
    rule = ["--:" if cell[-1:].isdigit() or cell.endswith("%") else "---" for cell in rows[0]]
    lines = [head, rule] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def errors(fit):
    radius = fit["radius"]
    percent = [round(100 * fit[key] / radius, 2) for key in ("least", "greatest")]
    percent = [f"{value:+.2f} %" if value else "0" for value in percent]
    return [f"{radius:.5f}", *percent, f"{100 * fit['root_mean_square'] / radius:.3f} %"]


def load(name):
    with open(f"{scratch}/{name}.json") as file:
        return json.load(file)


sphere = [[run["mesh"], run["weights"], str(level["level"]), f"{level['vertices']:,}",
           f"{level['faces']:,}", *errors(level)]
          for run in load("sphere") for level in run["levels"]]
schemes = [[run["scheme"] + (", Warren's weights" if run.get("weights") == "warren" else "")
            + (", averaged" if run.get("averaged") else ""),
            "made to fit" if run["fitted"] else "", f"{run['levels'][-1]['faces']:,}",
            *errors(run["levels"][-1])]
           for run in load("schemes")]
tables = {
    "sphere": table(["mesh", "weights", "level", "vertices", "faces", "radius", "least", "greatest",
                     "r.m.s."], sphere),
    "schemes": table(["scheme", "", "faces", "radius", "least", "greatest", "r.m.s."], schemes),
}
with open(page) as file:
    text = file.read()
for name, made in tables.items():
    text, count = re.subn(rf"(<!-- {name} -->\n).*?(<!-- end -->)",
                          lambda marks: marks[1] + made + "\n" + marks[2], text, flags=re.S)
    assert count == 1, name
with open(page, "w") as file:
    file.write(text)
PYTHON
ls -l docs/schemes
