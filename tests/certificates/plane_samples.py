# SPDX-License-Identifier: MIT
"""Profiles of plane cams, their drawings and their programs as samples in doubles, for comparison with proved bounds.

The profile is an envelope of follower positions alone, with derivatives by differences; files are read by patterns.
"""
import math
import re

SAMPLES = 3000
STEP = 1e-5  # rad, of differences


class Sampled:
    """The cam of a result folder in doubles; `second`: the second disk of a conjugate one."""

    def __init__(self, scene, result, second=False):
        self.second = second
        self.cam, self.motion, parts = scene["cam"], scene["motion"], result["motion"]["parts"]
        self.curves, self.parts = result["motion"]["curves"], parts
        self.unit = math.radians(self.motion["rise_deg"]) if "rise_deg" in self.motion else 2 * math.pi / parts[-1]["end"]
        self.begin, self.end = 0.0, 2 * math.pi
        self.sense = -1 if self.cam.get("rotation") == "clockwise" else 1
        self.swings = self.cam.get("follower", "").startswith("oscillating")
        self.lift = math.radians(self.motion["lift_deg"]) if self.swings else self.motion["lift_mm"]
        self.roller = self.cam.get("roller_radius_mm", 0)

    def displacement(self, theta):
        x = (theta % (2 * math.pi) if self.begin == 0 else theta) / self.unit
        for part in self.parts:
            if part["begin"] <= x <= part["end"]:
                if part["curve"] is None:
                    return self.lift * part["y0"]
                curve = self.curves[part["curve"]]
                i = max(k for k, left in enumerate(curve["breakpoints"][:-1]) if left <= x or k == 0)
                t = x - curve["breakpoints"][i]
                return self.lift * sum(c * t**m for m, c in enumerate(curve["pieces"][i]))
        return 0.0 if x < 0 or self.begin == 0 else self.lift

    def follower(self, theta):
        """The roller's centre in the cam's frame; of a face, (height, 0) along its normal."""
        s, size = self.displacement(theta), self.cam
        if self.swings:
            distance, arm, prime = size["center_distance_mm"], size["arm_length_mm"], size["base_radius_mm"] + self.roller
            angle = math.acos((distance**2 + arm**2 - prime**2) / (2 * distance * arm)) + s
            angle = angle - math.radians(size["arm_angle_deg"]) if self.second else angle
            fixed = distance - arm * math.cos(angle), arm * math.sin(angle)
        else:
            offset = size.get("offset_mm", 0)
            fixed = offset, math.sqrt((size["base_radius_mm"] + self.roller)**2 - offset**2) + s
        return self.turned(fixed, theta)

    def turned(self, fixed, theta):
        c, s = math.cos(self.sense * theta), math.sin(self.sense * theta)
        return c * fixed[0] + s * fixed[1], c * fixed[1] - s * fixed[0]

    def at(self, theta):
        """(point of the profile, outward normal)."""
        if self.cam.get("follower") == "translating_flat":
            slope = (self.displacement(theta + STEP) - self.displacement(theta - STEP)) / (2 * STEP)
            contact = self.sense * slope, self.cam["base_radius_mm"] + self.displacement(theta)
            return self.turned(contact, theta), self.turned((0, 1), theta)
        center, before, after = (self.follower(theta + by) for by in (0, -STEP, STEP))
        dx, dy = after[0] - before[0], after[1] - before[1]
        normal = self.outwards(center, (-self.sense * dy / math.hypot(dx, dy), self.sense * dx / math.hypot(dx, dy)))
        return (center[0] - self.roller * normal[0], center[1] - self.roller * normal[1]), normal

    @staticmethod
    def outwards(center, normal):
        """Away from the cam's centre."""
        return normal if normal[0] * center[0] + normal[1] * center[1] >= 0 else (-normal[0], -normal[1])

    def curve(self, offset):
        own = [self.at(self.begin + (self.end - self.begin) * i / SAMPLES) for i in range(SAMPLES)]
        return [(p[0] + offset * n[0], p[1] + offset * n[1]) for p, n in own]


class SampledTappet(Sampled):
    """A lever, two couplers, a rocker and a slider along y, by the intersections of circles."""

    def __init__(self, scene, result):
        super().__init__(scene, result)
        self.linkage = scene["linkage"]
        if self.motion["type"] == "DRD":
            self.begin = (self.unit - 2 * math.pi) / 2
            self.end = self.begin + 2 * math.pi

    def joint(self, pivot, arm, far, coupler, branch):
        """The direction, from the pivot, of the joint on two circles, on one side of the line to the far one."""
        distance = math.dist(pivot, far)
        turn = math.acos((distance**2 + arm**2 - coupler**2) / (2 * distance * arm))
        return math.atan2(far[1] - pivot[1], far[0] - pivot[0]) + (turn if branch == "left" else -turn)

    def follower(self, theta):
        own, cam = self.linkage, self.cam
        slider, pivot = (own["slider_x_mm"], own["slider_y_mm"] + self.displacement(theta)), (own["rocker_pivot_x_mm"], own["rocker_pivot_y_mm"])
        turn = self.joint(pivot, own["rocker_output_arm_mm"], slider, own["second_coupler_mm"], own["rocker_branch"])
        arm = own["rocker_input_arm_mm"]
        far = pivot[0] + arm * math.cos(turn), pivot[1] + arm * math.sin(turn)
        pivot = cam["lever_pivot_x_mm"], cam["lever_pivot_y_mm"]
        turn = self.joint(pivot, own["lever_arm_mm"], far, own["coupler_mm"], own["lever_branch"]) - math.radians(own["lever_angle_deg"])
        arm = cam["roller_arm_mm"]
        return self.turned((pivot[0] + arm * math.cos(turn), pivot[1] + arm * math.sin(turn)), theta)


class SampledPlate(Sampled):
    """A plate that slides: the follower stands over it, and what lies below is seen from the plate."""

    def __init__(self, scene, result):
        super().__init__(scene, result)
        self.slide = self.cam["travel_mm"] / (2 * math.pi)
        self.sense = math.copysign(1, self.slide)
        if self.motion["type"] == "DRD":
            self.begin = (self.unit - 2 * math.pi) / 2
            self.end = self.begin + 2 * math.pi

    @staticmethod
    def outwards(center, normal):
        """Upwards."""
        return normal if normal[1] >= 0 else (-normal[0], -normal[1])

    def follower(self, theta):
        s, size = self.displacement(theta), self.cam
        height = size["base_height_mm"] + self.roller
        if not self.swings:
            lean = math.radians(size.get("inclination_deg", 0))
            return self.slide * theta + s * math.sin(lean), height + s * math.cos(lean)
        arm = size["arm_length_mm"]
        rest = math.asin((height - size["pivot_height_mm"]) / arm)
        return (self.slide * theta + arm * (math.cos(rest) - math.cos(rest + s)), size["pivot_height_mm"] + arm * math.sin(rest + s))


def guide_of(cam, feeder, theta):
    """(L, psi) of an inverse cam at a displacement of the feeder and a cam angle, in inches; psi without the pin's angle."""
    slope = (cam["feeder_start_in"] + feeder - cam["rocker_pivot_y_in"]) / cam["feeder_offset_in"]
    turn, pivot = math.atan(slope), (cam["rocker_pivot_x_in"], cam["rocker_pivot_y_in"])
    e = -math.cos(turn), -math.sin(turn)
    foot = e[0] * pivot[0] + e[1] * pivot[1]
    reach = -foot - math.sqrt(foot**2 + cam["pin_distance_in"]**2 - pivot[0]**2 - pivot[1]**2)
    rest, end, stroke = cam["roller_rest_in"], cam["roller_end_in"], math.radians(cam["roller_angle_deg"])
    at = stroke * math.sqrt((cam["roller_from_in"] - rest) / (end - rest)) + theta
    return rest + (end - rest) * (at / stroke)**2, -math.atan2(pivot[1] + reach * e[1], pivot[0] + reach * e[0])


class SampledGuide(Sampled):
    """`curve` to the left of the roller's path in the body, from positions by differences."""

    def __init__(self, scene, result):
        self.inches = {key: value for key, value in scene["cam"].items() if key.endswith("_in") or key == "roller_angle_deg"}
        super().__init__(scene | {"motion": scene["motion"] | {"lift_mm": scene["motion"]["lift_in"]}}, result)
        self.begin, self.end = STEP, self.unit - STEP

    def follower(self, theta):
        distance, angle = guide_of(self.inches, self.displacement(theta), theta)
        angle += math.radians(self.cam["pin_angle_deg"])
        return 25.4 * distance * math.cos(angle), 25.4 * distance * math.sin(angle)

    def at(self, theta):
        center, before, after = (self.follower(theta + by) for by in (0, -STEP, STEP))
        dx, dy = after[0] - before[0], after[1] - before[1]
        return center, (-dy / math.hypot(dx, dy), dx / math.hypot(dx, dy))


def to_line(point, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / (dx * dx + dy * dy)
    t = min(1, max(0, t))
    return math.dist(point, (a[0] + t * dx, a[1] + t * dy))


def to_arc(point, a, b, bulge):
    """Of an arc below half a circle."""
    if abs(bulge) < 1e-12:
        return to_line(point, a, b)
    dx, dy = b[0] - a[0], b[1] - a[1]
    k = (1 - bulge**2) / (4 * bulge)
    center = (a[0] + b[0]) / 2 - k * dy, (a[1] + b[1]) / 2 + k * dx
    radius = math.dist(center, a)
    ends = [(z[0] - center[0], z[1] - center[1]) for z in (a, b)] if bulge > 0 else [(z[0] - center[0], z[1] - center[1]) for z in (b, a)]
    arm = point[0] - center[0], point[1] - center[1]
    inside = ends[0][0] * arm[1] - ends[0][1] * arm[0] >= 0 and arm[0] * ends[1][1] - arm[1] * ends[1][0] >= 0
    return abs(math.hypot(*arm) - radius) if inside else min(math.dist(point, a), math.dist(point, b))


def largest_distance(points, segments):
    """From the points to the nearest of segments (a, b, bulge), which are searched around the nearest start."""
    worst, starts = 0.0, [own[0] for own in segments]
    for point in points:
        i = min(range(len(starts)), key=lambda k: (starts[k][0] - point[0])**2 + (starts[k][1] - point[1])**2)
        worst = max(worst, min(to_arc(point, *segments[(i + k) % len(segments)]) for k in (-2, -1, 0, 1)))
    return worst


def outline_of(text, layer="CAM", which=0):
    """[(line of x, x, y, bulge)] of a layer, by pattern; `which` of its outlines."""
    lines, found = text.split("\n"), []
    i = [k for k, line in enumerate(lines) if line == "LWPOLYLINE" and layer in lines[k:k + 10]][which]
    for k in range(i + 1, len(lines) - 1, 2):
        if lines[k].strip() == "0":
            return found
        if lines[k].strip() == "10":
            found.append([k + 2, float(lines[k + 1]), None, 0.0])
        elif lines[k].strip() == "20" and found:
            found[-1][2] = float(lines[k + 1])
        elif lines[k].strip() == "42":
            found[-1][3] = float(lines[k + 1])
    return found


def arcs_of(corners):
    return [((x, y), (u, v), b) for (_, x, y, b), (_, u, v, _) in zip(corners, corners[1:] + corners[:1])]


def finish_of(text):
    """[(line, x, y, (i, j) or None)] of the last pass, from where it first is at its lowest depth."""
    lines, found, x, y = text.split("\n"), [], None, None
    first = max(k for k, line in enumerate(lines) if line.startswith("(pass:"))
    for k in range(first, len(lines)):
        words = dict((w[0], float(w[1:])) for w in re.findall(r"[XYZIJG][-\d.]+", lines[k].split("(")[0]))
        x, y = words.get("X", x), words.get("Y", y)
        if words.get("G") in (1, 2, 3) and "Z" not in words:
            found.append((k + 1, x, y, (words["G"], words["I"], words["J"]) if "I" in words else None))
    return found[1:]  # the first move starts where the cutter plunged


def contour(program):
    """Segments of the closed part of the last pass."""
    moves = finish_of(program)
    begin = moves[0][1:3]
    last = max(k for k, move in enumerate(moves) if move[1:3] == begin)
    segments = []
    for before, (_, x, y, arc) in zip(moves[:last], moves[1:last + 1]):
        a, bulge = before[1:3], 0.0
        if arc:
            sense, i, j = arc
            turn = math.atan2(y - a[1] - j, x - a[0] - i) - math.atan2(-j, -i)
            turn = turn % (2 * math.pi) if sense == 3 else -(-turn % (2 * math.pi))
            bulge = math.tan(turn / 4)
        segments.append((a, (x, y), bulge))
    return segments
