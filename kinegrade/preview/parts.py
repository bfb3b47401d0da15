"""The parts of the page, each a piece of HTML made from the file as it is now; where a part cannot
be shown, what is wrong stands in its place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from kinegrade.errors import KinegradeError, Problem
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.html.filled_page import load_layout
from kinegrade.preview.check_part import write_check
from kinegrade.preview.draws_part import write_draws
from kinegrade.preview.motion_part import write_motion
from kinegrade.preview.problem_part import write_problem
from kinegrade.preview.solution_part import write_solution
from kinegrade.preview.subject import Subject, read_subjects
from kinegrade.preview.verdict import judge_typed

PartName = Literal["problem", "solution", "draws", "check", "motion"]

_WRITERS: Mapping[PartName, Callable[[Subject, Language], str]] = {
    "problem": write_problem,
    "solution": write_solution,
    "draws": write_draws,
    "check": write_check,
    "motion": write_motion,
}


@dataclass(frozen=True)
class Shown:
    """The problem of a file that a page shows, by its place in it, and the page's language."""

    path: Path
    place: int
    language: Language


def write_part(name: PartName, shown: Shown) -> str:
    """A part of the page; never raises for what is wrong with the file."""
    try:
        return _WRITERS[name](_choose(shown), shown.language)
    except KinegradeError as error:
        return _write_faults(error.faults, shown.language)


def write_verdict(shown: Shown, asked: str, typed: str) -> str:
    """What marking says of an answer to an ask as it was typed; as `write_part`."""
    try:
        said = judge_typed(_choose(shown), asked, typed, shown.language)
    except KinegradeError as error:
        return _write_faults(error.faults, shown.language)
    return load_layout("preview-verdict.html").render(said=said)


def list_labels(path: Path) -> tuple[str, ...]:
    """The labels of the problems of a file, none while it cannot be read."""
    try:
        return tuple(subject.label for subject in read_subjects(path))
    except KinegradeError:
        return ()


def _choose(shown: Shown) -> Subject:
    """The problem itself; the last where the file has lost some. Raises as `read_subjects`."""
    subjects = read_subjects(shown.path)
    return subjects[min(shown.place, len(subjects) - 1)]


def _write_faults(faults: Iterable[Problem], language: Language) -> str:
    words = open_catalogue(language)
    lines = [words.write(fault) for fault in faults]
    return load_layout("preview-faults.html").render(faults=lines)
