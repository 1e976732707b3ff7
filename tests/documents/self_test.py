# SPDX-License-Identifier: MIT
"""self_test.py CAMOPT: what documents_test.py must find is found, and what is right is not."""

import pathlib
import sys
import unittest

import blocks
import commands

ROOT = pathlib.Path(__file__).parents[2]
PROGRAM = sys.argv.pop()

PAGE = """Text. Save this as `first.toml`:

```toml
title = "a"
```

<!-- not run: takes
an hour -->
```sh
scripts/soak --seed 1   # a comment
```

  ```cpp
  int x;
  ```
"""


class Calls(unittest.TestCase):
    def test_the_demo_ends_with_the_path_of_the_readme(self):
        for page, line in (("README.md", r'export PATH="$PWD/build/release/apps:$PWD/build/release/first:$PATH"'),
                           ("scripts/demo", r'export PATH="$root/build/release/apps:$root/build/release/first:\$PATH"')):
            self.assertIn(line, (ROOT / page).read_text())

    def test_a_path_to_the_program_is_no_call(self):
        self.assertTrue(list(commands.faults_of(ROOT, PROGRAM, "build/release/apps/camopt list laws\n")))
        self.assertFalse(list(commands.faults_of(ROOT, PROGRAM, "camopt list laws\n")))


class Blocks(unittest.TestCase):
    def test_language_text_and_notes(self):
        scene, command, code = blocks.blocks_of("page.md", PAGE)
        self.assertEqual((scene.language, scene.saved_as, scene.line), ("toml", "first.toml", 3))
        self.assertEqual((command.language, command.notes), ("sh", {"not run": "takes\nan hour"}))
        self.assertEqual((code.language, code.text), ("cpp", "int x;\n"))

    def test_an_open_fence_is_refused(self):
        with self.assertRaisesRegex(ValueError, "page.md:1"):
            list(blocks.blocks_of("page.md", "```sh\ncamopt list laws\n"))


class Commands(unittest.TestCase):
    def faults(self, text):
        return list(commands.faults_of(ROOT, PROGRAM, text))

    def test_what_is_there(self):
        self.assertEqual(self.faults("camopt solve a.toml --set x=1 --out b   # words\n"
                                     "camopt sweep merge a b --out c && scripts/soak --seed 7 --motions 1\n"
                                     "cmake --preset release && cmake --build --preset release\n"
                                     "build/release/benchmarks/reproduce 000 --out paper"), [])

    def test_what_is_not(self):
        for text, words in [("camopt optimise a.toml", "no command optimise"), ("camopt solve --outt b", "no option --outt"),
                            ("camopt check a --out b", "no option --out"), ("scripts/absent", "no scripts/absent"),
                            ("scripts/soak --never", "knows no --never"), ("cmake --preset fastest", "no preset fastest"),
                            ("build/release/benchmarks/absent", "no benchmark absent"),
                            ("build/release/benchmarks/reproduce 000 --never", "knows no --never"),
                            ("no_such_program all", "no program"), ("camopt sweep merge a --resume", "no option --resume")]:
            with self.subTest(text):
                self.assertIn(words, "; ".join(self.faults(text)))


unittest.main()
