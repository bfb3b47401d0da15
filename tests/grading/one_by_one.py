"""Marking as its rule is stated: each answer read and decided exactly; blocks are held against
it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from itertools import groupby
from math import nan

import numpy as np

from kinegrade.exam.folder.key.exact_keys import ListedKeys
from kinegrade.exam.folder.papers import Paper
from kinegrade.exam.keyed_exam import Examinee, KeyedExam
from kinegrade.files.cell_text import is_answered
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.judging.decision import Decision, decide, void
from kinegrade.grading.judging.follow import Decided, Follows, follow_answers, withhold
from kinegrade.grading.marks import Mark
from kinegrade.grading.policy.accepted import Alternatives
from kinegrade.grading.policy.policy import Policy
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.sheet import Sheet
from kinegrade.grading.typed.answers import read
from kinegrade.grading.typed.decimal_style import FileStyle, find_file_style


def marks_one_by_one(
    exam: KeyedExam,
    sheet: Sheet,
    policy: Policy,
    accepted: Alternatives = {},  # noqa: B006 - never changed
    follows: Follows | None = None,
) -> list[Mark]:
    """All marks of a class."""
    styles = find_file_style(entries[-1].responses for entries in sheet.entries.values())
    marks = []
    for examinee in exam.examinees:
        rows = [
            _row(exam, examinee, entry, policy, accepted=accepted, styles=styles, follows=follows)
            for entry in sheet.entries[examinee.student]
        ]
        if policy.attempts == "best":
            marks += max(reversed(rows), key=lambda row: sum(mark.points for mark in row))
        else:
            marks += rows[0 if policy.attempts == "first" else -1]
    return marks


def _row(
    exam: KeyedExam,
    examinee: Examinee,
    entry: Entry,
    policy: Policy,
    *,
    accepted: Alternatives,
    styles: FileStyle,
    follows: Follows | None,
) -> Sequence[Mark]:
    style, decided = styles.of_row(entry.responses), []
    for ask, typed in zip(exam.asks, entry.responses, strict=True):
        reader, key = (
            partial(read, unit=ask.unit, style=style, convention=ask.convention, sign=ask.sign),
            examinee.keys[ask.column],
        )
        others, ruling = (
            accepted.get((examinee.student,) * 2 + (ask.column,), ()),
            policy.ruling(ask.column),
        )
        decision = decide(reader(typed), key, ruling, others, reader)
        decided.append(Decided(ask, reader(typed), key, ruling, decision))
    better: dict[str, Decision] = {}
    if follows is not None:
        better = {
            f"{question}.{name}": decision
            for question, group in groupby(decided, lambda each: each.ask.question)
            for name, decision in follow_answers(examinee.student, list(group), follows).items()
        }
        _withhold(exam, examinee, decided, better)
    return [_mark(examinee, entry, each, better) for each in decided]


def _withhold(
    exam: KeyedExam, examinee: Examinee, decided: Sequence[Decided], better: dict[str, Decision]
) -> None:
    """Takes back what follows where the answers are those to another paper."""
    own = Paper(examinee.student, "", ListedKeys([examinee.keys[ask.column] for ask in exam.asks]))
    numbers = [
        nan if each.reading.kind != "number" else float(each.reading.value or 0) for each in decided
    ]
    wrong = [each.decision[0].kind in ("wrong", "mistake", "accepted") for each in decided]
    for question in PapersAnswered(exam).find_shared(own, np.array(numbers), np.array(wrong)):
        for place in question:
            column = exam.asks[place].column
            if column in better:
                better[column] = withhold(decided[place].decision)


def _mark(examinee: Examinee, entry: Entry, each: Decided, better: Mapping[str, Decision]) -> Mark:
    verdict, share = better.get(each.ask.column, each.decision)
    if each.ruling.void:
        verdict, share = void(
            (verdict, share), each.ruling, handed_in=any(map(is_answered, entry.responses))
        )
    now = each.ruling.ask(each.ask)
    return Mark(examinee.student, now, each.reading, verdict, share * now.points)
