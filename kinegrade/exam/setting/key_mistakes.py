"""What known mistakes lead to in drawn papers, for the key: many papers at once."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from math import isclose, isfinite
from typing import Any

from kinegrade.exam.setting.setting import SetAsk, SetPaper, SetQuestion
from kinegrade.mechanics.plan import Plan
from kinegrade.students.comparison import collect_columns
from kinegrade.students.mistaking.mistakes import find_known_mistakes

# Significant digits kept of a mistaken value: far more than an answer has, fewer than doubles agree
# to
WRONG_DIGITS = 9
# For each ask the identifiers of mistakes with the value they lead to
Mistaken = Mapping[str, Mapping[str, str]]


def find_mistaken_answers(papers: Sequence[SetPaper]) -> Iterator[dict[str, Mistaken]]:
    """For each paper and question the values, as decimals in the asks' units; mistakes that change
    nothing are left out.
    """
    by_question: dict[str, list[SetQuestion]] = defaultdict(list)
    for question in chain.from_iterable(paper.questions for paper in papers):
        by_question[question.question.identifier].append(question)
    found = {name: iter(_find_class_mistakes(each)) for name, each in by_question.items()}
    for paper in papers:
        names = (question.question.identifier for question in paper.questions)
        yield {name: next(found[name]) for name in names}


def _find_class_mistakes(questions: Sequence[SetQuestion]) -> list[Mistaken]:
    """The values for one question as several students have it: those solved by the same plan are
    worked out together, so that the values do not depend on which papers are asked for together.
    """
    by_plan: dict[Plan, list[int]] = defaultdict(list)
    for number, question in enumerate(questions):
        by_plan[question.drawn.solution.motion.plan].append(number)
    found: dict[int, Mistaken] = {}
    for plan, numbers in by_plan.items():
        alike = [questions[number] for number in numbers]
        found.update(zip(numbers, _find_mistakes_by(plan, alike), strict=True))
    return [found[number] for number in range(len(questions))]


def _find_mistakes_by(plan: Plan, questions: Sequence[SetQuestion]) -> Iterator[Mistaken]:
    """The values for one question, as a plan leads to them."""
    first = questions[0]
    template = first.question.template
    asks = {entry.ask.name: template.asks[entry.ask.name] for entry in first.asks}
    values = collect_columns([question.drawn.values for question in questions])
    known = find_known_mistakes(template, asks, values, plan)
    for number, question in enumerate(questions):
        yield {
            entry.ask.name: _select_mistakes(entry, known[entry.ask.name], number)
            for entry in question.asks
        }


def _select_mistakes(entry: SetAsk, known: Mapping[str, Any], number: int) -> dict[str, str]:
    """The mistakes that change an answer, with their values."""
    right = entry.answer.value
    values = {name: float(array[number]) for name, array in known.items()}
    return {
        name: f"{value:.{WRONG_DIGITS}g}"
        for name, value in values.items()
        if isfinite(value) and not isclose(value, right, rel_tol=1e-9, abs_tol=1e-12)
    }
