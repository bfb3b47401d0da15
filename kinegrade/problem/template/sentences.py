"""The sentences in which a template states its joints and inputs, and what each must contain.

What each says stands with the joints and drivers of `mechanics`, as `FORM` and `EXAMPLES`;
`problem.vocabulary` lists them. Where no second body is named it is the ground.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from typing import TypeVar

from kinegrade.errors import FieldError, suggest_examples
from kinegrade.expressions.reading import MAX_LENGTH, read_expression
from kinegrade.expressions.tree import Call, Expression, Name
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message, Quoted
from kinegrade.mechanics.drivers import DRIVERS, Driver
from kinegrade.mechanics.joints import GROUND, JOINTS, Joint
from kinegrade.sign_conventions import Convention

_OTHER_LETTERS = r"\w*[^\W\x00-\x7f]\w*"
_Stated = TypeVar("_Stated", bound=Joint | Driver)
_AXES: Mapping[Convention, Expression] = {
    "+x": read_expression("0"),
    "-x": read_expression("pi"),
    "+y": read_expression("pi/2"),
    "-y": read_expression("-pi/2"),
}


@dataclass(frozen=True)
class JointSentence:
    """A joint as written: names, and shapes still to be worked out at an instance's values."""

    stated: type[Joint]
    text: str
    point: str = ""
    body: str = ""
    of: str = GROUND
    bodies: tuple[str, ...] = ()
    circle: Call | None = None
    on: Call | None = None
    carrier: str = ""
    options: frozenset[str] = frozenset()


_PARTS = {part.name for part in fields(JointSentence)}


@dataclass(frozen=True)
class DriverSentence:
    """An input as written: what moves, and the expressions of its velocity and acceleration."""

    stated: type[Driver]
    text: str
    velocity: Expression
    acceleration: Expression
    point: str = ""
    body: str = ""
    of: str = GROUND
    along: Expression | None = None
    centre: str = ""


def read_joint(text: str) -> JointSentence:
    """The joint that a sentence states. Raises FieldError naming the nearest sentences."""
    stated = _find_stated(JOINTS, text)
    if stated is None:
        _require_plain_names(JOINTS, text)
        what = Message("template.no-such-joint", sentence=found(text))
        raise FieldError(what, do=_suggest_sentences(text, JOINTS, "joints"))
    kind, parts = stated
    bodies = parts.get("bodies")
    return JointSentence(
        stated=kind,
        text=text,
        point=parts.get("point", ""),
        body=parts.get("body", ""),
        of=parts.get("of", GROUND),
        bodies=tuple(re.split(r"[ ,]+", bodies)) if bodies else (),
        circle=_shape(parts.get("circle")),
        on=_shape(parts.get("on")),
        carrier=parts.get("carrier", ""),
        options=frozenset(parts) - _PARTS,
    )


def read_driver(text: str, velocity: Expression, acceleration: Expression) -> DriverSentence:
    """The input that a sentence states. Raises FieldError naming the nearest sentences."""
    stated = _find_stated(DRIVERS, text)
    if stated is None:
        _require_plain_names(DRIVERS, text)
        what = Message("template.no-such-input", sentence=found(text))
        raise FieldError(what, do=_suggest_sentences(text, DRIVERS, "inputs"))
    kind, parts = stated
    return DriverSentence(
        stated=kind,
        text=text,
        velocity=velocity,
        acceleration=acceleration,
        point=parts.get("point", ""),
        body=parts["body"],
        of=parts.get("of", GROUND),
        along=_read_direction(parts.get("along")),
        centre=parts.get("centre", ""),
    )


def _read_direction(text: str | None) -> Expression | None:
    """The angle of a direction: of an axis by its name, or as an expression."""
    if text is None:
        return None
    named = (angle for axis, angle in _AXES.items() if axis == text)
    return next(named, None) or read_expression(text)


def find_axis(direction: Expression) -> Convention | None:
    """The axis along which a direction points; None for any other."""
    return next((axis for axis, angle in _AXES.items() if angle == direction), None)


def _require_plain_names(kinds: Iterable[type[_Stated]], text: str) -> None:
    """Raises FieldError where a sentence is right but for a name in other letters."""
    named = re.search(_OTHER_LETTERS, text)
    if named and _find_stated(kinds, re.sub(_OTHER_LETTERS, "X", text)):
        what = Message("template.other-letters", sentence=found(text), name=Quoted(named[0]))
        raise FieldError(what, Message("template.plain-name"))


def _suggest_sentences(
    text: str, kinds: Iterable[type[Joint]] | Iterable[type[Driver]], group: str
) -> Message:
    """The nearest sentences: those whose own words are nearest to those of the text."""
    shown = {_keep_verb(each): each for kind in kinds for each in kind.EXAMPLES}
    return suggest_examples(_keep_verb(text), shown, group)


def _keep_verb(sentence: str) -> str:
    """A sentence without its shapes and without names, as far as those are told by a capital or a
    digit.

    >>> _keep_verb("A of AB slides on line(O, A) of OC")
    'of slides on line of'
    """
    bare = re.sub(r"\(.*?\)", "", sentence)
    return " ".join(word for word in bare.split() if word.islower() or word[-1] == ":")


def _find_stated(
    kinds: Iterable[type[_Stated]], text: str
) -> tuple[type[_Stated], Mapping[str, str]] | None:
    """What a text states, with the parts that it has; None where it is no such sentence.

    Raises FieldError for what is too long for a sentence, before it keeps the patterns busy.
    """
    if len(text) > MAX_LENGTH:
        what = Message("template.long-sentence", count=len(text))
        raise FieldError(what, Message("template.at-most", most=MAX_LENGTH))
    for kind in kinds:
        match = re.fullmatch(kind.PATTERN, text.strip(), re.ASCII)
        if match:
            return kind, {part: value for part, value in match.groupdict().items() if value}
    return None


def _shape(text: str | None) -> Call | None:
    """A line or a circle about a named point."""
    if text is None:
        return None
    match read_expression(text):
        case Call(_, (Name(), _)) as shape:
            return shape
        case _:
            raise FieldError(found(text), Message("template.a-shape"))
