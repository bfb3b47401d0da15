r"""A worked solution as HTML with math between `\(` and `\)`, for a learning management system to
show after the quiz.

It is the text of the printed solution with its equations and tables; the pictures stay with the
printed one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import assert_never

from kinegrade.exam.equation_line import equation_line
from kinegrade.exam.quiz_prose import math_html, plain_html, prose_html, unit_html
from kinegrade.exam.solution_blocks import has_exact_decimal
from kinegrade.exam.solution_words import SolutionWords, solution_words_of
from kinegrade.language import Language
from kinegrade.problem.solving import Solution
from kinegrade.problem.template import Method
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Pictures,
    Prose,
    Result,
    Results,
    Term,
    TermTable,
)
from kinegrade.worked.solution import worked_solution

WHERE = "worked solution"


def solution_html(
    solution: Solution, asks: Sequence[str], language: Language, method: Method | None = None
) -> str:
    """The worked solution of an instance for the asks named, by the method where several serve.

    Raises TypesetError for texts that cannot be shown.
    """
    worked = worked_solution(solution, asks, language, method)
    return blocks_html(worked.blocks, language)


def blocks_html(blocks: Sequence[Block], language: Language) -> str:
    """The blocks of a worked solution one after the other; pictures are left out. Raises
    TypesetError.
    """
    words = solution_words_of(language)
    return "".join(_block(block, words) for block in blocks)


def _block(block: Block, words: SolutionWords) -> str:
    match block:
        case Heading():
            tag = "h4" if block.level == 1 else "h5"
            return f"<{tag}>{prose_html(block.text, WHERE, inline=True)}</{tag}>\n"
        case Prose():
            return prose_html(block.text, WHERE)
        case Display():
            return f"<p>{_aligned(block.lines)}</p>\n"
        case TermTable():
            return _terms(block.terms, words)
        case Results():
            items = "".join(f"<li>{_result(result)}</li>\n" for result in block.results)
            return f"<ul>\n{items}</ul>\n"
        case Pictures():
            return ""
        case _:
            assert_never(block)


def _aligned(lines: Sequence[str]) -> str:
    """Equations one below another; a long one continues on a new line before a relation sign."""
    rows = []
    for latex in lines:
        parts = equation_line(latex)
        rows += [
            f"{parts.left} &{parts.pieces[0] if parts.pieces else ''} "
            f"{' '.join(parts.pieces[1:])}".strip()
        ]
    body = r" \\ ".join(rows)
    return math_html(rf"\begin{{aligned}} {body} \end{{aligned}}", WHERE, display=True)


def _terms(terms: Sequence[Term], words: SolutionWords) -> str:
    """The vector equation over the magnitudes and directions of its terms."""
    symbols = [
        math_html(f"{term.sign}{{}} {term.symbol}".strip() if term.sign else term.symbol, WHERE)
        for term in terms
    ]
    rows = [
        ("", symbols),
        (words.magnitude, [_cell(term.magnitude) for term in terms]),
        (words.direction, [_cell(term.direction) for term in terms]),
    ]
    written = "".join(
        f'<tr><th scope="row">{plain_html(head)}</th>{"".join(map(_entry, cells))}</tr>\n'
        for head, cells in rows
    )
    return f"<table><tbody>\n{written}</tbody></table>\n"


def _cell(text: str) -> str:
    return prose_html(text, WHERE, inline=True)


def _entry(cell: str) -> str:
    return f'<td style="padding:0 .5em;text-align:center">{cell}</td>'


def _result(result: Result) -> str:
    exact = f"= {result.exact} " if result.exact not in (None, result.decimal) else ""
    relation = "=" if has_exact_decimal(result) else r"\approx"
    value = math_html(rf"{result.symbol} {exact}{relation} {result.decimal}", WHERE)
    unit = unit_html(result.unit)
    spaced = unit if unit in ("", "°") else f" {unit}"
    sense = f" ({prose_html(result.sense, WHERE, inline=True)})" if result.sense else ""
    return f"{value}{spaced}{sense}"
