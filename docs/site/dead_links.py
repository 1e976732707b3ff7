# SPDX-License-Identifier: MIT
"""dead_links.py FOLDER: every link, picture, script and style of the HTML pages in FOLDER leads to a file there, and every anchor
to an element; nothing is fetched from elsewhere when a page is opened."""

import functools
import html.parser
import pathlib
import sys
import urllib.parse

FETCHED = {("img", "src"), ("script", "src"), ("link", "href"), ("source", "src"), ("iframe", "src"), ("object", "data")}
# Pages of Sphinx that scripts fill; and links that say what a page is instead of fetching something.
NOT_FETCHED = {"canonical", "author", "search", "index", "next", "prev", "license"}


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.anchors, self.links, self.fetched = set(), [], []

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        for name in ("src", "href", "data"):
            if (tag, name) in FETCHED and values.get(name) and not NOT_FETCHED & set((values.get("rel") or "").split()):
                self.fetched.append(values[name])
                self.links.append(values[name])


@functools.lru_cache(maxsize=None)
def page_at(path):
    page = Page()
    page.feed(path.read_text(encoding="utf-8"))
    return page


def faults_of_link(path, link):
    address = urllib.parse.urlsplit(link)
    if address.scheme or address.netloc:
        return
    target = (path.parent / urllib.parse.unquote(address.path)).resolve() if address.path else path
    if not target.is_file():
        yield f"'{link}' leads to no file"
    elif address.fragment and target.suffix == ".html":
        if urllib.parse.unquote(address.fragment) not in page_at(target).anchors:
            yield f"'{link}': no such anchor"


def faults_in(folder):
    for path in sorted(folder.resolve().rglob("*.html")):
        page = page_at(path)
        for link in page.links:
            yield from (f"{path.relative_to(folder.resolve())}: {fault}" for fault in faults_of_link(path, link))
        for link in page.fetched:
            if link.startswith(("http:", "https:", "//")):
                yield f"{path.relative_to(folder.resolve())}: fetches {link}: the site must work without a network"


def main():
    folder = pathlib.Path(sys.argv[1])
    pages = list(folder.rglob("*.html"))
    faults = list(faults_in(folder))
    links = sum(len(page_at(path.resolve()).links) for path in pages)
    print("\n".join(faults + [f"dead_links: {len(faults)} faults in {links} links of {len(pages)} pages"]))
    sys.exit(1 if faults or not pages else 0)


if __name__ == "__main__":
    main()
