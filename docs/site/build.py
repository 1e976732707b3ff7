# SPDX-License-Identifier: MIT
"""build.py ROOT PROGRAM OUT PAGE: the documentation site in OUT/html. scripts/site calls it with what it needs; PAGE
(camopt.html) is offered as "Try it" where it is there.

OUT/pages is what Sphinx reads, made anew each time; OUT/solved keeps the results of the gallery's scenes."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import api
import gallery
import keys
import notebooks
import tree

HERE = pathlib.Path(__file__).parent
# Sections of the menu, in the order in which a reader needs them: install, first solve, scenes, results, cams, applications.
# Every page of the tree is in one of them; a page that is in none is an error (missing_pages).
SECTIONS = [
    ("Start", ["try", "install", "README", "designs", "gallery/index"]),
    ("Scenes and results", ["scene_file", "reference/scene", "programs", "least_value", "results", "report", "compare", "sweep", "scale"]),
    ("Cams", ["cams", "linear_cams", "tolerances", "prescribed_output", "drawing", "nc", "old_cam", "measured", "inspect"]),
    ("Applications", ["valves", "servo", "plc", "machines", "theory/elastic_follower"]),
    ("Your own program", ["examples/README", "embedding", "embedding_c", "python", "api/index", "notebooks_cpp/README",
                          "notebooks/index"]),
    ("Method and proofs", ["method", "certificates", "stability", "trials", "theory/pressure_angle", "reference/laws",
                           "reference/solvers"]),
    ("Papers", []),
    ("Benchmarks", ["benchmarks/RESULTS", "benchmarks/README"]),
    ("The project", ["architecture", "dependencies", "verification", "CONTRIBUTING", "adding_a_law", "adding_a_key", "adding_a_limit",
                     "adding_a_term", "adding_a_solver", "adding_a_follower", "adding_a_kind", "adding_a_format", "adding_a_study", "CHANGELOG", "SECURITY"]),
]
# Pages that other pages list; "source/" shows files that pages link to.
LISTED_ELSEWHERE = ("source/", "api/", "gallery/", "notebooks/")


def pages_of_tree(root):
    pages = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "benchmarks/README.md", "benchmarks/RESULTS.md",
             "notebooks_cpp/README.md", "examples/README.md"]
    pages += [str(path.relative_to(root)) for path in (root / "benchmarks/results").glob("*.md")]
    pages += [str(path.relative_to(root)) for path in sorted((root / "docs").rglob("*.md"))]
    return [page for page in pages if (root / page).exists()]


def sections(out):
    """(title, pages) of the menu: every page of the site but the first and those that other pages list."""
    written = {str(path.relative_to(out).with_suffix("")) for path in out.rglob("*.md")}
    rows = []
    for title, names in SECTIONS:
        pages = [name if name in written else f"docs/{name}" for name in names]
        if title == "Papers":
            pages = sorted(page for page in written if page.startswith("docs/papers/"))
        if title == "Benchmarks":
            pages += sorted(page for page in written if page.startswith("benchmarks/results/"))
        rows.append((title, [page for page in pages if page in written]))
    missing = missing_pages(written, rows)
    if missing:
        sys.exit(f"docs/site/build.py: SECTIONS lacks {', '.join(missing)}")
    return rows


def missing_pages(written, rows):
    """Pages that are not in the menu."""
    in_menu = {page for _, pages in rows for page in pages}
    return sorted(page for page in written - in_menu - {"index"} if not page.startswith(LISTED_ELSEWHERE))


def add_contents(out):
    index = out / "index.md"
    # The page of all pages and the site's own list are the same thing.
    text = index.read_text(encoding="utf-8")
    for title, pages in sections(out):
        listed = "\n".join("All pages <docs/README>" if page == "docs/README" else page for page in pages)
        text += f"\n```{{toctree}}\n:hidden:\n:caption: {title}\n\n{listed}\n```\n"
    index.write_text(text, encoding="utf-8")


TRY = """# Try it

The studio with its solver in one page: it runs in this browser, without a server and without a connection.

<p><a class="try" href="camopt.html"><strong>Open the studio</strong></a> &nbsp; or save the link's file and open it from disk.</p>

What it can do: [the offline page](docs/report.md#the-offline-page).
"""


def write_pages(root, program, out, work, offline):
    shutil.rmtree(out, ignore_errors=True)
    (out / "_static").mkdir(parents=True)
    for name in ("conf.py", "camopt.css"):
        shutil.copy(HERE / name, out / ("_static" if name.endswith(".css") else "") / name)
    scenes = gallery.Gallery(root, out, work / "solved", program)
    pages = tree.Tree(root, out, scenes.places())
    pages.pages = notebooks.found_in(root)
    pages.add_pages(pages_of_tree(root))
    pages.write("reference/scene.md", keys.page(program))
    pages.write("reference/laws.md", keys.laws_page(program))
    pages.write("reference/solvers.md", keys.solvers_page(program))
    if offline.is_file():
        pages.write("try.md", TRY)
    else:
        step(f"no {offline.name} (scripts/offline_page makes it): the site is without \"Try it\"")
    pages.write("notebooks/index.md", notebooks.index(notebooks.write(root, out, pages)))
    step("pages of the tree")
    headers, names = api.Reference(root, out, work / "doxygen").write()
    step(f"C++ reference: {names} names of {headers} headers")
    step(f"gallery: {scenes.write()} scenes")
    add_contents(out)


begun = [time.monotonic()]


def step(words):
    now = time.monotonic()
    print(f"site: {words} ({now - begun[0]:.1f} s)", flush=True)
    begun[0] = now


def run_sphinx(out, html, version):
    shutil.rmtree(html, ignore_errors=True)
    command = [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-E", "-d", str(html.parent / "doctrees"), "-b", "html",
               str(out), str(html)]
    subprocess.run(command, check=True, env=dict(os.environ, CAMOPT_VERSION=version))
    step("HTML")


def main():
    root, program, work, offline = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    words = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    write_pages(root, program, work / "pages", work, offline)
    run_sphinx(work / "pages", work / "html", re.search(r"\d+(\.\d+)+", words).group())
    if offline.is_file():
        shutil.copy(offline, work / "html/camopt.html")
    status = subprocess.run([sys.executable, "-B", HERE / "dead_links.py", work / "html"]).returncode
    step("links")
    if status == 0:
        print(f"site: {work / 'html/index.html'}")
    sys.exit(status)


if __name__ == "__main__":
    main()
