"""The students that are written: for each template its methods, mistakes and what follows on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from tests.by_hand.pad import Edge, Method, Mistake

STUDENTS = Path(__file__).parent / "students"


@dataclass(frozen=True)
class Taught:
    """What students of one template do.

    `methods` are textbook methods by name, each with every value written on a pad; `mistakes` are
    students who make one classical mistake, by its identifier; `follows` says which asks are
    worked out from which.
    """

    methods: Mapping[str, Method]
    mistakes: Mapping[str, Mistake]
    follows: tuple[Edge, ...]


def read_students() -> Mapping[str, Taught]:
    """All modules of `students/` by the name of their template."""
    return {file.stem.replace("_", "-"): _read(file.stem) for file in sorted(STUDENTS.glob("*.py"))}


def _read(name: str) -> Taught:
    module = import_module(f"tests.by_hand.students.{name}")
    return Taught(module.METHODS, module.MISTAKES, tuple(Edge(*edge) for edge in module.FOLLOWS))


TAUGHT = read_students()
