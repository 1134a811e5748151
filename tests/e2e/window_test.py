#!/usr/bin/env python3
"""How the window begins and ends: bad files, no display, unsaved changes, preferences that are kept.

usage: window_test.py PROGRAM MESH.obj"""

import json
import os
import subprocess
import sys

from program import Display, Folder, Program, clean_environment


def run_to_end(executable, arguments, folder, environment=None):
    return subprocess.run([executable, *arguments], env=environment or clean_environment(folder),
                          capture_output=True, text=True, cwd=folder, timeout=300)


def check_bad_file(executable, folder):
    path = os.path.join(folder, "bad.obj")
    with open(path, "w") as file:
        file.write("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n")
    done = run_to_end(executable, [path], folder)
    assert done.returncode == 3, done
    assert "bad.obj:4" in done.stderr, done.stderr
    done = run_to_end(executable, [os.path.join(folder, "none.obj")], folder)
    assert done.returncode == 3 and "none.obj" in done.stderr, done


def check_no_display(executable, mesh, folder):
    done = run_to_end(executable, [mesh], folder)
    assert done.returncode == 1, done
    assert "display" in done.stderr and "limn render" in done.stderr, done.stderr


def check_unsaved_and_preferences(executable, display, folder):
    program = Program(executable, [], display, folder)
    try:
        state = program.wait_for("it has started", lambda s: not s["busy"])
        assert state["title"] == "creature - Limn", "without an argument the creature is shown"
        program.click(*program.item("Raise all"))
        program.wait_for("it is painted", lambda s: s["modified"])
        program.close_window()
        program.wait_for("it asks before changes are lost", lambda s: s["modal"] == "unsaved")
        program.key("Escape")
        program.wait_for("it stays open", lambda s: not s["modal"])
        radius = program.state["brush_radius"]
        program.key("bracketright")
        state = program.wait_for("the brush is bigger", lambda s: s["brush_radius"] > radius)
        program.close_window()
        program.wait_for("it asks again", lambda s: s["modal"] == "unsaved")
        program.click(*program.item("Discard changes"))
        code = program.wait_for_exit()
        assert code == 0, f"{code}: {program.log()}"
    finally:
        program.kill()

    kept = os.path.join(folder, "config", "limn", "preferences.json")
    with open(kept) as file:
        assert abs(json.load(file)["brush_radius"] - state["brush_radius"]) < 1e-9
    with open(kept, "w") as file:
        file.write("{ broken")
    program = Program(executable, ["cube"], display, folder)
    try:
        state = program.wait_for("it starts all the same", lambda s: s["control_faces"] == 6)
        assert any("preferences" in toast for toast in state["toasts"]), state["toasts"]
        program.close_window()
        code = program.wait_for_exit()
        assert code == 0, f"{code}: {program.log()}"
    finally:
        program.kill()


def check_small_screen(executable, folder):
    """On a screen smaller than the window would like to be, all of it is on the screen."""
    display = Display((800, 600))
    program = Program(executable, ["cube"], display, folder)
    try:
        state = program.wait_for("it has started", lambda s: not s["busy"])
        assert state["window"][0] <= 800 and state["window"][1] <= 600, state["window"]
        program.close_window()
        assert program.wait_for_exit() == 0, program.log()
    finally:
        program.kill()
        display.close()


def main():
    executable, mesh = sys.argv[1:]
    with Folder() as folder:
        check_bad_file(executable, folder)
        check_no_display(executable, mesh, folder)
        check_small_screen(executable, folder)
        display = Display()
        try:
            check_unsaved_and_preferences(executable, display, folder)
        finally:
            display.close()


if __name__ == "__main__":
    main()
