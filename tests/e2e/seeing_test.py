#!/usr/bin/env python3
"""Looking at the mesh with a real pointer: orbits around the cursor, presets of navigation, the axes
in the corner, framing; colours and numbers of faces, the steps of legalisation, uniform beside.

usage: seeing_test.py PROGRAM MESH.obj"""

import os
import sys

from program import Display, Folder, Program
from scene import FaceImage, read_obj, read_png


def place_on_mesh(image):
    """A face that is well seen away from the middle of the view, and a place on it in pixels."""
    candidates = [(image.middle(f), f) for f in range(len(image.faces))]
    far = [(place, f) for place, f in candidates
           if place and abs(place[0] - image.width / 2) > image.width / 8]
    assert far, "no face is seen well"
    counts = image.counts()
    return max(far, key=lambda entry: counts[entry[1]])


def place_beside_mesh(image):
    """A place of the background, clear of what lies in the corners."""
    for row in range(image.height // 4, image.height * 3 // 4, 10):
        for column in range(image.width // 4, image.width * 3 // 4, 10):
            if all(image.at(column + dx, row + dy) < 0 for dx in (-30, 0, 30) for dy in (-30, 0, 30)):
                return column + 0.5, row + 0.5
    raise AssertionError("the mesh fills the view")


def expect_still_under(positions, faces, state, place, face):
    image = FaceImage(positions, faces, state)
    around = {image.at(place[0] + dx, place[1] + dy) for dx in (-2, 0, 2) for dy in (-2, 0, 2)}
    assert face in around, f"face {face} has gone from under the cursor: {around}"


def orbit_around_cursor(program, positions, faces):
    before = program.state
    image = FaceImage(positions, faces, before)
    place, face = place_on_mesh(image)
    x, y = image.to_window(place)
    program.drag([(x, y), (x + 15, y + 4), (x + 30, y + 8)], button=2)
    state = program.wait_for("the view has turned", lambda s: s["view"]["yaw"] != before["view"]["yaw"])
    state = program.wait_for("it has come to rest", lambda s: s["hover"] is not None)
    assert state["view"]["target"] != before["view"]["target"]
    assert state["view"]["distance"] == before["view"]["distance"]
    expect_still_under(positions, faces, state, place, face)
    return state


def orbit_beside_mesh(program, image):
    """Goes round the target, which stays."""
    before = program.state
    x, y = image.to_window(place_beside_mesh(image))
    program.drag([(x, y), (x + 30, y)], button=2)
    state = program.wait_for("the view has turned", lambda s: s["view"]["yaw"] != before["view"]["yaw"])
    moved = max(abs(a - b) for a, b in zip(state["view"]["target"], before["view"]["target"]))
    assert moved < 1e-9 * state["view"]["distance"], moved
    return state


def choose_navigation(program, name):
    program.click(*program.item("menu: View"))
    program.wait_for("the menu is open", lambda s: "menu: Navigation" in s["items"])
    program.click(*program.item("menu: Navigation"))
    program.wait_for("the choice is open", lambda s: "menu: " + name in s["items"])
    program.click(*program.item("menu: " + name))
    return program.wait_for("it is chosen", lambda s: "menu: Navigation" not in s["items"])


def mouse_alone(program, positions, faces):
    """Left beside the mesh turns, on it paints; right turns, middle pans."""
    before = choose_navigation(program, "Navigate with the mouse alone")
    image = FaceImage(positions, faces, before)
    x, y = image.to_window(place_beside_mesh(image))
    program.drag([(x, y), (x + 40, y + 5)])
    turned = program.wait_for("left has turned the view",
                              lambda s: s["view"]["yaw"] != before["view"]["yaw"])
    assert turned["depths"] == before["depths"] and not turned["undo"]
    image = FaceImage(positions, faces, turned)
    place, face = place_on_mesh(image)
    program.click(*image.to_window(place))
    painted = program.wait_for("left has painted", lambda s: s["undo"].startswith("paint"))
    assert painted["depths"][face] == 1 and painted["view"] == turned["view"]
    x, y = image.to_window(place)
    program.drag([(x, y), (x + 30, y)], button=3)
    after_right = program.wait_for("right has turned the view",
                                   lambda s: s["view"]["yaw"] != turned["view"]["yaw"])
    program.drag([(x, y), (x + 30, y)], button=2)
    after_middle = program.wait_for("middle has shifted it",
                                    lambda s: s["view"]["target"] != after_right["view"]["target"])
    assert after_middle["view"]["yaw"] == after_right["view"]["yaw"]
    program.key("ctrl+z")
    program.wait_for("the stroke is undone", lambda s: not s["undo"])
    choose_navigation(program, "Navigate with Alt")


def click_axes(program):
    for name, yaw, pitch in (("Right view", 90, 0), ("Top view", 0, 90), ("Front view", 0, 0)):
        program.click(*program.item("axis: " + name))
        state = program.wait_for(
            f"the view is the {name}",
            lambda s: abs(s["view"]["yaw"] - yaw) < 1e-9 and abs(s["view"]["pitch"] - pitch) < 1e-9)
        assert not state["undo"], "a click on an axis paints nothing"


def frame_face(program, positions, faces):
    state = program.state
    image = FaceImage(positions, faces, state)
    place, face = place_on_mesh(image)
    program.move(*image.to_window(place))
    program.wait_for("the face is hovered", lambda s: s["hover"] == face)
    program.key("period")
    state = program.wait_for("the face is framed",
                             lambda s: s["view"]["distance"] < 0.3 * state["view"]["distance"])
    def is_there(s):
        image = FaceImage(positions, [faces[face]], s)
        xs, ys, _ = zip(*image.points_of(0))
        fullest = max((max(xs) - min(xs)) / image.width, (max(ys) - min(ys)) / image.height)
        return 0.6 < fullest <= 1.0
    program.wait_for("it fills the view", is_there)
    program.key("Home")
    program.wait_for("all is framed",
                     lambda s: s["view"]["distance"] > 2 * state["view"]["distance"])


def take_picture(program):
    """The window as it is, read back."""
    before = set(os.listdir(program.pictures))
    program.key("F12")

    def path():
        return os.path.join(program.pictures, (set(os.listdir(program.pictures)) - before).pop())

    program.wait_for("a picture is taken", lambda _: set(os.listdir(program.pictures)) - before)
    program.wait_for("it is written whole", lambda _: b"IEND" in open(path(), "rb").read()[-12:])
    return read_png(path())


def colours_and_numbers(program, positions, faces):
    """Without light and wires, colours are those of the palette: by depth, by level, or none."""
    image = FaceImage(positions, faces, program.wait_for_rest())
    place, face = place_on_mesh(image)
    program.click(*image.to_window(place))
    program.wait_for("a face is painted", lambda s: s["depths"][face] == 1)
    program.key("l")
    program.key("w")
    program.move(*program.item("menu: Help"))  # Off the mesh, so that nothing lights up.
    program.wait_for("the cursor is off the mesh", lambda s: s["hover"] is None)
    shown = []
    for key in ("F5", "F6", "F7"):
        program.key(key)
        shown.append(take_picture(program))
    x, y = (round(part) for part in image.to_window((place[0] + 2, place[1] + 2)))
    by_depth, by_level, plain = (rows[y][x] for _, _, rows in shown)
    assert by_depth == (0xDB, 0xEF, 0x89), by_depth
    assert by_level == plain == (0xC8, 0xC4, 0xBD), "the control mesh is of level 0"
    program.key("F5")
    program.key("ctrl+n")
    _, _, rows = take_picture(program)
    around = [rows[y + dy][x + dx] for dy in range(-12, 8) for dx in range(-12, 8)]
    assert any(max(pixel) < 60 for pixel in around), "a digit is written on the face"
    for key in ("ctrl+n", "l", "w"):
        program.key(key)
    return face


def step_through(program):
    """What the painted face makes illegal, step by step; the control mesh shows meanwhile."""
    before = program.state
    program.key("shift+Right")
    state = program.wait_for("the steps are shown", lambda s: s["steps"]["size"] > 0)
    count = state["steps"]["size"]
    assert state["steps"]["position"] == 0
    for position in range(1, min(count, 3) + 1):
        program.key("shift+Right")
        program.wait_for("a step is made", lambda s: s["steps"]["position"] == position)
    program.key("shift+Left")
    program.wait_for("it is taken back", lambda s: s["steps"]["position"] == min(count, 3) - 1)
    program.key("shift+Down")
    program.wait_for("all are made", lambda s: s["steps"]["position"] == count)
    program.key("Escape")
    state = program.wait_for("the steps are left", lambda s: not s["steps"]["shown"])
    assert state["depths"] == before["depths"] and state["undo"] == before["undo"]


def uniform_beside(program):
    whole = program.state["viewport"][2]
    program.key("F8")
    program.wait_for("the view has two halves",
                     lambda s: s["split"] and s["viewport"][2] < 0.6 * whole and not s["busy"])
    program.key("F8")
    program.wait_for("it is whole again", lambda s: not s["split"] and s["viewport"][2] == whole)


def main():
    executable, mesh = sys.argv[1:3]
    positions, faces = read_obj(mesh)
    display = Display()
    try:
        with Folder() as folder:
            program = Program(executable, [mesh], display, folder)
            try:
                program.wait_for("it is there", lambda s: not s["busy"])
                program.key("F2")
                state = program.wait_for("the control mesh shows", lambda s: not s["busy"])
                state = orbit_around_cursor(program, positions, faces)
                orbit_beside_mesh(program, FaceImage(positions, faces, state))
                mouse_alone(program, positions, faces)
                click_axes(program)
                frame_face(program, positions, faces)
                colours_and_numbers(program, positions, faces)
                step_through(program)
                uniform_beside(program)
            finally:
                program.kill()
    finally:
        display.close()


if __name__ == "__main__":
    main()
