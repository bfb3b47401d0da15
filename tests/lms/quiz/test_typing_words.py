"""What a quiz tells students to type is read by its system as the number that they mean."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.quiz.document import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.lms.quiz.typing_words import Typing, make_typing_rule, write_rules
from tests.lms.quiz.a_quiz import SPEED, question
from tests.lms.quiz.packages import listing
from tests.small_class import kinegrade

ENGLISH, GERMAN = (",", "."), (".", ",")  # what separates thousands, and what decimals
LANGUAGES: tuple[Language, ...] = ("en", "zh")
POWERS_OF_TEN: dict[Typing, bool] = {
    "moodle": True,
    "canvas": False,
    "qti21": True,
    "blackboard": False,
}
EXAMPLE = re.compile(r"-?\d+[.,]\d+(?:e-?\d+)?")


def rule(typing: Typing, language: Language) -> str:
    return open_catalogue(language).write(make_typing_rule(typing, 4))


def moodle_reads(typed: str) -> Fraction | None:
    """What Moodle reads in English: commas are dropped, anything but a plain number is none."""
    found = re.fullmatch(r"\s*([-+]?\s*\d*\.?\d+(?:[eE][-+]?\d+)?)\s*", typed.replace(",", ""))
    return None if found is None else Fraction(found[1].replace(" ", ""))


def canvas_reads(typed: str, thousands: str, decimal: str) -> Fraction | None:
    """What Canvas's Classic Quizzes read by a user's locale, to the four decimals that it keeps."""
    groups, point = re.escape(thousands), re.escape(decimal)
    found = re.fullmatch(
        rf"\s*([+-]?(?:\d{{1,3}}(?:{groups}\d{{3}})+|\d*))(?:{point}(\d*))?\s*", typed
    )
    if found is None or not any(found.groups()):
        return None
    whole = found[1].replace(thousands, "") or "0"
    return round(Fraction(f"{whole}.{found[2] or '0'}"), 4)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("typing", ["moodle", "qti21", "blackboard"])
def test_the_examples_are_read_as_they_are_meant(typing: Typing, language: Language) -> None:
    examples = EXAMPLE.findall(rule(typing, language))
    assert examples[0] == "-0.8660"
    assert [moodle_reads(example) for example in examples] == [
        Fraction(example) for example in examples
    ]


@pytest.mark.parametrize("typing", ["moodle", "qti21", "blackboard"])
def test_the_examples_have_the_digits_that_are_asked_for(typing: Typing) -> None:
    rules = open_catalogue("en").write(make_typing_rule(typing, 6))
    digits = [re.sub(r"e.*|\D", "", each).lstrip("0") for each in EXAMPLE.findall(rules)]
    assert "six significant digits" in rules
    assert {len(each) for each in digits} == {6}


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_examples_for_canvas_are_read_as_they_are_meant(language: Language) -> None:
    negative, positive, german, first, second = EXAMPLE.findall(rule("canvas", language))
    assert canvas_reads(negative, *ENGLISH) == Fraction("-0.866")
    assert canvas_reads(positive, *ENGLISH) == canvas_reads(german, *GERMAN) == Fraction("12.34")
    # What is warned of
    assert canvas_reads(first, *GERMAN) == canvas_reads(second, *ENGLISH) == 1234


@given(st.integers(-(10**8), 10**8))
def test_four_decimals_are_never_taken_for_a_thousandfold_in_canvas(digits: int) -> None:
    number = Fraction(digits, 10**4)
    point = f"{'-' if number < 0 else ''}{abs(digits) // 10**4}.{abs(digits) % 10**4:04d}"
    comma = point.replace(".", ",")
    assert canvas_reads(point, *ENGLISH) == canvas_reads(comma, *GERMAN) == number
    assert canvas_reads(point, *GERMAN) is canvas_reads(comma, *ENGLISH) is None


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_system_promises_what_it_does_not_read(language: Language) -> None:
    for typing, promised in POWERS_OF_TEN.items():
        assert ("e-3" in rule(typing, language)) == promised
        assert "beside" not in rule(typing, language)
    forbidden = {
        "en": ("no comma", "no unit", "no superscripts", "no other minus"),
        "zh": ("不要用逗号", "不要写单位", "不要用上标", "不要用其他减号"),
    }
    assert [words for words in forbidden[language] if words not in rule("moodle", language)] == []


def test_as_many_digits_are_asked_for_as_the_tolerance_takes() -> None:
    one = question("P", "q1", (SPEED,), rule="Right within 1 %.", digits=5)
    assert "at least five significant digits" in write_rules(one, "moodle", "en")
    assert write_rules(one, "moodle", "en").endswith("no other minus sign. Right within 1 %.")
    assert "至少保留五位有效数字" in write_rules(one, "blackboard", "zh")


@pytest.mark.parametrize(
    ("system", "words"),
    [
        ("moodle-xml", "no comma, no unit, no superscripts, no other minus sign"),
        ("qti12", "Never type exactly three decimals"),
        ("qti21", "with a decimal point, in the stated unit"),
        ("blackboard", "No powers of ten"),
    ],
)
def test_every_quiz_says_how_its_system_reads_numbers(
    small_class: Path, tmp_path: Path, system: str, words: str
) -> None:
    target = tmp_path / "quiz.zip"
    put = kinegrade("quiz", small_class / "EXAM", "--to", system, "-o", target)
    assert put.exit_code == 1, put.stderr
    packed = target.read_bytes().startswith(b"PK")
    assert words in (listing(target) if packed else target.read_text(encoding="utf-8"))
