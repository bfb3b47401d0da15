"""Why points were lost, question by question, for the class report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from kinegrade.grading.wording import Wording
from kinegrade.language.catalogue import Catalogue
from kinegrade.press.class_charts import Bar
from kinegrade.press.class_sheet import LossLine, QuestionLosses
from kinegrade.reports.classes.tally import ClassTally
from kinegrade.reports.classes.words import describe_reason, find_symbol, name_question

_LAST = ("unexplained", "wrong unit", "unreadable", "blank")  # the least informative reasons


def list_losses(
    counts: ClassTally, wording: Wording, catalogue: Catalogue
) -> Iterator[QuestionLosses]:
    """For each question the reasons why points were lost, the most frequent first."""
    found = _by_question(counts)
    most = max((max(reasons.values()) for reasons in found.values() if reasons), default=1)
    for question, reasons in found.items():
        columns = [column for column in counts.columns if column.split(".")[0] == question]
        rows = tuple(
            LossLine(
                catalogue.write(describe_reason(reason, wording)),
                count,
                Bar(count / most, "faint" if reason in _LAST else "column", str(count)),
                tuple(
                    (find_symbol(column, wording), counts.losses[column][reason])
                    for column in columns
                    if counts.losses[column][reason]
                ),
            )
            for reason, count in sorted(reasons.items(), key=_rank)
        )
        if rows:
            title = wording.titles.get(question, "")
            yield QuestionLosses(name_question(question, catalogue), title, rows)


def _rank(reason: tuple[str, int]) -> tuple[bool, int, str]:
    name, count = reason
    return name in _LAST, -count, name


def _by_question(counts: ClassTally) -> Mapping[str, Counter[str]]:
    """The reasons of all asks of a question together."""
    found: dict[str, Counter[str]] = {}
    for column in counts.columns:
        found.setdefault(column.split(".")[0], Counter()).update(counts.losses[column])
    return found
