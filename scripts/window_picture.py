#!/usr/bin/python3
"""window_picture.py LIMN PROJECT PICTURE.png

Opens a project on an X server of its own, subdivides it and takes the program's own screenshot.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "tests", "e2e"))
from program import Display, Folder, Program  # noqa: E402


def main(executable, project, picture):
    display = Display((1280, 800))
    try:
        with Folder() as folder:
            program = Program(executable, [project], display, folder)
            try:
                program.wait_for("the window is there", lambda state: not state["busy"])
                program.key("Home")
                program.key("c")
                state = program.wait_for("it is subdivided",
                                         lambda s: s["refined"] is not None and not s["busy"])
                x, y, width, height = state["viewport"]
                program.move(x + 0.36 * width, y + 0.5 * height)
                program.wait_for("the brush is over the mesh", lambda s: s["hover"] is not None)
                program.take_picture(picture)
            finally:
                program.kill()
    finally:
        display.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
