# SPDX-License-Identifier: MIT
"""one_unit.py ROOT: the sources of a library go together into one translation unit (preset minimal, CAMOPT_UNITY_BATCH=0): no two
of them define the same name in an unnamed namespace. Reads the lists of sources of the CMakeLists.txt, compiles nothing.

Functions of one name with other parameter types are overloads, and allowed."""

import collections
import pathlib
import re
import sys

import source_tree

LISTED = re.compile(r"\b(camopt_add_module|add_library|add_executable)\s*\(\s*(\w+)(.*?)\)", re.DOTALL)
ALONE = re.compile(r"\bcamopt_compile_alone\s*\(\s*\S+(.*?)\)", re.DOTALL)
SOURCE = re.compile(r"[\w./]+\.cpp\b")
# Comments, raw strings, strings, characters; a digit separator is no character.
NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|^[ \t]*#[^\n]*|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'
                     r"(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'", re.DOTALL | re.MULTILINE)
NAMESPACE = re.compile(r"(?:inline\s+)?namespace\b\s*([\w:]*)\s*(?:\[\[.*?\]\]\s*)?$")
TYPE = re.compile(r"(?:class|struct|union|enum(?:\s+class|\s+struct)?)\s+(?:alignas\s*\([^)]*\)\s*)?(\w+)")


def units(root):
    """{(CMakeLists.txt, target): sources that are compiled together}."""
    for file in sorted(root.rglob("CMakeLists.txt")):
        folder = file.parent.relative_to(root)
        if not folder.parts or source_tree.module_of(folder / "x") not in (*source_tree.EVERY_MODULE, "apps", "bindings"):
            continue
        text = re.sub(r"#[^\n]*", "", file.read_text())
        alone = {name for listed in ALONE.findall(text) for name in SOURCE.findall(listed)}
        for command, target, listed in LISTED.findall(text):
            names = [name for name in SOURCE.findall(listed) if name not in alone and (root / folder / name).is_file()]
            if command == "camopt_add_module":
                names = [name for name in names if not name.endswith("_svg.cpp")]
            yield (file.relative_to(root).as_posix(), target), [folder / name for name in names]


def without_angles(text):
    """Template arguments taken out: what is left has no comma or parenthesis of theirs."""
    while True:
        shorter = re.sub(r"<[^<>]*>", " ", text)
        if shorter == text:
            return text
        text = shorter


def parameters(text):
    """Types of the parameters, without names and default values."""
    types = []
    for part in text.split(","):
        words = re.findall(r"[\w:]+|[&*]", part.split("=")[0])
        if len(words) > 1 and words[-1] not in ("&", "*") and words[-2] not in ("const", "unsigned", "long"):
            words.pop()
        types.append(" ".join(words))
    return tuple(types)


def defined(head, ends):
    """(name, what another definition must differ in, or None: it must not exist); None where no name is defined."""
    head = head.strip()
    while head.startswith("template"):
        depth, at = 0, head.find("<")
        for at in range(at, len(head)):
            depth += {"<": 1, ">": -1}.get(head[at], 0)
            if not depth:
                break
        head = head[at + 1:].strip()
    head = re.sub(r"\[\[.*?\]\]", " ", head).strip()
    if match := re.match(r"using\s+(\w+)\s*=", head):
        return match[1], head  # the same type twice is no fault
    if not head or re.match(r"(using|static_assert|friend|extern|requires)\b", head):
        return None
    if match := TYPE.match(head):
        return None if ends == ";" and "=" not in head else (match[1], None)
    plain = without_angles(head.replace("<=>", " ").replace("->", "  "))
    if re.search(r"\boperator\b", plain):
        match = re.search(r"operator\s*(\S+?)\s*\(([^()]*)\)", plain)
        return (f"operator{match[1]}", parameters(match[2])) if match else None
    if "::" in plain.split("(")[0].rsplit(" ", 1)[-1]:
        return None  # a member defined out of its class, or the type of a variable
    before = plain.split("=")[0]
    if "(" not in before:
        names = re.findall(r"\w+", re.sub(r"\[[^\]]*\]", " ", before))
        return (names[-1], None) if len(names) > 1 else None
    match = re.search(r"(\w+)\s*\(([^()]*(?:\([^()]*\)[^()]*)*)\)", plain)
    return (match[1], parameters(match[2])) if match else None


def names_of(text):
    """{(enclosing namespace, name): {what defined() says of it}} of the unnamed namespaces of a source."""
    code = NO_CODE.sub(lambda found: " " if found[0].lstrip()[:1] in "/#" else '""', text)
    found = collections.defaultdict(set)
    scopes, head, depth, parentheses = [], "", 0, 0  # depth: braces inside a declaration
    for char in code:
        if depth == 0 and char in "()":
            parentheses += 1 if char == "(" else -1
        if char == "{":
            match = NAMESPACE.search(head.strip()) if depth == 0 and parentheses == 0 else None
            if match:
                scopes.append(match[1])
                head = ""
                continue
            if depth == 0 and parentheses == 0 and scopes and scopes[-1] == "" and (name := defined(head, "{")):
                found["::".join(scopes), name[0]].add(name[1])
            depth += 1
            head += " {} " if depth == 1 else ""
        elif char == "}":
            if depth == 0:
                scopes.pop()
                head = ""
                continue
            depth -= 1
            if depth == 0 and parentheses == 0 and re.search(r"\)[^=;]*\{\}\s*$", head):
                head = ""  # a function's body
        elif char == ";" and depth == 0 and parentheses == 0:
            if "{}" not in head and scopes and scopes[-1] == "" and (name := defined(head, ";")):
                found["::".join(scopes), name[0]].add(name[1])
            head = ""
        elif depth == 0:
            head += char
    return found


def may_stand_together(one, other):
    """Overloads, or one alias twice."""
    if isinstance(one, tuple) and isinstance(other, tuple):
        return one != other
    return one is not None and one == other


def faults(root):
    for (file, target), sources in units(root):
        first = {}
        for source in sources:
            for (scope, name), kinds in names_of((root / source).read_text()).items():
                for kind in kinds:
                    for other, before in first.get((scope, name), []):
                        if not may_stand_together(kind, before):
                            yield f"{source}: {name} is defined in {other} too, and {file} compiles both as one unit ({target})"
                            break
                    first.setdefault((scope, name), []).append((source, kind))


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found = list(dict.fromkeys(faults(root)))
    if not any(sources for _, sources in units(root)):
        found.append("found no list of sources in any CMakeLists.txt")
    print("\n".join([*found, f"one_unit: {len(found)} faults"]))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
