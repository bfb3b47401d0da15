"""The other assemblies of a mechanism: where circles meet in two points, with the point that the
template does not take.

They close as well, often crossed: an author is told of them, so that none is taken for the other.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from msgspec.structs import replace

from kinegrade.errors import KinegradeError
from kinegrade.expressions.tree import SIDES_OF, Call, Expression, Name
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.template import Template
from kinegrade.proof.answerable import list_values
from kinegrade.proof.report import Report

_OPPOSITES: Mapping[str, str] = {
    "right": "left",
    "upper": "lower",
    "counterclockwise": "clockwise",
    SIDES_OF["right"]: SIDES_OF["left"],
}
_OTHER = {**_OPPOSITES, **{other: one for one, other in _OPPOSITES.items()}}


@dataclass(frozen=True)
class OtherAssembly:
    """The same template with the other common point in place of the one `taken` for `point`; sides
    as templates write them.
    """

    point: str
    taken: str
    other: str
    template: Template


def find_other_assemblies(template: Template) -> Iterator[OtherAssembly]:
    """A template for each point that is one of two common points."""
    for point, tree in template.scheme.points.items():
        shapes, side = _read_meeting(tree)
        if side is not None and "circle" in map(_shape, shapes):
            other = _oppose(side)
            points = {**template.scheme.points, point: Call("meet", (*shapes, other))}
            swapped = replace(template, scheme=replace(template.scheme, points=points))
            yield OtherAssembly(point, _write_side(side), _write_side(other), swapped)


def close_otherwise(solution: Solution, other: OtherAssembly) -> Solution | None:
    """The instance put together the other way; None where it does not close."""
    try:
        return solve_template(other.template, list_values(solution), ())
    except KinegradeError:
        return None


def _read_meeting(tree: Expression) -> tuple[tuple[Expression, ...], Expression | None]:
    """The shapes that meet in a point and the side that is named; None where there is none."""
    if isinstance(tree, Call) and tree.function == "meet" and len(tree.arguments) > 2:
        *shapes, side = tree.arguments
        return tuple(shapes), side
    return (), None


def _shape(tree: Expression) -> str:
    return tree.function if isinstance(tree, Call) else ""


def _oppose(side: Expression) -> Expression:
    """The side of the other common point."""
    match side:
        case Name(name):
            return Name(_OTHER[name])
        case Call(function, arguments):
            return Call(_OTHER[function], arguments)
        case _:
            raise TypeError(f"{side} is no side")


def _write_side(side: Expression) -> str:
    match side:
        case Call(function, (Name(start), Name(end))):
            return f"{function} {start}->{end}"
        case Name(name):
            return name
        case _:
            raise TypeError(f"{side} is no side")


def note_assemblies(report: Report) -> None:
    """How else the mechanism closes in the first instances."""
    for other in find_other_assemblies(report.template):
        closed = sum(close_otherwise(each, other) is not None for each in report.examples)
        if closed:
            report.assemblies.append(
                Message(
                    "template.report-assembly",
                    point=other.point,
                    taken=Quoted(other.taken),
                    other=Quoted(other.other),
                    share=f"{closed / len(report.examples):.0%}",
                )
            )
