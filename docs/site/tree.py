# SPDX-License-Identifier: MIT
"""The pages of the source tree as pages of the site: same paths, links to other files of the tree answered by the site."""

import os
import pathlib
import re
import shutil

LINK = re.compile(r"(!?\[(?:[^\]\[]|\[[^\]]*\])*\]\()([^)\s]+)(\))")
FENCE = re.compile(r"^ *```")
PICTURES = {".svg", ".png"}
LANGUAGES = {".hpp": "cpp", ".cpp": "cpp", ".h": "c", ".c": "c", ".py": "python", ".toml": "toml", ".sh": "sh", ".cmake": "cmake",
             ".json": "json", ".md": "markdown"}


def with_title(path, text):
    """A table that a program wrote begins below the headings of the page it belongs to; alone it needs a title."""
    levels = [len(match) for match in re.findall(r"^(#+) ", text, re.M)]
    if not levels or min(levels) == 1:
        return text
    raised = re.sub(r"^(#+) ", lambda match: match[1][min(levels) - 2:] + " ", text, flags=re.M)
    return f"# {pathlib.PurePath(path).stem.replace('_', ' ').capitalize()}\n\n{raised}"


class Tree:
    """Puts pages into `out`; what they link to beside pages is shown by pages below source/."""

    def __init__(self, root, out, scenes):
        self.root, self.out, self.scenes = root, out, scenes
        self.pages = {}
        self.shown = set()

    def page_of(self, path):
        """Where a page of the tree stands on the site."""
        return "index.md" if path == "README.md" else self.pages.get(path, path)

    def add_pages(self, paths):
        self.pages |= {path: self.page_of(path) for path in paths}
        for path in paths:
            self.write(self.pages[path], self.rewritten(path))

    def write(self, place, text):
        target = self.out / place
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")

    def rewritten(self, path):
        return with_title(path, self.with_links_of_site(path, (self.root / path).read_text(encoding="utf-8")))

    def with_links_of_site(self, path, text):
        """`text`, which stands at `path` in the tree, as it has to be at the place of that page."""
        lines, fenced = [], False
        for line in text.split("\n"):
            if FENCE.match(line):
                line = line if fenced else self.fence(line)
                fenced = not fenced
            elif not fenced:
                line = LINK.sub(lambda match: match[1] + self.target(path, match[2]) + match[3], line)
            lines.append(line)
        return "\n".join(lines)

    @staticmethod
    def fence(line):
        language = line.strip()[3:].strip()
        known = {"usage": "text", "gcode": "text", "": "text"}.get(language, language)
        return line.replace("```" + language, "```" + known)

    def target(self, page, link):
        """The same place, as a link from the page's place on the site."""
        if re.match(r"[a-z]+:", link) or link.startswith("#"):
            return link
        name, mark, anchor = link.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(page), name))
        if not (self.root / path).exists():  # a picture that was made for the site
            return link
        here = os.path.dirname(self.page_of(page))
        return os.path.relpath(self.place_of(path), here or ".") + mark + anchor

    def place_of(self, path):
        if path in self.pages:
            return self.pages[path]
        if pathlib.PurePath(path).suffix in PICTURES:
            target = self.out / path
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(self.root / path, target)
            return path
        if path in self.scenes:
            return self.scenes[path]
        return self.show(path)

    def show(self, path):
        place = f"source/{path}.md"
        if place not in self.shown:
            self.shown.add(place)
            full = self.root / path
            self.write(place, self.listing(path) if full.is_dir() else self.file(path))
        return place

    def file(self, path):
        text = (self.root / path).read_text(encoding="utf-8")
        language = LANGUAGES.get(pathlib.PurePath(path).suffix, "text")
        return f"---\norphan: true\n---\n# `{path}`\n\n````{language}\n{text}````\n"

    def listing(self, path):
        """A folder: its pages as links, its other files by name."""
        rows = []
        for file in sorted((self.root / path).iterdir()):
            name = f"{path}/{file.name}"
            place = self.pages.get(name) or self.scenes.get(name)
            here = os.path.dirname(f"source/{path}.md")
            rows.append(f"* [{file.name}]({os.path.relpath(place, here)})" if place else f"* `{file.name}`")
        return f"---\norphan: true\n---\n# `{path}`\n\n" + "\n".join(rows) + "\n"
