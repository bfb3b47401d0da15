"""What is read at a glance, a number and what stands behind it, is read as any other text is."""

from __future__ import annotations

from typing import get_args

from hypothesis import given
from hypothesis import strategies as st

from kinegrade.grading.typed.answers import PAPERS_RULE, read
from kinegrade.grading.typed.number_and_unit import split_unit
from kinegrade.grading.typed.number_text import DecimalStyle
from kinegrade.language.message import Message
from kinegrade.sign_conventions import Convention

SIGNS = st.sampled_from(["", "-", "+", "- ", "\u2013"])
WHOLES = st.sampled_from(["0", "7", "00", "007", "12", "123", "1234", "1 234", "1" * 22])
DECIMALS = st.from_regex(r"(?:[.,' ][0-9]{0,6})?", fullmatch=True)
UNITS = st.sampled_from(["m/s", "rad/s", "m/s^2", "deg", "1", "", "m", "rad", "1/s"])
BEHIND = st.sampled_from(
    ["", " ", ".", " e5", "e5", " x 10^3", " pi", "\u03c0", "\u221a3", " cm/s", " 1/s", " /s"]
) | st.sampled_from(
    [" clockwise", " ccw", " left", " or 4", "\u00b2", " m\u00bd", "?", "%", " upwards"]
)
WORDS = st.sampled_from(["", "I do not know", "-", "\u221a", "\u03c0", "v_B = ", "about ", "half"])
STYLES = st.sampled_from(
    [
        PAPERS_RULE,
        DecimalStyle("groups", "decimal", Message("marking.own-points")),
        DecimalStyle("decimal", "groups", "", Message("marking.own-point-groups")),
        DecimalStyle("unknown", "decimal", Message("marking.both-ways")),
        DecimalStyle("decimal", "decimal", "", Message("marking.against-own-commas")),
    ]
)
CONVENTIONS = st.sampled_from([None, *get_args(Convention)])


@given(st.tuples(SIGNS, WHOLES, DECIMALS, UNITS, BEHIND), UNITS, STYLES, CONVENTIONS)
def test_a_number_with_anything_behind_is_read_as_behind_a_label(
    parts: tuple[str, ...], unit: str, style: DecimalStyle, convention: Convention | None
) -> None:
    typed = "".join(parts)
    # A label means nothing, and is not taken apart at a glance
    labelled = f"v = {typed}"
    assert split_unit(labelled, style) is None
    found, expected = (read(each, unit, style, convention) for each in (typed, labelled))
    same = found.kind, found.value, found.error, found.read_as
    assert same == (expected.kind, expected.value, expected.error, expected.read_as)


@given(WORDS, UNITS, STYLES, CONVENTIONS)
def test_words_are_read_alike_in_every_style(
    words: str, unit: str, style: DecimalStyle, convention: Convention | None
) -> None:
    found, expected = (read(words, unit, each, convention) for each in (style, PAPERS_RULE))
    assert found == expected
    assert found.kind in ("blank", "unreadable", "number")


def test_the_reason_is_that_of_the_text() -> None:
    for typed in ("7 rad/s", "-2,5 rad/s", "13.25 furlongs"):
        found, other = read(typed, "m/s"), read(f"v = {typed}", "m/s")
        assert (found.kind, found.reason, found.typed) == (other.kind, other.reason, typed)
