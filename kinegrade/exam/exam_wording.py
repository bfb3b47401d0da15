"""What an exam's questions, asks and drawn numbers are called, from the templates that its folder
keeps.

Reports and feedback show it (`kinegrade.grading.wording` says what they want). A template that this
version cannot read any more costs its words only: identifiers stand in their place.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from kinegrade.errors import ExamError, KinegradeError
from kinegrade.language import Language, exam_language_of
from kinegrade.problem.library import kept_template
from kinegrade.problem.mistake_kinds import sentences
from kinegrade.problem.template import Template


@dataclass(frozen=True)
class ExamWording:
    """Titles by question and meanings by answer column (prose), symbols (math), sentences of
    mistakes (plain).
    """

    titles: Mapping[str, str] = field(default_factory=dict)
    meanings: Mapping[str, str] = field(default_factory=dict)
    symbols: Mapping[str, str] = field(default_factory=dict)
    parameters: Mapping[tuple[str, str], str] = field(default_factory=dict)
    mistakes: Mapping[str, str] = field(default_factory=dict)


def exam_wording(exam: Path, language: Language) -> ExamWording:
    """The words of an exam folder in a language. Raises ExamError where exam.json cannot be
    read.
    """
    templates = _templates(exam)
    asks = {
        f"{question}.{name}": ask
        for question, template in templates.items()
        for name, ask in template.asks.items()
    }
    return ExamWording(
        {
            question: template.title.in_language(language)
            for question, template in templates.items()
        },
        {column: ask.means.in_language(language) for column, ask in asks.items()},
        {column: ask.symbol for column, ask in asks.items()},
        {
            (question, name): parameter.symbol
            for question, template in templates.items()
            for name, parameter in template.parameters.items()
        },
        {identifier: sentence[language] for identifier, sentence in sentences().items()},
    )


def exam_language(exam: Path) -> Language:
    """The language of an exam's papers. Raises ExamError where exam.json cannot be read or knows
    another one.
    """
    path = exam / "exam.json"
    return exam_language_of(_head(path), path)


def _templates(exam: Path) -> dict[str, Template]:
    """The templates by question, those that can be read."""
    found: dict[str, Template] = {}
    for question in _head(exam / "exam.json")["questions"]:
        try:
            found[str(question["question"])] = kept_template(
                str(question["template"]), exam / "templates"
            )
        except (KinegradeError, KeyError, TypeError):
            continue
    return found


def _head(path: Path) -> dict[str, Any]:
    try:
        head: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        list(head["questions"])
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as fault:
        raise ExamError(
            f"{path}: cannot be read ({type(fault).__name__}) - expected an exam folder made by "
            "kinegrade generate - check the name"
        ) from fault
    return head
