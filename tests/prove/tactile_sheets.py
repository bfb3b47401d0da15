"""Fingers can read the tactile sheets of every template: lines, dots and labels keep their
distances, and each part and all that is given has room on one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.tactile.labels import AxesNames, Subject
from kinegrade.figure.tactile.tactile import TactileFigure, draw_tactile
from kinegrade.language.math.braille import label_in_braille, write_braille_number
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.hints import FigureHints
from tests.figures.tactile_flaws import find_tactile_flaws
from tests.prove.draws import seeded_solution


def hold(seed: int, _: Path) -> None:
    """Draw the sheets of the instance of a seed, and measure them."""
    solution = seeded_solution(seed)
    template = solution.template
    if not template.scheme.has_mechanism:
        return
    hints = mark_question(template, template.asked())
    figure = draw_sheets(solution, hints)
    for place, sheet in enumerate(figure.sheets, start=1):
        flaws = list(find_tactile_flaws(to_svg(sheet.scene)))
        assert flaws == [], f"{template.name}, sheet {place}: {flaws}"
    assert figure.missing_parts == 0, f"{template.name}: parts without room"
    assert figure.missing == (), f"{template.name}: no room for {figure.missing[0].subject}"
    said = list(list_symbols(named.subject for sheet in figure.sheets for named in sheet.named))
    for given in (*hints.lengths, *hints.angles, *hints.radii):
        assert given.symbol in said, f"{template.name}: {given} is nowhere"


def list_symbols(subjects: Iterable[Subject]) -> Iterator[str]:
    """The symbols of labels."""
    for subject in subjects:
        if isinstance(subject, AxesNames):
            yield from (subject.x, subject.y)
        else:
            yield subject.symbol


def draw_sheets(solution: Solution, hints: FigureHints) -> TactileFigure:
    """The sheets of a solution's figure, as question 1 has them."""
    return draw_tactile(
        solution.assembly.mechanism.map(float),
        hints,
        lambda symbol: label_in_braille([symbol], "en")[symbol],
        lambda place: write_braille_number(1, place),
    )
