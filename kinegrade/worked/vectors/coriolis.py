"""The directions of Coriolis accelerations by the right-hand rule, each said once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from msgspec.structs import replace

from kinegrade.language.math.tree import Lettering, Row, Scripts
from kinegrade.language.message import Message, list_all, list_statements
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case, write_row
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import VectorSymbol
from kinegrade.worked.formulas.measures import NEGLIGIBLE, double
from kinegrade.worked.senses import name_rotation_sense
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import (
    name_by_role,
    name_part,
    number_composition,
    vanishes,
)


class Turned(NamedTuple):
    """A Coriolis acceleration: its symbol, that of the relative velocity, and the moving frame."""

    coriolis: VectorSymbol
    relative: VectorSymbol
    frame: str


def list_turned(stage: Stage) -> Iterator[Turned]:
    """The Coriolis accelerations of a step that do not vanish."""
    for equation in stage.equations:
        for part in equation.parts:
            if part.role == "coriolis" and not vanishes(part):
                number = number_composition(equation, part, stage.case)
                relative = name_by_role("r", "velocity", number, bold=True)
                coriolis = name_part(equation, part, stage.case, bold=True)
                yield Turned(coriolis, relative, part.frame)


def explain_directions(turned: Iterable[Turned], case: Case) -> Iterator[Block]:
    """The relative velocity turned through a right angle as the frame turns, for each acceleration
    of which that has not been said.
    """
    new = [one for one in turned if one.coriolis not in case.findings.directed]
    if new:
        is_known = bool(case.findings.directed)
        case.findings.directed.update(one.coriolis for one in new)
        frames = {one.frame for one in new}
        if len(new) > 1 and len(frames) == 1:
            yield case.say(_describe_directions(new, case))
            return
        directions = list_statements(_describe_direction(one, case) for one in new)
        if is_known:
            yield case.say(Message("solution.coriolis-rule-again", directions=directions))
        else:
            yield case.say(Message("solution.coriolis-rule", directions=directions))


def explain_absences(absent: Sequence[tuple[Part, str]], case: Case) -> Iterator[Message]:
    """Why there are no Coriolis accelerations, each with the equation that says so: frames do not
    turn, or the point rests in one.
    """
    still = [(part, zero) for part, zero in absent if _is_still(part, case)]
    if still:
        frames = list_all(case.naming.body(part.frame) for part, _ in still)
        zeros = list_all(zero for _, zero in still)
        if len(still) == 1:
            yield Message("solution.no-coriolis-still", frame=frames, zero=zeros)
        else:
            yield Message("solution.no-coriolis-still-each", frame=frames, zero=zeros)
    for part, zero in absent:
        if (part, zero) not in still:
            yield Message("solution.no-coriolis-at-rest", zero=zero)


def _is_still(part: Part, case: Case) -> bool:
    return abs(double(case.motion.rates[make_turning(part.frame)])) < NEGLIGIBLE


def _describe_directions(turned: Sequence[Turned], case: Case) -> Message:
    """The rule for several accelerations in one frame."""
    omega = case.naming.omega(turned[0].frame)
    bold = write_row(_write_bold(omega.row))
    products = (
        f"${case.text(one.coriolis)}=2\\,{bold}\\times{case.text(one.relative)}$" for one in turned
    )
    return Message(
        "solution.coriolis-rule-together",
        coriolis=list_all(products),
        relative=list_all(f"${case.text(one.relative)}$" for one in turned),
        sense=name_rotation_sense(double(case.motion.rates[make_turning(turned[0].frame)]) > 0),
        omega=case.text(omega),
    )


def _describe_direction(one: Turned, case: Case) -> Message:
    omega = double(case.motion.rates[make_turning(one.frame)])
    return Message(
        "solution.coriolis-direction",
        coriolis=case.text(one.coriolis),
        relative=case.text(one.relative),
        sense=name_rotation_sense(omega > 0),
        omega=case.text(case.naming.omega(one.frame)),
        bold=write_row(_write_bold(case.naming.omega(one.frame).row)),
    )


def _write_bold(letters: Row) -> Row:
    """The letters of an angular velocity as those of a vector."""
    first, *rest = letters
    if isinstance(first, Scripts) and first.base is not None:
        return (replace(first, base=Lettering("boldsymbol", (first.base,))), *rest)
    return (Lettering("boldsymbol", (first,)), *rest)
