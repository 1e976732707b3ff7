# SPDX-License-Identifier: MIT
"""site_test.py: the parts of docs/site that need no package: links are rewritten as the site lays its pages out, dead ones are found."""

import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))

import api  # noqa: E402
import build  # noqa: E402
import dead_links  # noqa: E402
import tree  # noqa: E402


class Links(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def faults(self, body):
        (self.path / "page.html").write_text(f"<html><body>{body}</body></html>")
        (self.path / "other.html").write_text('<h2 id="here">Here</h2>')
        dead_links.page_at.cache_clear()
        return list(dead_links.faults_in(self.path))

    def test_what_is_there(self):
        self.assertEqual(self.faults('<p id="a"><a href="#a">a</a><a href="other.html#here">b</a><a href="https://example.org">c</a>'), [])

    def test_what_is_not(self):
        for body, words in [('<a href="absent.html">', "no file"), ('<a href="other.html#there">', "no such anchor"),
                            ('<a href="#b">', "no such anchor"), ('<img src="absent.svg">', "no file"),
                            ('<script src="https://example.org/a.js"></script>', "without a network")]:
            with self.subTest(body):
                self.assertIn(words, "; ".join(self.faults(body)))


class Pages(unittest.TestCase):
    def test_links_to_files_of_the_tree_lead_to_pages(self):
        with tempfile.TemporaryDirectory() as folder:
            pages = tree.Tree(ROOT, pathlib.Path(folder), {"scenes/drd_cubic_12.toml": "gallery/drd_cubic_12.md"})
            pages.pages = {"README.md": "index.md", "docs/cams.md": "docs/cams.md"}
            self.assertEqual(pages.target("docs/cams.md", "../README.md"), "../index.md")
            self.assertEqual(pages.target("README.md", "docs/cams.md#inverse-cams"), "docs/cams.md#inverse-cams")
            self.assertEqual(pages.target("docs/cams.md", "../scenes/drd_cubic_12.toml"), "../gallery/drd_cubic_12.md")
            self.assertEqual(pages.target("docs/cams.md", "../LICENSE"), "../source/LICENSE.md")
            self.assertTrue((pathlib.Path(folder) / "source/LICENSE.md").exists())
            self.assertEqual(pages.target("docs/cams.md", "https://example.org"), "https://example.org")

    def test_a_table_without_title_gets_one(self):
        self.assertEqual(tree.with_title("a/stability.md", "### one\n"), "# Stability\n\n## one\n")
        self.assertEqual(tree.with_title("a/b.md", "# Title\n"), "# Title\n")


class Menu(unittest.TestCase):
    """Pages of the tree, laid out as on the site, without what programs write (reference, gallery, notebooks)."""

    MADE = ("try", "reference/", "gallery/", "notebooks/", "api/")

    def written(self, folder, *more):
        out = pathlib.Path(folder)
        for page in [*build.pages_of_tree(ROOT), *more]:
            path = out / ("index.md" if page == "README.md" else page)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("# Page\n")
        return out

    def test_has_every_page_once(self):
        with tempfile.TemporaryDirectory() as folder:
            pages = [page for _, pages in build.sections(self.written(folder)) for page in pages]
        self.assertEqual(len(pages), len(set(pages)))
        self.assertEqual(pages[0], "docs/install")
        self.assertEqual(len(pages), len(build.pages_of_tree(ROOT)) - 1)

    def test_refuses_a_page_that_is_in_no_section(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(SystemExit, "lacks docs/forgotten"):
            build.sections(self.written(folder, "docs/forgotten.md"))

    def test_names_no_page_that_is_gone(self):
        with tempfile.TemporaryDirectory() as folder:
            out = self.written(folder)
            gone = [name for _, names in build.SECTIONS for name in names if not name.startswith(self.MADE)
                    and not (out / f"{name}.md").exists() and not (out / f"docs/{name}.md").exists()]
        self.assertEqual(gone, [])


class Declarations(unittest.TestCase):
    LINES = ["/// y = a*b, |x| < 1:", "///     y_k = Σ a_i", "class Thing {", " public:", "    int open();", " private:",
             "    int closed_;", "};", "int after();"]

    def test_what_is_private_is_left_out(self):
        first, body = api.declaration(self.LINES, api.Entity("class", "Thing", 3, 8))
        self.assertEqual(body, ["class Thing {", " public:", "    int open();", "};"])
        self.assertEqual(api.comment_above(self.LINES, first), ["y = a*b, |x| < 1:", "    y_k = Σ a_i"])

    def test_formulas_stay_as_they_are(self):
        text = api.prose(["y = a*b, |x| < 1:", "    y_k = Σ a_i"])
        self.assertIn(r"y = a\*b, \|x\| \< 1:", text)
        self.assertIn("```text\n    y_k = Σ a_i\n```", text)


unittest.main()
