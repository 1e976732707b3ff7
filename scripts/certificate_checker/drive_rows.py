# SPDX-License-Identifier: MIT
"""Rows of a motor in a bound.

Theorem. Torque and speed are affine in the motion, so are their limits and the torque's peak. A root mean square over the cycle is a norm of
the torque: with <., .> its inner product and z any motion, every motion y has

    rms(y) >= <torque(y), torque(z)> / |torque(z)|,    rms(y)^2 >= 2 <torque(y), torque(z)> - |torque(z)|^2,

so that both are rows of every motion, for any z. That of the delivered motion is taken; where none is delivered, the one at which all rows,
times their multipliers, are least together, over all splines and displacements that are free. The limit's own row is (rms^2 / limit^2 - 1) / 2 <= 0.
"""

from .conditions import solved
from .drive_laws import Span, square_along
from .exact import SAME_PLACE, Refuted, Unverified, add_to, derivative, integral, middle_of, product, root, shifted
from .laws import ends_of_law
from .prescribed import value_beside
from .rational import Fraction
from .runs import Row, Stretch

RELIEVED = " as the speed approaches 0, which motion may relieve"


class MotorRows:
    def __init__(self, bound):
        self.bound, self.problem, self.drive = bound, bound.problem, bound.problem.drive
        self.rules = self.drive.rules + self.drive.peak_rules
        self.square = Fraction(0)  # the multiplier of the limit on the root mean square

    # -- rows at a place

    def takes(self, origin):
        return origin.key.startswith(("limits.motor_", "motor_torque"))

    def add(self, origin, multiplier):
        if origin.key.startswith("limits.motor_torque_rms"):
            if self.drive.rms_limit is None:
                raise Refuted("limits.motor_torque_rms: the scene has no such rule")
            if self.drive.at_rest and not self.drive.is_square_left():
                return self.bound.leave_out(origin.key + RELIEVED, multiplier)
            self.square += multiplier
            return None
        rule = next((rule for rule in self.rules if rule.is_meant(origin)), None)
        if rule is None:
            raise Refuted(f"{origin}: the scene has no such rule")
        if self.drive.at_rest:
            return self.add_at_rest(rule, multiplier)
        return self.bound.use(self.row(rule, *self.problem.place_of(origin)), multiplier)

    def add_at_rest(self, rule, multiplier):
        """Wherever the row is: the torque at rest may be taken at any place where no motion relieves it."""
        largest = self.drive.largest_at_rest(rule.sign)
        if largest is None:
            return self.bound.leave_out(rule.key + RELIEVED, multiplier)
        return self.bound.use(Row.over_runs(rule.key, [], Fraction(0), rule.scale, (rule.most - largest) / rule.scale), multiplier)

    def row(self, rule, at, side):
        name, drive = f"{rule.key} at x = {float(at)}", self.drive
        span = drive.span_at(at, side)
        if span is None:
            raise Refuted(f"{name}: outside the motion")
        k, run, _ = self.bound.run_at(at, side)
        slope = (rule.by_torque * drive.velocity + rule.by_speed * drive.speed) / rule.scale
        bend = rule.by_torque * drive.acceleration / rule.scale
        most = (rule.most - rule.by_torque * span.constant) / rule.scale + (self.bound.relaxed if rule.peak is None else 0)
        if run is None:
            function = {}
            for factor, order in ((slope, 1), (bend, 2)):
                own, ends = value_beside(self.problem, at, side, order)
                add_to(function, own, factor)
                most -= min(factor * end for end in ends)
            return Row(name, 0, function, most, rule.peak)
        at = self.problem.folded(at, side)
        function = {j: slope * w for j, w in run.space.functional(at, 1, side).items()}
        add_to(function, run.space.functional(at, 2, side), bend)
        return Row(name, k, function, most, rule.peak)

    # -- root mean squares

    def use_terms(self, curve):
        """The tangents of the terms that are root mean squares."""
        for i, term in enumerate(self.problem.terms):
            if term.kind == "motor_rms":
                functions, constant, square = self.products(curve)
                size = root(square)[1] * term.reference
                self.bound.use(Row.over_runs("tangent of the root mean square of the torque", functions, constant, size,
                                             Fraction(0), i), term.weight)

    def use_limit(self, cost):
        """After all other rows."""
        if self.square and self.drive.at_rest:
            most = (1 - self.drive.square_at_rest() / self.drive.rms_limit**2) / 2
            self.bound.use(Row.over_runs("limits.motor_torque_rms", [], 0, 1, most), self.square)
        elif self.square:
            rows = [self.limit_row(own) for own in (self.bound.curve, self.preferred()) if own is not None]
            self.bound.use(max(rows, key=lambda row: self.bound.total_with(row, self.square, cost)), self.square)

    def limit_row(self, curve):
        functions, constant, square = self.products(curve)
        limit = self.drive.rms_limit**2
        return Row.over_runs("limits.motor_torque_rms", functions, constant, limit, self.bound.relaxed + (1 + square / limit) / 2)

    def fixed(self):
        """What laws, dwells and rests add to the mean square at least."""
        return self.drive.mean_square(self.drive.squares_beside())[0]

    def products(self, curve):
        """<torque(y), torque(z)> as (functions of the control points of each run, a constant), z the curve; and |torque(z)|^2."""
        drive, functions = self.drive, []
        constant = square = self.fixed()
        for k, run in enumerate(self.problem.runs):
            function = {}
            for i, p, begin, width, span in drive.pieces_of(curve, k):
                torque = drive.torque(p, span)
                constant += span.constant * integral(torque, width) / drive.cycle
                square += integral(product(torque, torque), width) / drive.cycle
                add_to(function, {j: integral(product(part, torque), width) for j, part in self.parts(run, i, begin)}, 1 / drive.cycle)
            functions.append(function)
        for span in drive.free_laws():
            own, function, room = self.product_along(span, curve)
            add_to(functions[0], function, 1 / drive.cycle)
            constant, square = constant + (own[0] - room) / drive.cycle, square + (own[1] + room) / drive.cycle
        return functions, constant, square

    def product_along(self, span, curve):
        """The same integrals along a law between displacements that are free: ((constant, square), function of these, rounding). Jet
        a law that moves y by h the torque is h g + c, with Q and R the integrals of g^2 and g:

            h_y (h_z Q + c R) + h_z c R + c^2 length."""
        moves, q, half, cr = self.law_form(span)
        moved = curve.moved(self.problem.stretches.index(span.stretch))
        function = {}
        add_to(function, moves, moved * q + cr)
        constant = moved * cr + span.constant**2 * (span.stretch.end - span.stretch.begin)
        own = constant + function.pop(None, Fraction(0)), moved * (moved * q + cr) + constant
        return own, function, half * max(2 * self.problem.farthest_level, abs(moved))**2

    def law_form(self, span):
        """(h as a function of displacements that are free, Q, how far Q can be from that, c R)."""
        stretch, drive, i = span.stretch, self.drive, self.problem.stretches.index(span.stretch)
        unit = Stretch("law", stretch.begin, stretch.end, Fraction(0), Fraction(1))
        unit.law = stretch.law
        first, last = ends_of_law(stretch.law, 1)
        r = drive.velocity + drive.acceleration * (last - first) / (stretch.end - stretch.begin)
        q, half = middle_of(square_along(Span(unit, unit.begin, unit.end, 0, Fraction(0)), drive.acceleration, drive.velocity))
        return self.problem.moved_between(i, i + 1), q, half, span.constant * r

    def parts(self, run, i, begin):
        """(control point, the torque without its constant of its basis function), t from `begin` of piece i."""
        for n, basis in enumerate(run.space.basis(i)):
            bent, slope = derivative(basis, 2), derivative(basis)
            part = [self.drive.velocity * c for c in slope]
            for m, c in enumerate(bent):
                part[m] += self.drive.acceleration * c
            yield run.space.first(i) + n, shifted(part, begin) if begin else part

    # -- what bounds the motion

    def bounded(self, run, length):
        """(order, what |y^(order)| can be). From |Ka u' + Kv u| <= B along a run of this length, u = y', follow
        |u| <= |u at the start| + B length / Ka and |u'| <= (B + Kv |u|) / Ka; and from a mean square of it, with the ends of u,
        Ka^2 integral u'^2 <= integral (Ka u' + Kv u)^2 + Ka Kv u(start)^2."""
        drive, problem, bound = self.drive, self.problem, self.bound
        if drive.at_rest:
            return
        start = abs(run.ends()[1] - run.ends()[0]) / length if run.is_ring() else abs(run.states[0][0])
        largest = max(abs(span.constant) for span in drive.spans)
        for rule in drive.rules:
            if rule.by_speed and not rule.by_torque:
                yield 1, rule.most * (1 + bound.relaxed) / abs(rule.by_speed) / drive.speed
        torques = [term.reference * most for term, most in zip(problem.terms, bound.most) if term.kind == "motor" and most is not None]
        sides = [[(r.most + r.scale * bound.relaxed) / abs(r.by_torque) for r in drive.rules if r.by_torque * sign > 0 and not r.by_speed]
                 for sign in (1, -1)]
        if all(sides):
            torques.append(max(abs(min(own)) for own in sides))
        for torque in torques:
            speed = start + (torque + largest) * length / drive.acceleration
            yield 1, speed
            yield 2, (torque + largest + drive.velocity * speed) / drive.acceleration
        squares = [term.reference * most for term, most in zip(problem.terms, bound.most)
                   if term.kind == "motor_rms" and most is not None]
        squares += [drive.rms_limit * (1 + bound.relaxed)] if drive.rms_limit is not None else []
        for size in squares:
            norm = size * root(drive.cycle)[1] + largest * root(length)[1]
            bend = root(norm**2 + drive.acceleration * drive.velocity * start**2)[1] / drive.acceleration
            yield 1, start + bend * root(length)[1]

    # -- no motion: the tangent's place

    def preferred(self):
        """The motion at which all rows so far and the mean square, each times its multiplier, are least: one system of linear equations in
        the control points of all runs and the displacements that are free, solved in doubles. Any motion will do."""
        matrix, slope = self.form(self.square / self.drive.rms_limit**2 / self.drive.cycle)
        add_to(slope, self.bound.named(dict(enumerate(self.bound.functions))))
        return Found(self.problem, least_of_form(self.bound.together(), matrix, slope))

    def form(self, factor):
        """(matrix, slope) in {key of `named`: number or row}: the integral of torque^2 / 2 is x . matrix x / 2 + slope . x and a number."""
        matrix, slope = {}, {}
        for k, run in enumerate(self.problem.runs):
            for i in range(run.space.segments):
                for begin, width, constant in self.cuts(run, i):
                    own = [((k, j), p) for j, p in self.parts(run, i, begin)]
                    for key, p in own:
                        add_to(slope, {key: constant * integral(p, width)}, factor)
                        add_to(matrix.setdefault(key, {}), {other: integral(product(p, q), width) for other, q in own}, factor)
        for span in self.drive.free_laws():
            moves, q, _, cr = self.law_form(span)
            fixed = moves.pop(None, Fraction(0))
            moves = {(None, joint): w for joint, w in moves.items()}
            add_to(slope, moves, factor * (fixed * q + cr))
            for key, w in moves.items():
                add_to(matrix.setdefault(key, {}), moves, factor * q * w)
        return matrix, slope

    def cuts(self, run, i):
        """[(begin, width, the constant torque)] of piece i, where friction turns."""
        left, width = run.space.breakpoints[i], run.space.width(i)
        stretch = run.stretch_at(left)
        x = left - run.begin_of(stretch) + stretch.begin
        for span in self.drive.spans:
            begin, end = max(x, span.begin), min(x + width, span.end)
            if span.stretch is stretch and end - begin > SAME_PLACE:
                yield begin - x, end - begin, span.constant


class Found:
    """A motion that is only a place of tangents, by {key of `named`: number}: what pieces_of() and product_along() want of a curve."""

    def __init__(self, problem, numbers):
        self.problem, self.numbers, self.control, self.pieces = problem, numbers, [], []
        for k, run in enumerate(problem.runs):
            points, control = run.space.breakpoints, [numbers.get((k, j), Fraction(0)) for j in range(run.space.size)]
            self.control.append(control)
            self.pieces.append([(p, run.space.width(i), points[i], run.stretch_at(points[i]))
                                for i, p in enumerate(run.space.pieces(control))])

    def moved(self, i):
        """By how much y is higher after a stretch."""
        return sum((w * (self.numbers.get((None, joint), Fraction(0)) if joint else 1)
                    for joint, w in self.problem.moved_between(i, i + 1).items()), Fraction(0))


def least_of_form(conditions, matrix, slope):
    """Numbers on the conditions, {key: number}, at which x . matrix x / 2 + slope . x is least: solved in doubles, corrected twice."""

    def along(row, numbers):
        return sum((w * numbers[j] for j, w in row.items() if j in numbers), Fraction(0))

    seen = {key for row, _ in conditions.rows.values() for key in row} | set(matrix)
    free = sorted((key for key in seen if key not in conditions.rows), key=str)
    reach = [{key: Fraction(1)} | {pivot: -row[key] for pivot, (row, _) in conditions.rows.items() if row.get(key)} for key in free]
    applied = []  # the matrix times each of these: how all numbers follow one that is free
    for own in reach:
        applied.append({})
        for key, w in own.items():
            add_to(applied[-1], matrix.get(key, {}), w)
    reduced = [[float(along(other, line)) for other in reach] for line in applied]
    found = dict.fromkeys(free, Fraction(0))
    for _ in range(3):
        numbers = found | {pivot: value - along(row, found) for pivot, (row, value) in conditions.rows.items()}
        gradient = {key: slope.get(key, Fraction(0)) + along(matrix.get(key, {}), numbers) for key in numbers}
        steps = solved([[*line, -float(along(own, gradient))] for line, own in zip(reduced, reach)])
        if steps is None:
            raise Unverified("a root mean square that does not see the whole motion")
        found = {key: Fraction(round((found[key] + by) * 2**110), 2**110) for key, by in zip(free, steps)}
    return found | {pivot: value - along(row, found) for pivot, (row, value) in conditions.rows.items()}
