"""A question of a practice sheet, from the papers on which it stands with different numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import assert_never

from kinegrade.cycles.curves import find_followed
from kinegrade.cycles.wording import say_input
from kinegrade.description.description import describe
from kinegrade.exam.setting.setting import SetQuestion
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.language import Language
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.language.prose.html import write_page_line, write_page_prose
from kinegrade.motion.path import MotionPath, Still, find_path
from kinegrade.practice.document import PracticeDraw, PracticeQuestion
from kinegrade.practice.drawn import DrawnQuestion
from kinegrade.practice.follows import FollowTable
from kinegrade.practice.keys import tabulate_keys
from kinegrade.practice.patterns import pool_texts
from kinegrade.practice.poses import PracticeMotion, write_motion
from kinegrade.practice.sections import split_sections
from kinegrade.practice.skeleton import PracticeSkeleton, make_skeleton
from kinegrade.press.html.described import write_described
from kinegrade.press.html.solution import IN_MATHML, write_blocks
from kinegrade.press.places import locate_part
from kinegrade.problem.template.template import Template
from kinegrade.worked.solution import write_worked_solution


def make_question(
    drawn: Sequence[DrawnQuestion], shares: Mapping[str, Fraction], language: Language
) -> PracticeQuestion:
    """The question with these draws; `shares` of the points are the bank's for known mistakes.
    Raises TypesetError for texts that cannot be shown.
    """
    first = drawn[0]
    template = first.question.question.template
    asks = tuple(entry.ask.name for entry in first.question.asks)
    follows = FollowTable(template, asks)
    movable = find_followed(first.question.drawn.solution)
    followed = tuple(place for place, name in enumerate(asks) if name in movable)
    pooled = pool_texts([tuple(_list_texts(each, language)) for each in drawn])
    table = tabulate_keys(drawn, follows.stages, shares)
    paths = [find_path(each.question.drawn.solution.motion) for each in drawn]
    curves = tuple(asks[place] for place in followed)
    return PracticeQuestion(
        write_page_line(first.sheet.title, locate_part(first.sheet.template, "title")),
        table.asks,
        table.rules,
        pooled.patterns,
        tuple(
            PracticeDraw(
                texts, keys, follows.write(each.question), _move(path, each.question, curves)
            )
            for texts, keys, each, path in zip(pooled.draws, table.draws, drawn, paths, strict=True)
        ),
        _find_skeleton(paths, template, language),
        followed,
    )


def _move(
    path: MotionPath | Still, question: SetQuestion, curves: tuple[str, ...]
) -> PracticeMotion | None:
    match path:
        case MotionPath():
            return write_motion(path, question.drawn.solution, curves)
        case Still():
            return None
        case _:
            assert_never(path)


def _find_skeleton(
    paths: Sequence[MotionPath | Still], template: Template, language: Language
) -> PracticeSkeleton | None:
    """What all draws that move have in common."""
    path = next((each for each in paths if isinstance(each, MotionPath)), None)
    if path is None:
        return None
    moves = say_input(path, template, language)
    unit = "°" if path.input.is_angle else "m"
    return make_skeleton(path, template, moves, unit)


def _list_texts(drawn: DrawnQuestion, language: Language) -> Iterator[str]:
    """The texts of a draw, as `PracticeDraw` lists them."""
    sheet, question = drawn.sheet, drawn.question
    statement = locate_part(sheet.template, "statement")
    described = describe(question.drawn.solution, language, [ask.ask.name for ask in question.asks])
    yield write_page_prose(sheet.statement, statement) + write_described(
        described, language, lambda text: write_page_prose(text, statement)
    )
    short = sheet.described.short if sheet.described else ""
    yield "" if sheet.figure is None else to_svg(sheet.figure, short)
    for row in sheet.rows:
        where = locate_part(sheet.template, "tolerance")
        lines = (write_decimals_of_prose(each, language) for each in row.tolerance)
        yield ", ".join(write_page_line(each, where) for each in lines)
    asks = tuple(entry.ask.name for entry in question.asks)
    blocks = write_worked_solution(question.drawn.solution, asks, language).blocks
    for section in split_sections(blocks):
        yield write_blocks(section, language, IN_MATHML)
