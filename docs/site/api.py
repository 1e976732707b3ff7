# SPDX-License-Identifier: MIT
"""The reference of the promised headers: doxygen says what is declared where, the headers themselves say the rest.

A page a promised header: its purpose, then what it brings, each declaration as it stands in its header, with its comment, its
formulas and its units untouched. What is private is left out."""

import dataclasses
import html
import pathlib
import re
import subprocess
import xml.etree.ElementTree as xml

INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
COMMENT = re.compile(r"^\s*//[/!]? ?(?!<)(.*)$")
SETTINGS = """
QUIET = YES
WARN_AS_ERROR = YES
WARN_IF_UNDOCUMENTED = NO
WARN_IF_DOC_ERROR = NO
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
MARKDOWN_SUPPORT = NO
AUTOLINK_SUPPORT = NO
ENABLE_PREPROCESSING = YES
MACRO_EXPANSION = NO
OUTPUT_DIRECTORY = {out}
STRIP_FROM_PATH = {root}
INPUT = {files}
"""


@dataclasses.dataclass
class Entity:
    kind: str
    name: str
    first: int  # lines of the header, from 1
    last: int


def brought_by(header, root):
    """The headers of the tree that a promised one includes itself, in its order."""
    names = INCLUDE.findall(header.read_text(encoding="utf-8"))
    return [root / name for name in names if not name.startswith("camopt/")]


def run_doxygen(root, out, files):
    out.mkdir(parents=True, exist_ok=True)
    listed = " ".join(f'"{file}"' for file in files)
    settings = SETTINGS.format(out=out, root=root, files=listed)
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True, cwd=root)
    return out / "xml"


def entities_in(folder):
    """{header: entities}, of types and of what stands directly in a namespace."""
    found = {}
    for path in folder.glob("*.xml"):
        # Of files only those of C: what a C++ header declares stands in its namespace.
        if path.stem.startswith(("struct", "class", "namespace", "union")) or path.stem.endswith("_8h"):
            compound = xml.parse(path).getroot().find("compounddef")
            if compound.get("kind") in ("namespace", "file"):
                for member in compound.iter("memberdef"):
                    add(found, member, member.get("kind"), member.findtext("name"))
            else:
                add(found, compound, compound.get("kind"), compound.findtext("compoundname").removeprefix("camopt::"))
    return found


def add(found, element, kind, name):
    place = element.find("location")
    file = place.get("declfile") or place.get("file")
    line = int(place.get("declline") or place.get("line"))
    if not name or name.startswith("@"):
        return
    end = int(place.get("bodyend") or -1) if place.get("bodyfile") == file else -1
    found.setdefault(file, []).append(Entity(kind, name, line, max(line, end)))


def declaration(lines, entity):
    """Its lines, from `template` or the comment above to the ';' or '}' that closes it, without what is private."""
    first = entity.first - 1
    while first > 0 and re.match(r"\s*(template|\[\[)", lines[first - 1]):
        first -= 1
    last = entity.last - 1
    if entity.kind == "define":
        return first, lines[first:first + 1]
    while last < len(lines) - 1 and not re.search(r"[;}]\s*(//.*)?$", lines[last]):
        last += 1
    body = lines[first:last + 1]
    private = next((n for n, line in enumerate(body) if line.strip() == "private:"), None)
    if private is not None:
        body = [*body[:private], body[-1]]
    return first, body


def comment_above(lines, first):
    """The lines of the comment right above a line, without their slashes."""
    start = first
    while start > 0 and COMMENT.match(lines[start - 1]):
        start -= 1
    return [COMMENT.match(line).group(1) for line in lines[start:first]]


def purpose_of(lines):
    """The comment that a header opens with."""
    words = []
    for line in lines:
        if line.startswith("//") and "SPDX" not in line:
            words.append(COMMENT.match(line).group(1))
        elif not line.startswith("//"):
            break
    return words


def prose(words):
    """Comment lines as Markdown: indented lines are formulas and keep their blanks, all else is text as it stands."""
    parts, formula = [], False
    for line in words:
        indented = line.startswith("  ")
        if indented != formula:
            parts += ["", "```text"] if indented else ["```", ""]
            formula = indented
        parts.append(line if indented else escaped(line))
    return "\n".join(parts + ["```"] * formula) + "\n"


def escaped(line):
    """Markdown's own marks mean nothing in a comment, but backticks do."""
    pieces = re.split(r"(`[^`]*`)", line)
    return "".join(piece if piece.startswith("`") and len(piece) > 1 else re.sub(r"([\\*_<>|#\[\]$`~])", r"\\\1", piece)
                   for piece in pieces)


def anchor(kind, name):
    return f"api-{kind}-" + re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


class Reference:
    def __init__(self, root, out, work):
        self.root, self.out = root, out
        self.include = work / "include"
        subprocess.run(["cmake", f"-Dcamopt_promised_dir={self.include}", "-P", root / "include/promised_headers.cmake"], check=True)
        self.promised = sorted((self.include / "camopt").glob("*.hpp"))
        brought = {header for promised in self.promised for header in brought_by(promised, root)}
        own = sorted((root / "bindings/c").glob("*.h"))
        self.promised += own
        self.entities = entities_in(run_doxygen(root, work, sorted(brought) + own))
        self.names = []

    def write(self):
        (self.out / "api").mkdir(parents=True, exist_ok=True)
        rows, pages = [], []
        for header in self.promised:
            if header.stem == "camopt" and header.suffix == ".hpp":
                continue
            page = header.name.replace(".", "_")
            (self.out / f"api/{page}.md").write_text(self.page(header, page), encoding="utf-8")
            pages.append(f"{header.name} <{page}>")
            first = " ".join(purpose_of(header.read_text(encoding="utf-8").split("\n")[0:9])).split(". ")[0].split(": ")[0]
            rows.append(f"| [`{self.name_of(header)}`]({page}.md) | {escaped(first).rstrip('.')} |")
        (self.out / "api/index.md").write_text(self.index(rows, pages), encoding="utf-8")
        return len(pages), len(self.names)

    def name_of(self, header):
        return header.name if header.suffix == ".h" else str(header.relative_to(self.include))

    def page(self, header, page):
        parts = [f"# `<{self.name_of(header)}>`\n", prose(purpose_of(header.read_text(encoding="utf-8").split("\n")))]
        headers = [header] if header.suffix == ".h" else brought_by(header, self.root)
        for brought in headers:
            lines = brought.read_text(encoding="utf-8").split("\n")
            if len(headers) > 1 or brought != header:
                parts += [f"## From `{brought.relative_to(self.root)}`\n", prose(purpose_of(lines))]
            else:
                parts.append("## Names\n")
            parts += [part for entity in self.entities_of(brought, lines) for part in self.section(entity, lines, page)]
        return "\n".join(parts)

    def entities_of(self, header, lines):
        """In the order of the header; a declaration inside another stands with that one, overloads together."""
        entities = sorted(self.entities.get(str(header.relative_to(self.root)), []) + self.entities.get(str(header), []),
                          key=lambda entity: (entity.first, -entity.last))
        outer = []
        for entity in entities:
            if outer and entity.first <= outer[-1].last or "::" in entity.name:
                continue
            if entity.kind == "define" and len(lines[entity.first - 1].split()) < 3:
                continue  # a guard, or a word that only a compiler sees
            outer.append(entity)
        return outer

    def section(self, entity, lines, page):
        first, body = declaration(lines, entity)
        key = anchor(entity.kind, entity.name)
        known = any(key == other for _, other, _ in self.names)
        if not known:
            self.names.append((entity.name, key, page))
            yield f"({key})=\n### `{entity.name}`\n"
        yield prose(comment_above(lines, first)) + "\n```cpp\n" + "\n".join(body) + "\n```\n"

    def index(self, rows, pages):
        names = sorted(self.names, key=lambda name: name[0].lower())
        languages = "C++ and C" if any(header.suffix == ".h" for header in self.promised) else "C++"
        text = [f"# {languages} reference\n\nThe promised headers, and what they bring. `<camopt/camopt.hpp>` is all of them. What is promised and how to link: "
                "[Embedding](../docs/embedding.md).\n", "| header | for |", "|---|---|", *rows, "\n## Every name\n",
                " · ".join(f'<a href="{page}.html#{key}"><code>{html.escape(name)}</code></a>' for name, key, page in names),
                "\n```{toctree}\n:hidden:\n\n" + "\n".join(pages) + "\n```\n"]
        return "\n".join(text)
