"""The languages in which exams are set, told and marked: every text of the package has one form in
each of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal, get_args

from kinegrade.errors import ExamError, one_line

Language = Literal["en", "zh"]
LANGUAGES: tuple[Language, ...] = get_args(Language)


def exam_language_of(head: Mapping[str, Any], path: Path) -> Language:
    """The language that the head of an exam folder, read from `path`, says its papers are in.

    Raises ExamError for one that this version does not know, and where none is said.
    """
    said = head.get("language")
    for language in LANGUAGES:
        if said == language:
            return language
    found = f'"{one_line(str(said))}"' if "language" in head else "no language"
    raise ExamError(
        f"{path}: language: {found} - expected one of {', '.join(LANGUAGES)} - "
        "restore the exam folder, or use the version of kinegrade that made it"
    )
