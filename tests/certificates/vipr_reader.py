# SPDX-License-Identifier: MIT
"""An independent reader of VIPR certificates, version 1.0, without integer variables: vipr_reader.py FILE.

It knows the public format and nothing of camopt or of its checker: reads the linear program, recomputes every derived
constraint from its multipliers in exact arithmetic, and compares the last one with the relation to prove.
"""
import sys
from fractions import Fraction
from pathlib import Path

sys.set_int_max_str_digits(0)  # exact numbers are long


class Invalid(Exception):
    pass


class Words:
    def __init__(self, text):
        lines = [line for line in text.splitlines() if not line.startswith("%")]
        self.words, self.place = " ".join(lines).split(), 0

    def next(self):
        if self.place >= len(self.words):
            raise Invalid("the file ends too early")
        self.place += 1
        return self.words[self.place - 1]

    def expect(self, word):
        found = self.next()
        if found != word:
            raise Invalid(f"found {found}, expected {word}")

    def pairs(self, count):
        found = {}
        for _ in range(count):
            index, value = int(self.next()), Fraction(self.next())
            if index in found:
                raise Invalid(f"index {index} twice")
            found[index] = value
        return found

    def constraint(self, objective):
        """(sense, right side, weights)."""
        self.next()  # its name
        sense, right, count = self.next(), Fraction(self.next()), self.next()
        if sense not in "EGL":
            raise Invalid(f"the sense {sense}")
        return sense, right, dict(objective) if count == "OBJ" else self.pairs(int(count))


def dominates(sense, right, weights, asked):
    """Whether "weights sense right" says all that `asked` says."""
    weights = {j: w for j, w in weights.items() if w}
    if not weights and ((sense in "GE" and right > 0) or (sense in "LE" and right < 0)):
        return True  # an absurdity
    if weights != {j: w for j, w in asked[2].items() if w}:
        return False
    if asked[0] == "G":
        return sense in "GE" and right >= asked[1]
    if asked[0] == "L":
        return sense in "LE" and right <= asked[1]
    return sense == "E" and right == asked[1]


def program(words):
    """The linear program to minimize: (names of the variables, objective, [(sense, right side, weights)])."""
    words.expect("VER")
    words.expect("1.0")
    words.expect("VAR")
    variables = [words.next() for _ in range(int(words.next()))]
    words.expect("INT")
    if int(words.next()):
        raise Invalid("integer variables")
    words.expect("OBJ")
    words.expect("min")
    objective = words.pairs(int(words.next()))
    words.expect("CON")
    count, _ = int(words.next()), words.next()
    return variables, objective, [words.constraint(objective) for _ in range(count)]


def check(text):
    """The relation that is proved: ("infeasible", None) or ("bound", lower bound). Raises Invalid."""
    words = Words(text)
    variables, objective, constraints = program(words)
    words.expect("RTP")
    kind = words.next()
    bounds = (words.next(), words.next()) if kind == "range" else None
    words.expect("SOL")
    if int(words.next()):
        raise Invalid("solutions")
    words.expect("DER")
    derived = int(words.next())
    for _ in range(derived):
        asked = words.constraint(objective)
        words.expect("{")
        words.expect("lin")
        multipliers = words.pairs(int(words.next()))
        words.expect("}")
        words.next()
        senses, right, weights = set(), Fraction(0), {}
        for index, multiplier in multipliers.items():
            if not 0 <= index < len(constraints):
                raise Invalid(f"constraint {index} of {len(constraints)}")
            sense, own_right, own = constraints[index]
            if sense != "E" and multiplier:
                senses.add((sense == "G") == (multiplier > 0))
            right += multiplier * own_right
            for j, w in own.items():
                if not 0 <= j < len(variables):
                    raise Invalid(f"variable {j} of {len(variables)}")
                weights[j] = weights.get(j, Fraction(0)) + multiplier * w
        if len(senses) > 1:
            raise Invalid("multipliers of both directions")
        sense = "E" if not senses else "G" if senses.pop() else "L"
        if not dominates(sense, right, weights, asked):
            raise Invalid("the multipliers do not give the derived constraint")
        constraints.append(asked)
    last = constraints[-1]
    if kind == "infeas":
        if not dominates(*last, ("G", Fraction(1), {})):
            raise Invalid("the last constraint is no absurdity")
        return "infeasible", None
    if bounds[1] != "inf" or not derived or not dominates(*last, ("G", Fraction(bounds[0]), objective)):
        raise Invalid("the last constraint is not the bound to prove")
    return "bound", Fraction(bounds[0])


if __name__ == "__main__":
    print(*check(Path(sys.argv[1]).read_text()))
