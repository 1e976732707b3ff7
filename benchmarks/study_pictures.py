# SPDX-License-Identifier: MIT
"""The pictures of RESULTS.md, each from the rows (dicts of text) of one table. Python's standard library only."""

from plot import COLOURS, Axis, Panel, Picture

DESIGNS = {"states": COLOURS[0], "coefficients": COLOURS[2], "ordinates": COLOURS[1]}
LEAST_ERROR = 1e-15


def number(row, key):
    """None where the cell is empty or no number."""
    try:
        value = float(row.get(key) or "nan")
    except ValueError:
        return None
    return value if value == value and abs(value) != float("inf") else None


def doublings(lower, upper):
    ticks, n = [], lower
    while n <= upper:
        ticks.append((n, str(n)))
        n *= 4
    return ticks


def grid_boxes(count, columns, width, height):
    for index in range(count):
        yield (90 + (index % columns) * (width + 100), 150 + (index // columns) * (height + 95), width, height)


def marked_line(panel, points, colour, size):
    panel.line(points, colour)
    for across, up in points:
        panel.mark(across, up, colour, size=size)


def error_against_time(rows, machine):
    backends = list(dict.fromkeys(row["backend"] for row in rows))
    columns = 3
    lines = -(-len(backends) // columns)
    picture = Picture(1400, 130 + lines * 365, "How exact, how fast: error of the objective against run time",
                      f"DRD and RR, cubic and quintic splines, 4 to 16384 segments, every row that ran. {machine}")
    picture.legend(90, 100, [(name, colour, "circle", True) for name, colour in DESIGNS.items()] +
                   [("hollow: not proved optimal", COLOURS[0], "circle", False),
                    ("tolerance 1e-6", COLOURS[0], "triangle", True), ("gap asked for, 1e-7", "", "target", True)])
    for backend, box in zip(backends, grid_boxes(len(backends), columns, 340, 270)):
        own = [row for row in rows if row["backend"] == backend]
        ran = [row for row in own if number(row, "relative_error") is not None and number(row, "seconds_median")]
        proved = sum(row["verdict"] == "optimal" for row in own)
        panel = Panel(picture, box, Axis(1e-5, 10, "seconds"), Axis(LEAST_ERROR, 10, "relative error", stride=3),
                      f"{backend}: {len(ran)} of {len(own)} ran, {proved} proved")
        panel.level(1e-7)
        for row in sorted(ran, key=lambda row: -int(row["n"])):
            loose = number(row, "tolerance") > 1e-8
            size = 2.2 + 0.42 * (int(row["n"]).bit_length() - 2)
            panel.mark(number(row, "seconds_median"), max(abs(number(row, "relative_error")), LEAST_ERROR),
                       DESIGNS[row["design"]], "triangle" if loose else "circle", size, row["verdict"] == "optimal")
    return picture.svg()


def time_against_segments(rows, machine):
    kinds = [("DRD", "3"), ("DRD", "5"), ("RR", "3")]
    picture = Picture(1400, 500, "Run time against the number of segments",
                      f"Exchange at tolerance 1e-9 over states; filled: proved optimal. {machine}")
    backends = list(dict.fromkeys(row["backend"] for row in rows))
    picture.legend(90, 100, [(name, COLOURS[k], "circle", True) for k, name in enumerate(backends)])
    for (motion, degree), box in zip(kinds, grid_boxes(3, 3, 340, 290)):
        panel = Panel(picture, box, Axis(4, 16384, "segments", ticks=doublings(4, 16384)), Axis(1e-5, 10, "seconds"),
                      f"{motion}, degree {degree}")
        for k, backend in enumerate(backends):
            own = [row for row in rows if row["backend"] == backend and row["motion"] == motion and
                   row["degree"] == degree and row["design"] == "states" and number(row, "tolerance") < 1e-8 and
                   number(row, "seconds_median")]
            panel.line([(int(row["n"]), number(row, "seconds_median")) for row in own], COLOURS[k])
            for row in own:
                panel.mark(int(row["n"]), number(row, "seconds_median"), COLOURS[k], size=3.5,
                           filled=row["verdict"] == "optimal")
    return picture.svg()


def forward_check(rows, machine):
    laws = list(dict.fromkeys(row["law"] for row in rows))
    followers = list(dict.fromkeys(row["follower"] for row in rows))
    picture = Picture(1400, 500, "The exported profile: a follower on its points against the designed motion",
                      f"Largest deviation by the prime radius, cam turning counterclockwise. {machine}")
    picture.legend(90, 100, [(name, COLOURS[k], "circle", True) for k, name in enumerate(followers)])
    panels = [(law, "points", Axis(100, 10000, "points")) for law in laws]
    panels.append((laws[0], "seconds", Axis(1e-4, 1, "seconds of the check")))
    for (law, key, axis), box in zip(panels, grid_boxes(3, 3, 340, 290)):
        panel = Panel(picture, box, axis, Axis(1e-16, 1e-5, "relative deviation", stride=2),
                      law if key == "points" else f"{law}, by time")
        for k, follower in enumerate(followers):
            own = [(number(row, key), max(number(row, "relative") or 0, 1e-16)) for row in rows
                   if row["law"] == law and row["follower"] == follower and row["rotation"] == "counterclockwise"]
            marked_line(panel, own, COLOURS[k], 3)
    return picture.svg()


def mechanism_check(rows, machine):
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    picture = Picture(1000, 500, "The finished cam of a mechanism: its points move the output",
                      f"Largest deviation of the output, relative; the points alone drive it. {machine}")
    picture.legend(90, 100, [(name, COLOURS[k], "circle", True) for k, name in enumerate(scenes)])
    for (key, axis, title), box in zip((("asked", Axis(100, 10000, "points a turn or section"), "by points"),
                                        ("seconds", Axis(1e-4, 10, "seconds of the check"), "by time")),
                                       grid_boxes(2, 2, 380, 290)):
        panel = Panel(picture, box, axis, Axis(1e-16, 1e-4, "relative deviation", stride=2), title)
        for k, scene in enumerate(scenes):
            own = [(number(row, key), max(number(row, "relative") or 0, 1e-16)) for row in rows if row["scene"] == scene]
            marked_line(panel, own, COLOURS[k], 3)
    return picture.svg()


def peaks_by_sampling(rows, machine):
    curves = list(dict.fromkeys(row["curve"] for row in rows))
    picture = Picture(1400, 515, "Peaks looked up on samples against exact extrema",
                      f"Errors below 1e-10 stand on the lowest line; sampled peaks are never too large. {machine}")
    for row, part in enumerate((curves[:4], curves[4:])):
        picture.legend(90, 92 + 22 * row, [(name, COLOURS[4 * row + k], "circle", True) for k, name in enumerate(part)])
    for (key, title), box in zip((("error_velocity", "velocity"), ("error_acceleration", "acceleration"),
                                  ("error_jerk", "jerk")), grid_boxes(3, 3, 340, 290)):
        box = (box[0], box[1] + 15, box[2], box[3])
        panel = Panel(picture, box, Axis(60, 16000, "samples", ticks=[(90 * 2 ** k, str(90 * 2 ** k)) for k in range(0, 8, 2)]),
                      Axis(1e-10, 1, "relative error", stride=2), title)
        for k, curve in enumerate(curves):
            own = [(int(row["samples"]), max(-(number(row, key) or 0), 1e-10)) for row in rows
                   if row["curve"] == curve and row["samples"] != "0"]
            marked_line(panel, own, COLOURS[k], 2.5)
    return picture.svg()


def final_lp(best, machine):
    """best: (program, degree) -> [(n, seconds)], the quickest accurate way of each."""
    programs = list(dict.fromkeys(program for program, _ in best))
    picture = Picture(1000, 525, "One linear program, every solver: the quickest way of each",
                      f"The program an exchange ended on; ways within 1e-8 of the optimum only. {machine}")
    for line in range(2):
        picture.legend(90, 92 + 22 * line, [(name, COLOURS[4 * line + k], "circle", True)
                                            for k, name in enumerate(programs[4 * line:4 * line + 4])])
    for degree, box in zip(("3", "5"), grid_boxes(2, 2, 380, 300)):
        box = (box[0], box[1] + 15, box[2], box[3])
        panel = Panel(picture, box, Axis(8, 1500, "segments", ticks=[(16, "16"), (64, "64"), (256, "256"), (1024, "1024")]),
                      Axis(1e-5, 100, "seconds of the call"), f"DRD, degree {degree}")
        for k, program in enumerate(programs):
            own = best.get((program, degree), [])
            panel.line(own, COLOURS[k])
            for n, seconds in own:
                panel.mark(n, seconds, COLOURS[k])
    return picture.svg()


def growth(rows, machine):
    kinds = {"call": "call on the final grid", "exchange": "exchange", "solve": "whole solve, proof included"}
    picture = Picture(1000, 500, "The structured solver from 128 to 16384 segments", f"DRD cubic, states. {machine}")
    picture.legend(90, 100, [(words, COLOURS[k], "circle", True) for k, words in enumerate(kinds.values())])
    boxes = list(grid_boxes(2, 2, 370, 290))
    across = Axis(100, 20000, "segments", ticks=[(n, str(n)) for n in (128, 512, 2048, 8192)])
    seconds = Panel(picture, boxes[0], across, Axis(1e-4, 100, "seconds"), "time; dashed: growth as n")
    errors = Panel(picture, boxes[1], across, Axis(1e-14, 1e-6, "relative", stride=2),
                   "distance from independent optima of ten digits")
    for k, kind in enumerate(kinds):
        own = [row for row in rows if row["kind"] == kind and number(row, "seconds_median")]
        points = [(int(row["n"]), number(row, "seconds_median")) for row in own]
        seconds.line(points, COLOURS[k])
        if points:
            n, first = points[0]
            seconds.line([(n, first), (16384, first * 16384 / n)], COLOURS[k], dashed=True)
        for point in points:
            seconds.mark(*point, COLOURS[k])
        for row in own:
            if number(row, "relative_difference") is not None:
                errors.mark(int(row["n"]), max(abs(number(row, "relative_difference")), 1e-14), COLOURS[k])
    errors.level(1e-8, "asked for")
    return picture.svg()


INTEGRATORS = (("exact", "circle"), ("exact with its peak", "square"), ("BDF (CVODE)", "circle"), ("DIRK 5 (ARKODE)", "square"),
               ("Rosenbrock 4 (odeint)", "triangle"), ("Dormand-Prince 5 (odeint)", "circle"), ("Runge-Kutta 4 (odeint)", "square"))


def integrators(rows, names):
    """Error against time by the exact response's: three stiffnesses of either train, damping 0.02."""
    picture = Picture(1180, 800, "A follower train's response: error against time",
                      "Damping 0.02 of critical; time by that of the exact end state; what is missing stopped or blew up")
    colours = dict(zip((name for name, _ in INTEGRATORS), COLOURS))
    for k, words in enumerate(names):
        picture.legend(60 + 285 * (k % 4), 92 + 20 * (k // 4), [(words, colours[words], dict(INTEGRATORS)[words], True)])
    for i, train in enumerate(("one mass", "two masses")):
        for k, (ratio, words) in enumerate(((1.0, "1"), (1e4, "10⁴"), (1e8, "10⁸"))):
            what = "of the train" if train == "one mass" else "of its two springs"
            panel = Panel(picture, (80 + 370 * k, 155 + 325 * i, 300, 235),
                          Axis(0.3, 1e5, "time by that of the exact end state" if i else "", stride=2),
                          Axis(1e-17, 1.0, "error" if k == 0 else "", stride=4),
                          f"{train}: stiffness {words} {what}")
            for name, shape in INTEGRATORS:
                own = [row for row in rows if row["train"] == train and number(row, "stiffness_ratio") == ratio and
                       number(row, "damping_ratio") == 0.02 and row["method"] == name and row["status"] == "ok"]
                points = sorted((number(row, "ratio"), number(row, "error")) for row in own)
                panel.line(points, colours[name])
                for time, error in points:
                    panel.mark(time, error, colours[name], shape, 3.5)
    return picture.svg()
