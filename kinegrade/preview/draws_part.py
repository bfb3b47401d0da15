"""Other draws of the same problem: what students would get beside each other."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import assert_never

from markupsafe import Markup

from kinegrade.draws.deal import count_reasons
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.draws.examining import Examined, Reason, Refused
from kinegrade.exam.bank.blueprint import BankQuestion
from kinegrade.exam.printing.pages import draw_figure
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.language.message import Message
from kinegrade.language.prose.html import write_page_line
from kinegrade.press.html.filled_page import load_layout
from kinegrade.press.places import locate_part
from kinegrade.preview.instance import make_exam
from kinegrade.preview.subject import Subject
from kinegrade.problem.given import list_givens
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.processes.executor import split_in_parts

_SHOWN = 6
_LOOKED_AT = 60  # combinations at most: of a sound template one in ten is fit, or more
_TOGETHER = 10


@dataclass(frozen=True)
class _Draw:
    """A draw as HTML: its figure and its values."""

    picture: Markup
    givens: Markup


def write_draws(subject: Subject, language: Language) -> str:
    """The first draws that are fit for students, and what the others were refused for. Raises
    KinegradeError.
    """
    question, words = subject.question, open_catalogue(language)
    draws, refused = [], Counter[Reason]()
    for found in _examine(make_exam(question).filters[question.identifier]):
        match found:
            case Examined():
                draws.append(_show(found.solution, question, language))
            case Refused():
                refused[found.reason] += 1
            case _:
                assert_never(found)
        if len(draws) == _SHOWN:
            break
    return load_layout("preview-draws.html").render(
        draws=draws,
        refused=words.write(
            Message(
                "preview.refused",
                number=refused.total(),
                reasons=count_reasons(dict(sorted(refused.items()))),
            )
        )
        if refused
        else "",
    )


def _examine(draw_filter: DrawFilter) -> Iterator[Examined | Refused]:
    """What is found of the first combinations of a deck, in their order."""
    combinations = draw_filter.deck.first(_LOOKED_AT)
    for part in split_in_parts(combinations, _TOGETHER):
        yield from draw_filter.examine(part)


def _show(solution: Solution, question: BankQuestion, language: Language) -> _Draw:
    template, asks = question.template, tuple(ask.name for ask in question.asks)
    figure = draw_figure(
        template, solution.assembly.mechanism.map(float), mark_question(template, asks)
    )
    values = ", ".join(map(str, list_givens(template, solution.parameters).values()))
    return _Draw(
        Markup("" if figure is None else to_svg(figure)),
        Markup(
            write_page_line(
                write_decimals_of_prose(values, language), locate_part(template.name, "givens")
            )
        ),
    )
