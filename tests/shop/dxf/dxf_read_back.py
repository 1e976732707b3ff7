# SPDX-License-Identifier: MIT
"""dxf_read_back.py FOLDER TOLERANCE_MM: every NAME.dxf in the folder, opened by ezdxf, has no error, is in mm, has
the layers of a cam and a closed outline whose arcs pass the points of NAME.csv within the tolerance.

Needs ezdxf (Debian: python3-ezdxf). Without it nothing is checked and the exit status is 77.
"""

import csv
import math
import pathlib
import sys

LAYERS = {"CAM", "PITCH", "BASE_CIRCLE", "PRIME_CIRCLE", "ROLLER", "FACE", "AXES"}
MILLIMETRES = 4


def distance_to_arc(point, start, end, bulge):
    """Distance to the arc itself, its ends included."""
    import ezdxf.math
    center, first, last, radius = ezdxf.math.bulge_to_arc(start, end, bulge)
    dx, dy = point[0] - center.x, point[1] - center.y
    turn = (math.atan2(dy, dx) - first) % math.tau
    if turn <= (last - first) % math.tau:
        return abs(math.hypot(dx, dy) - radius)
    return min(math.dist(point, start), math.dist(point, end))


def distance_to_polyline(point, vertices, near):
    """Least distance; only arcs whose ends are near the point are looked at."""
    least = math.inf
    for (x, y, bulge), (next_x, next_y, _) in zip(vertices, vertices[1:] + vertices[:1]):
        if min(math.dist(point, (x, y)), math.dist(point, (next_x, next_y))) < near:
            least = min(least, distance_to_arc(point, (x, y), (next_x, next_y), bulge))
    return least


def check(path, tolerance):
    import ezdxf
    drawing = ezdxf.readfile(path)
    auditor = drawing.audit()
    assert not auditor.has_errors, [error.message for error in auditor.errors]
    assert not auditor.has_fixes, [error.message for error in auditor.fixes]
    assert drawing.dxfversion == "AC1015", drawing.dxfversion
    assert drawing.units == MILLIMETRES, drawing.units
    used = {entity.dxf.layer for entity in drawing.modelspace()}
    assert "CAM" in used and used <= LAYERS, used
    assert used <= {layer.dxf.name for layer in drawing.layers}, used
    outlines = drawing.modelspace().query("LWPOLYLINE[layer=='CAM']")
    assert len(outlines) == 1 and outlines[0].closed
    vertices = list(outlines[0].get_points("xyb"))
    longest = max(math.dist(a[:2], b[:2]) for a, b in zip(vertices, vertices[1:] + vertices[:1]))
    with open(path.with_suffix(".csv"), newline="") as file:
        points = [(float(row["x_mm"]), float(row["y_mm"])) for row in csv.DictReader(file)]
    worst = max(distance_to_polyline(point, vertices, longest) for point in points)
    print(f"{path.name}: {len(vertices)} arcs, {len(points)} points, largest distance {1e3 * worst:.4f} um")
    assert worst <= tolerance, f"{path.name}: {worst} mm from the cam"


def main():
    folder, tolerance = pathlib.Path(sys.argv[1]), float(sys.argv[2])
    files = sorted(folder.glob("*.dxf"))
    assert files, f"no DXF file in {folder}"
    try:
        import ezdxf
    except ImportError:
        print(f"SKIPPED: no ezdxf (Debian: python3-ezdxf); {len(files)} DXF files were not read back")
        sys.exit(77)
    for path in files:
        check(path, tolerance)
    print(f"dxf_read_back: {len(files)} files read by ezdxf {ezdxf.__version__}, no error")


main()
