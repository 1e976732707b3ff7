# SPDX-License-Identifier: MIT
"""Scenes in Python: the keys, units and messages of a scene file."""

from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Mapping
from typing import Any

from . import _camopt
from ._names import dotted
from ._rules import OwnLimit, OwnTerm
from ._toml import document_text, value_text

_PART = re.compile(r"([^.\[\]]+)((?:\[\d+\])*)")


class Scene:
    """What must move, with what cam, how good, found how.

    A scene is always a valid one: what cannot stand raises InputError with the words of the scene file's reader, and
    the scene stays as it was. Keys that only go together are set together, by update().

        scene = Scene(lift_mm=10, rise_deg=120, weights=dict(v=.4, a=.4, j=.2))
        scene["limits.velocity"] = 1.7

    Keywords are keys of [motion], [spline] and [solver]; the tables are dicts: limits=dict(velocity_mm_s=300). weights
    is [objective], in which v, a and j may stand for velocity, acceleration and jerk. The type of motion is "DRD" where
    nothing else is said. docs/scene_file.md lists all keys. terms and own_limits are lists of camopt.term() and
    camopt.limit(): functions of Python, in addition to the keys and in no file.
    """

    __slots__ = ("_read", "terms", "own_limits")
    terms: tuple[OwnTerm, ...]  # replaced by update(terms=…)
    own_limits: tuple[OwnLimit, ...]
    __hash__ = None  # it can change

    def __init__(self, **keys: Any) -> None:
        terms, limits = tuple(keys.pop("terms", ())), tuple(keys.pop("own_limits", ()))
        given = dict(dotted(keys))
        given.setdefault("motion.type", "DRD")
        self._set("", "scene", _settings(given), terms, limits)

    def _set(self, text: str, source: str, settings: list[str], terms: tuple[OwnTerm, ...],
             limits: tuple[OwnLimit, ...]) -> None:
        alone = bool(terms) and _weighs_nothing(_camopt.settled_text(text, source, settings))
        self._read = _camopt.ReadScene(text, source, settings, list(terms), list(limits), alone)
        self.terms, self.own_limits = terms, limits

    @classmethod
    def from_toml(cls, text: str, source: str = "scene") -> Scene:
        """The scene of a TOML text. Messages about it begin "SOURCE:LINE:COLUMN: "."""
        return cls._of(text, source, [], (), ())

    @classmethod
    def from_file(cls, path: str | os.PathLike[str]) -> Scene:
        """The scene of a file."""
        return cls.from_toml(_camopt.read_text(os.fspath(path)), os.fspath(path))

    @classmethod
    def _of(cls, *parts: Any) -> Scene:
        scene = cls.__new__(cls)
        scene._set(*parts)
        return scene

    def to_toml(self) -> str:
        """One TOML text that reads back as the same scene, bit for bit, but for terms and own_limits: the text given,
        with its comments, where nothing was set since."""
        return self._read.toml()

    def to_dict(self) -> dict[str, Any]:
        """The keys given, as nested dicts, without defaults."""
        return tomllib.loads(self.to_toml())

    def copy(self) -> Scene:
        """Another scene with the same keys."""
        return self._of(*self._parts())

    def _parts(self) -> tuple[Any, ...]:
        return self._read.text, self._read.source, self._read.settings, self.terms, self.own_limits

    def update(self, keys: Mapping[str, Any] | None = None, /, **more: Any) -> None:
        """Sets several keys at once: dotted ones in a dict, keywords as Scene() takes them. None takes a key out.

        A key replaces every other spelling of its quantity: lift_in the lift in mm.
        """
        every = {**(keys or {}), **more}
        text, source, settings, terms, limits = self._parts()
        terms, limits = tuple(every.pop("terms", terms)), tuple(every.pop("own_limits", limits))
        given = dict(dotted(every))
        dropped = [key for key, value in given.items() if value is None]
        if dropped:
            text, settings = self._text_without(dropped), []
        settings = settings + _settings({key: value for key, value in given.items() if value is not None})
        self._set(text, source, settings, terms, limits)

    def _text_without(self, keys: list[str]) -> str:
        document = self.to_dict()
        for key in keys:
            table, last = _walk(document, key)
            del table[last]
        return document_text(document)

    def __getitem__(self, key: str) -> Any:
        """A key as it was given, in its own unit; a table is a dict. Raises KeyError for a key that was not given."""
        table, last = _walk(self.to_dict(), key)
        return table[last]

    def __setitem__(self, key: str, value: Any) -> None:
        self.update({key: value})

    def __delitem__(self, key: str) -> None:
        self.update({key: None})

    def __contains__(self, key: object) -> bool:
        try:
            self[str(key)]
        except KeyError:
            return False
        return True

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, Scene) and self.to_dict() == other.to_dict() and self.terms == other.terms
                and self.own_limits == other.own_limits)

    def __repr__(self) -> str:
        tables = {name: value for name, value in self.to_dict().items() if isinstance(value, dict)}
        given = ", ".join(f"{name}.{key}" for name, table in tables.items() for key in table)
        return f"<camopt scene {self._read.source}: {given}>"

    def __reduce__(self) -> Any:
        return _unpickled, self._parts()


def _unpickled(*parts: Any) -> Scene:
    return Scene._of(*parts)


def _weighs_nothing(toml: str) -> bool:
    """No built-in term of the objective has a weight: only user-defined terms count."""
    weights = tomllib.loads(toml).get("objective", {})
    return not any(value != 0 for value in weights.values() if isinstance(value, (int, float)))


def _settings(keys: Mapping[str, Any]) -> list[str]:
    return [f"{key}={value_text(key, value)}" for key, value in keys.items()]


def _walk(document: Any, key: str) -> tuple[Any, Any]:
    """The table and the last step of a dotted key: "motion.segments[1].to" is (…["segments"][1], "to")."""
    steps: list[Any] = []
    for part in key.split("."):
        match = _PART.fullmatch(part)
        if not match:
            raise KeyError(key)
        steps += [match[1], *(int(number) for number in re.findall(r"\d+", match[2]))]
    for step in steps[:-1]:
        document = _step(document, step, key)
    _step(document, steps[-1], key)
    return document, steps[-1]


def _step(document: Any, step: Any, key: str) -> Any:
    try:
        return document[step]
    except (KeyError, IndexError, TypeError):
        raise KeyError(f"{key} is not given in this scene") from None
