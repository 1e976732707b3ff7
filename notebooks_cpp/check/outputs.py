# SPDX-License-Identifier: MIT
"""Outputs of a notebook, computed again, beside those stored; and the numbers of its text beside its outputs.

Rules. Between two outputs the words must be the same. A number may differ by 1e-6 of itself, or by one unit of its last
printed decimal, whichever is more; integers must be equal. A number before a unit of time (s, ms, µs) is a time and left
out. Numbers below 1e-9 are rounding and equal. Coordinates in a picture may differ by 0.05 px.

Every number that a text cell states must stand, rounded as the text has it, in an output of the notebook (pictures do
not count), or as it is in a code cell. Numbers in code spans, formulas and links are not read.
"""

import re

NUMBER = re.compile(r"(?<![\w.])[-+−]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][-+]?\d+)?(?![\w]|\.\d)")
ANY_NUMBER = re.compile(r"[-+−]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?")
TIME = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)? ?(?:s|ms|µs|us)\b")
PIXEL = 0.05


def value_of(number):
    return float(number.replace("−", "-"))


def unit_of_last_decimal(number):
    mantissa, _, exponent = number.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 10.0 ** ((int(exponent) if exponent else 0) - decimals)


def is_integer(number):
    return re.fullmatch(r"[-+−]?\d+", number) is not None


def same_number(stored, now):
    if stored == now:
        return True
    old, new = value_of(stored), value_of(now)
    if is_integer(stored) and is_integer(now):
        return old == new
    if abs(old) < 1e-9 and abs(new) < 1e-9:
        return True
    last = 1.000001 * unit_of_last_decimal(stored) if "." in stored else 0.0
    return abs(old - new) <= max(1e-6 * abs(old), last)


def difference(stored, now, same=same_number):
    """What differs between two texts, in words; empty: nothing that counts."""
    stored, now = TIME.sub("TIME", stored), TIME.sub("TIME", now)
    words = [ANY_NUMBER.split(text) for text in (stored, now)]
    if words[0] != words[1]:
        pairs = [pair for pair in zip(*words) if pair[0] != pair[1]] or [("", f"{len(words[1])} pieces")]
        return f"words: stored {pairs[0][0]!r}, now {pairs[0][1]!r}"
    for old, new in zip(ANY_NUMBER.findall(stored), ANY_NUMBER.findall(now)):
        if not same(old, new):
            return f"number: stored {old}, now {new}"
    return ""


def same_place(stored, now):
    return abs(value_of(stored) - value_of(now)) <= PIXEL or same_number(stored, now)


def parts(outputs):
    """(kind, text) of each output of a cell; streams of one name that follow one another are one."""
    found = []
    for output in outputs:
        if output["output_type"] == "stream":
            if found and found[-1][0] == output["name"]:
                found[-1] = (output["name"], found[-1][1] + output["text"])
            else:
                found.append((output["name"], output["text"]))
        elif output["output_type"] == "error":
            found.append(("error", output["ename"] + ": " + output["evalue"]))
        else:
            mime = next((mime for mime in ("image/svg+xml", "text/html") if mime in output["data"]), "text/plain")
            found.append((mime, output["data"][mime]))
    return found


def compare_cell(stored, now):
    """Faults of one code cell, in words."""
    old, new = parts(stored["outputs"]), parts(now["outputs"])
    if [kind for kind, _ in old] != [kind for kind, _ in new]:
        yield f"outputs: stored {[kind for kind, _ in old]}, now {[kind for kind, _ in new]}"
        return
    for (kind, before), (_, after) in zip(old, new):
        fault = difference(before, after, same_place if kind == "image/svg+xml" else same_number)
        if fault:
            yield f"{kind}: {fault}"


def numbers_computed(notebook):
    """Numbers of the outputs but for pictures, and numbers of the code."""
    outputs, code = [], []
    for cell in notebook.cells:
        if cell.cell_type != "code":
            continue
        code += ANY_NUMBER.findall(re.sub(r"(?<=\d)'(?=\d)", "", cell.source))
        for kind, text in parts(cell.outputs):
            if kind != "image/svg+xml":
                outputs += ANY_NUMBER.findall(re.sub(r"<[^>]*>", " ", text))
    return [value_of(number) for number in outputs], [value_of(number) for number in code]


def text_of(source):
    """A text cell without what is no statement: code, formulas, targets of links, HTML."""
    for pattern in (r"```.*?```", r"`[^`]*`", r"\$\$.*?\$\$", r"\$[^$]*\$", r"\]\([^)]*\)", r"<[^>]*>"):
        source = re.sub(pattern, " ", source, flags=re.DOTALL)
    return re.sub(r"(?m)^\s*(#+\s*)?\d+\. ", " ", source)  # of a numbered list or heading


def text_faults(notebook):
    """Numbers in the text that nothing computes."""
    outputs, code = numbers_computed(notebook)
    for index, cell in enumerate(notebook.cells):
        if cell.cell_type != "markdown":
            continue
        for number in NUMBER.findall(text_of(cell.source)):
            value = value_of(number)
            half = 0.5000001 * unit_of_last_decimal(number)
            stated = any(abs(abs(known) - abs(value)) <= half for known in outputs)
            if not stated and not any(abs(known) == abs(value) for known in code):
                yield f"text cell {index}: {number} is no output of this notebook and stands in none of its code"
