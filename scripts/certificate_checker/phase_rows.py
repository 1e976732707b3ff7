# SPDX-License-Identifier: MIT
"""Rows of amplitudes in a bound: of an elastic follower's vibration, and of harmonics of the lift.

Theorem. Both are |E|, E complex and affine in the motion (train.py, at every speed of a range; harmonics.py). For any u of magnitude 1
|E| >= Re(conj(u) E), which is affine: a row of every motion, for any u. certificate.json names the speed or the harmonic of such a row, not
its u. The checker takes that of the delivered motion where there is one, turned such that as little as possible is left of all rows.
"""

from .exact import add_to, number, root
from .rational import Fraction
from .runs import Row

LIGHT = Fraction(1, 10**7)  # rows lighter than this part of the heaviest are left out
FREE = Fraction(1, 10**4)   # how much less a turn is damped than that of a tangent: two speeds are no neighbours


class Amplitude:
    """Of a motion: the real and the imaginary part, each (rows {control point: (number, its error)} of the runs, a constant)."""

    def __init__(self, real, imaginary, constants=(Fraction(0), Fraction(0))):
        self.parts, self.constants = (real, imaginary), constants

    def functions(self, i, size=1):
        return {k: {j: size * w for j, (w, _) in row.items()} for k, row in enumerate(self.parts[i])}

    def values(self, curve):
        """(real, imaginary) part of the delivered motion's, and the error of either at most."""
        found = [sum((w * control[j] for control, row in zip(curve.control, rows) for j, (w, _) in row.items()), constant)
                 for rows, constant in zip(self.parts, self.constants)]
        return found, self.error([max(map(abs, control)) for control in curve.control])

    def error(self, most):
        """`most`: of the control points of each run."""
        return sum((error * size for rows in self.parts for size, row in zip(most, rows) for _, error in row.values()), Fraction(0))


def use_phase_rows(bound):
    """bound.ringing: [(what the row says, the limit or reference it is in units of, the peak or None, how the amplitude is found)]."""
    weights, kinds = {}, {}
    for key, amplitude, unit, peak, multiplier in bound.ringing:
        add_to(weights, {key: multiplier})
        kinds[key] = amplitude, unit, peak
    heaviest = max(weights.values())
    own = [(*kinds[key], key, weight) for key, weight in weights.items() if weight > heaviest * LIGHT]
    found = [(amplitude(), unit, peak, key, weight) for amplitude, unit, peak, key, weight in own]
    phases = []
    for amplitude, *_, weight in found:
        values = amplitude.values(bound.curve)[0] if bound.curve else [Fraction(0)] * 2
        size = root(values[0]**2 + values[1]**2)[1]
        phases += [weight * value / size if size else Fraction(0) for value in values]
    columns = [amplitude.functions(i, 1 / unit) for amplitude, unit, *_ in found for i in (0, 1)]
    more = bound.fitted([(column, heaviest) for column in columns], [FREE] * len(columns), list(zip(columns, phases)))
    phases = [u + heaviest * by for u, by in zip(phases, more or [Fraction(0)] * len(phases))]
    most = [own[0] * run.space.spread() for own, run in zip(bound.supremum, bound.problem.runs)]  # of a control point
    for (amplitude, unit, peak, key, _), a, b in zip(found, phases[::2], phases[1::2]):
        multiplier = root(a * a + b * b)[1]
        if not multiplier:
            continue
        functions = {}
        for i, u in enumerate((a, b)):
            for k, function in amplitude.functions(i, u / multiplier / unit).items():
                add_to(functions.setdefault(k, {}), function)
        constant = sum(u * c for u, c in zip((a, b), amplitude.constants)) / multiplier
        side = (amplitude.error(most) - constant) / unit + (0 if peak is not None else 1 + bound.relaxed)
        bound.use(Row(str(key), 0, functions.pop(0), side, peak, beside=functions), multiplier)


def add_phase_row(bound, origin, multiplier):
    """Whether the row is one of these."""
    problem, rule = bound.problem, origin.key
    if problem.train and rule.startswith(("residual", "limits.residual_")):
        train = problem.train
        time = min(max(train.time_at(number(origin.which["rpm"])), train.times[0]), train.times[1])  # any of the range will do
        k = min(range(len(problem.runs)), key=lambda k: abs(problem.runs[k].stretches[-1].end - origin.at))  # what it is after
        place = next(i for i, term in enumerate(problem.terms) if term.kind == "residual")
        reference = problem.terms[place].reference
        if origin.limit:  # the row is in parts of the limit
            multiplier *= reference / train.residual_limit()

        def residual():
            return Amplitude(*([own if i == k else {} for i in range(len(problem.runs))]
                               for own in train.residual_functions(problem.runs[k], time)))
        bound.ringing.append((("residual", k, time), residual, reference, place, multiplier))
        return True
    if problem.harmonics and rule.startswith("limits.spring_harmonic_"):
        order = int(origin.which["harmonic"])
        if order not in problem.harmonics.orders:
            return False
        bound.ringing.append((("harmonic", order), lambda: problem.harmonics.amplitude(order), problem.harmonics.most, None, multiplier))
        return True
    return False
