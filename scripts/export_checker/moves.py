# SPDX-License-Identifier: MIT
"""A move of an NC program."""


class Move:
    """From a block of line `line`. `start`, `end`: (x, y, z) and, in degrees, (rotary, tilt) as far as there are such axes,
    None where a coordinate is not known. `kind`: 0 rapid, 1 line,
    2 arc clockwise, 3 counterclockwise. `center`: (x, y) of an arc. `wanted`: (x, y) of both ends as they are programmed, which
    cutter compensation goes beside."""

    def __init__(self, line, kind, start, end, center=None, wanted=None):
        self.line, self.kind, self.start, self.end, self.center = line, kind, tuple(start), tuple(end), center
        self.wanted = wanted or (self.start[:2], self.end[:2])

    def is_known(self):
        return None not in self.start and None not in self.end

    def moves_in_plane(self):
        return self.kind in (2, 3) or self.start[:2] != self.end[:2]
