"""The page of the face table: what was tried, and of that the fewest faces for each distance."""

from math import exp, log

from page import table

FIGURES = {"greatest": "greatest", "rms": "r.m.s."}
BUDGETS = {"greatest": "budget_greatest", "rms": "budget_rms"}
# Ratios from which on it is said to pay, and below which to be behind.
PAYS = 1.1
BEHIND = 0.98


def fewest(trials, figure, target):
    """The fewest faces that keep to a target; None where none do."""
    return min((trial["faces"] for trial in trials if trial[figure] <= target), default=None)


def geometric_mean(values):
    return exp(sum(log(value) for value in values) / len(values))


class Row:
    """A mesh against its uniform refinement with vertices at `points`: faces at its distance."""

    def __init__(self, mesh, figure, points):
        uniform = mesh[f"uniform_{points}"][mesh["level"]]
        self.mesh = mesh
        self.target = uniform[figure]
        self.uniform = uniform["faces"]
        self.at_level = fewest(mesh["tolerance_level"], figure, self.target)
        self.at_limit = fewest(mesh["tolerance_limit"], figure, self.target)
        self.budget = fewest(mesh[BUDGETS[figure]], figure, self.target)
        self.measured = (fewest(mesh["measured_limit"], figure, self.target)
                         if figure == "greatest" else None)
        self.alike = self.at_level if points == "level" else self.at_limit
        self.best = min(filter(None, [self.at_level if points == "level" else None, self.at_limit,
                                      self.measured, self.budget]), default=None)

    @property
    def has_curvature(self):
        """Whether there is anything to be refined for."""
        return self.target > 1e-9

    def ratio(self, faces):
        return self.uniform / faces if faces else None


def rows(meshes, figure, points):
    return [row for row in (Row(mesh, figure, points) for mesh in meshes) if row.has_curvature]


def page(results):
    meshes = results["meshes"]
    sections = [opening(meshes)]
    for figure in FIGURES:
        sections.append(section(meshes, figure))
    sections += [asked(meshes), small(results["small"]), method(meshes)]
    return "\n\n".join(text for text in sections if text) + "\n"


def sentence(ratios):
    return (f"{geometric_mean(ratios):.1f} in the geometric mean of {len(ratios)} meshes "
            f"({min(ratios):.1f} to {max(ratios):.1f})")


def summary(meshes):
    """The headline, for the README."""
    level, limit = ([row.ratio(row.measured) for row in rows(meshes, "greatest", points)
                     if row.measured] for points in ("level", "limit"))
    return (f"At the same measured greatest distance to the limit surface a uniform mesh has this "
            f"many times the faces of one by a tolerance that is measured while depths are chosen: "
            f"{sentence(level)} where it is as subdividing leaves it, {sentence(limit)} where its "
            f"vertices are put on the limit surface too.")


def names(found):
    return ", ".join(f"`{row.mesh['name']}` ({row.ratio(row.best):.2f})" for row in found)


def behind_on(found):
    """What is said of meshes where uniform ones have fewer faces."""
    if not found:
        return "None of them takes more than the uniform mesh."
    return f"They are behind on {names(found)}."


def opening(meshes):
    found = sorted(rows(meshes, "greatest", "limit"), key=lambda row: -row.ratio(row.best or 1))
    found = [row for row in found if row.best]
    pays = [row for row in found if row.ratio(row.best) >= PAYS]
    behind = [row for row in found if row.ratio(row.best) < BEHIND]
    rest = [row for row in found if BEHIND <= row.ratio(row.best) < PAYS]
    return f"""# Faces for the same distance

How many faces a mesh needs to be as near to its limit surface as a uniform one, measured for all of them in the same way. Written by `scripts/faces.sh`, with the plots. [That tolerances are kept](tolerances.md) was tried on many more meshes.

{summary(meshes)}

So depths by themselves pay where detail is uneven. With both on the limit surface: {names(pays)}. Where every face needs about the same there is little to be had: {names(rest)}.
{behind_on(behind)} (In brackets: the uniform mesh's faces over those of the best of Limn's.) Without measuring, depths go by estimates, at once, and cost more: beside semi-sharp creases and on uneven
triangles far more error is expected than is then found. None of this is about painting by intent, where what shall stay coarse does.

![Greatest distance against faces](faces.svg)"""


def number(value):
    return f"{value:,}" if value else "-"


def ratio(value):
    return f"{value:.2f}×" if value else "-"


def distance(value):
    return f"{1e3 * value:.3g}"


def patches(mesh):
    last = mesh["patches"][-1] if mesh["patches"] else None
    return f"{last['patches']:,} ({last['isolation']})" if last else "-"


def means(found, columns):
    """The last line: geometric means of ratios."""
    cells = []
    for what in columns:
        values = [row.ratio(what(row)) for row in found if what(row)]
        cells.append(f"**{geometric_mean(values):.2f}×**" if values else "")
    return cells


def section(meshes, figure):
    word = FIGURES[figure]
    limit = rows(meshes, figure, "limit")
    level = rows(meshes, figure, "level")
    is_greatest = figure == "greatest"
    limit_lines = [[f"`{row.mesh['name']}`", number(row.mesh["faces"]), str(row.mesh["level"]),
                    distance(row.target), number(row.uniform)] +
                   ([number(row.measured), ratio(row.ratio(row.measured))] if is_greatest else []) +
                   [number(row.at_limit), ratio(row.ratio(row.at_limit)), number(row.budget),
                    ratio(row.ratio(row.budget))] + ([patches(row.mesh)] if is_greatest else [])
                   for row in limit]
    mean = means(limit, [lambda row: row.measured, lambda row: row.at_limit,
                         lambda row: row.budget])
    limit_lines.append(["geometric mean", "", "", "", ""] + (["", mean[0]] if is_greatest else []) +
                       ["", mean[1], "", mean[2]] + ([""] if is_greatest else []))
    level_lines = [[f"`{row.mesh['name']}`", number(row.mesh["faces"]), str(row.mesh["level"]),
                    distance(row.target), number(row.uniform), number(row.at_level),
                    ratio(row.ratio(row.at_level)), number(row.measured),
                    ratio(row.ratio(row.measured)), number(row.at_limit),
                    ratio(row.ratio(row.at_limit)), number(row.budget),
                    ratio(row.ratio(row.budget))] for row in level]
    mean = means(level, [lambda row: row.at_level, lambda row: row.measured,
                         lambda row: row.at_limit, lambda row: row.budget])
    level_lines.append(["geometric mean", "", "", "", "", "", mean[0], "", mean[1], "", mean[2],
                        "", mean[3]])
    head = ["mesh", "its faces", "levels", "distance, d / 1000", "uniform"]
    limit_head = head + (["by tolerance, measured", "fewer"] if is_greatest else []) + [
        "by tolerance", "fewer", "by budget", "fewer"]
    if is_greatest:
        limit_head.append("OpenSubdiv's patches (levels isolated)")
    level_head = head + ["by tolerance, level", "fewer", "measured, limit", "fewer",
                         "by tolerance, limit", "fewer", "by budget, limit", "fewer"]
    words = {"greatest": "Patches are no faces: a GPU cuts each into triangles when it draws, as "
                         "finely as it is told to. They are those with which OpenSubdiv's feature-"
                         "adaptive surface itself is as near to the limit.",
             "rms": "A tolerance is meant for the greatest distance; here its mean is held to that "
                    "of the uniform mesh. The budget spends its faces on the mean.\n\n"
                    "![R.m.s. distance against faces](faces_rms.svg)"}
    against_level = f"""

Against the uniform mesh that subdividing leaves, with vertices where the last level has them; by tolerance the same (*level*) or on the limit surface (*limit*), which is what `limn` chooses where
depths come from a tolerance or a budget:

{table(level_head, level_lines)}"""
    return f"""## At the same {word} distance

Both with vertices on the limit surface. *Levels* are those of the uniform mesh, and the distance is what it reaches, in thousandths of the diagonal. {words[figure]}

{table(limit_head, limit_lines)}{against_level if figure == "greatest" else ""}"""


def asked(meshes):
    """At a distance that is asked for: uniform meshes have whole levels only."""
    lines, ratios = [], []
    for mesh in meshes:
        found = mesh["asked_tolerance"]
        uniform = fewest(mesh["uniform_limit"], "greatest", found["asked"])
        if not uniform or found["greatest"] < 1e-9:
            continue
        measured = mesh["asked_measured"]
        ratios.append((uniform / measured["faces"], uniform / found["faces"]))
        lines.append([f"`{mesh['name']}`", number(mesh["faces"]), number(uniform),
                      number(measured["faces"]), distance(measured["greatest"]),
                      ratio(ratios[-1][0]), number(found["faces"]), distance(found["greatest"]),
                      ratio(ratios[-1][1])])
    if not lines:
        return ""
    mean = [f"**{geometric_mean(column):.2f}×**" for column in zip(*ratios)]
    lines.append(["geometric mean", "", "", "", "", mean[0], "", "", mean[1]])
    value = meshes[0]["asked_tolerance"]["asked"]
    return f"""## At a distance that is asked for

A uniform mesh has whole levels only. Here somebody asks for {1e3 * value:g} thousandth of the diagonal: the least uniform mesh that keeps to it, and `tolerance={value:g}d` as it is, measured while choosing and
not. Both on the limit surface; left out are meshes whose uniform refinement to that distance was too large to measure.

{table(["mesh", "its faces", "uniform", "measured", "its distance, d / 1000", "fewer", "by tolerance", "its distance, d / 1000", "fewer"], lines)}"""


def small(meshes):
    lines = []
    gaps = {"tolerance": [], "budget": []}
    for mesh in meshes:
        for target in mesh["targets"]:
            optimum = target["optimum"]["faces"]
            cells = []
            for method, found in gaps.items():
                faces = fewest(target[method], "greatest", target["target"])
                cells += [number(faces), f"{100 * (faces / optimum - 1):.0f} %" if faces else "-"]
                if faces:
                    found.append(faces / optimum)
            lines.append([mesh["name"], str(mesh["faces"]), distance(target["target"]),
                          number(target["uniform"]), number(optimum), *cells])
    if not lines:
        return ""
    lines.append(["geometric mean", "", "", "", ""] +
                 [cell for found in gaps.values()
                  for cell in ("", f"{100 * (geometric_mean(found) - 1):.0f} %")])
    return f"""## Against the optimum

Meshes so small that all their paintings with depths of 0 to 3 can be tried: each is legalised, counted and, in the order of faces, measured until one keeps to the distance. On the limit surface;
*uniform* is the least uniform mesh that keeps to it.

{table(["mesh", "its faces", "distance, d / 1000", "uniform", "optimum", "by tolerance", "more than the optimum", "by budget", "more"], lines)}"""


def method(meshes):
    sources = sorted({mesh["source"] for mesh in meshes if mesh["source"] != "bundled"})
    others = (f"The others were at hand on the machine that measured ({', '.join(sources)}) and are "
              f"no part of Limn." if sources else "")
    return f"""## How it is measured

- Distances are Hausdorff distances between the refined mesh, as triangles, and the Catmull-Clark limit surface with creases and boundary, in both directions, sampled until twice as many samples
  change them by less than a fiftieth or a million have been taken (as `limn compare --to limit` does, which goes on for longer). The r.m.s. is over the areas of both.
- The uniform mesh has as many levels as stay below 26,000 faces, four at the most. Its measured distance is the target. The tolerance and the budget that reach it are sought by trying five of
  each or less, and of measured tolerances only the target itself; counted is the mesh with the fewest faces that was measured to be no further off than the target. A dash: none of these was near enough; means leave it out.
- All settings are those that `limn` starts with: look-ahead legalisation and, on meshes with faces that are no quads, a uniform first step.
- Patches: OpenSubdiv's tables with Gregory end caps and infinitely sharp patches, isolated level by level until the greatest distance at equal parameters, in 81 places of every quad, from a
  table with nine levels is within the same distance.
- The bundled meshes come with Limn. {others}
- The same run gives the same figures on any machine: nothing here is a time."""
