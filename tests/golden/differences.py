# SPDX-License-Identifier: MIT
"""Where two lists of lines differ: words literally, numbers by their size.

Two numbers are equal where they differ by no more than RELATIVE of either, or of the largest number of their column: of their place
in the lines of the file with the same words, of their list in a line with a list. Below ROUND_OFF all numbers are equal. A number
printed with SHORT or more digits may differ by one in its last digit, which is where rounding falls."""

import difflib
import re

from views import NUMBER, value_of, words_of

RELATIVE = 1e-6
ROUND_OFF = 1e-7
SHORT = 4


def last_digit(one, other):
    """The size of the last digit that either shows, 0 where both show too few digits; trailing zeros are not printed."""
    size, shown = 1.0, 0
    for text in (one, other):
        mantissa, _, exponent = text.lstrip("+-−").lower().partition("e")
        whole, _, decimals = mantissa.partition(".")
        shown = max(shown, len((whole + decimals).lstrip("0")) if decimals else 0)
        size = min(size, 10.0 ** (int(exponent or 0) - len(decimals)))
    return size if shown >= SHORT else 0.0


def columns_of(lines):
    """{words: the largest size at each place}."""
    found = {}
    for line in lines:
        sizes = [abs(value_of(text)) for text in NUMBER.findall(line)]
        if "[#" in line and sizes:
            sizes = [max(sizes)] * len(sizes)
        held = found.setdefault(words_of(line), sizes)
        for place, size in enumerate(sizes):
            held[place] = max(held[place], size)
    return found


def same_numbers(expected, found, sizes):
    for one, other, size in zip(NUMBER.findall(expected), NUMBER.findall(found), sizes):
        if one == other:
            continue
        apart = abs(value_of(one) - value_of(other))
        if apart == 0.0:
            continue
        if re.fullmatch(r"[-+−]?\d+", one) and re.fullmatch(r"[-+−]?\d+", other) and abs(value_of(one)) < 1e6:
            return False
        if apart > max(RELATIVE * max(size, abs(value_of(one))), ROUND_OFF, 1.01 * last_digit(one, other)):
            return False
    return True


def differences(expected, found):
    """(place in expected, expected line or None, found line or None)."""
    if expected == found:
        return
    sizes = columns_of(expected)
    one, other = [words_of(line) for line in expected], [words_of(line) for line in found]
    steps = ([("equal", 0, len(one), 0, len(other))] if one == other else
             difflib.SequenceMatcher(None, one, other, autojunk=False).get_opcodes())
    for kind, i, i_end, j, j_end in steps:
        if kind == "equal":
            for line, words, now in zip(expected[i:i_end], one[i:i_end], found[j:j_end]):
                if not same_numbers(line, now, sizes[words]):
                    yield i, line, now
                i += 1
            continue
        for k in range(max(i_end - i, j_end - j)):
            yield (min(i + k, i_end), expected[i + k] if i + k < i_end else None, found[j + k] if j + k < j_end else None)
