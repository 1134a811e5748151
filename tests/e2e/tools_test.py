#!/usr/bin/env python3
"""Every painting tool beside the plain brush, with a real pointer: fill, smart fill, rectangle,
lasso, straight line, through, mirror, rules for the whole painting, and what a click would cost.

usage: tools_test.py PROGRAM MESH.obj"""

import heapq
import math
import sys

from program import Display, Folder, Program, count_in
from scene import FaceImage, edge_angles, read_obj, read_png


def changed(before, after):
    return {f for f, (a, b) in enumerate(zip(before, after)) if a != b}


def inside(polygon, x, y):
    """Whether a polygon winds around a place, by the angles under which its sides are seen."""
    turn = 0.0
    for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
        angle = math.atan2(by - y, bx - x) - math.atan2(ay - y, ax - x)
        turn += math.remainder(angle, 2 * math.pi)
    return abs(turn) > math.pi


def faces_shown_in(image, polygon, margin):
    """Faces with a pixel centre in the polygon: at least `margin` pixels within, and around it."""
    sure, possible = set(), set()
    xs, ys = [p[0] for p in polygon], [p[1] for p in polygon]
    for row in range(max(0, int(min(ys)) - 2), min(image.height, int(max(ys)) + 3)):
        for column in range(max(0, int(min(xs)) - 2), min(image.width, int(max(xs)) + 3)):
            face = image.ids[row * image.width + column]
            if face < 0:
                continue
            around = [inside(polygon, column + 0.5 + dx, row + 0.5 + dy)
                      for dx in (-margin, margin) for dy in (-margin, margin)]
            if all(around):
                sure.add(face)
            if any(around):
                possible.add(face)
    return sure, possible


def neighbours(positions, faces):
    beside = [[] for _ in faces]
    for (a, b), angle in edge_angles(positions, faces):
        beside[a].append((b, angle))
        beside[b].append((a, angle))
    return beside


def reached(beside, seed, degrees):
    """The least sum of angles on the way to every face that is reached."""
    distance, heap = {}, [(0.0, seed)]
    while heap:
        way, face = heapq.heappop(heap)
        if face in distance:
            continue
        distance[face] = way
        for other, angle in beside[face]:
            if other not in distance and way + angle <= degrees:
                heapq.heappush(heap, (way + angle, other))
    return distance


def flooded(beside, depths, seed):
    met, todo = {seed}, [seed]
    while todo:
        for other, _ in beside[todo.pop()]:
            if other not in met and depths[other] == depths[seed]:
                met.add(other)
                todo.append(other)
    return met


def large_face(image, avoid=()):
    """The face of which most shows, and a place well inside it."""
    counts = image.counts()
    for f in sorted(range(len(counts)), key=lambda f: -counts[f]):
        place = image.middle(f)
        if f not in avoid and place is not None:
            return f, image.to_window(place)
    raise AssertionError("no face shows")


class Tools:
    def __init__(self, program, positions, faces):
        self.program = program
        self.positions = positions
        self.faces = faces
        self.beside = neighbours(positions, faces)
        self.image = FaceImage(positions, faces, program.state)

    def take(self, key, tool):
        self.program.key(key)
        self.program.wait_for(f"the {tool} tool is taken up", lambda s: s["tool"] == tool)

    def undo(self):
        before = self.program.state["undo"]
        self.program.key("ctrl+z")
        return self.program.wait_for("it is undone", lambda s: s["redo"] == before)

    def check_cost(self, act, name, face=None):
        """Waits for the forecast (over a face), acts, and holds it against what came of it."""
        program = self.program
        state = program.wait_for("the cost is known",
                                 lambda s: s["forecast"] and s["forecast"]["faces"] > 0
                                 and (face is None or s["hover"] == face))
        forecast, before = state["forecast"], state
        act()
        after = program.wait_for(f"{name} has painted",
                                 lambda s: s["undo"].startswith(name) and not s["busy"])
        assert count_in(after["undo"]) == forecast["faces"], (after["undo"], forecast)
        assert len(changed(before["depths"], after["depths"])) == forecast["faces"]
        had = before["refined"]["faces"] if before["refined"] else len(self.faces)
        added = after["refined"]["faces"] - had
        assert added == forecast["added"], f"{added} faces more, foretold {forecast['added']}"
        return before["depths"], after["depths"]

    def fill(self):
        self.take("f", "fill")
        face, place = large_face(self.image)
        self.program.move(*place)
        before, after = self.check_cost(lambda: self.program.click(*place), "fill", face)
        assert changed(before, after) == flooded(self.beside, before, face)
        assert all(depth == 1 for depth in after), "an unpainted mesh is one region"
        self.program.drag([place], held="shift")
        self.program.wait_for("Shift lowers it again", lambda s: not any(s["depths"]))
        self.undo()
        self.undo()

    def smart_fill(self):
        self.take("shift+u", "smart fill")
        before = self.program.state["fill_angle"]
        self.program.click(*self.slider_place(0.13))
        angle = self.program.wait_for("the angle is set",
                                      lambda s: s["fill_angle"] != before)["fill_angle"]
        assert 15 < angle < 70, angle
        face, place = large_face(self.image)
        self.program.move(*place)
        before, after = self.check_cost(lambda: self.program.click(*place), "smart fill", face)
        got = changed(before, after)
        sure = set(reached(self.beside, face, angle - 1e-4))
        possible = set(reached(self.beside, face, angle + 1e-4))
        assert sure <= got <= possible, (sure - got, got - possible)
        assert 1 < len(got) < len(self.faces)
        self.undo()

    def slider_place(self, part):
        x, y, width, height = self.program.state["items"]["Fill angle"]
        return x + width * part, y + height / 2

    def outline_shows(self, places):
        """The picture with the drag still going on: the line runs along the sides."""
        program = self.program
        program.xdotool("key", "F12")
        state = program.wait_for("a screenshot is taken",
                                 lambda s: any(t.startswith("Screenshot") for t in s["toasts"]))
        name = next(t for t in state["toasts"] if t.startswith("Screenshot"))
        width, height, rows = read_png(name.removeprefix("Screenshot: "))
        for x, y in places:
            near = [rows[round(y) + dy][round(x) + dx] for dx in range(-2, 3) for dy in range(-2, 3)]
            assert any(r > 140 and r - b > 100 for r, _, b in near), f"no amber line at {x}, {y}"

    def rectangle(self):
        self.take("q", "rectangle")
        image, program = self.image, self.program
        low = (image.width * 0.42, image.height * 0.42)
        high = (image.width * 0.6, image.height * 0.66)
        corners = [low, (high[0], low[1]), high, (low[0], high[1])]
        program.move(*image.to_window(low))
        program.xdotool("mousedown", 1)
        program.move(*image.to_window((high[0] - 30, high[1])))
        program.move(*image.to_window(high))
        program.wait_for("its cost is known", lambda s: s["forecast"])
        middles = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
                   for a, b in zip(corners, corners[1:] + corners[:1])]
        self.outline_shows([image.to_window(place) for place in middles])
        before, after = self.check_cost(lambda: program.xdotool("mouseup", 1), "rectangle")
        sure, possible = faces_shown_in(image, corners, 1.5)
        got = changed(before, after)
        assert sure <= got <= possible, (sure - got, got - possible)
        self.undo()

        program.move(*image.to_window(low))
        program.xdotool("mousedown", 1)
        program.move(*image.to_window(high))
        program.wait_for("it is under way", lambda s: s["forecast"])
        program.xdotool("key", "Escape")
        program.wait_for("it is given up", lambda s: not s["forecast"] or s["forecast"]["faces"] == 1)
        program.xdotool("mouseup", 1)
        state = program.read()
        assert state["depths"] == before, "Esc leaves the painting as it was"
        return got

    def through(self, visible):
        """The same rectangle, hidden faces too."""
        image, program = self.image, self.program
        program.key("h")
        program.wait_for("it goes through", lambda s: s["through"])
        low = (image.width * 0.42, image.height * 0.42)
        high = (image.width * 0.6, image.height * 0.66)
        before = program.state["depths"]
        program.drag([image.to_window(low), image.to_window((high[0], low[1])),
                      image.to_window(high)])
        state = program.wait_for("the rectangle has painted",
                                 lambda s: s["undo"].startswith("rectangle"))
        got = changed(before, state["depths"])
        assert visible < got, "all that shows, and more"
        for f, face in enumerate(self.faces):
            xs, ys = [image.points[v][0] for v in face], [image.points[v][1] for v in face]
            if any(low[0] + 1 < x < high[0] - 1 and low[1] + 1 < y < high[1] - 1
                   for x, y in zip(xs, ys)):
                assert f in got, f"face {f} has a corner in it"
            if max(xs) < low[0] - 1 or min(xs) > high[0] + 1 or max(ys) < low[1] - 1 \
                    or min(ys) > high[1] + 1:
                assert f not in got, f"face {f} is outside"
        self.undo()
        program.key("h")
        program.wait_for("visible only", lambda s: not s["through"])

    def lasso(self):
        self.take("shift+q", "lasso")
        image, program = self.image, self.program
        middle = (image.width * 0.5, image.height * 0.55)
        loop = [(middle[0] + 90 * math.cos(a), middle[1] + 70 * math.sin(a))
                for a in (2 * math.pi * i / 14 for i in range(14))]
        loop = [(round(x), round(y)) for x, y in loop]  # As the pointer goes.
        before = program.state["depths"]
        program.drag([image.to_window(p) for p in loop], held="ctrl")
        program.wait_for("nothing is there to lower", lambda s: not s["forecast"]
                         or s["forecast"]["faces"] <= 1)
        program.drag([image.to_window(p) for p in loop])
        state = program.wait_for("the lasso has painted", lambda s: s["undo"].startswith("lasso"))
        sure, possible = faces_shown_in(image, loop, 1.5)
        got = changed(before, state["depths"])
        assert sure <= got <= possible, (sure - got, got - possible)
        assert len(got) > 10
        self.undo()

    def lines(self):
        """The lower tool draws lines with Shift; the paint tool where that is wished for."""
        image, program = self.image, self.program
        for _ in range(40):
            if program.state["brush_radius"] <= 3.0:
                break
            before = program.state["brush_radius"]
            program.key("bracketleft")
            program.wait_for("the brush is smaller", lambda s: s["brush_radius"] < before)
        start = (round(image.width * 0.4), round(image.height * 0.55))
        end = (round(image.width * 0.62), round(image.height * 0.5))
        crossed = image.faces_within(start, end, 1.0)
        near = image.faces_within(start, end, program.state["brush_radius"] + 2.0)
        assert len(crossed) > 5

        self.take("p", "paint")
        program.click(*program.item("Line with Shift"))
        program.wait_for("Shift draws lines", lambda s: s["shift_draws_lines"])
        before = program.state["depths"]
        program.click(*image.to_window(start))
        program.wait_for("a dab is painted", lambda s: s["undo"].startswith("paint"))
        program.drag([image.to_window(end)], held="shift")
        state = program.wait_for("the line is painted",
                                 lambda s: len(changed(before, s["depths"])) >= len(crossed))
        got = changed(before, state["depths"])
        assert crossed <= got <= near, (crossed - got, got - near)
        painted = state["depths"]
        program.click(*program.item("Line with Shift"))
        program.wait_for("Shift lowers again", lambda s: not s["shift_draws_lines"])

        self.take("shift+p", "lower")
        program.click(*image.to_window(start))
        program.wait_for("the first is lowered", lambda s: s["depths"] != painted)
        program.drag([image.to_window(end)], held="shift")
        program.wait_for("the line is lowered",
                         lambda s: not any(s["depths"][f] for f in crossed))
        for _ in range(4):
            self.undo()
        assert program.state["depths"] == before, "four strokes, four commands"

    def fine(self):
        """Faces of the refined mesh alone, which control faces and their depths know nothing of."""
        program = self.program
        self.take("p", "paint")
        program.key("a")
        program.wait_for("all is raised", lambda s: s["undo"].startswith("raise all"))
        program.key("y")
        program.wait_for("the refined mesh is painted",
                         lambda s: s["fine"] and s["refined"] and not s["busy"])
        face, place = large_face(self.image)
        viewport = program.state["viewport"]
        program.move(viewport[0] + 3, viewport[1] + 3)
        program.wait_for("the cursor is beside the mesh", lambda s: s["hover"] is None)
        program.move(*place)
        before = program.wait_for("the cost is known",
                                  lambda s: s["forecast"] and s["forecast"]["faces"] > 0
                                  and s["hover"] == face)
        program.click(*place)
        after = program.wait_for("finer faces are painted",
                                 lambda s: "finer face" in s["undo"] and not s["busy"])
        count = before["forecast"]["faces"]
        assert after["undo"] == f"paint {count} finer face{'s' if count > 1 else ''}", after["undo"]
        assert after["depths"] == before["depths"]
        assert after["demands"] > 0
        added = after["refined"]["faces"] - before["refined"]["faces"]
        assert added == before["forecast"]["added"], (added, before["forecast"])
        program.drag([place], held="ctrl")
        back = program.wait_for("Shift takes it back",
                                lambda s: s["demands"] == 0 and not s["busy"])
        assert back["refined"]["faces"] == before["refined"]["faces"]
        for _ in range(3):
            self.undo()
        program.key("y")
        program.key("F2")
        program.wait_for("the control mesh is painted again", lambda s: not s["fine"])

    def mirror_and_rules(self):
        program = self.program
        self.take("shift+u", "smart fill")
        program.key("shift+x")
        state = program.wait_for("it mirrors", lambda s: s["mirror"] == "x")
        face, place = large_face(self.image)
        program.move(*place)
        before, after = self.check_cost(lambda: program.click(*place), "smart fill", face)
        got = changed(before, after)
        middle = (min(p[0] for p in self.positions) + max(p[0] for p in self.positions)) / 2
        reach = 1e-3 * math.dist([min(p[i] for p in self.positions) for i in range(3)],
                                 [max(p[i] for p in self.positions) for i in range(3)])

        def centroid(f):
            return [sum(self.positions[v][i] for v in self.faces[f]) / len(self.faces[f])
                    for i in range(3)]
        for f in got:
            x, y, z = centroid(f)
            assert any(math.dist(centroid(g), (2 * middle - x, y, z)) <= reach for g in got), f
        program.key("shift+x")
        program.wait_for("it mirrors no more", lambda s: not s["mirror"])

        around = [set() for _ in self.faces]
        at = {}
        for f, face in enumerate(self.faces):
            for v in face:
                at.setdefault(v, []).append(f)
        for shared in at.values():
            for f in shared:
                around[f].update(shared)
        program.click(*program.item("Grow"))
        state = program.wait_for("it has grown", lambda s: s["undo"].startswith("grow"))
        assert state["depths"] == [max(after[g] for g in around[f])
                                   for f in range(len(self.faces))]
        program.key("shift+bracketleft")
        state = program.wait_for("it has shrunk", lambda s: s["undo"].startswith("shrink"))
        assert all(a <= b for a, b in zip(after, state["depths"])), "nothing is lost by that"
        shrunk = state["depths"]
        program.key("ctrl+i")
        state = program.wait_for("it is inverted", lambda s: s["undo"].startswith("invert"))
        assert state["depths"] == [max(shrunk) - depth for depth in shrunk]
        program.click(*program.item("Even out"))
        state = program.wait_for("it is evened out", lambda s: s["undo"].startswith("even out"))
        for _ in range(5):
            self.undo()
        assert program.state["depths"] == before


def main():
    executable, mesh = sys.argv[1:]
    positions, faces = read_obj(mesh)
    display = Display()
    with Folder() as folder:
        program = Program(executable, [mesh], display, folder)
        try:
            program.wait_for("the mesh is open and its labels are known", lambda s: not s["busy"])
            program.key("F2")  # What is painted on is what is known here: the control mesh.
            tools = Tools(program, positions, faces)
            tools.fill()
            tools.smart_fill()
            tools.through(tools.rectangle())
            tools.lasso()
            tools.lines()
            tools.fine()
            tools.mirror_and_rules()
            program.close_window()
            # All is undone: there is nothing to be asked about.
            code = program.wait_for_exit()
            assert code == 0, f"it ended with {code}:\n{program.log()}"
            assert "Sanitizer" not in program.log(), program.log()
        finally:
            program.kill()
            display.close()


if __name__ == "__main__":
    main()
