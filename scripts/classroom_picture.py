#!/usr/bin/python3
"""classroom_picture.py LIMN PICTURE.png

Opens a classroom on an X server of its own, with two schemes side by side and their errors against
a sphere, and takes the program's own screenshot.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "tests", "e2e"))
from program import Display, Folder, Program  # noqa: E402

SECOND = "Beside it: Modified butterfly"


def main(executable, picture):
    display = Display((1280, 800))
    try:
        with Folder() as folder:
            program = Program(executable, ["classroom", "cube_triangulated", "3"], display, folder)
            try:
                program.wait_for("the window is there", lambda s: s["refined"] and not s["busy"])
                program.click(*program.item("Beside it"))
                program.wait_for("the list unfolds", lambda s: SECOND in s["items"])
                program.click(*program.item(SECOND))
                state = program.wait_for("both are there", lambda s: not s["busy"] and
                                         SECOND not in s["items"])
                program.click(*program.item("Compare with a sphere"))
                program.wait_for("the spheres are fitted",
                                 lambda s: "sphere plot" in s["items"] and not s["busy"])
                program.key("F4", "shift+n", "Home")
                x, y, width, height = state["viewport"]
                program.move(x + 0.5 * width, y + 0.97 * height)
                program.wait_for("the pointer is out of the way", lambda s: s["hover"] is None)
                program.take_picture(picture)
            finally:
                program.kill()
    finally:
        display.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
