"""Distance against faces, in logarithms, a panel a mesh. An SVG by hand, light or dark."""

from math import ceil, floor, log10

from plot import STYLE, text

WIDTH = 960
COLUMNS = 3
PANEL = (250, 190)
LEFT, TOP, GAP_X, GAP_Y = 66, 96, 58, 74

# The meshes that are shown, where they were measured; others take the places of those that were not.
SHOWN = ["creature", "teapot", "spot_control_mesh", "Bigguy", "Rook", "cow", "mixed", "torus_open",
         "icosahedron"]
PANELS = 6

OWN_STYLE = """
  .series { fill: none; stroke-width: 2.2; stroke-linejoin: round; stroke-linecap: round; }
  .dashed { stroke-dasharray: 6 5; }
  .uniform { stroke: #59636e; } .tolerance { stroke: #c96a00; } .budget { stroke: #1f6fc9; }
  .measured { stroke: #1a7f37; } .measured-dot { fill: #1a7f37; }
  .uniform-dot { fill: #59636e; } .tolerance-dot { fill: #c96a00; } .budget-dot { fill: #1f6fc9; }
  .frame { fill: none; stroke: #d1d9e0; }
  @media (prefers-color-scheme: dark) {
    .uniform { stroke: #9198a1; } .tolerance { stroke: #f5a623; } .budget { stroke: #58a6ff; }
    .measured { stroke: #3fb950; } .measured-dot { fill: #3fb950; }
    .uniform-dot { fill: #9198a1; } .tolerance-dot { fill: #f5a623; } .budget-dot { fill: #58a6ff; }
    .frame { stroke: #3d444d; }
  }
"""

SERIES = [("uniform_level", "uniform dashed", "uniform, positions of the level"),
          ("uniform_limit", "uniform", "uniform, on the limit surface"),
          ("tolerance_level", "tolerance dashed", "by tolerance, positions of the level"),
          ("tolerance_limit", "tolerance", "by tolerance, on the limit surface"),
          ("measured_limit", "measured", "measured, on the limit surface"),
          ("budget", "budget", "by budget, on the limit surface")]


def frontier(trials, figure):
    """(faces, distance) of those trials that none with as few faces is nearer than."""
    points = []
    nearest = float("inf")
    for trial in sorted(trials, key=lambda trial: (trial["faces"], trial[figure])):
        if 1e-9 < trial[figure] < nearest:
            nearest = trial[figure]
            points.append((trial["faces"], nearest))
    return points


def series_of(mesh, figure):
    found = []
    for key, kind, _ in SERIES:
        points = frontier(mesh[f"budget_{figure}" if key == "budget" else key], figure)
        # Below the uniform mesh that has one level nothing is painted yet.
        found.append((kind, [point for point in points if point[1] > 0]))
    return found


def chosen(meshes):
    by_name = {mesh["name"]: mesh for mesh in meshes
               if mesh["uniform_limit"][mesh["level"]]["greatest"] > 1e-9}
    order = [name for name in SHOWN if name in by_name]
    order += [name for name in by_name if name not in order]
    return [by_name[name] for name in order[:PANELS]]


def plot(meshes, figure):
    shown = chosen(meshes)
    width, height = PANEL
    lines = ceil(len(shown) / COLUMNS)
    total = TOP + lines * (height + GAP_Y)
    word = "Greatest" if figure == "greatest" else "R.m.s."
    parts = [text(24, 30, f"{word} distance to the limit surface, in diagonals, against faces",
                  "title")]
    legend(parts)
    for i, mesh in enumerate(shown):
        x = LEFT + i % COLUMNS * (width + GAP_X)
        y = TOP + 22 + i // COLUMNS * (height + GAP_Y)
        panel(parts, x, y, mesh, figure)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {total}" width="{WIDTH}" '
            f'height="{total}" role="img" aria-label="{word} distance against faces">\n'
            f'<style>{STYLE}{OWN_STYLE}</style>\n'
            f'<rect class="paper" width="{WIDTH}" height="{total}" rx="8"/>\n'
            + "\n".join(parts) + "\n</svg>\n")


def legend(parts):
    for i, (_, kind, name) in enumerate(SERIES):
        x = 24 + i % 3 * 306
        y = 54 + i // 3 * 22
        parts.append(f'<path d="M{x} {y}h34" class="series {kind}"/>')
        parts.append(text(x + 44, y + 4, name))


def panel(parts, left, top, mesh, figure):
    width, height = PANEL
    series = series_of(mesh, figure)
    points = [point for _, found in series for point in found]
    low_x, high_x = (log10(bound(point[0] for point in points)) for bound in (min, max))
    low_y, high_y = (log10(bound(point[1] for point in points)) for bound in (min, max))
    low_x, high_x = low_x - 0.08, high_x + 0.08
    low_y, high_y = low_y - 0.12, high_y + 0.12

    def across(faces):
        return left + (log10(faces) - low_x) / (high_x - low_x) * width

    def up(distance):
        return top + height - (log10(distance) - low_y) / (high_y - low_y) * height

    parts.append(text(left, top - 10, f"{mesh['name']}, {mesh['faces']:,} faces"))
    for power in range(floor(low_x), ceil(high_x) + 1):
        for digit in (1, 2, 5):
            value = digit * 10 ** power
            if low_x <= log10(value) <= high_x:
                parts.append(f'<path d="M{across(value):.1f} {top}v{height}" class="grid"/>')
                parts.append(text(across(value), top + height + 17, short(value), "faint", "middle"))
    for power in range(floor(low_y), ceil(high_y) + 1):
        value = 10.0 ** power
        if low_y <= power <= high_y:
            parts.append(f'<path d="M{left} {up(value):.1f}h{width}" class="grid"/>')
            parts.append(text(left - 8, up(value) + 4, f"1e{power}", "faint", "end"))
    parts.append(f'<rect x="{left}" y="{top}" width="{width}" height="{height}" class="frame"/>')
    parts.append(text(left + width / 2, top + height + 36, "faces", "faint", "middle"))
    for kind, found in series:
        if not found:
            continue
        path = " L".join(f"{across(faces):.1f} {up(distance):.1f}" for faces, distance in found)
        parts.append(f'<path d="M{path}" class="series {kind}"/>')
        dot = kind.split()[0]
        if "dashed" not in kind:
            parts += [f'<circle cx="{across(faces):.1f}" cy="{up(distance):.1f}" r="2.6" '
                      f'class="{dot}-dot"/>' for faces, distance in found]


def short(value):
    return f"{value / 1000:.0f}k" if value >= 1000 else str(value)
