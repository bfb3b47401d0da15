"""The instructor's key as LaTeX source: each paper's numbers, answers and marked intervals."""

from __future__ import annotations

from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.latex import write_latex_math
from kinegrade.language.math.latex_text import write_comment, write_plain, write_signed, write_unit
from kinegrade.language.message import Location
from kinegrade.language.prose.latex import write_line
from kinegrade.press.latex.document import (
    write_command,
    write_environment,
    write_title,
    write_value,
)
from kinegrade.press.places import locate_paper, locate_question
from kinegrade.press.sheet import KeyAnswer, KeyBook, KeyEntry, KeyPaper, KeyParameter
from kinegrade.question_numbers import find_bank_number


def write_key_body(book: KeyBook) -> str:
    """The whole key; raises TypesetError with all faults of its texts."""
    words = open_catalogue(book.language)
    head = write_command("keyhead", *map(write_plain, (book.course, book.title, book.warning)))
    papers = convert_each(lambda paper: _write_paper(paper, words), book.papers)
    return "\n".join((write_title(book.title), head, *papers)) + "\n"


def _write_paper(paper: KeyPaper, words: Catalogue) -> str:
    where = locate_paper(paper.code)
    entries = convert_each(
        lambda entry: _write_entry(entry, locate_question(where, entry.identifier), words),
        paper.entries,
    )
    head = write_command("keypaper", *map(write_plain, (paper.name, paper.student, paper.code)))
    return "\n".join((write_comment(words.write(where)), head, *entries))


def _write_entry(entry: KeyEntry, where: Location, words: Catalogue) -> str:
    parts = gather(
        title=lambda: write_line(entry.title, where),
        parameters=lambda: convert_each(
            lambda parameter: _write_parameter(parameter, where), entry.parameters
        ),
        answers=lambda: convert_each(lambda answer: _write_answer(answer, where), entry.answers),
    )
    given = rf"\wordgiven{', '.join(parts['parameters'])}" if entry.parameters else ""
    head = write_command(
        "keyquestion", write_plain(find_bank_number(entry.identifier)), parts["title"], given
    )
    note = write_command("keynote", write_plain(entry.note))
    below = note if entry.note else write_environment("keyanswers", parts["answers"])
    together = write_environment("together", [head, below])
    return f"{write_comment(words.write(where))}\n{together}"


def _write_parameter(parameter: KeyParameter, where: Location) -> str:
    """`r = 1/5 = 0.2 m`; the decimal is not repeated where the exact value is written the same
    way.
    """
    equation = write_latex_math(parameter.symbol, where)
    if parameter.exact:
        equation += f" = {write_latex_math(parameter.exact, where)}"
    return rf"\mbox{{${equation} = {{}}${write_value(parameter.decimal, parameter.unit)}}}"


def _write_answer(answer: KeyAnswer, where: Location) -> str:
    exact = "–" if answer.exact is None else f"${write_latex_math(answer.exact, where)}$"
    return write_command(
        "keyanswer",
        f"${write_latex_math(answer.symbol, where)}$",
        exact,
        write_signed(answer.decimal),
        write_unit(answer.unit),
        write_signed(answer.interval),
        answer.points,
    )
