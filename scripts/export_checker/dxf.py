# SPDX-License-Identifier: MIT
"""profile.dxf: each outline of a plane cam as one polyline of lines and arcs, open where the cam is.

A DXF file is a list of tags: a group code and a value, a line each. Only what the outline consists of is read; what it may
consist of is listed, so that nothing which changes it is overlooked. Base and prime circle are those of the cam, the rim of a grooved disk
leaves the wall that the scene states around the outer flank; other layers (axes, follower) are not checked. The walls of an inverse cam's
guide share a layer, the left one first. The outline of a plate is its surface, closed by its sides and its bottom at y = 0.
"""
import itertools
import math

from certificate_checker.exact import Refuted, Unverified
from certificate_checker.rational import Fraction
from certificate_checker.units import dimension_of

from .clearance import Polygon
from .departure import largest_departure
from .linear_cam import LinearCam
from .linked_cams import InverseCam, LinkedCam, RemoteCam
from .outcome import Outcome
from .places import Places
from .plane_cam import MILLIMETRES as PER_METRE, WITH_ROLLER, PlaneCam
from .segments import bulged

MILLIMETRES = "4"  # of $INSUNITS
# Group codes of a LWPOLYLINE that do not move it: handle, owner, subclass, layer, count, flags; constant width where it is 0.
HARMLESS = {5, 330, 100, 8, 90, 70}
WIDTH = 43
HARMLESS_OF_CIRCLES = {5, 330, 100, 8}
CIRCLES = Fraction(1, 10**6)  # mm: a circle that departs by more is another one
RIM, RIM_SAG = 1e-3, 1e-4     # mm: the same of a rim, which rounds a largest radius; of the polygon that encloses it


class Tag:
    """`line`: of the group code, counted from 1."""

    def __init__(self, line, code, value):
        self.line, self.code, self.value = line, code, value


def tags_of(text):
    lines = text.splitlines()
    if len(lines) % 2:
        raise Refuted(f"line {len(lines)}: a group code without a value")
    found = []
    for i in range(0, len(lines), 2):
        try:
            found.append(Tag(i + 1, int(lines[i]), lines[i + 1].strip()))
        except ValueError:
            raise Refuted(f"line {i + 1}: {lines[i]!r} is not a group code") from None
    if not found or (found[-1].code, found[-1].value) != (0, "EOF"):
        raise Refuted(f"line {len(lines)}: the file does not end with EOF")
    return found


def sections_of(tags):
    """{name: tags between its name and its end}."""
    found, name, begin = {}, None, 0
    for i, tag in enumerate(tags):
        if tag.code != 0:
            continue
        if tag.value == "SECTION":
            if name is not None or tags[i + 1].code != 2 or tags[i + 1].value in found:
                raise Refuted(f"line {tag.line}: a section that begins inside another, or twice")
            name, begin = tags[i + 1].value, i + 2
        elif tag.value == "ENDSEC":
            if name is None:
                raise Refuted(f"line {tag.line}: the end of no section")
            found[name], name = tags[begin:i], None
    return found


def check_units(header):
    for variable, value in zip(header, header[1:]):
        if (variable.code, variable.value) == (9, "$INSUNITS"):
            if (value.code, value.value) != (70, MILLIMETRES):
                raise Unverified(f"line {value.line}: a drawing in other units than mm")
            return
    raise Unverified("a drawing that does not state its units")


def entities_of(tags):
    """Each with its tags, the type first."""
    found = []
    for tag in tags:
        if tag.code == 0:
            found.append([])
        if not found:
            raise Refuted(f"line {tag.line}: a tag before the first entity")
        found[-1].append(tag)
    return found


def on_layer(entities, layer):
    return [own for own in entities if any(tag.code == 8 and tag.value.upper() == layer for tag in own)]


def real(tag):
    try:
        return Fraction(tag.value)
    except (ValueError, ZeroDivisionError):
        raise Refuted(f"line {tag.line + 1}: {tag.value!r} is not a number") from None


class Polyline:
    """`vertices`: (line, (x, y), bulge of what follows)."""

    def __init__(self, entity, is_open):
        if entity[0].value != "LWPOLYLINE":
            raise Refuted(f"line {entity[0].line + 1}: {entity[0].value} on the layer of the outline, which is one LWPOLYLINE")
        self.line, self.is_open, self.vertices = entity[0].line, is_open, []
        count, flags, x, line = None, None, None, 0
        for tag in entity[1:]:
            if x is not None and tag.code != 20:
                raise Refuted(f"line {tag.line}: a vertex without y")
            if tag.code == 10:
                x, line = real(tag), tag.line + 1
            elif tag.code == 20 and x is not None:
                self.vertices.append((line, (x, real(tag)), Fraction(0)))
                x = None
            elif tag.code == 42 and self.vertices:
                self.vertices[-1] = *self.vertices[-1][:2], real(tag)
            elif tag.code not in HARMLESS and (tag.code != WIDTH or real(tag)):
                raise Refuted(f"line {tag.line}: group code {tag.code} in the outline")
            count, flags = (tag.value if tag.code == 90 else count), (tag.value if tag.code == 70 else flags)
        if count is None or count != str(len(self.vertices)) or len(self.vertices) < 2:
            raise Refuted(f"line {self.line}: {count} vertices are announced, {len(self.vertices)} follow")
        if flags != ("0" if is_open else "1"):
            raise Refuted(f"line {self.line}: the outline is {'closed' if is_open else 'not closed'}")

    def points(self):
        return [tuple(map(float, point)) for _, point, _ in self.vertices]

    def reverse(self):
        lines, points, bulges = zip(*reversed(self.vertices))
        self.vertices = list(zip(lines, points, [-b for b in bulges[1:] + bulges[:1]]))

    def segments(self):
        """Without those of no length; the line is that of the vertex where they begin."""
        back = self.vertices[-1:] if self.is_open else self.vertices[:1]  # no segment follows the end of an open one
        kept = [own for own, following in zip(self.vertices, self.vertices[1:] + back) if own[1] != following[1]]
        found = [bulged(line, point, following[1], bulge)
                 for (line, point, bulge), following in zip(kept, kept[1:] + (back if self.is_open else kept[:1]))]
        found[-1].end_line = back[0][0]
        return found


def surface_of(entity):
    """The outline of a plate without what closes it: straight down from either end to the bottom, and along it."""
    polyline = Polyline(entity, False)
    kept, below = polyline.vertices[:-2], polyline.vertices[-2:]
    straight = len(kept) > 1 and not any(bulge for _, _, bulge in kept[-1:] + below)
    ends = [(kept[-1][1][0], 0), (kept[0][1][0], 0)] if straight else []
    if not straight or any(abs(a - b) > CIRCLES for (_, point, _), end in zip(below, ends) for a, b in zip(point, end)):
        raise Refuted(f"line {polyline.line}: the outline is not closed by the sides and the bottom of the plate")
    polyline.vertices, polyline.is_open = kept, True
    return polyline


def departure_of(cam, entity, offset):
    is_body = isinstance(cam, LinearCam) and not offset
    polyline, places = surface_of(entity) if is_body else Polyline(entity, cam.motion.is_open), Places(cam, offset)
    if places.are_against(polyline.points()):
        polyline.reverse()
    segments = polyline.segments()
    points = [tuple(map(float, segment.start)) for segment in segments]
    if polyline.is_open:
        points.append(tuple(map(float, segments[-1].end)))
    return largest_departure(cam, segments, places.along(points), offset)


def circles_on(entities, layer):
    """[(line, {group code: number} of a circle, None of another entity)]."""
    for own in on_layer(entities, layer):
        yield own[0].line, {tag.code: real(tag) for tag in own[1:] if tag.code not in HARMLESS_OF_CIRCLES} if own[0].value == "CIRCLE" else None


def is_circle(drawn, radius, room):
    wanted = {10: 0, 20: 0, 30: 0, 40: radius}
    return drawn is not None and drawn.keys() == wanted.keys() and all(abs(drawn[k] - z) <= room for k, z in wanted.items())


def circle_faults(cam, entities):
    """Base and prime circle of a disk cam, about its centre."""
    sizes = {} if isinstance(cam, (LinkedCam, LinearCam)) else {"BASE_CIRCLE": cam.size["base_radius"]}
    if sizes and cam.follower in WITH_ROLLER:
        sizes["PRIME_CIRCLE"] = cam.prime
    faults = [f"line {line}: not the {layer} of the cam, radius {float(radius):g} mm" for layer, radius in sizes.items()
              for line, drawn in circles_on(entities, layer) if not is_circle(drawn, radius, CIRCLES)]
    return faults + (rim_faults(cam, entities) if cam.form == "grooved" else [])


def rim_faults(cam, entities):
    """The wall around a groove is the thinnest where the outer flank is the farthest from the cam's centre."""
    wall = dimension_of(cam.motion.scene["cam"], "groove_wall") * PER_METRE or cam.roller
    flank = Polygon(cam, 2 * cam.roller + cam.clearance / 2, RIM_SAG)
    radius = max(math.hypot(*corner) for corner in flank.corners) + float(wall)
    rims = list(circles_on(entities, "RIM"))
    faults = [f"line {line}: not the RIM of the cam, radius {radius:g} mm" for line, drawn in rims if not is_circle(drawn, radius, RIM - flank.sag)]
    return faults if rims else ["no circle on the layer RIM"]


def outlines_of(scene, design):
    """[(layer, bound it belongs to, cam, distance outside of the profile)]; a path of a roller's centre may be absent."""
    kind = scene.get("cam", {}).get("type")
    if kind == "inverse":
        cam = InverseCam(scene, design)
        return [("WALLS", "profile_mm", cam, cam.roller), ("WALLS", "profile_mm", cam, -cam.roller), ("PITCH", "pitch_mm", cam, Fraction(0))]
    makers = {"remote": RemoteCam, "linear": LinearCam}
    cam = makers.get(kind, PlaneCam)(scene, design)
    if cam.form == "grooved":
        half = cam.clearance / 2
        return [("INNER_FLANK", "profile_mm", cam, -half), ("OUTER_FLANK", "profile_mm", cam, 2 * cam.roller + half),
                ("PITCH", "pitch_mm", cam, cam.roller)]
    found = [("CAM", "profile_mm", cam, Fraction(0)), ("PITCH", "pitch_mm", cam, cam.roller)]
    if cam.form == "conjugate":
        second = PlaneCam(scene, design, second=True)
        found += [("SECOND_CAM", "profile_mm", second, Fraction(0)), ("SECOND_PITCH", "pitch_mm", second, second.roller)]
    return found


def verify(text, scene, design):
    """The Outcome of a drawing: "profile_mm", the largest over all outlines, and "pitch_mm" where it has the path of a roller's
    centre."""
    outlines = outlines_of(scene, design)
    sections = sections_of(tags_of(text))
    check_units(sections.get("HEADER", []))
    blocks = entities_of(sections.get("BLOCKS", []))
    entities = entities_of(sections.get("ENTITIES", []))
    outcome = Outcome(faults=circle_faults(outlines[0][2], entities))
    for layer, wanted in itertools.groupby(outlines, key=lambda row: row[0]):
        wanted, own = list(wanted), on_layer(entities, layer)
        if on_layer(blocks, layer):
            raise Refuted(f"line {on_layer(blocks, layer)[0][0].line}: a block on the layer {layer}")
        if len(own) > len(wanted):
            raise Refuted(f"line {own[len(wanted)][0].line}: one outline too many on the layer {layer}")
        if len(own) < len(wanted) and wanted[0][1] == "profile_mm":
            raise Refuted(f"{len(own)} outlines on the layer {layer}, not {len(wanted)}")
        for (_, name, cam, offset), entity in zip(wanted, own):
            bound, place = departure_of(cam, entity, offset)
            if bound > outcome.bounds.get(name, -1.0):
                outcome.bounds[name], outcome.places[name] = bound, place
    return outcome
