"""The page reads what people type as `kinegrade grade` does."""

from __future__ import annotations

import re
import sys
from collections import defaultdict
from random import Random
from typing import Any
from unicodedata import category

from kinegrade.grading.typed.answers import Reading, read
from kinegrade.grading.typed.keyboard import fold
from kinegrade.language.message import Message
from kinegrade.sign_conventions import CONVENTIONS
from tests.grading.test_typed_answers import ROWS, STYLES
from tests.practice.node import read_in_node
from tests.practice.typed_texts import make_texts

UNITS = ("m/s", "rad/s", "m/s^2", "rad/s^2", "deg", "mm", "1", "rpm", "deg/s", "m^2")
# Where doubles and fractions are too large or too small is said in other words
SIZES = {"beyond", "below", "not-finite"}
HALF = re.compile("[\ud800-\udfff]")  # of a character: no box of a page has that alone
USUAL = (
    "0.25", "-1,5", "−8．６６×１０⁻¹ m/s", "1 234,5", "1.234,5", "1,234", "12 e3", ".5", "5.", "",
    "--", "√3/2", "2 sqrt(3)/3", "5π/3", "2½", "1/2√3", "5-3", "(1/2)√3 m/s", "sqrt(-2)", "1/0",
    "v_B = 3.2 m/s", "ω≈12 rad/s (clockwise)", "clockwise: 5", "↻ 3", "3 ↺", "逆时针 2.5 rad/s",
    "-3 cw", "+3 to the left", "nach links 4", "ca. 7,25", "about 2 m/s", "30 rpm", "30 r/min",
    "30 1/min", "2 Hz", "5 m s^-2", "5 ms⁻²", "5 m/s/s", "5 米/秒²", "5 metres per second squared",
    "5 cm/s", "1/rpm", "5 constructor", "2 min⁻¹ cm/cm", "2^17", "10^40", "(10)^20 m/s", "(0010)^69", "(+10)^20", "10.0^20", "(10^1)^20", "(-10)^20", "(2*5)^20", "〔1/2〕√3", "π/0", "5 km/h", "5 ft/s", "45°", "45 deg", "π/4 rad", "π/4", "50 %", "3 apples", "3 4", "3;4",
    "1e200", "199\t956", "199\t956 m/s²", "5\tm/s²", "5\x1cm", "3±0.1", "<b>1</b>", "0x10", "１２．５", "½ v_B =", "1.2.3", "1'000.5", "7 (m/s)",
)  # fmt: skip
PIECES = (
    "3", "1,5", "0.25", "1/2", "√3", "sqrt(3)", "π", "*", "/", "+", "-", " ", "m/s", "rad/s", "°",
    "cm", "cw", "逆时针", "(", ")", "^2", "e-3", "×10^-2", "½", "v_B =", "=", "ca.", "to the left",
    "rpm", "1 234.5", "nach rechts", "米/秒", "Hz", "per second", "squared", "，", "。", "−", "'",
    "m s⁻²", "[", "]", "2½", "un", "about ",
)  # fmt: skip
PLACES = (
    "3{}", "{}3", "3 {} m/s", "29 1/{}", "3 *{}m", "x{} = 3", "{}x=3", "√{}3", "3 m{}", "3{}4", "pi{}=3",
    "3 cw{}", "{}cw 3", "2 {}rads^-1", "3 square {}m", "3 m/{}s", "1{}3 4",
)  # fmt: skip
EACH = 6


def list_unlike(texts: list[str], seed: int) -> list[str]:
    """The texts that the script does not read as Python does, each for an ask chosen by a seed."""
    random = Random(seed)
    asked = [(random.choice(UNITS), random.choice((*CONVENTIONS, None))) for _ in texts]
    cases = [
        {"typed": text, "ask": {"unit": unit, "convention": convention, "sign": "x"}}
        for text, (unit, convention) in zip(texts, asked, strict=True)
    ]
    return [
        f"{text!r} for {unit}, {convention}"
        for text, (unit, convention), found in zip(texts, asked, read_in_node(cases), strict=True)
        if not is_like(found, read(text, unit, convention=convention, sign="x"))
    ]


def is_like(found: dict[str, Any], expected: Reading) -> bool:
    """Whether the script has the kind, the reason and the value."""
    if found["kind"] != expected.kind or found["reason"] not in (name_reason(expected), *SIZES):
        return False
    value = expected.value
    return value is None or abs(found["value"] - float(value)) <= 1e-12 * abs(value)


def name_reason(reading: Reading) -> str:
    """The entry that says why, without its file."""
    reason = reading.reason
    return reason.key.partition(".")[2] if isinstance(reason, Message) else ""


def list_unlike_made_up(seed: int, count: int) -> list[str]:
    """The same of so many texts that are made of what people type."""
    random = Random(seed)
    loose = ["".join(random.choices(PIECES, k=random.randint(1, 5))) for _ in range(count // 2)]
    return list_unlike([*loose, *make_texts(random, count - len(loose))], seed)


def test_usual_texts_are_read_as_in_a_file() -> None:
    assert [each for seed in range(3) for each in list_unlike(list(USUAL), seed)] == []


def test_the_table_of_typed_answers_is_read_as_in_a_file() -> None:
    """What is decided of typed answers has its row there: the page is told of it as well."""
    asked = [
        (text, unit, context or None)
        for text, unit, context, *_ in ROWS
        if context not in STYLES and not HALF.search(text)
    ]
    cases = [
        {"typed": text, "ask": {"unit": unit, "convention": convention, "sign": "x"}}
        for text, unit, convention in asked
    ]
    unlike = [
        f"{text!r} for {unit}, {convention}: {found}"
        for (text, unit, convention), found in zip(asked, read_in_node(cases), strict=True)
        if not is_like(found, read(text, unit, convention=convention, sign="x"))
    ]
    assert unlike == []


def test_made_up_texts_are_read_as_in_a_file() -> None:
    assert list_unlike_made_up(7, 4000) == []


def list_signs_of_all_kinds() -> list[str]:
    """Characters that are folded into others, and some of each category of Unicode."""
    kinds = defaultdict(list)
    for code in range(sys.maxunicode + 1):
        kinds[category(chr(code))].append(chr(code))
    del kinds["Cs"], kinds["Cn"]  # halves, and what browsers may know and Python does not
    folded = [sign for signs in kinds.values() for sign in signs if fold(sign) != sign]
    return folded + [sign for signs in kinds.values() for sign in signs[:: -(-len(signs) // EACH)]]


def test_signs_of_all_kinds_are_read_as_in_a_file() -> None:
    """For the page, 1/Ⅳ behind a number was another number, and 〔1/2〕√3 none."""
    texts = [place.format(sign) for sign in list_signs_of_all_kinds() for place in PLACES]
    assert list_unlike(texts, 1) == []
