# SPDX-License-Identifier: MIT
"""Lower bounds over boxes (branch and bound): a list of inequalities, each of which follows from earlier ones.

The proof's variables x are control points of the splines, which are numbers of the scene's own spline space, and after
them peaks and dimensions. Every step is an inequality  weights . x <= side. Of each the checker keeps a side of its own:

  linear, cost   the row is built anew from the scene: function . c - peak <= most. What the step's weights differ from
                 it by, rounding, is added at its worst in the box of x.
  plane          slope . z + constant may not pass the rule anywhere in the box of z = (y, y', y'', y''', dimensions or peak
                 of the rule), whose ends are those that earlier steps prove. The rule is the checker's own
                 (disk_rules.py), its least distance from the plane is found by dividing the box.
  derived        with the multipliers m >= 0 of earlier steps: at most sum m side + the greatest (weights - sum m weights) . x
                 of the box.
  split          an assumption of one part, whose opposite is assumed in another part.

Theorem. Every motion of the scene that is better than the delivered one has an x in the box (`range_of`), and satisfies every step but the
splits. The parts are the leaves of a binary tree of opposite splits, so that x satisfies all splits of one part, and rest on no other
assumptions than theirs: the least of their bounds is a lower bound of the objective, and if each part is a contradiction there is no
motion. What the file claims beyond that is refuted.
"""
from . import enclosures
from .conditions import Conditions
from .dimensions import largest_of, parts_of
from .laws import constant
from .origins import Origin
from .exact import STATED, Refuted, Unverified, add_to, number, require_every_row
from .rational import Fraction
from .runs import name_in_run, name_of_peak

ROUNDED = Fraction(1, 2**44)   # what the sums of a step may be off by in the file, relative: it was rounded outward
SAME_ROW = Fraction(1, 10**9)  # a row of the scene is that of the file to this, relative to its size
ROUNDED_ROW = Fraction(1, 10**14)  # of a row's numbers in doubles, which are about one
TOUCHING = Fraction(1, 10**6)  # a plane is pushed back by the square of this part of its size where it touches its rule
LEAST_REACH = Fraction(1, 10**6)  # a cam nearer to the end of its reach, in parts of its longest dimension, is none
SHORT = 2**150                 # sides are rounded up to parts of this


def rounded_up(value):
    return Fraction(-(-value.numerator * SHORT // value.denominator), SHORT)


def greatest(weights, box):
    return sum((w * box[j][1 if w > 0 else 0] for j, w in weights.items() if w), Fraction(0))


def difference(a, b, factor=1):
    """a - factor b, of rows {variable: weight}."""
    result = dict(a)
    add_to(result, b, -factor)
    return result


def box_room(value):
    """By how much ends of boxes may differ and be the same."""
    return SAME_ROW * 100 * max(1, abs(value))


class Step:
    def __init__(self, data):
        self.data, self.kind = data, data["kind"]
        self.weights = {j: number(w) for j, w in zip(data["indices"], data["values"], strict=True)}
        self.stated = number(data["side"])  # what the file says
        self.side = None                    # what is so
        self.splits = frozenset()           # what it rests on


class BoxProof:
    """`bound`: the linear side of things (bound.py), for what every better motion must satisfy. `incumbent`: the objective
    of the motion at hand, None where there is none."""

    def __init__(self, problem, bound, proof, incumbent):
        self.problem, self.bound, self.proof, self.incumbent = problem, bound, proof, incumbent
        self.steps, self.left_out, self.planes = [], {}, 0
        self.known = {}  # rows of the motion that were needed before
        self.name_variables()
        self.box = [self.range_of(v) for v in self.variables]
        self.stated_box = [(number(a), number(b)) for a, b in zip(proof["box"]["lower"], proof["box"]["upper"],
                                                                  strict=True)]
        if len(self.stated_box) != len(self.variables) or len(proof["cost"]) != len(self.variables):
            raise Refuted("the proof's lists do not match")
        self.cost = {j: number(w) for j, w in enumerate(proof["cost"]) if w}

    def check_holds(self, result):
        """The file's box is said to hold every better motion: the delivered one lies in it."""
        searched = self.problem.cam.searched if self.problem.cam else {}
        for name, value in zip(result["design"]["names"], result["design"]["values"]):
            if name in self.proof["variables"]:
                low, high = self.stated_box[self.proof["variables"].index(name)]
                value = number(value) / (largest_of(searched[name]) if name in searched else 1)
                if not low - STATED * 1000 <= value <= high + STATED * 1000:
                    raise Refuted(f"the box of {name} does not hold the delivered motion")

    # -- the variables

    def name_variables(self):
        """("c", run, control point), ("peak", term), ("dimension", name) or its ("magnitude", name); control points that are no variables
        are numbers by the conditions."""
        if self.problem.free:
            raise Unverified("a bound over boxes next to displacements that are free")
        runs, searched = self.problem.runs, self.problem.cam.searched if self.problem.cam else {}
        known = {name_in_run(f"c[{j}]", k, len(runs)): ("c", k, j) for k, run in enumerate(runs) for j in range(run.space.size)}
        known |= {name_of_peak(term): ("peak", i) for i, term in enumerate(self.problem.terms) if term.kind in ("peak", "torque", "area")}
        for name in searched:
            known |= {name: ("dimension", name), "magnitude of " + name: ("magnitude", name)}
        self.variables, self.place = [], {}
        for j, name in enumerate(self.proof["variables"]):
            if name not in known:
                raise Unverified(f"a bound over boxes with the variable {name}")
            if known[name] in self.place:
                raise Refuted(f"the variable {name} stands twice")
            self.variables.append(known[name])
            self.place[known[name]] = j
        self.conditions, self.points, self.fixed = [], [], {}
        for k, run in enumerate(self.problem.runs):
            conditions = Conditions(run.conditions)
            if conditions.contradiction:
                raise Unverified("conditions that contradict each other")
            numbers = {j: value for j, (row, value) in conditions.rows.items() if not any(row.values())}
            for j in range(run.space.size):
                if j not in numbers and ("c", k, j) not in self.place:
                    raise Unverified("a bound over boxes in other variables than control points")
            self.conditions.append(conditions)
            self.points.append({j: value for j, value in numbers.items() if ("c", k, j) not in self.place})
            self.fixed.update({("c", k, j): value for j, value in numbers.items()})

    def range_of(self, variable):
        if variable in self.fixed:
            return (self.fixed[variable],) * 2
        if variable[0] == "c":
            return self.ranges_of_run(variable[1])[0][variable[2]]
        if variable[0] == "peak":
            most, term = self.bound.most[variable[1]], self.problem.terms[variable[1]]
            if most is None:
                raise Unverified("a peak that nothing bounds")
            if term.kind == "area":
                return self.bound.least_of(term) / term.weight, most
            return Fraction(0), min(most, self.own_peak(self.problem.terms[variable[1]]) or most)
        return (Fraction(0), Fraction(1)) if variable[0] == "magnitude" else parts_of(self.problem.cam.searched[variable[1]])

    def own_peak(self, term):
        """What a peak that is the motion's own can be: a spline lies within its control points. None: no peak of a derivative, or
        one that jumps."""
        if term.kind != "peak" or not term.order:
            return None
        sizes = []
        for k, run in enumerate(self.problem.runs):
            ranges = self.ranges_of_run(k)[term.order]
            if ranges is None:
                return None
            largest = max(max(abs(a), abs(b)) for a, b in ranges)
            sizes.append(largest / min(t.scale(term.order) for t in run.stretches) / term.reference)
        return max(sizes)

    def ranges_of_run(self, k):
        """Of the control points of the motion and its derivatives (None: of one that jumps): those of the derivative r lie within what y^(r)
        can be, times the spread; those of the next lower one follow from both ends by summation."""
        if ("run", k) in self.known:
            return self.known["run", k]
        run, supremum = self.problem.runs[k], self.bound.supremum[k]
        space, top, ranges, found = run.space, run.top(), None, [None] * 4
        for order in range(top, -1, -1):
            count = space.size - order
            size = supremum[order] * space.of_derivative(order).spread()
            own = [(-size, size)] * count
            if order < top:
                steps = [tuple(sorted((a * h, b * h))) for (a, b), h in zip(ranges, space.steps(order + 1))]
                levels = run.ends()
                for end, places in ((0, range(count)), (1, range(count - 1, -1, -1))):
                    if order and not run.rests[end]:
                        continue
                    low = high = levels[end] if order == 0 else Fraction(0)
                    for i in places:
                        if i not in (0, count - 1) or i != places[0]:
                            a, b = steps[i - 1] if end == 0 else steps[i]
                            low, high = (low + a, high + b) if end == 0 else (low - b, high - a)
                        own[i] = max(low, own[i][0]), min(high, own[i][1])
            ranges = found[order] = own
        self.known["run", k] = found
        return found

    def in_variables(self, k, function):
        """(weights of x, constant) of a function of the control points of a run."""
        weights, fixed = {}, Fraction(0)
        for j, w in function.items():
            if j in self.points[k]:
                fixed += w * self.points[k][j]
            else:
                weights[self.place["c", k, j]] = w
        return weights, fixed

    def state(self, at, side, order):
        """y^(order) at a cam angle in x: (weights, constant, run, stretch)."""
        key = (at, side, order)
        if key not in self.known:
            k, run, stretch = self.bound.run_at(at, side)
            if run is None:
                self.known[key] = self.at_rest(at, order)
            else:
                weights, fixed = self.in_variables(k, run.cam_space.functional(at, order, side))
                self.known[key] = (weights, fixed, k, stretch)
        return self.known[key]

    def at_rest(self, at, order):
        stretch = next((s for s in self.problem.stretches if s.begin <= at <= s.end), None)
        if stretch is None:
            raise Refuted(f"a step speaks of x = {float(at)}, outside the motion")
        if stretch.kind != "dwell":
            raise Unverified("a bound over boxes along a law")
        level = self.problem.cam_at_rest(stretch.start)
        return {}, level if order == 0 else Fraction(0), None, stretch

    # -- steps

    def check(self):
        """(the bound, or None where there is no motion at all)."""
        for index, data in enumerate(self.proof["steps"]):
            step = Step(data)
            named = [i for i, _ in data.get("multipliers", [])] + data.get("bounds", []) + \
                    [i for ends in data.get("ends", []) for i in ends if i != -1]
            if any(not 0 <= i < index for i in named) or any(not 0 <= j < len(self.box) for j in step.weights):
                raise Refuted(f"step {index} names what does not stand before it")
            step.splits = frozenset({index} if step.kind == "split" else ()).union(
                *(self.steps[i].splits for i in named))
            getattr(self, {"linear": "linear", "cost": "cost_row", "plane": "plane", "derived": "derived",
                           "split": "split"}[step.kind])(step, index)
            step.side = rounded_up(step.side)
            self.steps.append(step)
        return self.parts()

    def of_scene(self, step, index, function, most, factor=Fraction(1)):
        """A step that is function . x <= most but for rounding; of the row before it was taken times the factor."""
        step.side = most + greatest(difference(step.weights, function), self.box)
        reach = max((abs(end) for j in function for end in self.box[j]), default=0)
        self.compare(step, index, factor * ROUNDED_ROW * max(1, reach))

    def compare(self, step, index, rounded=Fraction(0)):
        size = max([Fraction(1)] + [abs(w) * max(map(abs, self.box[j])) for j, w in step.weights.items()])
        if step.side > step.stated + SAME_ROW * size + rounded:
            raise Refuted(f"step {index} is no row of the scene: it says at most {float(step.stated)}, the scene allows "
                          f"{float(step.side)}")

    def cost_row(self, step, index):
        """Only motions that are no worse than that at hand are looked for."""
        if self.incumbent is None:
            raise Refuted("a bound of the cost without a current motion")
        function = self.objective()
        if any(abs(w) > SAME_ROW * max(1, abs(self.cost.get(j, 0)))
               for j, w in difference(self.cost, function).items()):
            raise Refuted("the proof's cost is not the scene's objective")
        self.of_scene(step, index, function, self.incumbent - self.fixed_cost())

    def objective(self):
        cost = {}
        for j, variable in enumerate(self.variables):
            if variable[0] == "peak" and self.problem.terms[variable[1]].weight:
                cost[j] = self.problem.terms[variable[1]].weight
            elif variable[0] in ("dimension", "magnitude") and self.problem.cam.weights[variable[1]]:
                ends = self.problem.cam.searched[variable[1]]
                if (variable[0] == "magnitude") == (ends[0] < 0):
                    cost[j] = self.problem.cam.weights[variable[1]] * largest_of(ends)
        missing = [t for i, t in enumerate(self.problem.terms) if t.weight and ("peak", i) not in self.place]
        if missing:
            raise Refuted("the proof leaves out a term of the objective")
        return cost

    def fixed_cost(self):
        return self.problem.cam.fixed if self.problem.cam else Fraction(0)

    def linear(self, step, index):
        origin = Origin.of(step.data["origin"])
        if origin.at is None:
            return self.condition(step, index)
        at, side = self.problem.place_of(origin)
        row = self.bound.row_of(origin, at, side, *self.bound.run_at(at, side))
        if row is None:  # it adds nothing
            self.left_out[origin.key] = True
            step.side = greatest(step.weights, self.box)
            return None
        row, factor = row
        weights, fixed = self.in_variables(row.run, row.function)
        if row.peak is not None:
            weights[self.place["peak", row.peak]] = Fraction(-1)
        for name, slope in row.searched.items():
            weights[self.place["dimension", name]] = slope * largest_of(self.problem.cam.searched[name])
        function = {j: factor * w for j, w in weights.items()}
        return self.of_scene(step, index, function, factor * (row.most - fixed), factor)

    def condition(self, step, index):
        """What the conditions leave of a row that they imply is a number. A cap on a peak is an end of its box; rows of dimensions follow
        from the box or from one of these."""
        rest, most = dict(step.weights), Fraction(0)
        for k in range(len(self.problem.runs)):
            own = {j: rest.pop(self.place["c", k, j]) for j in range(self.problem.runs[k].space.size)
                   if ("c", k, j) in self.place and self.place["c", k, j] in rest}
            if own:
                left, value = self.conditions[k].reduced(own, Fraction(0))
                left, fixed = self.in_variables(k, {j: w for j, w in left.items() if w})
                most += fixed - value
                rest = difference(rest, left, -1)
        own = [({}, Fraction(0))] + [({self.place[v]: w for v, w in row.items()}, side) for row, side in self.rows_of_dimensions()]
        step.side = most + min(side + greatest(difference(rest, row), self.box) for row, side in own)
        self.compare(step, index)

    def rows_of_dimensions(self):
        """[({variable: weight}, side)]: magnitudes, and what a cam reaches, in parts of its longest dimension."""
        cam = self.problem.cam
        rows = [({("dimension", v[1]): Fraction(sign), v: Fraction(-1)}, Fraction(0)) for v in self.variables for sign in (1, -1)
                if v[0] == "magnitude"]
        for signs in cam.reach() if cam else ():
            ends = {name: cam.searched.get(name, (cam.sizes[name],)) for name in signs}
            longest = max(map(largest_of, ends.values()))
            fixed = sum((sign * cam.sizes[name] for name, sign in signs.items() if name not in cam.searched), Fraction(0))
            rows.append(({("dimension", name): sign * largest_of(cam.searched[name]) / longest for name, sign in signs.items()
                          if name in cam.searched}, -fixed / longest - LEAST_REACH))
        return rows

    def derived(self, step, index):
        self.follow(step.weights, step.data, f"step {index}", step)

    def follow(self, weights, data, name, step=None, stated=None):
        """The greatest weights . x that the multipliers allow. What the file says is held against its own numbers."""
        rest, stated_most, most = dict(weights), Fraction(0), Fraction(0)
        for i, multiplier in data["multipliers"]:
            m, earlier = number(multiplier), self.steps[i]
            if m < 0:
                raise Refuted(f"{name}: a multiplier below 0")
            most += m * earlier.side
            stated_most += m * earlier.stated
            add_to(rest, earlier.weights, -m)
        most += greatest(rest, self.narrowed(data["bounds"], self.box, "side", name))
        stated_most += greatest(rest, self.narrowed(data["bounds"], self.stated_box, "stated", name))
        stated = step.stated if step else stated
        if stated is not None and stated_most > stated + ROUNDED * max(1, abs(stated)):
            raise Refuted(f"{name} says at most {float(stated)}; the steps it follows from allow {float(stated_most)}")
        if step:
            step.side = most
        return most, stated_most

    def narrowed(self, bounds, box, side, name):
        box = list(box) if bounds else box
        for i in bounds:
            weights, most = self.steps[i].weights, getattr(self.steps[i], side)
            if len(weights) != 1 or abs(next(iter(weights.values()))) != 1:
                raise Refuted(f"{name}: step {i} is no bound of one variable")
            (j, w), = weights.items()
            low, high = box[j]
            box[j] = (low, min(high, most)) if w > 0 else (max(low, -most), high)
        return box

    def split(self, step, _):
        step.side = step.stated

    # -- planes

    def plane(self, step, index):
        data, origin = step.data, Origin.of(step.data["origin"])
        at, side = self.problem.place_of(origin)
        slopes = [number(s) for s in data["slope"]]
        states = [self.state(at, side, order) for order in range(4)]
        formulas, parameters = self.rules_of(origin, states[0][3], at)
        weights, fixed = {}, Fraction(0)
        for slope, (row, value, _, _) in zip(slopes, states):
            weights, fixed = difference(weights, row, -slope), fixed + slope * value
        for slope, j in zip(slopes[4:], parameters, strict=True):
            weights = difference(weights, {j: slope}, -1)
        if not formulas:
            self.left_out[origin.key] = True
            step.side = greatest(step.weights, self.box)
            return
        box = self.box_of_plane(step, index, states, parameters)
        if box is None:  # nothing satisfies what the step rests on
            step.side = step.stated
            return
        lowest = self.lowest_of_any(formulas, slopes, box, number(data["constant"]))
        if lowest is None and not self.is_within(box, data["box"]):  # the plane was made for less: it adds nothing
            self.left_out[f"{origin.key}, over a box that is proved less far than the file says"] = True
            step.side = greatest(step.weights, self.box)
            return
        if lowest is None:
            raise Refuted(f"step {index}: the plane passes {origin}")
        self.planes += 1
        self.of_scene(step, index, weights, -lowest - fixed)

    def rules_of(self, origin, stretch, at):
        """(formulas of z, the variables that stand behind y''')."""
        cam, rule = self.problem.cam, origin.key
        if rule == "torque" and not origin.limit:
            i = next(i for i, t in enumerate(self.problem.terms) if t.kind == "torque")
            size = self.problem.terms[i].reference * stretch.scale(1) * stretch.scale(2)
            sign = constant(origin.sign / size)
            return [lambda z: sign * z[1] * z[2] - z[4]], [self.place["peak", i]]
        if cam is None or cam.rules is None:
            return [], []
        cam.rules.of_planes = True
        formulas = cam.formulas_at(origin, at)
        cam.rules.of_planes = False
        if cam.direct and rule.endswith("pressure_angle_deg"):  # in m
            formulas = [lambda z, f=f: f(z) * cam.rules.reach() for f in formulas]
        return formulas, [self.place["dimension", name] for name in cam.rules.searched]

    def box_of_plane(self, step, index, states, parameters):
        """What the steps that the plane names prove of z, as far as they can be followed here. The file's box must say no
        less than the file's own steps. None: nothing is left."""
        box = []
        rows = [(row, value) for row, value, _, _ in states] + [({j: Fraction(1)}, Fraction(0)) for j in parameters]
        data = step.data
        for i, ((row, value), ends) in enumerate(zip(rows, data["ends"], strict=True)):
            if i == 3:  # no rule looks at y'''
                box.append((Fraction(0), Fraction(0)))
                continue
            own = []
            for sign, end, stated in ((-1, ends[0], data["box"]["lower"][i]), (1, ends[1], data["box"]["upper"][i])):
                function = {j: sign * w for j, w in row.items()}
                most = greatest(function, self.box)
                if end != -1:
                    beside = greatest(difference(function, self.steps[end].weights), self.box)
                    claimed = self.steps[end].stated + beside
                    if claimed + sign * value > sign * number(stated) + box_room(claimed):
                        raise Refuted(f"step {index}: the plane's box ends before what step {end} proves")
                    most = min(most, self.steps[end].side + beside)
                own.append(sign * most + value)
            if i == 0 and self.problem.cam:
                own = self.problem.cam.kept_within(*own)
            if own[0] > own[1]:
                return None
            box.append(tuple(own))
        return box

    @staticmethod
    def is_within(box, stated):
        """Whether a box ends where the file says, or before."""
        return all(low >= number(l) - box_room(low) and high <= number(u) + box_room(high)
                   for (low, high), l, u in zip(box, stated["lower"], stated["upper"], strict=True))

    def lowest_of_any(self, formulas, slopes, box, stated):
        """Each of the formulas is a limit: it is enough that the plane lies under one."""
        found, undecided = [], None
        for formula in formulas:
            try:
                found.append(self.lowest(formula, slopes, box, stated))
            except Unverified as fault:
                undecided = fault
        known = [value for value in found if value is not None]
        if not known and undecided:
            raise undecided
        return max(known, default=None)

    @staticmethod
    def lowest(formula, slopes, box, stated):
        """The least of rule - slope . z over the box, or less; None: it lies below what the file says by more than
        rounding. Where the plane touches its rule it is pushed back by as little as is needed."""
        used = [i for i, slope in enumerate(slopes) if slope]
        factors = [constant(s) for s in slopes]

        def above(z):
            value = formula(z)
            for i in used:
                value = value - factors[i] * z[i]
            return value

        size = max([TOUCHING, abs(stated)] + [abs(slopes[i]) * max(map(abs, box[i])) for i in used])
        ends = [enclosures.interval(*e) for e in box]
        for back in (TOUCHING**2, TOUCHING**2 * 30, SAME_ROW):
            found = enclosures.least(above, ends, enclosures.interval(stated - back * size)[0])
            if found is not None:
                return enclosures.fraction(found)
        return None

    # -- parts

    def parts(self):
        """The least bound of all parts; None: every part is a contradiction."""
        parts = self.proof["parts"]
        if not parts:
            raise Refuted("a proof without parts")
        self.check_tree([part["splits"] for part in parts])
        cost, best = self.objective(), None
        constant_stated, fixed = number(self.proof["constant"]), self.fixed_cost()
        for p, part in enumerate(parts):
            rests_on = frozenset().union(*(self.steps[i].splits for i, _ in part["multipliers"]),
                                         *(self.steps[i].splits for i in part["bounds"]))
            if not rests_on <= set(part["splits"]):
                raise Refuted(f"part {p} rests on an assumption of another part")
            name = f"part {p}"
            if part["infeasible"]:
                most, stated_most = self.follow({}, part, name)
                if most >= 0:
                    require_every_row(self.left_out)
                    raise Refuted(f"{name} is called empty, and its multipliers contradict nothing")
                continue
            if self.incumbent is None:
                raise Refuted(f"{name} is not empty")
            weights = {j: -w for j, w in self.cost.items()}
            most, stated_most = self.follow(weights, part, name, stated=constant_stated - number(part["bound"]))
            bound = fixed - most + -greatest(difference(self.cost, cost), self.box)
            best = bound if best is None else min(best, bound)
            if number(self.proof["bound"]) > number(part["bound"]):
                raise Refuted(f"the bound is above that of {name}")
        return best

    def check_tree(self, leaves):
        """The splits are pairs of opposites, and all parts together hold everything."""
        if len(leaves) == 1 and not leaves[0]:
            return
        if not all(leaves):
            raise Refuted("a part that is also split")
        first = sorted({leaf[0] for leaf in leaves})
        if len(first) != 2 or any(not 0 <= i < len(self.steps) or self.steps[i].kind != "split" for i in first):
            raise Refuted("the parts do not hold everything: a split without its opposite")
        a, b = (self.steps[i] for i in first)
        if any(difference(a.weights, b.weights, -1).values()) or a.stated + b.stated < 0:
            raise Refuted("the parts do not hold everything: two splits are not opposite")
        for i in first:
            self.check_tree([leaf[1:] for leaf in leaves if leaf[0] == i])
