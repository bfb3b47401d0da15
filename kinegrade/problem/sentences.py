"""The sentences in which a template states its joints and inputs, and what each must contain.

    pin A: OA AB
    B of AB slides on line(O, 0)
    A of AB slides on line(O, A) of OC
    AB slides through sleeve along line(O, A)
    M stays on circle(O1, R) of ring1
    circle(C, R) of cam touches line(A, 0) of BC
    circle(A, r2) of II rolls on circle(O, r1) inside
    circle(A, r1) of I meshes with circle(B, r2) of II on arm
    BC translates
    rod turns with arm

    OA turns
    AB turns relative to OA
    B of AB moves along -x [relative to AE]
    A of W circles O

Where no second body is named it is the ground. `inside` says that one circle lies within the other.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from kinegrade.errors import ExpressionError
from kinegrade.expression import MAX_LENGTH, Call, Expression, Name, read
from kinegrade.mechanics.joints import GROUND

SHAPE = r"(?:line|circle)\(.+?\)"
OF = r"(?: of (?P<of>\w+))?"
JointKind = Literal["pin", "slide", "sleeve", "arc", "contact", "roll", "mesh", "parallel"]
DriverKind = Literal["rotation", "component", "circulation"]
_JOINT_PATTERNS: Mapping[JointKind, str] = {
    "pin": r"pin (?P<point>\w+): (?P<bodies>\w+(?:[ ,]+\w+)+)",
    "slide": rf"(?P<point>\w+) of (?P<body>\w+) slides on (?P<on>line\(.+\)){OF}",
    "sleeve": r"(?P<body>\w+) slides through (?P<of>\w+) along (?P<on>line\(.+\))",
    "arc": rf"(?P<point>\w+) of (?P<body>\w+) stays on (?P<on>circle\(.+\)){OF}",
    "contact": r"(?P<circle>circle\(.+?\)) of (?P<body>\w+) touches "
    rf"(?P<on>{SHAPE}){OF}(?P<inside> inside)?",
    "roll": rf"(?P<circle>circle\(.+?\)) of (?P<body>\w+) rolls on (?P<on>{SHAPE}){OF}(?P<inside> "
    r"inside)?",
    "mesh": r"(?P<circle>circle\(.+?\)) of (?P<body>\w+) meshes with (?P<on>circle\(.+?\)) of "
    r"(?P<of>\w+) on (?P<carrier>\w+)(?P<inside> inside)?",
    "parallel": r"(?P<body>\w+) (?:translates|turns with (?P<of>\w+))",
}
_DRIVER_PATTERNS: Mapping[DriverKind, str] = {
    "rotation": r"(?P<body>\w+) turns(?: relative to (?P<of>\w+))?",
    "component": r"(?P<point>\w+) of (?P<body>\w+) moves along (?P<along>.+?)(?: relative to "
    r"(?P<of>\w+))?",
    "circulation": r"(?P<point>\w+) of (?P<body>\w+) circles (?P<centre>\w+)",
}
JOINTS = {kind: re.compile(pattern, re.ASCII) for kind, pattern in _JOINT_PATTERNS.items()}
DRIVERS = {kind: re.compile(pattern, re.ASCII) for kind, pattern in _DRIVER_PATTERNS.items()}
AXES = {"+x": "0", "-x": "pi", "+y": "pi/2", "-y": "-pi/2"}


@dataclass(frozen=True)
class JointSentence:
    """A joint as written: names, and shapes still to be worked out at an instance's values."""

    kind: JointKind
    text: str
    point: str = ""
    body: str = ""
    of: str = GROUND
    bodies: tuple[str, ...] = ()
    circle: Call | None = None
    on: Call | None = None
    carrier: str = ""
    inside: bool = False


@dataclass(frozen=True)
class DriverSentence:
    """An input as written: what moves, and the expressions of its velocity and acceleration."""

    kind: DriverKind
    text: str
    velocity: Expression
    acceleration: Expression
    point: str = ""
    body: str = ""
    of: str = GROUND
    along: Expression | None = None
    centre: str = ""


def read_joint(text: str) -> JointSentence:
    """The joint that a sentence states. Raises ExpressionError saying which sentences there are."""
    require_short(text)
    for kind, pattern in JOINTS.items():
        match = pattern.fullmatch(text.strip())
        if match:
            found = {key: value for key, value in match.groupdict().items() if value is not None}
            bodies = tuple(re.split(r"[ ,]+", found["bodies"])) if "bodies" in found else ()
            return JointSentence(
                kind,
                text,
                found.get("point", ""),
                found.get("body", ""),
                found.get("of", GROUND),
                bodies,
                read_shape(found.get("circle")),
                read_shape(found.get("on")),
                found.get("carrier", ""),
                "inside" in found,
            )
    raise ExpressionError(
        f'"{text}": no such joint: write one of "pin A: OA AB", "B of AB slides on line(O, 0)", '
        '"... stays on circle(C, r) of ...", "... touches ...", "... rolls on ...", '
        '"... meshes with ... on ...", "... slides through ... along ...", "... translates"'
    )


def require_short(text: str) -> None:
    """Refuse what is too long for a sentence, before it keeps the patterns busy."""
    if len(text) > MAX_LENGTH:
        raise ExpressionError(
            f"a sentence of {len(text)} characters: at most {MAX_LENGTH} are read"
        )


def read_shape(text: str | None) -> Call | None:
    """A line or a circle about a named point."""
    if text is None:
        return None
    tree = read(text)
    if (
        not isinstance(tree, Call)
        or len(tree.arguments) != 2
        or not isinstance(tree.arguments[0], Name)
    ):
        raise ExpressionError(
            f'"{text}": expected line(POINT, angle or point) or circle(POINT, radius)'
        )
    return tree


def read_driver(text: str, velocity: str, acceleration: str) -> DriverSentence:
    """The input that a sentence states. Raises ExpressionError saying which sentences there are."""
    require_short(text)
    for kind, pattern in DRIVERS.items():
        match = pattern.fullmatch(text.strip())
        if match:
            found = {key: value for key, value in match.groupdict().items() if value is not None}
            along = found.get("along")
            return DriverSentence(
                kind,
                text,
                read(velocity),
                read(acceleration),
                found.get("point", ""),
                found["body"],
                found.get("of", GROUND),
                read(AXES.get(along, along)) if along else None,
                found.get("centre", ""),
            )
    raise ExpressionError(
        f'"{text}": no such input: write "OA turns", "AB turns relative to OA", '
        '"B of AB moves along +x" or "A of W circles O"'
    )
