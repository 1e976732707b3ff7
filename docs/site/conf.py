# SPDX-License-Identifier: MIT
"""Sphinx's settings for the documentation site; scripts/site calls it."""

import os
import pathlib
import re

import furo

project = "camopt"
author = "The camopt authors"
version = release = os.environ.get("CAMOPT_VERSION", "")
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "index"
exclude_patterns = []
nitpicky = True
myst_heading_anchors = 4
myst_enable_extensions = []
language = "en"
today_fmt = "%Y-%m-%d"

html_theme = "furo"
html_title = f"camopt {version}"
html_static_path = ["_static"]
html_css_files = ["camopt.css"]
html_show_sourcelink = False
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_last_updated_fmt = None
# A page of the tree is the source of each page here; blocks of the program's output have no language.
highlight_language = "text"
pygments_style = "default"
pygments_dark_style = "github-dark"
smartquotes = False


def dark_colors():
    """Debian's furo.css has its dark colours only behind the switch on the page; given as options they follow the system too."""
    styles = pathlib.Path(furo.__file__).parent / "theme/furo/static/styles/furo.css"
    block = re.search(r'body\[data-theme="?dark"?\] *\{(.*?)\}', styles.read_text(encoding="utf-8"), re.S)
    return {name: value.strip() for name, value in re.findall(r"--([\w-]+):([^;]+)", block.group(1))}


html_theme_options = {"dark_css_variables": dark_colors()}
