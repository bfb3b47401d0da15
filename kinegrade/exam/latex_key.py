"""The instructor's key as LaTeX source: each paper's numbers, answers and marked intervals."""

from __future__ import annotations

from kinegrade.exam.document import KeyAnswer, KeyBook, KeyEntry, KeyPaper, KeyParameter
from kinegrade.exam.latex_markup import line
from kinegrade.exam.latex_math import math
from kinegrade.exam.latex_source import Block, command, environment
from kinegrade.exam.latex_text import comment, plain, signed, unit
from kinegrade.exam.layout_call import each, gathered
from kinegrade.exam.typst_source import points_text
from kinegrade.question_numbers import bank_number


class KeyAnswers(Block):
    """The table of right answers and of what is marked right."""


class Together(Block):
    """What stays on one page."""


def key_body(book: KeyBook) -> str:
    """The whole key; raises TypesetError with all faults of its texts."""
    head = command("keyhead", *map(plain, (book.course, book.title, book.warning)))
    papers = each(_paper, book.papers)
    return "\n".join((head, *papers)) + "\n"


def _paper(paper: KeyPaper) -> str:
    where = f"paper {paper.code}"
    entries = each(lambda entry: _entry(entry, f"{where}, {entry.identifier}"), paper.entries)
    head = command("keypaper", *map(plain, (paper.name, paper.student, paper.code)))
    return "\n".join((comment(where), head, *entries))


def _entry(entry: KeyEntry, where: str) -> str:
    parts = gathered(
        title=lambda: line(entry.title, where),
        parameters=lambda: each(lambda parameter: _parameter(parameter, where), entry.parameters),
        answers=lambda: each(lambda answer: _answer(answer, where), entry.answers),
    )
    given = rf"\wordgiven{', '.join(parts['parameters'])}" if entry.parameters else ""
    head = command("keyquestion", plain(bank_number(entry.identifier)), parts["title"], given)
    table = environment(KeyAnswers(), parts["answers"])
    return f"{comment(where)}\n{environment(Together(), [head, table])}"


def _parameter(parameter: KeyParameter, where: str) -> str:
    """`r = 1/5 = 0.2 m`; the decimal is not repeated where the exact value is written the same
    way.
    """
    equation = math(parameter.symbol, where)
    if parameter.exact is not None and parameter.exact != parameter.decimal:
        equation += f" = {math(parameter.exact, where)}"
    shown = "" if parameter.unit == "1" else unit(parameter.unit)
    space = "" if shown in ("", "°") else r"\,"
    return rf"\mbox{{${equation} = {{}}${signed(parameter.decimal)}{space}{shown}}}"


def _answer(answer: KeyAnswer, where: str) -> str:
    exact = "–" if answer.exact is None else f"${math(answer.exact, where)}$"
    return command(
        "keyanswer",
        f"${math(answer.symbol, where)}$",
        exact,
        signed(answer.decimal),
        unit(answer.unit),
        signed(answer.interval),
        points_text(answer.points),
    )
