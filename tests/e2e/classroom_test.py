#!/usr/bin/env python3
"""A lesson with a real pointer: a scheme stepped forward and back, edges split and flipped by clicks.

usage: classroom_test.py PROGRAM MESH.obj"""

import os
import subprocess
import sys

from program import Display, Folder, Program, clean_environment
from scene import FaceImage, read_obj


def at_level(level, faces):
    return lambda s: (not s["busy"] and s["stage"]["levels"] == level and
                      (s["refined"] or {"faces": 0})["faces"] == faces)


def check_without_display(executable, folder):
    done = subprocess.run([executable, "classroom", "sphere", "3"], cwd=folder, timeout=300,
                          env=clean_environment(folder), capture_output=True, text=True)
    assert done.returncode == 1, done
    assert "display" in done.stderr, done.stderr
    steps = [line for line in done.stdout.splitlines() if line.startswith("level")]
    assert len(steps) == 3, done.stdout
    for line, vertices, faces in zip(steps, (66, 258, 1026), (128, 512, 2048)):
        assert f"{vertices} vertices" in line and f"{faces} faces" in line, line
        assert line.endswith(" ms"), line
    done = subprocess.run([executable, "classroom", "sphere", "13"], cwd=folder, timeout=300,
                          env=clean_environment(folder), capture_output=True, text=True)
    assert done.returncode == 2, done


def check_steps(program):
    state = program.wait_for("the mesh is subdivided already", at_level(1, 128))
    assert state["scheme"] == "loop", state["scheme"]
    program.key("Right")
    program.wait_for("one step forward by a key", at_level(2, 512))
    program.click(*program.item("Forward"))
    program.wait_for("one step forward by the button", at_level(3, 2048))
    program.click(*program.item("Back"))
    program.wait_for("one step back by the button", at_level(2, 512))
    program.key("Left", "Left")
    program.wait_for("back at the control mesh", at_level(0, 0))
    program.click(*program.item("level 2"))
    program.wait_for("a line of the table is pressed", at_level(2, 512))
    program.key("ctrl+z")
    program.wait_for("that is undone", at_level(0, 0))


def front_edge(positions, faces, state):
    """An edge seen from the front with a place on it, in window coordinates."""
    image = FaceImage(positions, faces, state)
    best = None
    for f, face in enumerate(faces):
        if image.middle(f) is None:
            continue
        mx, my = image.middle(f)
        for i, a in enumerate(face):
            b = face[(i + 1) % len(face)]
            ends = image.points[a], image.points[b]
            # A little inside of the face, so that the face is this one beyond doubt.
            x = (ends[0][0] + ends[1][0]) / 2 * 0.96 + mx * 0.04
            y = (ends[0][1] + ends[1][1]) / 2 * 0.96 + my * 0.04
            length = abs(ends[0][0] - ends[1][0]) + abs(ends[0][1] - ends[1][1])
            if image.at(x, y) == f and (best is None or length > best[0]):
                best = length, sorted((a, b)), image.to_window((x, y))
    assert best, "no edge is seen"
    return best[1], best[2]


def check_edges(program, mesh):
    positions, faces = read_obj(mesh)
    state = program.wait_for("nothing is subdivided", at_level(0, 0))
    edge, place = front_edge(positions, faces, state)
    program.click(*program.item("tool: Split edge tool"))
    program.move(*place)
    program.wait_for("the edge lights up",
                     lambda s: sorted(s["hover_edge"] or []) == edge)
    program.click(*place)
    state = program.wait_for("the edge is split", lambda s: s["control_vertices"] == 19)
    assert state["control_faces"] == 34 and state["undo"] == "split edge", state["undo"]
    program.key("ctrl+z")
    program.wait_for("that is undone", lambda s: s["control_vertices"] == 18)

    program.click(*program.item("tool: Flip edge tool"))
    program.click(*place)
    state = program.wait_for("the edge is flipped", lambda s: s["undo"] == "flip edge")
    assert state["control_vertices"] == 18 and state["control_faces"] == 32, state
    program.move(place[0] + 1, place[1])
    program.wait_for("another edge is there now",
                     lambda s: s["hover_edge"] and sorted(s["hover_edge"]) != edge)
    program.key("ctrl+z")
    program.wait_for("that is undone", lambda s: s["undo"] == "" or "flip" not in s["undo"])
    program.key("Right")
    program.wait_for("the scheme goes on from there", at_level(1, 128))


def check_side_by_side(program):
    before = program.wait_for("it is at rest", lambda s: not s["busy"])
    program.click(*program.item("Beside it"))
    program.wait_for("the list unfolds",
                     lambda s: any(name.startswith("Beside it: Modified") for name in s["items"]))
    program.click(*program.item("Beside it: Modified butterfly"))
    state = program.wait_for("the view is split in two",
                             lambda s: s["viewport"][2] < 0.6 * before["viewport"][2])
    x, y, width, height = state["viewport"]
    middle = y + height / 2
    program.drag([(x + 1.5 * width, middle), (x + 1.5 * width + 60, middle)])
    program.wait_for("a drag in the second half turns both",
                     lambda s: abs(s["view"]["yaw"] - state["view"]["yaw"]) > 1.0)


def check_refusal(executable, mesh, display, folder):
    program = Program(executable, ["classroom", "cube", "0"], display, folder)
    try:
        state = program.wait_for("it has started", lambda s: not s["busy"])
        assert state["scheme"] == "catmull-clark", "what takes a cube as it is"
        edge, place = front_edge(*read_obj(mesh), state)
        program.click(*program.item("tool: Flip edge tool"))
        program.move(*place)
        program.wait_for("an edge of the cube is met",
                         lambda s: sorted(s["hover_edge"] or []) == edge)
        program.click(*place)
        program.wait_for("the reason is told", lambda s: s["toasts"])
        assert program.state["control_faces"] == 6 and not program.state["undo"]
    finally:
        program.kill()


def main():
    executable, creature = sys.argv[1:]
    meshes = os.path.dirname(creature)
    with Folder() as folder:
        check_without_display(executable, folder)
        display = Display()
        try:
            program = Program(executable, ["classroom", "sphere", "1"], display, folder)
            try:
                check_steps(program)
                check_edges(program, os.path.join(meshes, "sphere.obj"))
                check_side_by_side(program)
            finally:
                program.kill()
            # In a folder of its own, or it would ask about the work of the one that was killed.
            with Folder() as another:
                check_refusal(executable, os.path.join(meshes, "cube.obj"), display, another)
        finally:
            display.close()


if __name__ == "__main__":
    main()
