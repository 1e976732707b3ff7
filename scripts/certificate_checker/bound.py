# SPDX-License-Identifier: MIT
"""The lower bound by weak duality.

Theorem. Let "function_i(y) - peak_i <= most_i" be rows that every motion y of the scene satisfies, and m_i >= 0. Then

    objective(y) >= sum over peaks of (weight - sum of their m_i) * peak - sum m_i most_i + f(y),   f = sum m_i function_i,

f linear in the control points. Conditions of the scene reduce f to fewer control points; what remains of it, rounding and what a tangent taken
elsewhere leaves, is a sum of y, y', y'' and y''' at breakpoints, reduced likewise (small_sums.py), bounded by what these can be
(`supremum_of`): a motion better than the delivered one has peaks below objective / weight, and limits bound it too. Where displacements are free,
conditions of all runs are taken together, and these displacements are bounded by their range. So no motion is below `value`; without an objective
a value above 0 is a contradiction: there is no motion. Assumptions: the rows are derived from the scene (the file only names them), and their
multipliers are arbitrary.
"""
from .conditions import Conditions, solved
from .exact import ORDERS, Refuted, SAME_PLACE, STATED, Unverified, add_to, derivative, integral, number, product, root
from .drive_rows import MotorRows
from .motion_bounds import lost_area
from .origins import Origin
from .prescribed import limits_at, value_beside
from .rational import Fraction
from .runs import Row
from .small_sums import small_sum
from .strokes import farthest, stroke_of
from .phase_rows import add_phase_row, use_phase_rows


MOST_LEANING = 30           # tangents whose slopes are chosen anew
STEADY = Fraction(1, 10**5)  # they move little: neighbours are not to be played off against each other
LITTLE, SAME_DIRECTION = Fraction(1, 10**12), Fraction(99, 100)  # the same where nothing but rounding is corrected, with rows whose directions differ
ROUNDED = Fraction(1, 10**9)  # what rounding may leave of a bound before multipliers are corrected
OTHER_MEANS = "root mean squares at other motions"  # tangents at which could say more
FARTHEST = Fraction(1000)    # lifts: no motion beyond is considered where nothing else bounds it


def inner(a, b):
    """The product of two rows, rounded."""
    return number(sum(float(w) * float(b[j]) for j, w in a.items() if j in b))


class Bound:
    """constant, peaks and functions: of the theorem, as the rows are used. `incumbent`: the objective that a motion has to be better than,
    None: any motion counts; `relaxed`: by how much limits may be passed, relative; `curve`: the delivered motion."""

    def __init__(self, problem, incumbent, relaxed, curve=None, rising=None):
        self.problem, self.incumbent, self.curve = problem, incumbent, curve
        self.rising = rising or {}  # of strokes whose displacement is free: whether they rise, in the case that is judged
        self.functions = [{} for _ in problem.runs]
        self.constant = Fraction(0)
        self.peaks = [Fraction(0)] * len(problem.terms)   # multipliers that lean on each peak
        self.leaning = {}                                 # what leans on each dimension that is searched, 1/m
        self.relaxed, self.left_out = relaxed, {}
        self.rows, self.remainders, self.tangents = [], [], []
        self.means = []  # root mean squares: (term, the motion of the tangent, its root mean square)
        self.area = Fraction(0), []  # the lost area in the objective: a number, and a function of each run
        self.ringing = []  # rows of amplitudes: phase_rows.py
        self.motor = MotorRows(self) if problem.drive else None
        self.highest = FARTHEST
        for _ in range(3 if any(term.kind == "area" for term in problem.terms) else 1):  # less area is lost the higher y can be
            self.most = [self.most_of(term) for term in problem.terms]
            self.supremum = [self.supremum_of(run) for run in problem.runs]
            self.highest = max([own[0] for own in self.supremum] + [abs(s.to) for s in problem.stretches if s.to is not None] +
                               [problem.farthest_level or 0])
        self.own_peaks()

    def most_of(self, term):
        """The largest a peak can be, in units of its reference; None: nothing is known."""
        options = []
        if term.weight and self.incumbent is not None:
            others = sum((self.least_of(other) for other in self.problem.terms if other is not term), Fraction(0))
            options.append((self.incumbent - self.problem.least_cost() - others) / term.weight)
        if term.cap is not None:
            options.append(term.cap * (1 + self.relaxed) / term.reference)
        return min(options) if options else None

    def least_of(self, term):
        """What a term adds to the objective at least."""
        return min(Fraction(0), term.weight * (1 - self.highest) / term.reference) if term.kind == "area" else Fraction(0)

    def supremum_of(self, run):
        """Bounds of |y|, |y'|, |y''|, |y'''| on a run."""
        known = [farthest(self.problem, run, self.relaxed) or FARTHEST, None, None, None]

        def lower(order, size):
            if known[order] is None or size < known[order]:
                known[order] = size
        for term, most in zip(self.problem.terms, self.most):
            if most is None or term.kind != "peak":
                continue
            lower(term.order, most * term.reference * max(s.scale(term.order) for s in run.stretches))
        length = run.space.breakpoints[-1] - run.space.breakpoints[0]
        for order, size in self.motor.bounded(run, length) if self.motor else ():
            lower(order, size)
        ends = max(self.problem.farthest_level if None in (level, end) else max(abs(end), abs(level + run.level(s)))
                   for end in run.ends() for s in run.stretches for level in (s.start, s.to))
        for order, size in self.bounded_by_sides(run, length, ends):
            lower(order, size)
        for term, most in zip(self.problem.terms, self.most):
            # From rest, and by Cauchy and Schwarz: |y^(r-1)| <= length * root mean square of y^(r).
            if term.kind == "rms" and most is not None and run.rests[0] and len(self.problem.runs) == 1:
                lower(term.order - 1, most * term.reference * length * max(s.scale(term.order) for s in run.stretches))
        for order in (3, 2, 1):
            if known[order] is None:
                continue
            reach, beside = length / 2, ends  # to the nearer of two ends that are known
            if order > 1 and run.is_ring():  # somewhere the derivative has its mean
                reach, beside = length, abs(run.ends()[1] - run.ends()[0]) / length if order == 2 else 0
            elif order > 1:
                beside = max(abs(state[order - 2]) for state in run.states)
            lower(order - 1, known[order] * reach + beside)
        for order in (1, 2, 3):
            lower(order, run.space.steepest(order, known[order - 1]))
        return known

    def cam_supremum(self, k):
        """Bounds of |s|, |s'|, |s''|, |s'''| of the cam on a run."""
        weights, known = self.problem.to_cam or [1], list(self.supremum[k])
        for order in range(4, 3 + len(weights)):
            known.append(self.problem.runs[k].space.steepest(order, known[-1]))
        return [sum(abs(w) * known[order + r] for r, w in enumerate(weights)) for order in range(4)]

    def bounded_by_sides(self, run, length, ends):
        """(order, what |y^(order)| can be): limits of one side that come in pairs bound a derivative; one of them the derivative
        below it, which cannot come back from further than what is left of the run allows."""
        for order in (1, 2, 3):
            sizes = []
            for sign in (-1, 1):
                own = [[b.most + b.scale * self.relaxed for b in self.problem.bounds
                        if (b.order, b.sign) == (order, sign) and not b.of_cam and b.stretch in (None, stretch) and b.begin <= stretch.begin and
                        b.end >= stretch.end] for stretch in run.stretches]
                sizes += [max(min(found) for found in own)] if all(own) else []
            if len(sizes) == 2:
                yield order, max(abs(size) for size in sizes)
            if sizes and (order == 1 or not run.is_ring()):
                beside = ends if order == 1 else max(abs(state[order - 2]) for state in run.states)
                yield order - 1, beside + max(Fraction(0), min(sizes)) * length

    def displacements_at(self, k, x):
        """What y can be at a place, from the ends of the run (and the top of a rise and return) and the velocity."""
        run, velocity = self.problem.runs[k], self.supremum[k][1]
        if run.raised:
            raise Unverified("a cam that goes on in the next turn from where it is")
        x = run.space.folded(x)
        known = list(zip((run.space.breakpoints[0], run.space.breakpoints[-1]), run.ends()))
        known += [(Fraction(1), Fraction(1))] if self.problem.type == "RR" else []
        return max(y - velocity * abs(x - at) for at, y in known), min(y + velocity * abs(x - at) for at, y in known)

    def own_peaks(self):
        """A peak may be taken as that of the motion itself: it is no larger than the derivative can be."""
        for i, term in enumerate(self.problem.terms):
            sizes = [s[term.order] / min(t.scale(term.order) for t in run.stretches) / term.reference
                     for run, s in zip(self.problem.runs, self.supremum)]
            if sizes and term.kind == "peak" and (self.most[i] is None or max(sizes) < self.most[i]):
                self.most[i] = max(sizes)

    def run_at(self, x, side):
        """(k, the run, the stretch) of a place on a spline; (None, None, None) elsewhere."""
        stretch = self.problem.stretch_at(self.problem.folded(x, side), side)
        found = ((k, run, stretch) for k, run in enumerate(self.problem.runs) if stretch in run.stretches)
        return next(found, (None, None, None))

    def use(self, row, multiplier):
        """function + searched . dimensions - peak <= most, times a multiplier."""
        for k, own in row.functions().items():
            if own:
                add_to(self.functions[k], own, multiplier)
        self.constant -= multiplier * row.most
        add_to(self.leaning, row.searched, multiplier)
        if row.peak is not None:
            self.peaks[row.peak] += multiplier
        self.rows.append((row, multiplier))

    def add_row(self, row, factor=1):
        """A row of the certificate, by its fields alone: rule, place, side, derivative, sign."""
        origin, multiplier = Origin.of(row["origin"]), factor * number(row["multiplier"])
        if origin.at is None or not multiplier or origin.key == "area":
            return None  # conditions, limits of peaks, the area: their multipliers are chosen here
        segment = origin.which.get("segment")  # whose displacement is held in its range
        if segment is not None and multiplier > 0 and int(segment) + 1 in self.problem.free:
            return self.use(self.range_row(int(segment) + 1, origin.sign > 0), multiplier)
        if multiplier < 0:
            raise Refuted(f"{row['name']}: a multiplier below 0 of a row that has no lower side")
        if add_phase_row(self, origin, multiplier):
            return None
        if origin.key == "deviation" and self.problem.table:
            return self.use(self.problem.table.row(origin), multiplier)
        if self.motor and self.motor.takes(origin):
            return self.motor.add(origin, multiplier)
        at, side = self.problem.place_of(origin)
        found = self.row_of(origin, at, side, *self.run_at(at, side))
        if found is None:
            return self.leave_out(origin.key, multiplier)
        if found[0].leaning:
            self.left_out.setdefault(origin.key, Fraction(0))  # another tangent could say more
            return self.tangents.append((found[0], multiplier * found[1], at, side))
        return self.use(found[0], multiplier * found[1])

    def add_rows(self, rows, factor=1):
        for row in rows:
            self.add_row(row, factor)
        return self

    def range_row(self, joint, upper):
        """A displacement that is free stays within one span of those given."""
        level, sign = self.problem.level_at(joint), 1 if upper else -1
        return Row("the range of a displacement", 0, {key: sign * w for key, w in level.items()}, sign * self.problem.level_ends[upper])

    def row_of(self, origin, at, side, k, run, stretch):
        """(the row that an origin names, what camopt's row is in units of it), or None: this checker has no use for it."""
        order, sign, rule = origin.order, origin.sign, origin.key
        name = str(origin)
        if not origin.limit and rule in ORDERS:
            peak = next((i for i, t in enumerate(self.problem.terms) if t.kind == "peak" and t.order == order), None)
            if peak is None or order != ORDERS[rule] or sign not in (1, -1):
                raise Refuted(f"{name}: the scene has no such rule")
            if run is None:
                raise Refuted(f"{name}: no spline is there")
            term = self.problem.terms[peak]
            weight = sign / (term.reference * stretch.scale(order))
            function = {j: w * weight for j, w in run.space.functional(at, order, side).items()}
            return Row(name, k, function, Fraction(0), peak), Fraction(1)
        if run is None and sign:
            return self.row_beside_splines(name, rule, order, sign, at, side)
        bound = next((b for b in self.problem.bounds if b.is_meant(rule, order, sign, stretch)), None)
        if bound is None and any(b.key == rule for b in self.problem.bounds):
            raise Refuted(f"{name}: the scene has no such rule")
        if bound is not None:
            return self.bound_row(bound, name, k, run, stretch, at, side)
        if rule == "area" and self.problem.runs:
            return self.area_row(name)
        if rule in ("motion.within_lift", "motion.monotone"):
            return self.stroke_row(rule, order, sign, name, k, run, stretch, at, side)
        if self.problem.cam and run is not None:
            return self.problem.cam.row(self, k, run, name, origin, at)
        return None

    def row_beside_splines(self, name, rule, order, sign, at, side):
        """A bound or a cap of the motion where it is prescribed, along a law or in a dwell: a row without control points, of what
        displacements are free there."""
        stretch = self.problem.stretch_at(self.problem.folded(at, side), side)
        if stretch is None:
            raise Refuted(f"{name}: outside the motion")
        for most, scale in [own[2:] for own in limits_at(self.problem, rule, at, stretch) if own[:2] == (order, sign)][:1]:
            function, ends = value_beside(self.problem, at, side, order)
            reached = min(sign * end for end in ends)
            return Row(name, 0, {key: sign * w / scale for key, w in function.items()}, (most - reached) / scale + self.relaxed), Fraction(1)
        return None

    def bound_row(self, bound, name, k, run, stretch, at, side):
        if not bound.begin - SAME_PLACE <= at <= bound.end + SAME_PLACE:
            raise Refuted(f"{name}: the rule does not hold there")
        at = self.problem.folded(min(max(at, bound.begin), bound.end), side)
        space = run.cam_space if bound.of_cam else run.space
        function = {j: w * bound.sign / bound.scale for j, w in space.functional(at, bound.order, side).items()}
        most = bound.most if bound.order else bound.most + bound.sign * run.level(stretch)
        return Row(name, k, function, most / bound.scale + self.relaxed), Fraction(1)

    def area_row(self, name):
        """lost area / reference - its variable <= 0."""
        place = next((i for i, t in enumerate(self.problem.terms) if t.kind == "area"), None)
        if place is None:
            raise Refuted(f"{name}: the scene has no such rule")
        lost, functions = lost_area(self.problem)
        if len(functions) > 1:
            raise Unverified("the area over several splines in a bound over boxes")
        reference = self.problem.terms[place].reference
        return Row(name, 0, {j: w / reference for j, w in functions[0].items()}, -lost / reference, place), Fraction(1)

    def stroke_row(self, rule, order, sign, name, k, run, stretch, at, side):
        """A row of a stroke that stays in its range, or does not turn back; None where set points, or what is beside it, open
        the range."""
        at = self.problem.folded(at, side)
        stroke = stroke_of(self.problem, stretch, at) if run is not None else None
        i = self.problem.stretches.index(stretch) if stroke else None
        if stroke is None or not sign:
            return None
        if stretch.free and i not in self.rising:
            raise Refuted(f"{name}: the case leaves open whether the stroke rises")
        moved, length = stroke.moved, stroke.end - stroke.begin
        rises = self.rising[i] if stretch.free else stroke.to > stroke.start
        function = {j: w * sign for j, w in run.space.functional(at, order, side).items()}
        ends = True, True
        if rule == "motion.monotone":
            if not self.problem.motion.get("monotone", False) or order != 1 or sign != (-1 if rises else 1):
                raise Refuted(f"{name}: the scene has no such rule")
            scale, most = moved / length, Fraction(0)
        elif stretch.free:
            if not self.problem.motion.get("within_lift", True) or order != 0:
                raise Refuted(f"{name}: the scene has no such rule")
            at_end = rises == (sign > 0)
            end, ends = self.problem.level_at(i + at_end), (not at_end, at_end)
            add_to(function, {key: w for key, w in end.items() if key}, -sign)
            scale, most = moved, sign * (end.get(None, Fraction(0)) + run.level(stretch))
        else:
            bounds = stroke.least, stroke.most
            if not self.problem.motion.get("within_lift", True) or order != 0:
                raise Refuted(f"{name}: the scene has no such rule")
            if bounds[sign > 0] is None:
                return None
            scale = max(moved, STATED) if None in bounds else stroke.most - stroke.least
            most = sign * (bounds[sign > 0] + run.level(stretch))
        near = stroke.near(at, order, ends)  # camopt's row is this much larger
        if near <= 0:
            return None
        return Row(name, k, {j: w / scale for j, w in function.items()}, most / scale + self.relaxed * near), 1 / near

    def leave_out(self, rule, multiplier):
        """A row that is not used only weakens the bound."""
        add_to(self.left_out, {rule: multiplier})

    def add_area(self):
        """The lost area is linear in the motion: its part of the objective is added as it is."""
        for i, term in enumerate(self.problem.terms):
            if term.kind != "area":
                continue
            factor = term.weight / term.reference
            lost, functions = lost_area(self.problem)
            self.constant += factor * lost
            self.peaks[i] += term.weight
            self.area = factor * lost, [{j: factor * w for j, w in function.items()} for function in functions]
            for own, function in zip(self.functions, self.area[1]):
                add_to(own, function)

    def least_objective(self):
        """What follows for the objective."""
        if self.curve:
            self.add_root_mean_squares(self.curve)
        self.add_area()
        return self.value()

    def add_root_mean_squares(self, curve):
        """Root mean squares lie above their tangents: rms(y) >= <y, z> / |z| for any z; z is the delivered motion."""
        problem = self.problem
        if problem.free and any(term.kind.endswith("rms") and term.weight for term in problem.terms):  # each case has its own best motion
            self.leave_out(OTHER_MEANS, Fraction(0))
        if self.motor:
            self.motor.use_terms(curve)
        for t, term in enumerate(problem.terms):
            if term.kind == "deviation_rms":
                row = problem.table.tangent(curve, t)
                if row:
                    self.use(row, term.weight)
            if term.kind == "rms" and term.weight:
                self.means.append((t, [dict(enumerate(control)) for control in curve.control], curve.term(term)[1] * term.reference))
                self.use(self.tangent_at(*self.means[-1]), term.weight)

    def tangent_at(self, t, motion, size):
        """Of a root mean square, at a motion ({control point: number} of each run) whose own is `size`."""
        term = self.problem.terms[t]
        return Row.over_runs(f"tangent of the root mean square of derivative {term.order}", self.products(t, motion), 0, size * term.reference,
                             Fraction(0), t)

    def products(self, t, motion):
        """The mean of the product of the derivatives of `motion` and of any other, a function of the other."""
        order, length = self.problem.terms[t].order, sum((w for run in self.curve.pieces for _, w, _, _ in run), Fraction(0))
        functions = [{} for _ in self.problem.runs]
        for k, (run, pieces) in enumerate(zip(self.problem.runs, self.curve.pieces)):
            for i, (_, width, _, stretch) in enumerate(pieces):
                factor = self.problem.rms_weight(stretch, order) / length
                bases = {run.space.first(i) + j: derivative(basis, order) for j, basis in enumerate(run.space.basis(i))}
                for own, weight in ((bases[j], motion[k][j]) for j in bases if motion[k].get(j)):
                    add_to(functions[k], {j: integral(product(own, other), width) for j, other in bases.items()}, factor * weight)
        return functions

    def lean_means(self):
        """The same of the heaviest root mean square: camopt's proof may belong to a motion outside of limits by its tolerance, beside
        which the delivered one lies within them. Its tangent is taken at the motion at which nothing of a function is left."""
        t, motion, size = max(self.means, key=lambda own: self.problem.terms[own[0]].weight)
        runs, weight, old = self.problem.runs, self.problem.terms[t].weight, self.tangent_at(t, motion, size)
        rests = [Conditions(run.conditions) for run in runs]
        keys = [(k, j) for k, rest in enumerate(rests) for j in range(runs[k].space.size) if j not in rest.rows]

        def step(k, j, by):
            """Control points of all runs, where one moves and conditions hold."""
            moved = [{} for _ in runs]
            moved[k] = {j: by, **{pivot: -row[j] * by for pivot, (row, _) in rests[k].rows.items() if row.get(j)}}
            return moved

        def left_of(functions):
            found = [rest.reduced(dict(own), Fraction(0))[0] for rest, own in zip(rests, functions)]
            return [float(found[k].get(j, 0)) for k, j in keys]

        factor = weight / size / self.problem.terms[t].reference
        columns = [left_of(self.products(t, step(*key, factor))) for key in keys]
        by = solved([list(line) for line in zip(*columns, [-w for w in left_of(self.functions)])])
        other = [dict(own) for own in motion]
        for key, own in zip(keys, by or []):
            for there, function in zip(other, step(*key, own)):
                add_to(there, function)
        squares = [sum((w * own[j] for function, own in zip(self.products(t, z), z) for j, w in function.items()), Fraction(0))
                   for z in (motion, other)]
        length = root(size * size + squares[1] - squares[0])[1]
        self.use(old, -weight)
        self.rows = [own for own in self.rows if own[0].name != old.name]
        self.use(self.tangent_at(t, other, length), weight * length / size)

    def lean_tangents(self):
        """camopt took tangents of convex rules at its optimum, from which the delivered motion may stand aside by what breaks
        ties. Which tangents are taken is free: the slopes of the heaviest are chosen such that, with the other rows, as little
        of a function of the control points is left as can be."""
        heaviest = max((m for _, m, _, _ in self.tangents), default=Fraction(0))
        free = sorted((t for t in self.tangents if t[1] > heaviest / 10**7), key=lambda t: -t[1])[:MOST_LEANING]
        slopes = {id(t): by for t, by in zip(free, self.slopes_that_fit(free))}
        for tangent in self.tangents:
            row, multiplier = tangent[:2]
            other = row.leaning(slopes[id(tangent)]) if id(tangent) in slopes else None
            self.use(other or row, multiplier)

    def slopes_that_fit(self, free):
        """By how much the slopes of these tangents are to be larger. Light ones would turn far to stand in for heavy ones
        beside them: that is damped in proportion."""
        columns = [({row.run: self.problem.runs[row.run].cam_space.functional(at, 0, side)}, multiplier)
                   for row, multiplier, at, side in free]
        return self.fitted(columns, [free[0][1] / t[1] for t in free], [(t[0].functions(), t[1]) for t in self.tangents])

    def fitted(self, columns, damping, beside):
        """Factors of these functions ({run: function}, times what) with which the rows so far and those (functions, multiplier) beside
        leave as little as can be of a function of the control points: least squares, steadied."""
        rests, functions = [Conditions(run.conditions) for run in self.problem.runs], [dict(f) for f in self.functions]
        for own, multiplier in beside:
            for k, function in own.items():
                add_to(functions[k], function, multiplier)
        left = {(k, j): w for k, rest in enumerate(rests) for j, w in rest.reduced(functions[k], Fraction(0))[0].items()}
        reduced = [{(k, j): number(float(factor * w)) for k, function in own.items()
                    for j, w in rests[k].reduced(dict(function), Fraction(0))[0].items()} for own, factor in columns]
        matrix = [[inner(a, b) for b in reduced] + [-inner(a, left)] for a in reduced]
        for i, line in enumerate(matrix):
            line[i] *= 1 + STEADY * number(float(damping[i]))
        return solved(matrix) or []

    def value(self, cost=True):
        """What follows from all rows used."""
        self.lean_tangents()
        if self.ringing:
            use_phase_rows(self)
            if self.motor:
                self.left_out.setdefault("amplitudes together with a motor", Fraction(0))  # other phases could say more
        if self.motor:
            self.motor.use_limit(cost)
        total = self.total(cost)
        for correct in [self.lean_means] * bool(self.means) + [self.refine] * 3:
            if self.residual <= ROUNDED * max(1, abs(total)):
                break
            before = self.state()
            correct()
            corrected = self.total(cost)
            if corrected <= total:
                self.constant, self.peaks, self.leaning, self.functions, self.rows = before
            total = self.total(cost)
        return total

    def state(self):
        return self.constant, list(self.peaks), dict(self.leaning), [dict(f) for f in self.functions], list(self.rows)

    def total_with(self, row, multiplier, cost):
        """What would follow with one more row."""
        before = self.state()
        self.use(row, multiplier)
        total = self.total(cost)
        self.constant, self.peaks, self.leaning, self.functions, self.rows = before
        return total

    def refine(self):
        """Rows near the ends of strokes are stored to few digits. Any multipliers will do: those of the heaviest rows that
        differ from each other are corrected, by least squares, such that less is left of a function of the control points."""
        runs = self.problem.runs
        rest = self.together(lambda run, row: run.in_top(row))

        def left_of(functions):
            own = rest.reduced(self.named({k: runs[k].in_top(function) for k, function in functions.items()}), Fraction(0))[0]
            return {key: number(float(w)) for key, w in own.items() if w}

        left, columns = left_of(dict(enumerate(self.functions))), []
        for row, multiplier in sorted((own for own in self.rows if own[0].function and own[1] > 0), key=lambda own: -own[1]):
            column = left_of(row.functions())
            size = number(float(inner(column, column))**0.5)
            if size and len(columns) < MOST_LEANING and \
                    not any(abs(inner(column, other)) > SAME_DIRECTION * size * norm for _, _, other, norm in columns):
                columns.append((row, multiplier, column, size))
        matrix = [[inner(a, b) / (m * n) for _, _, b, n in columns] + [-inner(a, left) / m] for _, _, a, m in columns]
        for i, line in enumerate(matrix):
            line[i] *= 1 + LITTLE
        for (row, multiplier, _, size), by in zip(columns, solved(matrix) or []):
            if multiplier + by / size >= 0:
                self.use(row, by / size)

    def total(self, cost):
        """What follows from the rows as they are."""
        total = self.constant
        self.slopes, self.remainders = [], []
        for i, term in enumerate(self.problem.terms):
            slope = (term.weight if cost else Fraction(0)) - self.peaks[i]
            self.slopes.append(slope)
            if slope >= 0:
                continue
            if self.most[i] is None:
                raise Unverified(f"multipliers lean on the peak of derivative {term.order}, which nothing bounds")
            total += slope * self.most[i]
        if self.problem.cam:
            total += self.problem.cam.least(self.leaning, cost)
        self.residual = Fraction(0)
        if self.problem.free:
            return total + self.under_together()
        for run, function, supremum in zip(self.problem.runs, self.functions, self.supremum):
            constant, residual = self.under(run, dict(function), supremum)
            total += constant - residual
            self.residual += residual
        return total

    @staticmethod
    def named(functions):
        """Functions of the runs, {run: function}, as one."""
        whole = {}
        for k, function in functions.items():
            add_to(whole, {(k if j >= 0 else None, j): w for j, w in function.items()})
        return whole

    def together(self, seen=lambda run, row: row):
        """The conditions of all runs, which displacements that are free join."""
        return Conditions([(self.named({k: seen(run, row)}), value, name) for k, run in enumerate(self.problem.runs)
                           for row, value, name in run.conditions])

    def under_together(self):
        """Below what all functions together are not."""
        conditions = self.together()
        if conditions.contradiction:
            raise Unverified("conditions that contradict each other")
        most = {(None, -joint): self.problem.farthest_level for joint in self.problem.free}
        rows = [({key: Fraction(1)}, size) for key, size in most.items()]
        for k, (run, supremum) in enumerate(zip(self.problem.runs, self.supremum)):
            rows += [(self.named({k: row}), size) for row, size in self.states_of(run, supremum)]
            most |= {(k, j): size for j, size in self.points_of(run, supremum).items()}
        constant, _, pieces = self.in_pieces(self.named(dict(enumerate(self.functions))), conditions, rows, most)
        self.residual = self.reach_of(pieces)
        self.remainders.append(None)
        return constant - self.residual

    def under(self, run, function, supremum):
        """(constant, residual): the function of the spline is at least constant - residual."""
        if run.is_fine():
            return self.under_in_top(run, function, supremum)
        conditions = Conditions(run.conditions)
        if conditions.contradiction:
            raise Unverified("conditions that contradict each other")
        constant, function, pieces = self.in_pieces(function, conditions, self.states_of(run, supremum), self.points_of(run, supremum))
        self.remainders.append((conditions, function, pieces))
        return constant, self.reach_of(pieces)

    @staticmethod
    def states_of(run, supremum):
        """[(row of a state at a breakpoint, the largest it can be)]."""
        return [(row, supremum[order]) for order, row in run.space.at_breakpoints() if supremum[order]]

    @staticmethod
    def points_of(run, supremum):
        """What control points can be."""
        return dict.fromkeys(range(run.space.size), supremum[0] * run.space.spread())

    @staticmethod
    def in_pieces(function, conditions, rows, most):
        """(constant, function less states, pieces): with the conditions, the function is the constant and the sum of pieces (row, times what,
        the largest it can be). These are rows, the states, and single numbers, which can be `most`, of what rounding leaves beside them. States
        are seen through the conditions, so that one that these fix costs nothing."""

        def reduced(row):
            return {j: w for j, w in conditions.reduced(dict(row), Fraction(0))[0].items() if w}

        parts = [{j: float(w / size) for j, w in reduced(row).items()} for row, size in rows]
        factors = small_sum({j: float(w) for j, w in reduced(function).items()}, parts, float(max(most.values())))
        function = dict(function)
        states = [(row, number(factor) / size, size) for factor, (row, size) in zip(factors, rows) if factor]
        for row, weight, _ in states:
            add_to(function, row, -weight)
        left, constant = conditions.reduced(dict(function), Fraction(0))
        return -constant, function, states + [({j: Fraction(1)}, w, most[j]) for j, w in left.items() if w]

    @staticmethod
    def reach_of(pieces):
        return sum((abs(w) * most for _, w, most in pieces), Fraction(0))

    def under_in_top(self, run, function, supremum):
        """The same where some segments are far narrower than others: conditions solved in control points of a
        derivative."""
        top = run.top()
        function, constant = run.conditions_in_top().reduced(run.in_top(function), Fraction(0))
        most = [self.at_start(run, order, supremum) for order in range(top)] + self.sizes_in_top(run, supremum)
        self.remainders.append(None)
        return -constant, sum((abs(w) * most[j] for j, w in function.items() if w), Fraction(0))

    @staticmethod
    def sizes_in_top(run, supremum):
        """What the control points of the derivative top can be: from an end at rest, where the first is 0, they grow by the steps
        times what those of the next derivative can be."""
        top, space = run.top(), run.space
        sizes = [supremum[top] * space.of_derivative(top).spread()] * (space.size - top)
        if top == 3:
            return sizes
        growth = supremum[top + 1] * space.of_derivative(top + 1).spread()
        steps = [growth * step for step in space.steps(top + 1)]
        for rests, places, grown in zip(run.rests, (range(len(sizes)), range(len(sizes) - 1, -1, -1)), (steps, steps[::-1])):
            reach = Fraction(0)
            for i, step in zip(places, grown + [Fraction(0)]) if rests else ():
                sizes[i] = min(sizes[i], reach)
                reach += step
        return sizes

    def at_start(self, run, order, supremum):
        """|y^(order)| at the start of the run."""
        if order == 0:
            start = run.stretches[0].start
            return self.problem.farthest_level if start is None else abs(start)
        return supremum[order] if run.is_ring() or order > 2 else abs(run.states[0][order - 1])
