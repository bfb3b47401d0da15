"""The blocks of a worked solution with the decimal mark of its language."""

from __future__ import annotations

from dataclasses import replace
from typing import assert_never

from kinegrade.language import Language
from kinegrade.language.decimal_mark import (
    write_decimal_text,
    write_decimals_of_math,
    write_decimals_of_prose,
)
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Picture,
    Pictures,
    Prose,
    Result,
    Results,
    Term,
    TermTable,
)


def mark_decimals(block: Block, language: Language) -> Block:
    """A block whose numbers have the decimal mark of the language; they are worked out with a
    point.
    """
    match block:
        case Heading() | Prose():
            return replace(block, text=write_decimals_of_prose(block.text, language))
        case Display(lines):
            return Display(tuple(write_decimals_of_math(line, language) for line in lines))
        case TermTable(terms):
            return TermTable(tuple(_mark_term(term, language) for term in terms))
        case Pictures(pictures):
            return Pictures(tuple(_mark_picture(picture, language) for picture in pictures))
        case Results(results):
            return Results(tuple(_mark_result(result, language) for result in results))
        case _:
            assert_never(block)


def _mark_term(term: Term, language: Language) -> Term:
    return replace(
        term,
        magnitude=write_decimals_of_prose(term.magnitude, language),
        direction=write_decimals_of_prose(term.direction, language),
    )


def _mark_picture(picture: Picture, language: Language) -> Picture:
    return replace(picture, caption=write_decimals_of_prose(picture.caption, language))


def _mark_result(result: Result, language: Language) -> Result:
    exact = result.exact and write_decimals_of_math(result.exact, language)
    return replace(
        result,
        exact=exact,
        decimal=write_decimal_text(result.decimal, language),
        sense=write_decimals_of_prose(result.sense, language),
    )
