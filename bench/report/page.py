"""The page of tables. A section whose cases were not run is left out."""

from math import log

from names import BOUNDS, CHOICES, LAYOUTS, LOOP_PROGRAMS, MAIN, METHODS, PAINTED, PICKING, PROGRAMS, \
    WISHES, beside_painting, works


def page(results):
    sections = [opening, at_a_glance, uniform, loop, memory, adaptive, limit, cracks, choosing, legalisation,
                machine_bounds, others, picking, agreement, not_measured, method]
    texts = [section(results) for section in sections]
    return "\n\n".join(text for text in texts if text) + "\n"


def table(head, rows, words=1):
    """Markdown; all columns but the first `words` to the right."""
    lines = [head, ["---"] * words + ["---:"] * (len(head) - words)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def times(factor):
    """A ratio that is better the larger it is; what is below 1 is said aloud."""
    digits = 0 if factor >= 10 else 1 if factor >= 1 else 2
    text = f"{factor:.{digits}f}×"
    return text if factor >= 0.995 else f"**{text} (behind)**"


def milliseconds(case):
    low, high = (1e3 * bound(case.times) for bound in (min, max))
    return f"{1e3 * case.seconds:.1f} ({low:.1f} to {high:.1f})"


def millions(number):
    return f"{number / 1e6:.2f}"


def opening(results):
    machine = results.machine
    return f"""# Performance

Limn and its peers, measured by `scripts/bench.sh` in one run of one program on the same meshes, and written by it. Read the ratios: they carry over to other machines better
than times do. How it was measured stands [at the end](#how-it-is-measured).

| | |
|---|---|
| Processor | {machine["processor"]} (family {machine["processor_family"]}), {machine["cores"]} cores |
| Memory | {machine["memory"]}, transparent huge pages: {chosen(machine["huge_pages"])} |
| System | {machine["system"]} |
| GPU | {gpu(results)} |
| Others on the machine | took {others_share(results)} of the time |
| Compiler | {machine["compiler"]}, release build |
| Peers | OpenSubdiv {machine["opensubdiv"]}, OpenMesh {machine["openmesh"]}, CGAL {machine["cgal"]}, from Debian 12 |
| Date | {machine["date"][:10]} |"""


def others_share(results):
    """How much of the time of runs on one thread that thread had no processor."""
    cases = [case for case in results.group("uniform") if "_threads" not in case.path[3]]
    total = sum(sum(case.times) for case in cases)
    own = sum(sum(case.processor_times) for case in cases)
    return f"{100 * (1 - own / total):.0f} %" if total else "an unknown part"


def chosen(setting):
    """The word in brackets of a kernel setting."""
    return setting[setting.find("[") + 1:setting.find("]")] if "[" in setting else setting


def gpu(results):
    labels = {case.label for case in results.group("picking") if case.label}
    if not labels:
        return "none used"
    return ", ".join("none (Mesa llvmpipe)" if "llvmpipe" in label else label
                     for label in sorted(labels))


def at_a_glance(results):
    peer = results.get("uniform", *MAIN, "opensubdiv")
    if not peer:
        return ""
    rows = []
    for name, text in PROGRAMS.items():
        case = results.get("uniform", *MAIN, name)
        if case:
            rows.append([text, f"{case.faces_per_second / 1e6:.1f}",
                         times(peer.seconds / case.seconds) if name.startswith("limn")
                         else f"{peer.seconds / case.seconds:.2f}×"])
    return f"""## At a glance

{thousands(results, MAIN[0])} quads refined uniformly {MAIN[1]} times, to {peer.counters["faces"]:,.0f}; one thread where nothing else is said.
{summary(results)}

{table(["", "million faces a second", "OpenSubdiv Far's rate"], rows)}

![Rates, memory and the cost of paintings](performance.svg)"""


def summary(results):
    """One sentence of ratios, for the README."""
    peer, ours, again = (results.get("uniform", *MAIN, name)
                         for name in ("opensubdiv", "limn", "limn_retained"))
    peaks = [results.get("memory", *MAIN, name) for name in ("limn", "opensubdiv")]
    if not (peer and ours and again and all(peaks)):
        return ""
    return (f"On one thread Limn refines a closed quad mesh uniformly "
            f"{peer.seconds / ours.seconds:.1f} times as fast as OpenSubdiv Far, "
            f"{peer.seconds / again.seconds:.0f} times where it refines again into a result it has, in "
            f"{100 * peaks[0].peak_per_face / peaks[1].peak_per_face:.0f} % of the memory.")


def thousands(results, mesh):
    case = next(case for case in results.group("uniform", mesh))
    return f"{case.counters['faces'] / 4 ** int(case.path[2]):,.0f}"


def rates(results, group, programs):
    """The table of all programs on all meshes; empty where nothing was run."""
    rows = []
    for mesh, levels in works(results, group):
        peer = results.get(group, mesh, levels, "opensubdiv")
        first = True
        for name, text in programs.items():
            case = results.get(group, mesh, levels, name)
            if not case:
                continue
            what = f"`{mesh}`, {levels} levels, {millions(case.counters['faces'])} M faces"
            rows.append([what if first else "", text, milliseconds(case),
                         f"{case.faces_per_second / 1e6:.2f}",
                         times(peer.seconds / case.seconds) if peer and name.startswith("limn")
                         else ""])
            first = False
    head = ["mesh", "program", "ms: median (least to most)", "M faces/s", "against OpenSubdiv"]
    return table(head, rows, words=2) if rows else ""


def uniform(results):
    found = rates(results, "uniform", PROGRAMS)
    return found and f"""## Uniform refinement

Topology and positions of all levels, in single precision, from the control mesh in each program's own form. The programs start without memory for the result, which they take from
the system while the clock runs, unless it is said that they keep it.

{found}{allocations(results)}"""


def loop(results):
    found = rates(results, "loop", LOOP_PROGRAMS)
    return found and f"""## Loop's scheme

The same of triangle meshes by Loop's scheme, all memory fresh. Limn computes in double precision from level to level here.

{found}"""


def allocations(results):
    counts = {name: max((case.counters["allocations"] for case in results.group("uniform")
                         if case.path[3] == name), default=None)
              for name in ("limn_retained", "limn", "opensubdiv")}
    if None in counts.values():
        return ""
    return f"""

A refinement by Limn asks for memory {counts["limn"]:.0f} times at most, into a retained result {counts["limn_retained"]:.0f} times; by OpenSubdiv {counts["opensubdiv"]:.0f} times."""


def memory(results):
    measured = [case for case in results.group("memory") if case.path[1] not in LAYOUTS]
    programs = [name for name in PROGRAMS if any(case.path[3] == name for case in measured)]
    rows = []
    for mesh, levels in sorted({(case.path[1], case.path[2]) for case in measured},
                               key=lambda work: -int(work[1])):
        cases = [results.get("memory", mesh, levels, name) for name in programs]
        rows.append([f"`{mesh}`, {levels} levels"] +
                    [f"{case.peak_per_face:.0f}" if case else "" for case in cases])
    if not rows:
        return ""
    return f"""## Memory

Peak bytes an output face, over what the process held before: its resident set as the kernel counts it, in a process of its own. What the program keeps of the control mesh
counts for no one.

{table(["mesh"] + [PROGRAMS[name].split()[0] for name in programs], rows)}"""


def adaptive(results):
    kinds = ("limn", "limn_retained")
    rows = []
    for case in results.group("adaptive"):
        layout, percent, depth, kind = case.path[1:]
        both = [results.get("adaptive", layout, percent, depth, kind) for kind in kinds]
        reference = [beside_painting(results, depth, kind) for kind in kinds]
        if kind != kinds[0] or not all(both + reference):
            continue
        peak = results.get("memory", layout, percent, depth, kind)
        costs = [[milliseconds(case), f"{case.nanoseconds_per_face:.1f}",
                  f"{case.nanoseconds_per_face / uniform.nanoseconds_per_face:.2f}"]
                 for case, uniform in zip(both, reference)]
        rows.append([f"{percent} %, {LAYOUTS[layout]}", depth,
                     millions(case.counters["faces"]), *costs[0], *costs[1],
                     f"{peak.peak_per_face:.0f}" if peak else ""])
    if not rows:
        return ""
    uniforms = [beside_painting(results, levels, kinds[1]) for levels in (1, PAINTED[1])]
    uniform_ns = [f"{case.nanoseconds_per_face:.1f}" if case else "-" for case in uniforms]
    costs = ["ns a face", "uniform = 1"]
    head = ["painted", "depth", "M faces", "fresh: ms", *costs, "retained: ms", *costs,
            "peak bytes a face"]
    return f"""## Paintings

`{PAINTED[0]}` painted in part, from legal labels to the refined mesh, one thread, into fresh memory and into a retained result. *Uniform = 1* is the time an output face beside that of uniform
refinement of the same mesh as deep as it is painted, or by {PAINTED[1]} levels where it is painted deeper: 1 says that the cost follows the output. Faces that are not painted are part of it.
(Into a retained result one level takes {uniform_ns[0]} ns a face, two levels {uniform_ns[1]}.) Memory is
measured where the painting is deepest.

{table(head, rows)}"""


def machine_bounds(results):
    rates = {}
    for case in results.group("bounds"):
        rates[case.path[1], case.path[2]] = case.counters["written_bytes"] / case.seconds / 1e9
    if not rates:
        return ""
    rows = [[text[0].upper() + text[1:], "",
             *(f"{rates[kind, threads]:.1f}" if (kind, threads) in rates else ""
               for threads in "12")]
            for kind, text in BOUNDS.items()]
    for one, two in (("limn", "limn_2_threads"), ("limn_retained", "limn_retained_2_threads")):
        cases = [results.get("uniform", *MAIN, name) for name in (one, two)]
        if any(cases):
            size = next(case for case in cases if case).counters
            rows.append([f"{PROGRAMS[one]}: the refined mesh",
                         f"{size['result_bytes'] / size['faces']:.0f}",
                         *(f"{case.counters['result_bytes'] / case.seconds / 1e9:.1f}"
                           if case else "" for case in cases)])
    return f"""## Against the machine

Gigabytes written a second. A refinement can be no faster than its result is written.

{table(["", "bytes a face", "1 thread", "2 threads"], rows)}"""


def picking(results):
    cases = [(text, results.get("picking", question)) for question, text in PICKING.items()]
    rows = [[text, f"{1e3 * case.seconds:.3g}"] for text, case in cases if case]
    if not rows:
        return ""
    faces = max(case.counters["faces"] for _, case in cases if case)
    return f"""## Picking

Questions about a picture of {faces:,.0f} quads, 1024 by 1024 pixels, answered by OpenGL: {gpu(results)}.

{table(["", "ms"], rows)}"""


def cracks(results):
    rows = []
    for case in results.group("cracks"):
        *what, kind = case.path[1:]
        if kind != "limn_retained":
            continue
        again = results.get("cracks", *what, "limn_retained_2_threads")
        mesh = (f"`{what[0]}`, {what[1]} levels" if len(what) == 2 else
                f"`{PAINTED[0]}`, {what[1]} %, {LAYOUTS[what[0]]}, {what[2]} deep")
        rows.append([mesh, millions(case.counters["faces"]), milliseconds(case),
                     f"{case.faces_per_second / 1e6:.0f}",
                     f"{again.faces_per_second / 1e6:.0f}" if again else ""])
    if not rows:
        return ""
    return f"""## The crack check

Every edge of a refined mesh is held against its neighbours, with nothing taken for granted of how the mesh was made.

{table(["mesh", "M faces", "ms", "M faces/s", "2 threads"], rows)}"""


def choosing(results):
    rows = []
    for case in results.group("choosing"):
        mesh, choice, kind = case.path[1:]
        again = results.get("choosing", mesh, choice, "refine")
        if kind != "choose" or not again:
            continue
        word, value = choice.split("_")
        share = case.seconds / again.seconds
        rows.append([f"`{mesh}`", CHOICES[word].format(value), millions(again.counters["faces"]),
                     milliseconds(case), milliseconds(again),
                     f"{share:.2f}" if share <= 1.0 else f"**{share:.2f} (behind)**"])
    if not rows:
        return ""
    return f"""## Choosing depths

Depths by themselves, and the refinement that they lead to: labels, legalisation, the refined mesh in memory that is there, and the check for cracks, as the program does it. On all cores.

{table(["mesh", "chosen by", "M faces", "ms to choose", "ms to refine", "choosing / refining"], rows, words=2)}"""


def number(value):
    if value is None:
        return ""
    return f"{value:,.0f}" if value == int(value) else f"{value:.4g}"


def limit(results):
    rows = []
    for mesh, levels in dict.fromkeys((case.path[1], case.path[2])
                                      for case in results.group("limit")):
        plain = results.get("limit", mesh, levels, "level")
        for wish, text in WISHES.items():
            case = results.get("limit", mesh, levels, wish)
            if case and plain:
                rows.append([f"`{mesh}`, {levels} levels" if case is plain else "", text,
                             milliseconds(case), f"{case.nanoseconds_per_face:.1f}",
                             f"{case.seconds / plain.seconds:.2f}"])
    if not rows:
        return ""
    head = ["mesh", "asked for", "ms: median (least to most)", "ns a face", "level = 1"]
    return f"""## The limit

Uniform refinement by Limn into a retained result, one thread, and what limit positions and limit normals of all vertices add to it.

{table(head, rows, words=2)}"""


def legalisation(results):
    rows, growth = [], []
    for method, text in METHODS.items():
        cases = sorted((case for case in results.group("legalise") if case.path[2] == method),
                       key=lambda case: case.counters["illegal"])
        if not cases:
            continue
        rows += [[text if case is cases[0] else "", number(case.counters["illegal"]),
                  milliseconds(case), f"{1e9 * case.seconds / case.counters['illegal']:.0f}",
                  number(case.counters["steps"]), number(case.counters["faces"])]
                 for case in cases]
        if len(cases) > 1:
            few, many = cases[0], cases[-1]
            # Of the least times: others on the machine disturb long cases more than short ones.
            exponent = (log(min(many.times) / min(few.times)) /
                        log(many.counters["illegal"] / few.counters["illegal"]))
            growth.append(f"{text} {exponent:.2f}")
    if not rows:
        return ""
    head = ["method", "illegal vertices", "ms: median (least to most)", "ns an illegal vertex",
            "choices", "faces of the refined mesh"]
    return f"""## Legalisation

Tori of quads of which 5 % are painted at random, one thread. The least time grows with the number of illegal vertices to the power of: {", ".join(growth)}.

{table(head, rows)}"""


def others(results):
    """Groups that have no section of their own: every counter of every case."""
    known = {"uniform", "loop", "memory", "adaptive", "bounds", "picking", "agreement", "legalise", "limit",
             "cracks", "choosing"}
    sections = []
    for group in sorted({case.path[0] for case in results.cases.values()} - known):
        cases = results.group(group)
        counters = sorted({name for case in cases for name in case.counters})
        rows = [["/".join(case.path[1:]), milliseconds(case)] +
                [number(case.counters.get(name)) for name in counters] for case in cases]
        sections.append(f"## {group.capitalize()}\n\n" + table(
            ["", "ms: median (least to most)"] + [name.replace("_", " ") for name in counters],
            rows))
    return "\n\n".join(sections)


def program_of(case):
    names = LOOP_PROGRAMS if case.path[1].endswith("_triangles") else PROGRAMS
    return names[case.path[3]]


def agreement(results):
    rows = [[f"`{case.path[1]}`, {case.path[2]} levels", program_of(case),
             f"{case.counters['distance']:.1e}"] for case in results.group("agreement")]
    if not rows:
        return ""
    return f"""## They compute the same

The largest distance between a vertex of Limn's and the nearest of the peer's, and the other way round, in diagonals of the control mesh. The run fails beyond 1e-5, and wherever a
program's numbers of vertices or faces differ from those of the scheme.

{table(["mesh", "peer", "largest distance"], rows, words=2)}"""


def not_measured(results):
    rows = [f"- `{case.name}`: {case.error}" for case in results.failures()]
    return "\n".join(["## Not measured", ""] + rows) if rows else ""


def method(results):
    del results
    return """## How it is measured

- Every case is run several times; all runs of all cases are made in random order, so that a machine that speeds up or slows down does so for all. Times are medians, ratios are those of medians
  of the same run.
- The asteroids are closed quad meshes of 15,360, 61,440 and 245,760 faces that the program makes itself; one vertex in 32 is extraordinary. The others are Limn's bundled meshes, and
  artists' control meshes where they were at hand. OpenMesh has other rules at boundaries and CGAL is kept to the same meshes, so both are measured on closed ones.
- On the clock is what has to be done for each refinement. Off it is what is done once a control mesh: Limn's flat topology, OpenSubdiv's base level, the copy of the mesh
  that OpenMesh and CGAL then refine in place. So is freeing the result.
- OpenSubdiv is asked for the last level without full topology; positions are interpolated level by level between two buffers. It, OpenMesh and CGAL compute on one thread here, as they come.
- *Fresh* memory: before each run everything freed is given back to the system (`malloc_trim`), and the allocator's thresholds are fixed where glibc's own adjustment would take them. So every
  program pays for its page faults. Limn asks for huge pages, which is part of how it is made; the rows on other pages tell what that is worth, for it and for
  OpenSubdiv.
- Before each run the system is also made to have as much free memory at hand as the program will need: a virtual machine gives free memory back to its host, and whoever takes
  it again first would be charged for that.
- *Kept* memory: one refinement is made before the clock starts. Limn refines into the result it has; for OpenSubdiv, which has no such way, the allocator keeps all memory.
- Run `scripts/bench.sh` again on a quiet machine to measure anew; `scripts/bench.sh --quick` takes a minute and writes nothing here."""
