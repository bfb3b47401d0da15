"""The key as data: one line of key.jsonl for each paper, by which marks are decided."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from kinegrade.exam.key_mistakes import Mistaken
from kinegrade.exam.setting import SetAsk, SetPaper, SetQuestion
from kinegrade.problem.tolerance import Tolerance

NOTHING_KNOWN: Mapping[str, Mistaken] = MappingProxyType({})


def key_record(
    paper: SetPaper, mistakes: Mapping[str, Mistaken] = NOTHING_KNOWN, *, shuffled: bool = False
) -> dict[str, Any]:
    """One line of key.jsonl; the questions stand in the bank's order, `printed` tells the paper's.

    `mistakes` holds for each question what known mistakes lead to.
    """
    return {
        "student": paper.student.student,
        "paper": paper.code,
        **({"version": paper.version} if paper.version else {}),
        **(
            {"printed": [question.question.identifier for question in paper.printed]}
            if shuffled
            else {}
        ),
        "questions": [
            question_record(question, mistakes.get(question.question.identifier, {}))
            for question in paper.questions
        ],
    }


def question_record(question: SetQuestion, mistakes: Mistaken) -> dict[str, Any]:
    """One question of a key line: what was drawn, what is right within which tolerance, what
    mistakes lead to.
    """
    parameters = {
        name: quantity.record() for name, quantity in question.drawn.solution.parameters.items()
    }
    for record in parameters.values():
        del record["decimal"]
    return {
        "question": question.question.identifier,
        "template": question.question.template.name,
        "parameters": parameters,
        "asks": {
            entry.ask.name: ask_record(entry, mistakes.get(entry.ask.name, {}))
            for entry in question.asks
        },
    }


def ask_record(entry: SetAsk, mistakes: Mapping[str, str]) -> dict[str, Any]:
    """One ask of a key line; `decimal` has 40 correct digits, by which marks are decided."""
    turn = {"period": entry.answer.full_turn} if entry.cyclic else {}
    return {
        **entry.answer.record(),
        "tolerance": tolerance_record(entry.tolerance),
        **turn,
        "points": amount(entry.ask.points),
        **({"mistakes": dict(mistakes)} if mistakes else {}),
    }


def tolerance_record(tolerance: Tolerance) -> dict[str, Any]:
    """Right within max(relative*|exact value|, absolute), or what rounds to the same `figures`
    significant figures.
    """
    return {
        "relative": amount(tolerance.relative),
        "absolute": amount(tolerance.absolute),
        **({"figures": tolerance.figures} if tolerance.figures else {}),
    }


def amount(number: Any) -> int | float:
    """A decimal of few digits as JSON writes it; whole numbers without a point."""
    return int(number) if number == int(number) else float(number)
