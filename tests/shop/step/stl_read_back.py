# SPDX-License-Identifier: MIT
"""stl_read_back.py FOLDER: every NAME.stl in the folder is a binary STL whose triangles, joined where their corners
are equal, bound a solid: every edge is passed once in each direction, the volume is positive, the normals are those
of the corners. Python's standard library only."""

import collections
import math
import pathlib
import struct
import sys


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def check(path):
    data = path.read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    assert not data.startswith(b"solid") and b"mm" in data[:80]
    assert len(data) == 84 + 50 * count and count > 100, path.name
    edges, volume, worst = collections.Counter(), 0.0, 0.0
    for k in range(count):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * k)
        normal, corners = numbers[:3], [numbers[i:i + 3] for i in (3, 6, 9)]
        volume += dot(corners[0], cross(corners[1], corners[2])) / 6.0
        for a, b in ((0, 1), (1, 2), (2, 0)):
            assert corners[a] != corners[b], f"{path.name}: triangle {k} has no area"
            edges[corners[a], corners[b]] += 1
        across = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
        area = math.sqrt(dot(across, across))
        if area > 1e-3:  # a sliver's normal is lost in single precision
            worst = max(worst, 1.0 - dot(normal, across) / area)
    faults = sum(1 for (a, b), times in edges.items() if times != 1 or edges.get((b, a)) != 1)
    print(f"{path.name}: {count} triangles, {faults} faulty edges, {volume:.1f} mm3, normals off by {worst:.1g}")
    assert faults == 0 and volume > 0.0 and worst < 1e-2


def main():
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.stl"))
    assert files, "no STL file"
    for path in files:
        check(path)


main()
