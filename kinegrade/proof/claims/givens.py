"""What givens mean in words against the values that they can have."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import pi

from kinegrade.language.message import Fault, Message
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.proof.claims.patterns import list_words


def find_wrong_givens(template: Template, examples: Sequence[Solution]) -> Iterator[Fault]:
    """A fault for each tooth count that is no whole number, and for an outer radius that is less
    than the inner one.
    """
    for name, given in template.parameters.items():
        if _names(given, "tooth-count") and not _names(given, "a-ratio"):
            broken = [each for each in given.choices if not _is_whole(each)]
            for value in broken[:1]:
                what = Message("template.broken-teeth", name=name, value=value)
                yield Fault(f"parameters.{name}.draw", what)
    yield from _find_inner_beyond_outer(template, examples)


def _find_inner_beyond_outer(template: Template, examples: Sequence[Solution]) -> Iterator[Fault]:
    """Of a radius called inner and the one that is called outer."""
    rims = [each for each in template.parameters.values() if _is_rim(each)]
    inner = [each for each in rims if _names(each, "inner") and not _names(each, "outer")]
    outer = [each for each in rims if _names(each, "outer") and not _names(each, "inner")]
    if len(inner) != 1 or len(outer) != 1:
        return
    larger = [each for each in examples if _measure(each, inner[0]) > _measure(each, outer[0])]
    if larger:
        what = Message(
            "template.inner-beyond-outer",
            inner=inner[0].name,
            outer=outer[0].name,
            number=len(larger),
            examined=len(examples),
        )
        yield Fault(f"parameters.{outer[0].name}", what)


def note_angles_in_radians(template: Template) -> Iterator[Message]:
    """A remark for each angle in rad that is more than a full turn at all its values."""
    for name, given in template.parameters.items():
        plain = given.unit.angle and not given.unit.time and not given.unit.degrees
        if plain and all(_is_more_than_a_turn(each) for each in given.choices):
            yield Message("template.more-than-a-turn", name=name)


def _is_rim(given: Parameter) -> bool:
    """Whether a given is a radius or a diameter by its words."""
    return given.unit.is_length and (_names(given, "a-radius") or _names(given, "a-diameter"))


def _names(given: Parameter, kind: str) -> bool:
    """Whether the words of a given name a kind, in whatever language."""
    said = " ".join(given.means.texts).lower()
    return any(word in said for word in list_words(kind))


def _measure(each: Solution, given: Parameter) -> float:
    """The value of a given length in an instance, in metres."""
    return abs(each.parameters[given.name].value) * Floats().scale(given.unit.scale)


def _read_plain(value: str) -> Fraction | None:
    """The value of a number; None for an expression."""
    try:
        return Fraction(value)
    except ValueError:
        return None


def _is_whole(value: str) -> bool:
    """Whether a value is a whole number, so far as it is plain."""
    number = _read_plain(value)
    return number is None or number.denominator == 1


def _is_more_than_a_turn(value: str) -> bool:
    """Whether an angle is more than a full turn, so far as it is plain."""
    number = _read_plain(value)
    return number is not None and abs(number) > 2 * pi
