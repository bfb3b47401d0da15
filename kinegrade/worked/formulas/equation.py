"""Equations: a left side and what it is equal to, link by link, and how they fill the lines of a
display.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal, TypeAlias

from kinegrade.language.math.tree import Mark, Row, Sign
from kinegrade.language.math.width import measure_row
from kinegrade.worked.formulas.atoms import Measured
from kinegrade.worked.formulas.exactness import is_exact, is_numeric, is_rounded
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.notation import Notation
from kinegrade.worked.formulas.printed_values import find_printed_value

Relation: TypeAlias = Literal["=", r"\approx", ":"]
_SAME = 1e-9  # relative, of numbers that are not far below
_SMALL = 1e-3
WIDEST = 68  # letters that fit on a line of a display


@dataclass(frozen=True)
class Link:
    """A relation sign and what stands to the right of it."""

    relation: Relation
    right: Formula


@dataclass(frozen=True)
class Equation:
    """A left side and its links; `aside` says the sense or direction after the last one."""

    left: Formula
    links: tuple[Link, ...]
    aside: Row = ()

    def _list_printed(self, notation: Notation) -> tuple[Link, ...]:
        """The links that are told, with the sign of about before a rounded figure to which the
        numbers before it, as they are printed, do not amount. An exact one stands after the sign of
        equality, as numbers stand for all their digits where they are put in.
        """
        told = self._list_told()
        before = (self.left, *(link.right for link in told))
        return tuple(
            replace(link, relation=r"\approx") if _is_missed(numbers, link, notation) else link
            for numbers, link in zip(before, told, strict=False)
        )

    def _list_told(self) -> tuple[Link, ...]:
        """The links without an exact form that would stand after numbers that have been rounded."""
        links = self.links
        places = (place for place, link in enumerate(links) if is_rounded(link.right))
        first = next(places, len(links))
        return tuple(
            link for place, link in enumerate(links) if place <= first or not is_exact(link.right)
        )

    def print_inline(self, notation: Notation) -> Row:
        """The equation within a sentence."""
        return (
            *self.left.print(notation),
            *print_links(self._list_printed(notation), notation),
            *self.aside,
        )

    def print_line(self, notation: Notation) -> Row:
        """The equation on one line, which the press breaks where it must."""
        left = self.left.print(notation)
        return (*left, Mark(), *print_links(self._list_printed(notation), notation), *self.aside)

    def break_lines(self, notation: Notation) -> tuple[Row, ...]:
        """The equation on as many lines as it needs, continued below its first relation sign."""
        left, links = self.left.print(notation), self._list_printed(notation)
        lines: list[Row] = [(*left, Mark())]
        room, used = WIDEST - measure_row(left), 0.0
        for group in _list_groups(links, notation, room):
            aside = self.aside if group[-1] is links[-1] else ()
            row = (*print_links(group, notation), *aside)
            width = measure_row(row)
            if used and used + width > room:
                lines.append((Mark(),))
                used = 0.0
            lines[-1] += row
            used += width
        return tuple(lines)


def _is_missed(numbers: Formula, link: Link, notation: Notation) -> bool:
    """Whether a sign of equality would join numbers to a rounded one that, as they are printed,
    differs from them.
    """
    if link.relation != "=" or not (is_numeric(numbers) and is_numeric(link.right)):
        return False
    if not is_rounded(link.right):
        return False
    if _find_unit(numbers) != _find_unit(link.right) and numbers.is_decimal:
        return False  # the same in another unit
    worked, stated = (find_printed_value(one, notation) for one in (numbers, link.right))
    return abs(worked - stated) > _SAME * max(abs(worked), _SMALL)


def _find_unit(figure: Formula) -> str:
    return figure.size.unit if isinstance(figure.size, Measured) else ""


def _list_groups(
    links: tuple[Link, ...], notation: Notation, room: float
) -> Iterator[tuple[Link, ...]]:
    """What stays on one line: each link, and a rounded value with the exact one before it where
    both have room.
    """
    starts = [place for place, link in enumerate(links) if not place or link.relation != r"\approx"]
    for start, end in zip(starts, (*starts[1:], len(links)), strict=True):
        group = links[start:end]
        if measure_row(print_links(group, notation)) <= room:
            yield group
        else:
            yield from ((link,) for link in group)


def print_links(links: tuple[Link, ...], notation: Notation) -> Row:
    """The right sides of an equation, each after its relation sign."""
    return tuple(
        node for link in links for node in (Sign(link.relation), *link.right.print(notation))
    )


def equate(*formulas: Formula) -> tuple[Link, ...]:
    """= first = second ..."""
    return tuple(Link("=", formula) for formula in formulas)


def approximate(formula: Formula) -> tuple[Link, ...]:
    """Approximately a formula."""
    return (Link(r"\approx", formula),)


def lead_to(
    left: Formula, working: tuple[Formula, ...], value: tuple[Link, ...]
) -> tuple[Link, ...]:
    """Formulas in symbols and in numbers and then a value, without what says nothing: a formula
    said before, a number that the value rounds again.
    """
    said = dict.fromkeys(working)
    telling = (formula for formula in said if formula != left and not formula.is_decimal)
    return (*equate(*telling), *value)


def drop_repetition(working: tuple[Link, ...], value: tuple[Link, ...]) -> tuple[Link, ...]:
    """All links; the last of the working is dropped where it is the value, or a decimal of it."""
    said = working and (working[-1].right.is_decimal or working[-1].right == value[0].right)
    return (working[:-1] if said else working) + value
