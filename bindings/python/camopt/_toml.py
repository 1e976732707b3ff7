# SPDX-License-Identifier: MIT
"""Values of Python as TOML: what a scene file would say. Reading is the library's part, and tomllib's."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from ._camopt import InputError


def value_text(key: str, value: Any) -> str:
    """A value in TOML on one line; numbers in the fewest digits that read back as the same double."""
    if hasattr(value, "tolist"):  # arrays and numbers of NumPy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_key(name)} = {value_text(key, one)}" for name, one in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(value_text(key, one) for one in value) + "]"
    raise InputError(f"{key}: found a {type(value).__name__}; allowed: numbers, texts, booleans, and "
                     "lists and dicts of these")


def document_text(document: Mapping[str, Any]) -> str:
    """A whole document: the tables at the top as sections, one line a key."""
    lines = [f"{_key(name)} = {value_text(name, value)}" for name, value in document.items()
             if not isinstance(value, Mapping)]
    for name, table in document.items():
        if isinstance(table, Mapping):
            lines += ["", f"[{_key(name)}]"]
            lines += [f"{_key(inner)} = {value_text(f'{name}.{inner}', value)}" for inner, value in table.items()]
    return "\n".join(lines) + "\n"


def _key(name: str) -> str:
    return name if name.replace("_", "").replace("-", "").isalnum() and name.isascii() else json.dumps(name)
