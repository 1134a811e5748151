#!/usr/bin/env python3
"""The main job with a real pointer: paint, lower, orbit, rules, subdivide, undo, look, save, close.

usage: painting_test.py PROGRAM MESH.obj"""

import json
import os
import sys

from program import Display, Folder, Program, check_replay, count_in
from scene import FaceImage, dihedral_angles, edge_angles, read_obj, read_png

# The palette of the depths, as published: 0 clay, then lighter to darker.
PALETTE = [(0xC8, 0xC4, 0xBD), (0xDB, 0xEF, 0x89), (0x74, 0xDA, 0x93), (0x09, 0xB9, 0xB1),
           (0x07, 0x93, 0xB7), (0x01, 0x70, 0xA9), (0x01, 0x4C, 0x9C), (0x23, 0x26, 0x74)]


def raised(before, after):
    return {f for f, (a, b) in enumerate(zip(before, after)) if b == a + 1}


def longest_row(image):
    """A horizontal way over the surface that meets many faces, as two places in pixels."""
    best = (0, None)
    for row in range(20, image.height - 20, 7):
        ids = image.ids[row * image.width:(row + 1) * image.width]
        covered = [x for x, f in enumerate(ids) if f >= 0]
        if not covered:
            continue
        start, end = covered[0] + 12, covered[-1] - 12
        score = len(set(ids[start:end])) if all(f >= 0 for f in ids[start:end]) else 0
        if score > best[0]:
            best = (score, ((start + 0.5, row + 0.5), (end + 0.5, row + 0.5)))
    assert best[1] is not None and best[0] >= 8, best
    return best[1]


def paint_and_lower(program, image):
    for _ in range(40):
        if program.state["brush_radius"] <= 3.0:
            break
        before = program.state["brush_radius"]
        program.key("bracketleft")
        program.wait_for("the brush is smaller", lambda s: s["brush_radius"] < before)
    radius = program.state["brush_radius"]
    assert radius <= 3.0, radius

    start, end = longest_row(image)
    middle = (round((start[0] + end[0]) / 2) + 0.5, start[1])
    # Two jumps: whatever lies between has to be painted all the same.
    program.drag([image.to_window(p) for p in (start, middle, end)])
    state = program.wait_for("the stroke is painted", lambda s: s["undo"].startswith("paint"))
    painted = {f for f, depth in enumerate(state["depths"]) if depth > 0}
    assert set(state["depths"]) == {0, 1}, "a face changes once a stroke"
    crossed = image.faces_within(start, end, 1.0)
    near = image.faces_within(start, end, radius + 2.0)
    assert crossed <= painted, f"the stroke left out {crossed - painted}"
    assert painted <= near, f"the stroke went astray: {painted - near}"
    assert count_in(state["undo"]) == len(painted)

    program.drag([image.to_window(p) for p in (middle, end)], held="shift")
    state = program.wait_for("a part is lowered", lambda s: sum(s["depths"]) < len(painted))
    state = program.wait_for("the stroke ends", lambda s: not s["redo"] and s["modified"])
    left = {f for f, depth in enumerate(state["depths"]) if depth > 0}
    lowered = painted - left
    assert image.faces_within(middle, end, 1.0) <= lowered
    assert lowered <= image.faces_within(middle, end, radius + 2.0)
    assert left, "only a part was lowered"


def orbit(program, image):
    before = program.state
    x, y = image.to_window((image.width / 2, image.height / 2))
    program.drag([(x, y), (x + 40, y), (x + 90, y + 25)], held="alt")
    state = program.wait_for("the view has turned", lambda s: s["view"] != before["view"])
    assert state["depths"] == before["depths"], "orbiting paints nothing"
    assert state["view"]["distance"] == before["view"]["distance"]
    return state


def raise_visible(program, positions, faces):
    before = program.state
    image = FaceImage(positions, faces, before)
    program.click(*program.item("Raise visible"))
    state = program.wait_for("visible faces are raised",
                             lambda s: s["undo"].startswith("raise visible"))
    got = raised(before["depths"], state["depths"])
    counts = image.counts()
    # A face of one or two pixels at a silhouette may fall to either side of rounding.
    must = {f for f, pixels in enumerate(counts) if pixels > 2}
    may = {f for f, pixels in enumerate(counts) if pixels > 0}
    assert must <= got, f"visible, not raised: {must - got}"
    assert len(got - may) <= 2, f"hidden, but raised: {got - may}"
    assert 0 < len(got) < len(faces)


def raise_sharp(program, positions, faces):
    x, y, width, height = program.state["items"]["Sharpness threshold"]
    before = program.state["dihedral_threshold"]
    place = (x + width * 0.37, y + height / 2)
    program.drag([(x + width * 0.3, y + height / 2), place])
    state = program.wait_for("the threshold is set", lambda s: s["dihedral_threshold"] != before)
    state = program.wait_for("the slider is near where it was let go",
                             lambda s: 60 < s["dihedral_threshold"] < 75)
    program.click(*program.item("Raise sharp"))
    after = program.wait_for("sharp faces are raised", lambda s: s["undo"].startswith("raise sharp"))
    threshold = after["dihedral_threshold"]
    angles = dihedral_angles(positions, faces)
    expected = {f for f, angle in enumerate(angles) if angle > threshold}
    unsure = {f for f, angle in enumerate(angles) if abs(angle - threshold) < 1e-6}
    assert raised(state["depths"], after["depths"]) - unsure == expected - unsure
    assert expected, "some face is sharp"
    return after


def crease_sharp(program, positions, faces):
    """The same threshold creases edges; undone again, since it changes what is drawn."""
    before = program.state
    program.key("shift+j")
    after = program.wait_for("edges are creased", lambda s: s["undo"].startswith("crease edges"))
    threshold = after["dihedral_threshold"]
    angles = [angle for _, angle in edge_angles(positions, faces)]
    assert all(abs(angle - threshold) > 1e-6 for angle in angles)
    expected = sum(angle > threshold for angle in angles)
    assert after["crease_edges"] == expected > 0, (after["crease_edges"], expected)
    assert after["depths"] == before["depths"], "the painting stays"
    program.key("ctrl+z")
    program.wait_for("they are smooth again", lambda s: s["crease_edges"] == 0)


def check_colours(program, positions, faces):
    """Without light, wires and brush the control mesh shows the pure depth colours."""
    program.key("F2")
    program.key("l")
    program.key("w")
    program.move(*program.item("menu: Help"))  # Off the mesh, so that nothing lights up.
    state = program.wait_for("the cursor is off the mesh", lambda s: s["hover"] is None)
    program.key("F12")
    state = program.wait_for("a screenshot is taken",
                             lambda s: any(t.startswith("Screenshot") for t in s["toasts"]))
    pictures = os.listdir(program.pictures)
    assert len(pictures) == 1, pictures
    assert any(pictures[0] in toast for toast in state["toasts"]), "the toast names the file"
    width, height, rows = read_png(os.path.join(program.pictures, pictures[0]))
    assert [width, height] == state["framebuffer"]

    image = FaceImage(positions, faces, state)
    wrong, seen = [], {}
    for f in range(len(faces)):
        place = image.middle(f)
        if place is None or place[1] < 60:  # A toast may lie over the upper rim.
            continue
        x, y = image.to_window(place)
        colour = rows[int(y)][int(x)]
        expected = PALETTE[min(state["depths"][f], 7)]
        seen[state["depths"][f]] = seen.get(state["depths"][f], 0) + 1
        if max(abs(a - b) for a, b in zip(colour, expected)) > 2:
            wrong.append((f, state["depths"][f], colour))
    assert sum(seen.values()) > 100, seen
    assert len(seen) >= 3, f"the picture shows several depths: {seen}"
    assert not wrong, f"{len(wrong)} of {sum(seen.values())} faces have another colour: {wrong[:5]}"
    program.key("F3")
    program.key("l")
    program.key("w")


def main():
    executable, mesh = sys.argv[1:]
    positions, faces = read_obj(mesh)
    display = Display()
    with Folder() as folder:
        recording = os.path.join(folder, "session.limnrec")
        program = Program(executable, [mesh, "--record", recording], display, folder)
        try:
            state = program.wait_for("the mesh is open and its labels are known",
                                     lambda s: not s["busy"])
            assert state["title"] == f"{os.path.basename(mesh)} - Limn", state["title"]
            assert state["depths"] == [0] * len(faces)

            program.key("F2")  # What is painted on is what is known here: the control mesh.
            paint_and_lower(program, FaceImage(positions, faces, state))
            orbit(program, FaceImage(positions, faces, state))
            raise_visible(program, positions, faces)
            painted = raise_sharp(program, positions, faces)["depths"]
            crease_sharp(program, positions, faces)

            program.click(*program.item("Subdivide"))
            state = program.wait_for("it is subdivided",
                                     lambda s: s["undo"] == "subdivide" and not s["busy"])
            assert state["stage"]["levels"] > 0
            assert state["refined"]["watertight"]
            # Euler: a closed mesh of quads without handles has two vertices more than faces.
            assert state["refined"]["vertices"] == state["refined"]["faces"] + 2
            assert len(faces) < state["refined"]["faces"]
            assert state["depths"] == painted, "subdividing leaves the painting"
            check_colours(program, positions, faces)

            program.key("ctrl+z")
            state = program.wait_for("subdividing is undone", lambda s: s["stage"]["levels"] == 0)
            assert state["depths"] == painted
            program.key("ctrl+z")
            state = program.wait_for("the rule is undone",
                                     lambda s: s["undo"].startswith("raise visible"))
            assert state["depths"] != painted
            program.key("ctrl+shift+z")
            program.wait_for("it is redone", lambda s: s["depths"] == painted)

            program.key("ctrl+s")
            program.wait_for("it asks for a name", lambda s: s["modal"] == "path")
            path = os.path.join(folder, "painted.limn")
            program.key("ctrl+a")
            program.type(path)
            program.key("Return")
            state = program.wait_for("it is saved", lambda s: not s["modal"] and not s["modified"])
            assert state["title"] == "painted.limn - Limn"
            with open(path) as file:
                saved = json.load(file)
            assert saved["depths"] == painted

            program.close_window()
            code = program.wait_for_exit()
            assert code == 0, f"it ended with {code}:\n{program.log()}"
            assert "Sanitizer" not in program.log(), program.log()
            check_replay(executable, recording, folder)
        finally:
            program.kill()
            display.close()


if __name__ == "__main__":
    main()
