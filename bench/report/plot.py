"""The plot: rates and memory of uniform refinement as bars, the cost of paintings as lines.

An SVG by hand, in the reader's light or dark colours.
"""

from html import escape

from names import LAYOUTS, MAIN, PROGRAMS, beside_painting

WIDTH = 960
MARGIN = 24
LABELS = 330  # Width of the column of names beside bars.
BAR = 20
ROW = 28

STYLE = """
  text { font: 13px system-ui, 'Segoe UI', 'Inter', 'DejaVu Sans', sans-serif; fill: #24292f; }
  .title { font-size: 15px; font-weight: 600; }
  .faint { fill: #59636e; }
  .grid { stroke: #d1d9e0; stroke-width: 1; }
  .one { stroke: #59636e; stroke-width: 1.5; stroke-dasharray: 4 3; }
  .limn { fill: #d9820f; }
  .peer { fill: #8c99a8; }
  .line { fill: none; stroke-width: 2.5; stroke-linejoin: round; stroke-linecap: round; }
  .paper { fill: #ffffff; }
  .s0 { stroke: #b85c00; } .s1 { stroke: #e39a2d; } .s2 { stroke: #b5a300; }
  .s3 { stroke: #14559c; } .s4 { stroke: #3d8bd6; } .s5 { stroke: #2aa198; }
  .d0 { fill: #b85c00; } .d1 { fill: #e39a2d; } .d2 { fill: #b5a300; }
  .d3 { fill: #14559c; } .d4 { fill: #3d8bd6; } .d5 { fill: #2aa198; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6edf3; }
    .faint { fill: #9198a1; }
    .grid { stroke: #3d444d; }
    .one { stroke: #9198a1; }
    .limn { fill: #f5a623; }
    .peer { fill: #6e7b8b; }
    .paper { fill: #0d1117; }
    .s0 { stroke: #ff9f43; } .s1 { stroke: #ffc46b; } .s2 { stroke: #e6db74; }
    .s3 { stroke: #58a6ff; } .s4 { stroke: #9ecbff; } .s5 { stroke: #56d4c8; }
    .d0 { fill: #ff9f43; } .d1 { fill: #ffc46b; } .d2 { fill: #e6db74; }
    .d3 { fill: #58a6ff; } .d4 { fill: #9ecbff; } .d5 { fill: #56d4c8; }
  }
"""


def plot(results):
    parts = []
    y = MARGIN
    for title, rows in ((rate_title(results), rates(results)),
                        ("Peak memory, bytes an output face", memory(results))):
        if rows:
            y = bars(parts, y, title, rows)
    y = paintings(parts, y, results)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {y}" width="{WIDTH}" '
            f'height="{y}" role="img" aria-label="Limn and its peers">\n<style>{STYLE}</style>\n'
            f'<rect class="paper" width="{WIDTH}" height="{y}" rx="8"/>\n'
            + "\n".join(parts) + "\n</svg>\n")


def text(x, y, words, kind="", anchor="start"):
    return f'<text x="{x:.1f}" y="{y:.1f}" class="{kind}" text-anchor="{anchor}">{escape(words)}</text>'


def line(x1, y1, x2, y2, kind):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" class="{kind}"/>'


def rate_title(results):
    peer = results.get("uniform", *MAIN, "opensubdiv")
    faces = f" to {peer.counters['faces'] / 1e6:.1f} million faces" if peer else ""
    return f"Uniform refinement{faces}, million faces a second"


def rates(results):
    """(name, is Limn, value, note) of each bar."""
    peer = results.get("uniform", *MAIN, "opensubdiv")
    cases = [(name, results.get("uniform", *MAIN, name)) for name in PROGRAMS]
    return [(PROGRAMS[name], name.startswith("limn"), case.faces_per_second / 1e6,
             f"{peer.seconds / case.seconds:.1f}×" if peer else "")
            for name, case in cases if case]


def memory(results):
    cases = [(name, results.get("memory", *MAIN, name)) for name in PROGRAMS]
    return [(PROGRAMS[name], name.startswith("limn"), case.peak_per_face, "")
            for name, case in cases if case]


def bars(parts, y, title, rows):
    """Horizontal bars under a title; returns where they end."""
    parts.append(text(MARGIN, y + 14, title, "title"))
    y += 30
    left = MARGIN + LABELS
    scale = (WIDTH - left - 130) / max(value for _, _, value, _ in rows)
    for name, is_limn, value, note in rows:
        parts.append(text(left - 12, y + BAR - 5, name, anchor="end"))
        parts.append(f'<rect x="{left}" y="{y}" width="{max(value * scale, 1):.1f}" height="{BAR}" '
                     f'rx="3" class="{"limn" if is_limn else "peer"}"/>')
        number = f"{value:.0f}" if value >= 100 else f"{value:.1f}"
        parts.append(text(left + value * scale + 8, y + BAR - 5, number))
        if note:
            parts.append(text(WIDTH - MARGIN, y + BAR - 5, note, "faint", "end"))
        y += ROW
    if any(note for *_, note in rows):
        parts.append(text(WIDTH - MARGIN, y - ROW * len(rows) - 16, "OpenSubdiv Far = 1", "faint",
                          "end"))
    return y + 24


def series(results):
    """(name, [(depth, cost beside uniform)]) of each line."""
    found = []
    for layout, words in LAYOUTS.items():
        cases = [case for case in results.group("adaptive", layout) if case.path[4] == "limn"]
        for percent in sorted({int(case.path[2]) for case in cases}):
            points = [(int(case.path[3]),
                       case.nanoseconds_per_face / uniform.nanoseconds_per_face)
                      for case in cases if int(case.path[2]) == percent
                      and (uniform := beside_painting(results, case.path[3], "limn"))]
            found.append((f"{percent} % {words}", sorted(points)))
    return [(name, points) for name, points in found if points]


def paintings(parts, y, results):
    lines = series(results)
    if not lines:
        return y
    parts.append(text(MARGIN, y + 14, "Paintings of 245,760 quads: time an output face, uniform "
                      "refinement of the same mesh = 1", "title"))
    y += 38
    left, right, height = MARGIN + 40, WIDTH - 230, 200
    depths = sorted({depth for _, points in lines for depth, _ in points})
    top = max(1.6, max(cost for _, points in lines for _, cost in points) * 1.08)

    def across(depth):
        return left + 30 + (depth - depths[0]) * (right - left - 60) / max(depths[-1] - depths[0], 1)

    def up(cost):
        return y + height - cost / top * height

    step = 0.5 if top <= 3 else 1.0
    for i in range(int(top / step) + 1):
        kind = "one" if i * step == 1 else "grid"
        parts.append(line(left, up(i * step), right, up(i * step), kind))
        parts.append(text(left - 8, up(i * step) + 4, f"{i * step:.1f}", "faint", "end"))
    for depth in depths:
        parts.append(text(across(depth), y + height + 20, str(depth), "faint", "middle"))
    parts.append(text((left + right) / 2, y + height + 40, "painted depth", "faint", "middle"))
    for i, (name, points) in enumerate(lines):
        path = " L".join(f"{across(depth):.1f} {up(cost):.1f}" for depth, cost in points)
        parts.append(f'<path d="M{path}" class="line s{i}"/>')
        parts += [f'<circle cx="{across(depth):.1f}" cy="{up(cost):.1f}" r="4" class="d{i}"/>'
                  for depth, cost in points]
        key = y + 8 + i * 24
        parts.append(f'<path d="M{right + 20} {key}h22" class="line s{i}"/>')
        parts.append(text(right + 50, key + 4, name))
    return y + height + 40 + MARGIN
