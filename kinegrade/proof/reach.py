"""The condition that keeps out values at which circles and lines of a construction do not meet."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kinegrade.errors import KinegradeError
from kinegrade.expressions.tree import Call, Expression, Name, Number
from kinegrade.problem.holding import condition_holds
from kinegrade.problem.template.conditions import read_condition
from kinegrade.problem.template.template import Template


def find_condition(template: Template, values: Mapping[str, str]) -> str:
    """A condition that these values do not fulfil and without which lengths do not reach; "" where
    there is none to name.
    """
    for tree in template.scheme.points.values():
        for text in _list_conditions(tree):
            try:
                if not condition_holds(template, read_condition(text), values):
                    return text
            except KinegradeError:
                break  # what it names cannot be placed either
    return ""


def _list_conditions(tree: Expression) -> Iterator[str]:
    """What holds where a circle meets another, or a line, so far as they have plain arguments."""
    match tree:
        case Call("meet", (Call("circle") as one, Call("circle") as other, *_)):
            parts = [_write(part) for part in (*one.arguments, *other.arguments)]
            if all(parts):
                centre, radius, other_centre, other_radius = parts
                distance = f"distance({centre}, {other_centre})"
                yield f"{distance} < {radius} + {other_radius}"
                yield f"abs({radius} - {other_radius}) < {distance}"
        case Call("meet", (Call("circle") as one, Call("line") as other, *_)):
            parts = [_write(part) for part in (*one.arguments, *other.arguments)]
            if all(parts):
                centre, radius, *line = parts
                yield f"distance({centre}, foot({centre}, line({', '.join(line)}))) < {radius}"
        case _:
            return  # nothing else that it could be about


def _write(tree: Expression) -> str:
    """A name or a whole number as it is written; "" for anything else."""
    match tree:
        case Name(name):
            return name
        case Number(value):
            return str(value)
        case _:
            return ""
