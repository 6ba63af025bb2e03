"""Makes wrench.obj: python3 wrench.py > wrench.obj

A spanner 0.23 m long with a ring, a handle and a jaw, each of its own thickness: closed,
concave, with one hole, and with its centre of mass away from its middle. Its length lies
along x, its flat sides face up and down y. Every face has its own normal, so that edges
look sharp; vertices on edges therefore stand in the file once for each normal.
"""
from __future__ import annotations

import math

Point = tuple[float, float]

RING, JAW = (0.0, 0.0), (0.19, 0.0)  # centres in the plane of the wrench [m]
HALF_THICK = {"ring": 0.006, "handle": 0.0035, "jaw": 0.005}
TILT = math.radians(15)  # of the jaw against the handle


def on_circle(centre: Point, radius: float, degrees: float) -> Point:
    angle = math.radians(degrees)
    return (round(centre[0] + radius * math.cos(angle), 6),
            round(centre[1] + radius * math.sin(angle), 6))


def jaw_outline() -> tuple[list[Point], list[Point]]:
    """Counter-clockwise, and the part of it that joins the handle."""
    def turned(x: float, y: float) -> Point:
        return (round(JAW[0] + x * math.cos(TILT) - y * math.sin(TILT), 6),
                round(JAW[1] + x * math.sin(TILT) + y * math.cos(TILT), 6))

    # The slot for a nut 20 mm wide, from the lower tip to the upper one
    slot = [turned(16e-3, -10e-3), turned(-7e-3, -10e-3), turned(-12.8e-3, 0),
            turned(-7e-3, 10e-3), turned(16e-3, 10e-3)]
    tip = math.degrees(math.acos(16 / 24))
    corners = [tip + 15, 160, 200, 375 - tip]
    angles = [a + (b - a) * i / n for (a, b), n in
              zip(zip(corners, corners[1:]), (10, 4, 10)) for i in range(n)]
    arc = [on_circle(JAW, 24e-3, angle) for angle in [*angles, corners[-1]]]
    return slot + arc, arc[10:15]


def ears(outline: list[Point]) -> list[tuple[Point, Point, Point]]:
    """Triangles of a simple polygon, by cutting off its ears."""
    def side(a: Point, b: Point, c: Point) -> float:
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    left, triangles = list(outline), []
    while len(left) > 2:
        found = []
        for i, b in enumerate(left):
            a, c = left[i - 1], left[(i + 1) % len(left)]
            others = (p for p in left if p not in (a, b, c))
            if side(a, b, c) > 1e-12 and not any(
                    min(side(a, b, p), side(b, c, p), side(c, a, p)) >= 0 for p in others):
                found.append((math.dist(a, c), i, (a, b, c)))
        _, i, triangle = min(found)  # the shortest cut: no slivers
        triangles.append(triangle)
        del left[i]
    return triangles


def strip(left: list[Point], right: list[Point]) -> list[tuple[Point, Point, Point]]:
    """Triangles between two chains that run side by side, seen along them."""
    i = j = 0
    triangles = []
    while i + 1 < len(left) or j + 1 < len(right):
        on_left = j + 1 == len(right) or (
            i + 1 < len(left)
            and math.dist(left[i + 1], right[j]) <= math.dist(left[i], right[j + 1]))
        third = left[i + 1] if on_left else right[j + 1]
        triangles.append((left[i], right[j], third))
        i, j = (i + 1, j) if on_left else (i, j + 1)
    return triangles


def flat_parts() -> dict[str, list[tuple[Point, Point, Point]]]:
    """The wrench seen from above: triangles that share their edges."""
    jaw, jaw_joint = jaw_outline()
    outer = [on_circle(RING, 16e-3, 360 / 32 * i) for i in range(33)]
    hole = [on_circle(RING, 11e-3, 60 * i) for i in range(7)]
    ring_joint = [on_circle(RING, 16e-3, 360 / 32 * (i % 32)) for i in range(-2, 3)]
    return {"ring": strip(hole, outer), "jaw": ears(jaw),
            "handle": strip(ring_joint, jaw_joint[::-1])}


def level_columns(parts: dict) -> dict[Point, list[float]]:
    """The heights at which the solid has vertices above and below each point."""
    columns: dict[Point, set[float]] = {}
    for part, triangles in parts.items():
        for point in (p for triangle in triangles for p in triangle):
            columns.setdefault(point, set()).update((-HALF_THICK[part], HALF_THICK[part]))
    return {point: sorted(heights) for point, heights in columns.items()}


def wall(a: Point, b: Point, low: float, high: float, columns: dict) -> list:
    """Upright between two heights over the edge from a to b, the solid to its left."""
    at_a, at_b = ([(*p, h) for h in columns[p] if low <= h <= high] for p in (a, b))
    return strip(at_a, at_b)


def solid() -> list:
    parts = flat_parts()
    columns = level_columns(parts)
    part_left_of = {(t[k], t[(k + 1) % 3]): part for part, triangles in parts.items()
                    for t in triangles for k in range(3)}
    faces = []
    for part, triangles in parts.items():
        h = HALF_THICK[part]
        for a, b, c in triangles:
            faces += [((*a, h), (*b, h), (*c, h)), ((*a, -h), (*c, -h), (*b, -h))]

    # Walls on the outline from bottom to top, and where a thinner part joins
    for (a, b), part in part_left_of.items():
        h, other = HALF_THICK[part], HALF_THICK.get(part_left_of.get((b, a), ""), 0)
        if other == 0:
            faces += wall(a, b, -h, h, columns)
        elif other < h:
            faces += wall(a, b, -h, -other, columns) + wall(a, b, other, h, columns)
    return faces


def normal(a, b, c) -> tuple[float, float, float]:
    u, v = ([q - p for p, q in zip(a, end)] for end in (b, c))
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return tuple(round(x / math.hypot(*n), 4) + 0.0 for x in n)


def main() -> None:
    # From the plane and the height above it to x, y up, z
    faces = [[(x, h, -y + 0.0) for x, y, h in face] for face in solid()]
    vertices = list(dict.fromkeys(v for face in faces for v in face))
    normals = list(dict.fromkeys(normal(*face) for face in faces))
    index = {v: i + 1 for i, v in enumerate(vertices)}
    of_normal = {n: i + 1 for i, n in enumerate(normals)}

    print("# A combination wrench, 0.23 m long, made by wrench.py")
    for v in vertices:
        print("v", *(f"{x:g}" for x in v))
    for n in normals:
        print("vn", *(f"{x:g}" for x in n))
    for face in faces:
        print("f", *(f"{index[v]}//{of_normal[normal(*face)]}" for v in face))


if __name__ == "__main__":
    main()
