#!/usr/bin/env python3
"""How the window begins and ends: bad files, no display, unsaved changes, preferences that are kept, work
that comes back after a kill.

usage: window_test.py PROGRAM MESH.obj"""

import json
import os
import subprocess
import sys
import time

from drop import drop_file
from program import PATIENCE, Display, Folder, Program, clean_environment


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


def check_bad_file_in_window(executable, display, folder):
    """Who came by the desktop sees no terminal: the window says what is wrong with the file."""
    path = os.path.join(folder, "bad.obj")
    program = Program(executable, [path], display, folder)
    try:
        state = program.wait_for("it says so", lambda s: s["modal"] == "error")
        assert state["title"] == "creature - Limn", state["title"]
        assert "bad.obj:4" in program.log(), program.log()
        program.key("Escape")
        program.wait_for("the creature is there to go on with", lambda s: not s["modal"])
        program.close_window()
        assert program.wait_for_exit() == 0
    finally:
        program.kill()


def check_desktop_dialog(executable, mesh, display, folder):
    """Where the desktop has a dialog for files, that is asked."""
    bin_folder = os.path.join(folder, "bin")
    os.makedirs(bin_folder)
    dialog = os.path.join(bin_folder, "zenity")
    with open(dialog, "w") as file:
        file.write(f"#!/bin/sh\necho {mesh}\n")
    os.chmod(dialog, 0o755)
    program = Program(executable, ["cube"], display, folder,
                      {"LIMN_DIALOGS": "", "PATH": bin_folder + ":" + os.environ["PATH"]})
    try:
        program.wait_for("it has started", lambda s: not s["busy"])
        program.key("ctrl+o")
        program.wait_for("what was chosen is open",
                         lambda s: s["title"].startswith("creature.obj") and not s["modal"])
        program.close_window()
        assert program.wait_for_exit() == 0
    finally:
        program.kill()


def check_no_display(executable, mesh, folder):
    done = run_to_end(executable, [mesh], folder)
    assert done.returncode == 1, done
    assert "display" in done.stderr and "limn render" in done.stderr, done.stderr


def check_first_start(executable, display, folder):
    """Who is here for the first time is told how to paint and orbit, until both were done."""
    home = os.path.join(folder, "new")
    program = Program(executable, ["cube"], display, home, is_first_start=True)
    try:
        state = program.wait_for("it has started", lambda s: not s["busy"] and s["hints"])
        x, y, width, height = state["viewport"]
        middle = (x + width / 2, y + height / 2)
        program.drag([middle, (middle[0] + 10, middle[1])])
        state = program.wait_for("it is painted", lambda s: s["modified"] and not s["busy"])
        assert state["hints"], "orbiting is not learnt yet"
        program.drag([middle, (middle[0] + 60, middle[1] + 10)], button=2)
        state = program.wait_for("the card is gone", lambda s: not s["hints"])
        assert "Got it" not in state["items"] or program.wait_for(
            "its button too", lambda s: "Got it" not in s["items"])
        program.key("ctrl+z")
        program.wait_for("nothing is to be saved", lambda s: not s["modified"])
        program.close_window()
        assert program.wait_for_exit() == 0, program.log()
    finally:
        program.kill()
    with open(os.path.join(home, "config", "limn", "preferences.json")) as file:
        assert json.load(file)["hints"] is False


def check_drop(executable, mesh, display, folder):
    """A file dropped on the window is opened, unless something would be lost."""
    program = Program(executable, ["cube"], display, folder)
    try:
        state = program.wait_for("it has started", lambda s: not s["busy"])
        x, y, width, height = state["viewport"]
        middle = (x + width / 2, y + height / 2)
        drop_file(program, mesh, middle)
        program.wait_for("it is open", lambda s: s["title"].startswith("creature.obj"))
        program.key("a")
        program.wait_for("it is painted", lambda s: s["modified"])
        drop_file(program, mesh, middle)
        program.wait_for("it asks before changes are lost", lambda s: s["modal"] == "unsaved")
        program.click(*program.item("Discard changes"))
        program.wait_for("it is open anew", lambda s: not s["modal"] and not s["modified"])
        program.close_window()
        assert program.wait_for_exit() == 0
    finally:
        program.kill()


def check_closing_while_refining(executable, display, folder):
    """Whoever closes the window waits for nothing."""
    program = Program(executable, [], display, folder)
    try:
        program.wait_for("it has started", lambda s: not s["busy"])
        program.key(*["a"] * 6)  # More than four million faces: they take a while,
        program.close_window()   # and nobody waits for them here.
        program.wait_for("it asks before changes are lost", lambda s: s["modal"] == "unsaved")
        program.click(*program.item("Discard changes"))
        assert program.wait_for_exit() == 0
        assert "Sanitizer" not in program.log(), program.log()
    finally:
        program.kill()


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


def check_recovery(executable, display, folder):
    """What was painted when the program is killed is offered by its next start."""
    program = Program(executable, ["cube"], display, folder)
    try:
        program.wait_for("it has started", lambda s: not s["busy"])
        program.key("c")  # After every refinement a copy is kept.
        program.wait_for("it is subdivided", lambda s: s["refined"] is not None and not s["busy"])
        program.key("a")
        program.wait_for("all is painted", lambda s: set(s["depths"]) == {1} and not s["busy"])
        kept = os.path.join(folder, ".local", "state", "limn", "recovery")
        end = time.monotonic() + PATIENCE
        while not any(name.endswith(".limn") and is_painted(os.path.join(where, name))
                      for where, _, names in os.walk(kept) for name in names):
            assert time.monotonic() < end, "no copy is kept"
            time.sleep(0.05)
    finally:
        program.kill()
    program = Program(executable, ["grid"], display, folder)
    try:
        program.wait_for("it asks", lambda s: s["modal"] == "recovery")
        picture = os.environ.get("LIMN_RECOVERY_PICTURE")
        program.click(*program.item("Recover"))
        state = program.wait_for("it is there again", lambda s: s["control_faces"] == 6)
        assert set(state["depths"]) == {1} and state["modified"], state
        program.key("ctrl+q")
        program.wait_for("it asks about changes", lambda s: s["modal"] == "unsaved")
        program.click(*program.item("Discard changes"))
        assert program.wait_for_exit() == 0, program.log()
        assert not os.listdir(kept), os.listdir(kept)
    finally:
        program.kill()


def is_painted(path):
    with open(path) as file:
        return set(json.load(file)["depths"]) == {1}


def check_small_screen(executable, folder):
    """On a screen smaller than the window would like to be, all of it is on the screen, at twice
    the scale too; and it follows when it is resized."""
    for size, dots_per_inch in (((800, 600), None), ((1600, 1200), 192)):
        display = Display(size, dots_per_inch)
        home = os.path.join(folder, f"{size[0]}")  # Of no run before, which the window is kept of.
        program = Program(executable, ["cube"], display, home)
        try:
            state = program.wait_for("it has started", lambda s: not s["busy"])
            assert state["window"] == list(size), state["window"]
            narrow = [size[0] - 100, size[1] - 80]
            program.resize(*narrow)
            state = program.wait_for("it is smaller", lambda s: s["window"] == narrow)
            assert state["framebuffer"] == narrow, state["framebuffer"]
            x, y, width, height = state["viewport"]
            panel = state["items"]["panel edge"]
            assert abs(panel[0] - (x + width)) < 1.5, "no gap between viewport and panel"
            assert panel[3] == height and y + height < narrow[1], state
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
            check_bad_file_in_window(executable, display, folder)
            check_desktop_dialog(executable, mesh, display, folder)
            check_first_start(executable, display, folder)
            check_drop(executable, mesh, display, folder)
            check_closing_while_refining(executable, display, folder)
            check_unsaved_and_preferences(executable, display, folder)
            check_recovery(executable, display, folder)
        finally:
            display.close()


if __name__ == "__main__":
    main()
