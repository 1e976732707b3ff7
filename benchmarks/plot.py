# SPDX-License-Identifier: MIT
"""Plots in SVG for RESULTS.md: panels with logarithmic or even axes, marks and lines. Python's standard library only."""

import math
from html import escape

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#8b6d3f")
STYLE = ("text{font-family:'DejaVu Sans','Helvetica Neue',Arial,sans-serif;fill:#222}.title{font-size:20px;"
         "font-weight:600}.subtitle{font-size:13px;fill:#444}.caption{font-size:14px;font-weight:600}"
         ".tick{font-size:11px;fill:#444}.axis{font-size:12px;fill:#444}.legend{font-size:12px}"
         ".grid{stroke:#e4e4e4;stroke-width:1}.frame{fill:none;stroke:#888;stroke-width:1}"
         ".target{stroke:#666;stroke-width:1.2;stroke-dasharray:5 4}.line{fill:none;stroke-width:1.8}")
SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


class Axis:
    """From numbers to px. `ticks`: (value, words); None: powers of ten, or of four for `base` 4."""

    def __init__(self, lower, upper, title="", logarithmic=True, ticks=None, stride=1):
        self.lower, self.upper, self.title, self.logarithmic = lower, upper, title, logarithmic
        self.ticks = ticks if ticks is not None else self.decades(stride)

    def decades(self, stride):
        first, last = math.ceil(math.log10(self.lower) - 1e-9), math.floor(math.log10(self.upper) + 1e-9)
        return [(10.0 ** k, "10" + str(k).translate(SUPERSCRIPT) if k % stride == 0 else "")
                for k in range(first, last + 1)]

    def place(self, value):
        value = min(max(value, self.lower), self.upper)
        if self.logarithmic:
            return math.log(value / self.lower) / math.log(self.upper / self.lower)
        return (value - self.lower) / (self.upper - self.lower)


class Picture:
    def __init__(self, width, height, title, subtitle):
        self.width, self.height = width, height
        self.parts = [f'<rect width="{width}" height="{height}" fill="#fff"/>']
        self.text(36, 40, title, "title")
        self.text(36, 63, subtitle, "subtitle")

    def text(self, x, y, words, css, anchor="start", turn=0):
        where = f' transform="rotate({turn} {x:.1f} {y:.1f})"' if turn else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" class="{css}" text-anchor="{anchor}"{where}>'
                          f"{escape(str(words))}</text>")

    def mark(self, x, y, colour, shape="circle", size=4.0, filled=True):
        looks = f'stroke="{colour}" stroke-width="1.4" fill="{colour if filled else "none"}" fill-opacity="0.55"'
        if shape == "circle":
            self.parts.append(f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{size:.2f}" {looks}/>')
        elif shape == "square":
            self.parts.append(f'<rect x="{x - 0.9 * size:.2f}" y="{y - 0.9 * size:.2f}" width="{1.8 * size:.2f}" '
                              f'height="{1.8 * size:.2f}" {looks}/>')
        elif shape == "triangle":
            half = 1.15 * size
            self.parts.append(f'<path d="M{x:.2f} {y - half:.2f}L{x + half:.2f} {y + 0.8 * half:.2f}'
                              f'L{x - half:.2f} {y + 0.8 * half:.2f}Z" {looks}/>')
        else:
            self.parts.append(f'<path d="M{x - size:.2f} {y - size:.2f}L{x + size:.2f} {y + size:.2f}M{x - size:.2f} '
                              f'{y + size:.2f}L{x + size:.2f} {y - size:.2f}" stroke="{colour}" stroke-width="1.8"/>')

    def segment(self, x1, y1, x2, y2, css, colour=None):
        stroke = f' stroke="{colour}"' if colour else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" class="{css}"{stroke}/>')

    def legend(self, x, y, entries):
        """entries: (words, colour, shape, filled) or (words, colour, "line", True), side by side."""
        for words, colour, shape, filled in entries:
            if shape in ("line", "target"):
                self.segment(x - 6, y - 4, x + 12, y - 4, shape, None if shape == "target" else colour)
            else:
                self.mark(x, y - 4, colour, shape, 4.5, filled)
            self.text(x + 18, y, words, "legend")
            x += 46 + 6.9 * len(words)

    def svg(self):
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" '
                f'viewBox="0 0 {self.width} {self.height}"><style>{STYLE}</style>' + "\n".join(self.parts) + "</svg>\n")


class Panel:
    """One frame with its two axes; numbers outside are drawn at its edge."""

    def __init__(self, picture, box, horizontal, vertical, caption):
        self.picture, self.horizontal, self.vertical = picture, horizontal, vertical
        self.left, self.top, self.width, self.height = box
        bottom = self.top + self.height
        for value, words in horizontal.ticks:
            x = self.x(value)
            picture.segment(x, self.top, x, bottom, "grid")
            picture.text(x, bottom + 16, words, "tick", "middle")
        for value, words in vertical.ticks:
            y = self.y(value)
            picture.segment(self.left, y, self.left + self.width, y, "grid")
            picture.text(self.left - 7, y + 4, words, "tick", "end")
        picture.parts.append(f'<rect x="{self.left}" y="{self.top}" width="{self.width}" height="{self.height}" '
                             'class="frame"/>')
        picture.text(self.left, self.top - 9, caption, "caption")
        picture.text(self.left + self.width / 2, bottom + 34, horizontal.title, "axis", "middle")
        picture.text(self.left - 48, self.top + self.height / 2, vertical.title, "axis", "middle", -90)

    def x(self, value):
        return self.left + self.width * self.horizontal.place(value)

    def y(self, value):
        return self.top + self.height * (1 - self.vertical.place(value))

    def mark(self, across, up, colour, shape="circle", size=4.0, filled=True):
        self.picture.mark(self.x(across), self.y(up), colour, shape, size, filled)

    def line(self, points, colour, dashed=False):
        if len(points) > 1:
            path = "L".join(f"{self.x(a):.2f} {self.y(b):.2f}" for a, b in points)
            dash = ' stroke-dasharray="6 4"' if dashed else ""
            self.picture.parts.append(f'<path d="M{path}" class="line" stroke="{colour}"{dash}/>')

    def level(self, up, words=""):
        y = self.y(up)
        self.picture.segment(self.left, y, self.left + self.width, y, "target")
        if words:
            self.picture.text(self.left + self.width - 6, y - 5, words, "tick", "end")
