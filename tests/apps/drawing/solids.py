# SPDX-License-Identifier: MIT
"""Solids as files, read without camopt."""

import struct


def mesh_volume(path):
    """Of a binary STL, mm³. Every edge must be there once in either direction: the mesh is closed."""
    data = path.read_bytes()
    count, = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count
    volume, edges = 0.0, {}
    for i in range(count):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * i)
        a, b, c = numbers[3:6], numbers[6:9], numbers[9:12]
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                   + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        for edge in ((a, b), (b, c), (c, a)):
            edges[edge] = edges.get(edge, 0) + 1
    assert all(edges.get((b, a)) == 1 and number == 1 for (a, b), number in edges.items()), "not watertight"
    return volume
