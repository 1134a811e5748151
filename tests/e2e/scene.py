"""What the window ought to show, worked out here and not by the program under test: a mesh file
read anew, projected with the reported camera, and filled into a picture of face numbers."""

import math
import struct
import zlib


def read_obj(path):
    """Positions and faces (0-based vertex lists) of an OBJ file."""
    positions, faces = [], []
    with open(path) as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                positions.append(tuple(map(float, words[1:4])))
            elif words[:1] == ["f"]:
                faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return positions, faces


def newell_normal(positions, face):
    x = y = z = 0.0
    for i, v in enumerate(face):
        a, b = positions[v], positions[face[(i + 1) % len(face)]]
        x += (a[1] - b[1]) * (a[2] + b[2])
        y += (a[2] - b[2]) * (a[0] + b[0])
        z += (a[0] - b[0]) * (a[1] + b[1])
    length = math.sqrt(x * x + y * y + z * z)
    return x / length, y / length, z / length


def edge_angles(positions, faces):
    """For every edge between two faces those and the angle between their normals in degrees."""
    normals = [newell_normal(positions, face) for face in faces]
    beside = {}
    for f, face in enumerate(faces):
        for i, v in enumerate(face):
            beside.setdefault(frozenset((v, face[(i + 1) % len(face)])), []).append(f)
    angles = []
    for pair in beside.values():
        if len(pair) == 2:
            cosine = sum(p * q for p, q in zip(normals[pair[0]], normals[pair[1]]))
            angles.append((pair, math.degrees(math.acos(max(-1.0, min(1.0, cosine))))))
    return angles


def dihedral_angles(positions, faces):
    """For every face the largest angle, in degrees, between its normal and a neighbour's."""
    angles = [0.0] * len(faces)
    for pair, angle in edge_angles(positions, faces):
        for f in pair:
            angles[f] = max(angles[f], angle)
    return angles


class FaceImage:
    """Which face shows at each pixel centre of the viewport."""

    def __init__(self, positions, faces, state):
        self.x, self.y, width, height = state["viewport"]
        self.width, self.height = round(width), round(height)
        self.faces = faces
        self.points = [self._project(state["view_projection"], p) for p in positions]
        self.ids = [-1] * (self.width * self.height)
        self._depths = [math.inf] * (self.width * self.height)
        for f, face in enumerate(faces):
            for i in range(1, len(face) - 1):
                self._fill(f, *(self.points[v] for v in (face[0], face[i], face[i + 1])))

    def _project(self, matrix, point):
        x, y, z, w = (sum(m * c for m, c in zip(row, (*point, 1.0))) for row in matrix)
        return ((x / w + 1) / 2 * self.width, (1 - y / w) / 2 * self.height, -z / w)

    def _fill(self, f, a, b, c):
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if abs(area) < 1e-12:
            return
        rows = range(max(0, math.ceil(min(a[1], b[1], c[1]) - 0.5)),
                     min(self.height, math.floor(max(a[1], b[1], c[1]) - 0.5) + 1))
        first = max(0, math.ceil(min(a[0], b[0], c[0]) - 0.5))
        last = min(self.width, math.floor(max(a[0], b[0], c[0]) - 0.5) + 1)
        for row in rows:
            y = row + 0.5
            for column in range(first, last):
                x = column + 0.5
                u = ((b[0] - x) * (c[1] - y) - (b[1] - y) * (c[0] - x)) / area
                v = ((c[0] - x) * (a[1] - y) - (c[1] - y) * (a[0] - x)) / area
                w = 1.0 - u - v
                if u < 0.0 or v < 0.0 or w < 0.0:
                    continue
                depth = u * a[2] + v * b[2] + w * c[2]
                at = row * self.width + column
                if depth < self._depths[at]:
                    self._depths[at] = depth
                    self.ids[at] = f

    def points_of(self, f):
        """Where the corners of a face show, in viewport pixels."""
        return [self.points[v] for v in self.faces[f]]

    def at(self, x, y):
        """The face at a pixel of the viewport; -1 for none."""
        column, row = math.floor(x), math.floor(y)
        if 0 <= column < self.width and 0 <= row < self.height:
            return self.ids[row * self.width + column]
        return -1

    def counts(self):
        """Pixels of every face."""
        counts = [0] * len(self.faces)
        for f in self.ids:
            if f >= 0:
                counts[f] += 1
        return counts

    def middle(self, f):
        """A place well inside what shows of a face, in viewport pixels; None where it is small."""
        x = sum(self.points[v][0] for v in self.faces[f]) / len(self.faces[f])
        y = sum(self.points[v][1] for v in self.faces[f]) / len(self.faces[f])
        around = [(x + dx, y + dy) for dx in (-3, 0, 3) for dy in (-3, 0, 3)]
        return (x, y) if all(self.at(*place) == f for place in around) else None

    def to_window(self, place):
        return self.x + place[0], self.y + place[1]

    def faces_within(self, start, end, reach):
        """Faces with a pixel centre within reach of the line between two places."""
        found = set()
        dx, dy = end[0] - start[0], end[1] - start[1]
        length2 = max(dx * dx + dy * dy, 1e-9)
        for row in range(max(0, int(min(start[1], end[1]) - reach)),
                         min(self.height, int(max(start[1], end[1]) + reach) + 1)):
            for column in range(max(0, int(min(start[0], end[0]) - reach)),
                                min(self.width, int(max(start[0], end[0]) + reach) + 1)):
                x, y = column + 0.5, row + 0.5
                t = max(0.0, min(1.0, ((x - start[0]) * dx + (y - start[1]) * dy) / length2))
                if math.hypot(x - start[0] - t * dx, y - start[1] - t * dy) <= reach:
                    found.add(self.ids[row * self.width + column])
        found.discard(-1)
        return found


def read_png(path):
    """Width, height and rows of (r, g, b) tuples of an 8-bit RGB or RGBA PNG without interlacing."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, header = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    width, height, bits, colour_type, _, _, interlace = header
    assert bits == 8 and colour_type in (2, 6) and interlace == 0
    size = 3 if colour_type == 2 else 4
    raw, rows, before = zlib.decompress(packed), [], bytearray(width * size)
    for y in range(height):
        start = y * (width * size + 1)
        row = _unfilter(raw[start], bytearray(raw[start + 1:start + 1 + width * size]), before, size)
        rows.append([tuple(row[x * size:x * size + 3]) for x in range(width)])
        before = row
    return width, height, rows


def _unfilter(kind, row, before, size):
    for i in range(len(row)):
        left = row[i - size] if i >= size else 0
        up = before[i]
        corner = before[i - size] if i >= size else 0
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = up
        elif kind == 3:
            guess = (left + up) // 2
        elif kind == 4:
            estimate = left + up - corner
            guess = min((left, up, corner), key=lambda value: abs(estimate - value))
        else:
            guess = 0
        row[i] = (row[i] + guess) & 255
    return row
