"""The first chapter of a solution: how each body moves."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import assert_never

from kinegrade.mechanics.joints import GROUND, Circle, Line, Parallel, Pin, Roll, Sleeve
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.relations import name_omega
from kinegrade.worked.document import Block, Prose
from kinegrade.worked.phrases import fill_phrase
from kinegrade.worked.solution_case import Case

_STOPS: Mapping[str, tuple[str, str]] = {"en": (".", "; "), "zh": ("。", "；")}


def describe_motions(case: Case) -> Iterator[Block]:
    """A sentence that says how each body moves."""
    mechanism = case.motion.frames.mechanism
    sentences = [_describe_motion(body, mechanism, case) for body in mechanism.bodies]
    end, between = _STOPS[case.language]
    text = between.join(sentences)
    yield Prose(text[0].upper() + text[1:] + end)


def _describe_motion(body: Body, mechanism: Mechanism, case: Case) -> str:
    """How one body moves."""
    name = case.naming.body(body.name)
    if body.particle:
        return fill_phrase("particle", case.language, body=case.naming.point(body.name))
    pivot = next(
        (
            joint.point
            for joint in mechanism.joints
            if isinstance(joint, Pin) and GROUND in joint.bodies and body.name in joint.bodies
        ),
        None,
    )
    if pivot is not None:
        return fill_phrase("rotates", case.language, body=name, point=case.naming.point(pivot))
    if body.name in find_translating(mechanism):
        return fill_phrase("translates", case.language, body=name)
    roll = next(
        (
            joint
            for joint in mechanism.joints
            if isinstance(joint, Roll) and joint.body == body.name
        ),
        None,
    )
    if roll is not None:
        return fill_phrase("rolls", case.language, body=name, other=describe_track(roll, case))
    still = name_omega(body.name) in case.motion.rates and case.arithmetic.is_zero(
        case.motion.omega(body.name)
    )
    return fill_phrase("plane_instant" if still else "plane", case.language, body=name)


def describe_track(roll: Roll, case: Case) -> str:
    """What a body rolls on, in prose."""
    if roll.of != GROUND:
        return case.naming.body(roll.of)
    match roll.on:
        case Line():
            return fill_phrase("ground", case.language)
        case Circle():
            return fill_phrase("fixed_circle", case.language)
        case _:
            assert_never(roll.on)


def find_translating(mechanism: Mechanism) -> set[str]:
    """The bodies that cannot rotate: kept parallel to the ground, or to a body that is."""
    held = {GROUND}
    for _ in mechanism.bodies:
        for joint in mechanism.joints:
            if isinstance(joint, (Parallel, Sleeve)) and held & {joint.body, joint.of}:
                held |= {joint.body, joint.of}
    return held - {GROUND}
