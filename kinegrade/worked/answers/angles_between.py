"""The angle between a vector known by its components and a line, by the vector's projection."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kinegrade.expressions.tree import Call, Name, Operation
from kinegrade.language.message import Message
from kinegrade.problem.template.template import Ask
from kinegrade.worked.answers.quantity_formulas import find_projected
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.symbols import draw_arrow


def explain_between(ask: Ask, case: Case) -> Iterator[Block]:
    """What the cosine of an asked angle is, where the line is written from point to point."""
    match ask.quantity:
        case Call("between", (_, Operation("-", Name(end), Name(start)))) as tree:
            projected = find_projected(tree, case)
        case _:
            return
    if projected is not None:
        symbol = projected[0].symbol
        arrow = draw_arrow((case.naming.letter(start), case.naming.letter(end)))
        yield case.say(
            Message(
                "solution.cosine-of-projection",
                angle=ask.symbol,
                vector=case.text(replace(symbol, bold=True)),
                size=case.text(symbol),
                direction=case.text(arrow),
            )
        )
