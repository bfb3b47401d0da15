"""Bodies that roll without slipping."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal, assert_never

from kinegrade.language.message import Message, Text, list_all
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.rates.drums import is_drum
from kinegrade.worked.rates.kinds import describe_track
from kinegrade.worked.rates.rolled_motion import (
    find_linked_term,
    find_slip_sign,
    state_rolled_radius,
)
from kinegrade.worked.rates.speeds import Statement, find_term, name_relative_rotation, name_speed
from kinegrade.worked.senses import describe_direction
from kinegrade.worked.vectors.known_vectors import find_positive_sense, find_stated_sense


def state_rolling(roll: NoSlip, relation: Relation, case: Case, level: Level) -> Statement:
    """No slip: the centre's speed along the track is the radius times the relative rotation."""
    term = find_linked_term(roll, relation, case)
    body, other = case.naming.body(roll.body), describe_track(roll, case)
    rotation = name_relative_rotation(roll.body, roll.of, case, level)
    right = (state_rolled_radius(roll, case) * rotation).signed(
        find_slip_sign(roll, relation, case, level)
    )
    equation = Equation(name_speed(term, case, level), equate(right))
    if roll.joint in case.findings.rim_tracks:
        kind = _name_kind_of_rim(roll, case)
        return Statement(
            Message(f"solution.title-rim-of-{kind}", **_name_rim(roll, case)),
            Message(
                f"solution.rim-of-{kind}-{level}",
                body=body,
                other=other,
                speed=case.text(name_speed(term, case, level)),
                way=_describe_positive_sense(term, case, level),
            ),
            equation,
        )
    title = Message("solution.title-roll", body=body, other=other)
    return Statement(title, _explain_rolling(roll, term, case, level), equation)


def _name_kind_of_rim(roll: NoSlip, case: Case) -> Literal["body", "drum"]:
    """Which sentences tell that a track moves with a rim: of a drum, that this is one body with a
    gear.
    """
    return "drum" if is_drum(roll, case) else "body"


def _name_rim(roll: NoSlip, case: Case) -> dict[str, Text]:
    """A wheel, the radius of the rim with which a track moves, one of several perhaps, and the
    track.
    """
    radius = case.text(state_rolled_radius(roll, case))
    return {
        "body": case.naming.body(roll.body),
        "other": describe_track(roll, case),
        "radius": radius,
    }


def _explain_rolling(roll: NoSlip, term: Term, case: Case, level: Level) -> Message:
    """Why the rotation of a rolling body and the motion of its centre are linked."""
    body, motion = case.naming.body(roll.body), _name_motion_along_path(roll, term, case, level)
    rotation, other = Message("solution.rotation-of", body=body), describe_track(roll, case)
    linked: dict[str, Text] = {"motion": motion, "rotation": rotation}
    match level:
        case "velocity" if roll.of == GROUND:
            return Message("solution.no-slip-on-ground", body=body, **linked)
        case "velocity":
            return Message("solution.no-slip-seen-from", body=body, other=other, **linked)
        case "acceleration" if roll.of == GROUND:
            return Message("solution.no-slip-differentiated", **linked)
        case "acceleration":
            return Message("solution.no-slip-differentiated-seen-from", other=other, **linked)
        case _:
            assert_never(level)


def group_rolls(rolls: Iterable[NoSlip]) -> list[tuple[NoSlip, ...]]:
    """The rollings of one body on several moving ones together, all others alone."""
    groups = list[tuple[NoSlip, ...]]()
    for roll in rolls:
        last = groups[-1][-1] if groups else None
        if last and GROUND not in (roll.of, last.of) and _find_hub(roll) == _find_hub(last):
            groups[-1] += (roll,)
        else:
            groups.append((roll,))
    return groups


def _find_hub(roll: NoSlip) -> tuple[str, str]:
    return roll.body, roll.circle.centre


def explain_rolls(rolls: Sequence[NoSlip], relation: Relation, case: Case, level: Level) -> Message:
    """Why the rotation of a body that rolls on several others and the motion of its centre are
    linked; `relation` is that of one of them.
    """
    term = find_term(relation.turning[0][0], case)
    others = list_all(describe_track(roll, case) for roll in rolls)
    motion = _name_motion_along_path(rolls[0], term, case, level)
    rotation = Message("solution.rotation-of", body=case.naming.body(rolls[0].body))
    return Message(
        f"solution.rolls-on-each-{level}", other=others, motion=motion, rotation=rotation
    )


def _name_motion_along_path(roll: NoSlip, term: Term, case: Case, level: Level) -> Message:
    """The motion of a rolling body's centre, with its positive sense where it moves in the plane of
    the page.
    """
    centre = case.naming.point(roll.circle.centre)
    if term.frame != GROUND:
        return Message("solution.motion-along-path", centre=centre)
    symbol = name_speed(term, case, level)
    way = _describe_positive_sense(term, case, level)
    if symbol.part:
        return Message(
            "solution.tangential-motion", centre=centre, speed=case.text(symbol), way=way
        )
    return Message(
        "solution.motion-along-path-positive", centre=centre, speed=case.text(symbol), way=way
    )


def _describe_positive_sense(term: Term, case: Case, level: Level) -> Message:
    """In which sense a guided point's speed counts positive."""
    match term.kind:
        case "arc":
            centre = case.naming.point(term.base)
            if find_stated_sense(term, case, level) < 0:
                return Message("solution.clockwise-about", point=centre)
            return Message("solution.around", centre=centre)
        case "sliding" | "rotation":
            return describe_direction(find_positive_sense(term, case, level), case)
        case _:
            assert_never(term.kind)


def tell_rolls(rolls: Sequence[NoSlip], case: Case) -> Message:
    """What no slip links, seen from the track where that moves, or from each of several."""
    roll, *others = rolls
    centre, body = case.naming.point(roll.circle.centre), case.naming.body(roll.body)
    if roll.of == GROUND:
        return Message("solution.idea-roll", body=body, centre=centre)
    other = list_all(case.naming.body(one.of) for one in rolls)
    if roll.joint in case.findings.rim_tracks:
        kind = _name_kind_of_rim(roll, case)
        return Message(f"solution.idea-rim-of-{kind}", **_name_rim(roll, case))
    if others:
        return Message("solution.idea-roll-on-each", body=body, centre=centre, other=other)
    return Message("solution.idea-roll-on", body=body, centre=centre, other=other)
