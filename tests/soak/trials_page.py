# SPDX-License-Identifier: MIT
"""Tables of counts between marks of a page, which later runs add to, several at a time."""
import collections
import contextlib
import fcntl
import os
import re


class Table:
    """`rows`: {key: Counter of columns}. A key has a cell for each of `names`, the first of which is printed as code."""

    def __init__(self, mark, names, columns):
        self.begin, self.end, self.names, self.columns, self.rows = f"<!-- {mark} -->\n", f"<!-- end of {mark} -->", names, columns, {}

    def read(self, text):
        for line in self.parted(text)[1].splitlines()[2:]:
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if cells[0] != "all":
                key = cells[0].strip("`"), *cells[1:len(self.names)]
                self.add(key, dict(zip(self.columns, map(int, cells[len(self.names):]))))

    def parted(self, text):
        """Before, between and after the marks."""
        head, rest = text.split(self.begin, 1)
        inside, tail = rest.split(self.end, 1)
        return head, inside, tail

    def add(self, key, counts):
        row = self.rows.setdefault(key, collections.Counter())
        row.update({name: count for name, count in counts.items() if count})

    def written(self, text):
        def line(key, row):
            return "| " + " | ".join([*key, *(str(row[name]) for name in self.columns)]) + " |"
        total = sum(self.rows.values(), collections.Counter())
        lines = ["| " + " | ".join(self.names + self.columns) + " |", "|" + "---|" * len(self.names) + "--:|" * len(self.columns),
                 *(line((f"`{key[0]}`", *key[1:]), row) for key, row in self.rows.items()), line(["all"] * len(self.names), total)]
        head, _, tail = self.parted(text)
        return head + self.begin + "\n".join(lines) + "\n" + self.end + tail

    def sum_of(self, commit):
        own = sum((row for key, row in self.rows.items() if key[0] == commit), collections.Counter())
        return ", ".join(f"{own[name]} {name}" for name in self.columns)


class Page:
    def __init__(self, file, tables):
        self.file, self.tables = file, tables
        self.read()

    def read(self):
        for table in self.tables:
            table.rows.clear()
            table.read(self.file.read_text())

    @contextlib.contextmanager
    def added_to(self):
        """Its rows with what others have added meanwhile; saved at the end. The file is whole at any time."""
        folder = os.open(self.file.parent, os.O_RDONLY)
        fcntl.flock(folder, fcntl.LOCK_EX)
        try:
            self.read()
            yield
            text = self.file.read_text()
            for table in self.tables:
                text = table.written(text)
            new = self.file.with_suffix(".new")
            new.write_text(text)
            new.replace(self.file)
        finally:
            os.close(folder)


def reason_cell(text):
    """A reason without the numbers, names and folders of its scene, so that equal ones are counted together."""
    text = re.sub(r"(?:/[\w.-]+)+/", "", " ".join(text.split()))
    text = re.sub(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?", "…", text).replace("|", "/")
    return text if len(text) <= 160 else text[:157] + "…"
