# SPDX-License-Identifier: MIT
"""Every Python block of the documentation runs as it stands, one after another."""

import contextlib
import io
import os
import re
import unittest

import program

BLOCK = re.compile(r"^```python\n(.*?)^```", re.M | re.S)


class Blocks(unittest.TestCase):
    def test_they_run(self):
        os.chdir(program.ROOT)
        for page, least in (("docs/python.md", 4), ("README.md", 1)):
            blocks = BLOCK.findall((program.ROOT / page).read_text())
            self.assertGreaterEqual(len(blocks), least, page)
            names, printed = {}, io.StringIO()
            with contextlib.redirect_stdout(printed):
                for block in blocks:
                    exec(compile(block, page, "exec"), names)
            self.assertIn("optimal", printed.getvalue())


if __name__ == "__main__":
    unittest.main(verbosity=2)
