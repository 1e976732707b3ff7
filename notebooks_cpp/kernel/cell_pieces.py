# SPDX-License-Identifier: MIT
"""A cell as the pieces that clang-repl gets one after another. Two things of clang-repl 22 are put right here.

Within one piece it initialises constants (`const auto x = f(scene);`) before everything else of the piece, the statements
above them included. So a constant begins a piece, and what follows it another: then a cell runs from top to bottom.

It crashes while it compiles a lambda inside a statement at the top level, `sort(a, [](…) {…});`, where the lambda's type
goes into a template (LLVM pull request 217041). So such a statement is put into a function, which is called at once.

Lines and columns in messages stay those of the cell.
"""

import re

STRING = re.compile(r'"(?:\\.|[^"\\\n])*"')
RAW_STRING = re.compile(r'R"([^()\\\s]{0,16})\(.*?\)\1"', re.DOTALL)
# 'a' is a character, 1'000 a number.
CHARACTER = re.compile(r"'(?:\\[^\n]{1,8}?|[^'\\\n])'")
NUMBER = re.compile(r"\.?\d(?:[eEpP][+-]|'?[\w.])*")
WORD = re.compile(r"[A-Za-z_]\w*")
DIRECTIVE = re.compile(r"[ \t]*#(?:\\\n|[^\n])*")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
CONTROL = {"for", "while", "do", "if", "switch", "try"}
# After these a closed brace does not end what it stands in.
OPEN_ENDED = {"=", "struct", "class", "union", "enum", "return"}


def tokens(text):
    """(begin, end) of each token, comments, white space and preprocessor lines left out."""
    place = 0
    while place < len(text):
        line_start = text.rfind("\n", 0, place) + 1
        skipped = COMMENT.match(text, place)
        if not skipped and not text[line_start:place].strip():
            skipped = DIRECTIVE.match(text, place)
        if skipped:
            place = skipped.end()
            continue
        if text[place].isspace():
            place += 1
            continue
        token = RAW_STRING.match(text, place) or STRING.match(text, place) or NUMBER.match(text, place) or \
            CHARACTER.match(text, place) or WORD.match(text, place)
        end = token.end() if token else place + 1
        yield place, end
        place = end


def bracket_fault(text):
    """(line, words) of a bracket without its partner, or None. At one that is never closed clang-repl waits for ever."""
    partner = {")": "(", "]": "[", "}": "{"}
    opened = []
    for begin, end in tokens(text):
        token = text[begin:end]
        line = text.count("\n", 0, begin) + 1
        if token in partner.values():
            opened.append((token, line))
        elif token in partner:
            if not opened or opened[-1][0] != partner[token]:
                return line, f"'{token}' closes nothing"
            opened.pop()
        elif token == '"':
            return line, "a text that does not end"
    return (opened[-1][1], f"'{opened[-1][0]}' is never closed") if opened else None


def statements(text):
    """(begin, first word, end) of each statement and declaration at the top level of a cell."""
    found = []
    begin, first, depth = None, "", 0
    for place, end in tokens(text):
        token = text[place:end]
        if begin is None:
            begin, first = place, token
        if token in "([{":
            depth += 1
        elif token in ")]}":
            depth = max(0, depth - 1)
        if depth == 0 and (token == ";" or (token == "}" and ends_with_brace(text, begin, end))):
            found.append((begin, first, end))
            begin = None
    if begin is not None:
        found.append((begin, first, len(text)))
    return found


def ends_with_brace(text, begin, place):
    """Whether the statement text[begin:place], whose last character is a brace, is complete."""
    rest = text[place:].lstrip()
    if rest.startswith((";", ",", ".", ")", "(", "[", "->", "=", "*", "+", "-", "/", "<", ">", "?", "|", "&")):
        return False
    following = WORD.match(rest)
    if following and following.group() in ("else", "while", "catch"):
        return False
    head = re.findall(r"\w+|=", text[begin:place].split("{", 1)[0])
    return bool(head and head[0] in CONTROL) or not set(head) & OPEN_ENDED or not following


LAMBDA = re.compile(r"\[[^\[\]]*\]\s*[({]")


def is_statement(text, first):
    """Whether this is no declaration, as far as its first words tell: one name, then what is done with it."""
    if first in CONTROL:
        return True
    head = re.split(r"<<|[(=\[{+]", text, maxsplit=1)[0]
    while re.search(r"<[^<>]*>", head):
        head = re.sub(r"<[^<>]*>", "", head)
    return re.fullmatch(r"\s*(::)?\w+((::|\.|->)\w+)*\s*", head) is not None


def place_of(text, offset):
    """What puts the compiler back to a place of the cell."""
    line_start = text.rfind("\n", 0, offset) + 1
    return f"\n#line {text.count(chr(10), 0, offset) + 1}\n" + " " * (offset - line_start)


def pieces(text, name="camopt_statement"):
    """The texts to run one after another; at least one. `name` begins the names of functions that are put in."""
    parts, copied = [""], 0  # copied: so far
    for begin, first, end in statements(text):
        code = text[begin:end]
        wrapped = code.endswith((";", "}")) and LAMBDA.search(code) and is_statement(code, first)
        if first != "const" and not wrapped:
            continue
        parts[-1] += text[copied:begin]
        copied = end
        if wrapped:
            function = f"{name}_{begin}"
            parts[-1] += f"\nvoid {function}() {{{place_of(text, begin)}{code}\n}}\n{function}();{place_of(text, end)}"
        else:
            parts.append(place_of(text, begin) + code)
            parts.append(place_of(text, end))
    parts[-1] += text[copied:]
    return [part for part in parts if re.sub(r"(?m)^#line \d+$", "", part).strip()] or [text]
