# SPDX-License-Identifier: MIT
"""Mutants that are compiled together and switched on by a number.

A mutant of an expression E becomes `(camopt_mutant == N ? (E with the change) : (E))`, its number read once from the
environment variable CAMOPT_MUTANT. E is found in the text: from the changed operator outwards up to a bracket that
encloses it, or to what stands outside every expression (`,` `;` `=` `?` `:` `return` …). Where such an expression
does not compile (both sides of another type, a constant expression) the whole statement is doubled:
`if (camopt_mutant == N) { … } else { … }`; where that does not either, the mutant is left to a build of its own.
"""
import json
import re
from pathlib import Path

HEADER = """// Written by tests/mutation/switched.py.
#pragma once
#include <cstdlib>
inline const int camopt_mutant = [] {
    const char* const number = std::getenv("CAMOPT_MUTANT");
    return number == nullptr ? 0 : std::atoi(number);
}();
"""

ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "|=", "&=", "^=", "<<=", ">>="}
WORDS = {"return", "co_return", "case", "else", "throw", "do", "co_yield"}
OPENING, CLOSING = "([{", ")]}"
TOKEN = re.compile(r"[A-Za-z_]\w*|\.?\d(?:[\w.]|[eE][+-])*|<<=|>>=|<=>|->|::|\+\+|--|&&|\|\||[-+*/%|&^<>=!]=|<<|>>|\S")


def tokens_of(code):
    """(text, begin, end) of every token; comments and literals are blanked."""
    return [(match.group(), match.start(), match.end()) for match in TOKEN.finditer(code)]


def partners_of(tokens):
    """Index of each bracket's partner."""
    partner, open_ones = {}, []
    for index, (text, _, _) in enumerate(tokens):
        if text in OPENING:
            open_ones.append(index)
        elif text in CLOSING and open_ones:
            partner[index] = open_ones.pop()
            partner[partner[index]] = index
    return partner


class Expressions:
    """The extents of expressions and statements in one file."""

    def __init__(self, code):
        self.code = code
        self.tokens = tokens_of(code)
        self.partner = partners_of(self.tokens)

    def touched(self, begin, end):
        """Indices of the first and the last token of a change."""
        inside = [k for k, (_, first, last) in enumerate(self.tokens) if first < end and last > begin]
        return inside[0], inside[-1]

    def juxtaposed(self, left):
        """Whether two tokens stand beside each other as they only do where a statement begins: `) x`, `} x`."""
        text, _, end = self.tokens[left]
        if left + 1 == len(self.tokens):
            return True
        following, begin, after = self.tokens[left + 1]
        if text == "}" and "\n" in self.code[end:begin]:
            return True
        if text not in ")}" or begin == end:
            return False
        unary = following in "*&!-+~" or following in ("++", "--")
        return following[0].isalnum() or following in "_(" or (unary and self.code[after] != " ")

    @staticmethod
    def ends(text):
        return text in (",", ";", "?", ":") or text in WORDS or text in ASSIGNMENTS

    def leftwards(self, left, stands_before):
        """The first token of what `left` belongs to, over whole brackets; None where they do not close."""
        while left > 0:
            text = self.tokens[left - 1][0]
            if stands_before(text) or self.juxtaposed(left - 1):
                break
            left -= 1
            if text in CLOSING:
                if left not in self.partner:
                    return None
                left = self.partner[left]
            elif text in "([":
                return None
        return left

    def expression(self, begin, end):
        """(begin, end) of the expression about a change; None where its brackets do not close."""
        first, last = self.touched(begin, end)
        tokens, partner = self.tokens, self.partner
        # What the change itself opens is followed to its end: std::min( … ).
        right = last
        if tokens[last][0] in OPENING:
            right = partner.get(last, last)
        while right + 1 < len(tokens):
            text = tokens[right + 1][0]
            if text in CLOSING or self.ends(text):
                break
            right += 1
            if text in OPENING:
                if right not in partner:
                    return None
                right = partner[right]
        left = self.leftwards(first, lambda text: text in OPENING or self.ends(text))
        return None if left is None else (tokens[left][1], tokens[right][2])

    def statement(self, begin, end):
        """(begin, end) of the simple statement about a change, its semicolon included."""
        first, last = self.touched(begin, end)
        tokens, partner = self.tokens, self.partner
        left, right = first, last
        while right < len(tokens) and tokens[right][0] != ";":
            if tokens[right][0] in CLOSING + OPENING and right not in partner or tokens[right][0] == "}":
                return None
            if tokens[right][0] in OPENING:
                right = partner[right]
            elif tokens[right][0] in CLOSING:  # the change stands within these
                left = min(left, partner[right])
            right += 1
        left = self.leftwards(left, lambda text: text in ";{" or text == ":")
        if right == len(tokens) or not left or tokens[left][0] in ("for", "if", "while", "else", "case"):
            return None
        return tokens[left][1], tokens[right][2]


class Switched:
    """Mutants of a copy of the sources that stand in it together.

    mutants: (path, offset, old, new) by number from 1. `way` of each: "expression", "statement" or "alone"; what
    an earlier call found out about the same mutants is kept beside the copy.
    """

    WAYS = ("expression", "statement", "alone")

    def __init__(self, copy, mutants, blanked):
        self.copy = copy
        self.mutants = {number: self.narrowed(*mutant) for number, mutant in mutants.items()}
        self.originals = {path: (copy / path).read_text() for path, _, _, _ in mutants.values()}
        self.known = {path: Expressions(blanked(text)) for path, text in self.originals.items()}
        self.kept = copy.parent / "ways.json"
        known = json.loads(self.kept.read_text()) if self.kept.exists() else {}
        self.way = {number: known.get(self.key(number), "expression") for number in mutants}
        self.header = copy.parent / "camopt_mutant.hpp"
        self.header.write_text(HEADER)

    @staticmethod
    def narrowed(path, offset, old, new):
        """Only what is taken away, of "return -" and its like: the word before it belongs to no expression."""
        if old.startswith(new):
            return path, offset + len(new), old[len(new):], ""
        return path, offset, old, new

    def extent(self, number):
        path, offset, old, _ = self.mutants[number]
        known = self.known[path]
        while self.way[number] != "alone":
            found = getattr(known, self.way[number])(offset, offset + len(old))
            if found and "#" not in self.originals[path][slice(*found)]:
                return found
            self.next_way(number)
        return None

    def key(self, number):
        return "|".join(map(str, (number, *self.mutants[number])))

    def next_way(self, number):
        self.way[number] = self.WAYS[self.WAYS.index(self.way[number]) + 1]
        self.kept.write_text(json.dumps({self.key(one): way for one, way in self.way.items() if way != "expression"}))

    def changed(self, number, begin, end):
        path, offset, old, new = self.mutants[number]
        text = self.originals[path]
        return text[begin:offset] + new + text[offset + len(old):end]

    def write(self):
        """Writes every file with all of its mutants; of two that overlap the later is left alone."""
        for path, text in self.originals.items():
            extents = []
            for number in [n for n, mutant in self.mutants.items() if mutant[0] == path]:
                extent = self.extent(number)
                if extent and any(extent[0] < end and begin < extent[1] for begin, end, _ in extents):
                    self.way[number] = "alone"
                elif extent:
                    extents.append((*extent, number))
            result = text
            for begin, end, number in sorted(extents, reverse=True):
                # On the lines of the original, so that a compiler's message names the mutant.
                plain, other = text[begin:end], self.changed(number, begin, end)
                if self.way[number] == "expression":
                    both = f"(camopt_mutant == {number} ? ({other}) : ({plain}))"
                else:
                    both = f"if (camopt_mutant == {number}) {{ {other} }} else {{ {plain} }}"
                result = result[:begin] + both + result[end:]
            result = f'#include "{self.header}"\n' + result
            if (self.copy / path).read_text() != result:  # else it need not be compiled again
                (self.copy / path).write_text(result)

    def restore(self):
        for path, text in self.originals.items():
            (self.copy / path).write_text(text)

    def blamed(self, messages):
        """The numbers on lines that a compiler's messages name as errors, or as what led there."""
        lines = {(Path(path).name, int(line)) for path, line in re.findall(r"([\w./-]+\.[ch]pp):(\d+):\d+:", messages)}
        found = []
        for number, (path, _, _, _) in self.mutants.items():
            if self.way[number] == "alone":
                continue
            begin, end = self.extent(number)
            text = self.originals[path]
            first, last = (text.count("\n", 0, place) + 2 for place in (begin, end))
            if any((Path(path).name, line) in lines for line in range(first, last + 1)):
                found.append(number)
        if found:
            return found
        # A switch that moved a declaration into a block is missed on a later line: any of that file may be it.
        files = {name for name, _ in lines}
        return [number for number, (path, _, _, _) in self.mutants.items()
                if self.way[number] != "alone" and Path(path).name in files]
