"""What cases are called in tables and plots, in the order they are shown."""

PROGRAMS = {
    "limn": "Limn",
    "limn_retained": "Limn, into a retained result",
    "limn_2_threads": "Limn, 2 threads",
    "limn_retained_2_threads": "Limn, into a retained result, 2 threads",
    "limn_small_pages": "Limn, 4 KiB pages",
    "opensubdiv": "OpenSubdiv Far",
    "opensubdiv_kept_memory": "OpenSubdiv Far, memory kept by the allocator",
    "opensubdiv_huge_pages": "OpenSubdiv Far, 2 MiB pages",
    "openmesh": "OpenMesh CatmullClarkT",
    "cgal": "CGAL CatmullClark_subdivision",
}

LOOP_PROGRAMS = {
    "limn": "Limn",
    "limn_2_threads": "Limn, 2 threads",
    "opensubdiv": "OpenSubdiv Far",
    "openmesh": "OpenMesh LoopT",
    "cgal": "CGAL Loop_subdivision",
}

BOUNDS = {
    "fill": "fill memory touched before",
    "copy": "copy (`memcpy`) memory touched before",
    "first_touch_2_mib": "fill fresh memory, 2 MiB pages",
    "first_touch_4_kib": "fill fresh memory, 4 KiB pages",
}

LAYOUTS = {"patches": "in twelve patches", "scattered": "scattered"}

WISHES = {
    "level": "positions of the level",
    "level_and_normals": "and limit normals",
    "limit": "limit positions",
    "limit_and_normals": "limit positions and normals",
}

CHOICES = {"tolerance": "tolerance of {} diagonals", "budget": "budget of {} faces"}

METHODS = {"greedy": "greedy", "look_ahead": "look-ahead"}

PICKING = {
    "draw": "Draw what is asked, in a picture from a new side",
    "pick": "The face under the pointer, in a still picture",
    "brush_5": "The faces under a stroke of 5 pixels' radius, in a still picture",
    "brush_20": "of 20 pixels",
    "brush_100": "of 100 pixels",
    "visible": "All visible faces, in a still picture",
}

# The mesh that the short tables and the plot are about, and its levels.
MAIN = ("asteroid_15k", 4)
# The mesh of the paintings, and the most levels it is refined uniformly beside them: as deep as they
# are painted where that is less.
PAINTED = ("asteroid_246k", 2)


def beside_painting(results, depth, kind):
    """The uniform case that a painting of that depth is told beside."""
    return results.get("uniform", PAINTED[0], min(int(depth), PAINTED[1]), kind)


def works(results, group="uniform"):
    """(mesh, levels) of all cases of a group, the main one's family first."""
    found = {(case.path[1], int(case.path[2])) for case in results.group(group)}
    return sorted(found, key=lambda work: (not work[0].startswith("asteroid"), work[0] != MAIN[0],
                                           -work[1] if work[0].startswith("asteroid") else 0, work))
