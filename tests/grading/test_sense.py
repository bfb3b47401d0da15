"""Senses in words, in two languages and signs, under every convention that has one."""

from __future__ import annotations

from itertools import chain
from typing import get_args

import pytest

from kinegrade.exam.folder.earlier_signs import recognise_convention
from kinegrade.grading.typed.answers import read
from kinegrade.grading.typed.keyboard import fold
from kinegrade.grading.typed.number_text import Unreadable
from kinegrade.grading.typed.sense import SENSE_WORDS, Sense, find_direction, split_sense
from kinegrade.language import ENGLISH, Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.spellings import list_spellings
from kinegrade.sign_conventions import Convention

WORDS: dict[Sense, tuple[str, ...]] = {
    "ccw": ("ccw", "CCW", "c.c.w.", "acw", "counter-clockwise", "Counter clockwise", "anticlockwise", "逆时针",
            "逆時針方向", "↺"),
    "cw": ("cw", "c.w.", "clockwise", "Clockwise", "顺时针", "順時針", "顺时针转动", "↻"),
    "right": ("right", "to the right", "rightwards", "向右", "水平向右", "→"),
    "left": ("left", "to the left", "向左", "←"),
    "up": ("up", "upwards", "向上", "竖直向上", "↑"),
    "down": ("down", "downward", "向下", "铅直向下", "↓"),
}  # fmt: skip
FORMS = (
    "12 {}",
    "12 m/s {}",
    "12 m/s, {}",
    "12 m/s ({})",
    "12（{}）",
    "{} 12",
    "({}) 12",
    "{}: 12",
    "{}，12 m/s",
)


@pytest.mark.parametrize("sense", get_args(Sense))
def test_every_word_is_taken_off_before_and_behind(sense: Sense) -> None:
    for word in WORDS[sense]:
        for form in FORMS:
            rest, found = split_sense(fold(form.format(word)))
            assert (rest.strip(), found) == ("12 m/s" if "m/s" in form else "12", sense), (
                form.format(word)
            )


def test_no_word_for_a_sense_has_a_digit() -> None:
    """Whether an answer may hold one is looked up without its digits."""
    spelled = "".join(chain.from_iterable(map(list_spellings, SENSE_WORDS.values())))
    assert [letter for letter in spelled if letter.isdigit()] == []


@pytest.mark.parametrize(
    "typed", ["12 m/s", "12 rad/s", "12 mcw", "scw 12", "12 upper", "上 12", "12 rightful", ""]
)
def test_what_is_no_such_word_stays(typed: str) -> None:
    assert split_sense(typed) == (typed, None)


@pytest.mark.parametrize(
    ("convention", "positive", "negative"),
    [
        ("ccw", "ccw", "cw"),
        ("cw", "cw", "ccw"),
        ("+x", "right", "left"),
        ("-x", "left", "right"),
        ("+y", "up", "down"),
        ("-y", "down", "up"),
    ],
)
def test_the_convention_makes_it_a_sign(
    convention: Convention, positive: Sense, negative: Sense
) -> None:
    assert (
        find_direction(positive, "", convention)
        == find_direction(positive, "+", convention)
        == (1, "")
    )
    assert find_direction(negative, "", convention) == (-1, "")
    for sign, sense in (("-", positive), ("-", negative), ("+", negative)):
        with pytest.raises(Unreadable, match="together can mean either way; write one of the two"):
            find_direction(sense, sign, convention)
    for sense in set(get_args(Sense)) - {positive, negative}:
        with pytest.raises(Unreadable, match="does not determine the sign of this answer"):
            find_direction(sense, "", convention)


@pytest.mark.parametrize(
    ("convention", "words"),
    [
        ("signed", "with its sign"),
        (None, ""),
        (None, "positive as a counter-clockwise rocker carries $D$"),
        (None, "counter-clockwise positive"),  # an author's words are no keyword
    ],
)
def test_words_tell_nothing_where_the_convention_is_another(
    convention: Convention | None, words: str
) -> None:
    with pytest.raises(Unreadable, match="does not determine the sign of this answer") as caught:
        find_direction("ccw", "", convention, words)
    assert (f"({words})" in str(caught.value)) == bool(words)


@pytest.mark.parametrize("convention", ["magnitude", "unsigned"])
def test_words_are_left_out_where_there_is_no_sign(convention: Convention) -> None:
    factor, remark = find_direction("cw", "", convention)
    assert factor == 1
    assert open_catalogue(ENGLISH).write(remark) == (
        "a sense (clockwise) is not asked for; it was left out"
    )
    assert open_catalogue(Language("zh")).write(remark) == "不要求方向（顺时针）；已略去"


@pytest.mark.parametrize(
    ("words", "convention"),
    [
        ("magnitude, not negative", "magnitude"),
        ("magnitude", "magnitude"),
        ("between 0° and 180°", "unsigned"),
        ("with its sign", "signed"),
        ("counter-clockwise positive", "ccw"),
        ("positive counter-clockwise about $O$", "ccw"),
        ("clockwise positive", "cw"),
        ("positive clockwise about $O$", "cw"),
        ("positive in the direction of $+x$", "+x"),
        ("positive in the direction of $-x$", "-x"),
        ("positive in the direction of $+y$", "+y"),
        ("positive in the direction of $-y$", "-y"),
        ("positive from $A$ towards $B$", None),
        ("positive as a counter-clockwise rocker carries $D$", None),
        ("", None),
        (None, None),
    ],
)
def test_a_convention_is_recognised_by_the_words_of_earlier_folders(
    words: object, convention: Convention | None
) -> None:
    assert recognise_convention(words) == convention


@pytest.mark.parametrize(
    "typed", ["clockwise: 5", "clockwise = 5", "Clockwise:5 rad/s", "顺时针：5", "Uhrzeigersinn: 5"]
)
def test_a_sense_before_a_colon_is_no_label_to_be_dropped(typed: str) -> None:
    reading = read(typed, "rad/s", convention="ccw")
    assert (reading.kind, reading.read_as) == ("number", "-5")


@pytest.mark.parametrize("typed", ["omega (clockwise) = 5", "not clockwise: 5"])
def test_a_sense_inside_a_label_is_never_dropped_in_silence(typed: str) -> None:
    assert read(typed, "rad/s", convention="ccw").kind == "unreadable"


@pytest.mark.parametrize("typed", ["v_up = 5", "omega_AB: 5", "upsilon = 5"])
def test_a_symbol_before_the_number_is_a_label(typed: str) -> None:
    assert read(typed, "rad/s", convention="ccw").read_as == "5"
