"""The marking rule stands on the paper in words, and says what grading does."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.bank.bank import read_bank, read_kept_bank
from kinegrade.exam.printing.rules import (
    make_decimals_rule,
    make_marking_rule,
    make_percent,
    write_plain,
    write_rules,
)
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.template.library.library import load_template

BANK = """
title = "Midterm"
course = "Mechanics"
tolerance = { relative = "1 %" }
[[questions]]
template = "slider-crank"
asks = { v_B = 1, a_B = { points = 2, tolerance = { absolute = 0.05 } } }
"""


def write(message: Message, language: str) -> str:
    return open_catalogue(Language(language)).write(message)


@pytest.mark.parametrize(
    ("relative", "absolute", "english", "chinese"),
    [
        (
            "1/100",
            "0",
            "by at most 1 % of that value. Where larger terms cancel, so that the exact value is "
            "zero or less than 1 % of the largest of them",
            "不超过精确值的 1 %即判为正确。若较大的各项相互抵消，使精确值为零或小于其中最大项的 1 %，则允许偏差为该最大项的 1 %。",
        ),
        (
            "1/200",
            "1/500",
            "at most 0.5 % of that value, or by at most $0.002\\,\\unit{m/s}$, whichever is more.",
            "0.5 %（或不超过 $0.002\\,\\unit{m/s}$，取其大者）",
        ),
        (
            "0",
            "1/100000",
            "by at most $0.00001\\,\\unit{m/s}$.",
            "不超过 $0.00001\\,\\unit{m/s}$即",
        ),
    ],
)
def test_the_rule_in_words(relative: str, absolute: str, english: str, chinese: str) -> None:
    tolerance = Tolerance(Fraction(relative), Fraction(absolute))
    assert english in write(make_marking_rule(tolerance, "m/s"), "en")
    assert chinese in write(make_marking_rule(tolerance, "m/s"), "zh")


@pytest.mark.parametrize(
    ("tolerance", "english", "chinese"),
    [
        (
            Tolerance(Fraction(0), Fraction(0), 3),
            "an answer is right if it agrees with the exact value to 3 significant digits "
            "(where that is 1.2304, from 1.225 to 1.235). Where larger terms cancel, so that the "
            "exact value is zero or less than 0.5 % of the largest of them, 0.5 % of that term "
            "is allowed.",
            "答案与精确值在 3 位有效数字内一致（如精确值为 1.2304 时，从 1.225 到 1.235）即判为正确。"
            "若较大的各项相互抵消，使精确值为零或小于其中最大项的 0.5 %，则允许偏差为该最大项的 0.5 %。",
        ),
        (
            Tolerance(Fraction(1, 100), Fraction(0), 4),
            "(where that is 1.23404, from 1.2335 to 1.2345), or differs from it by at most 1 % "
            "of it. Where larger terms cancel, so that the exact value is zero or less than 1 % of",
            "（如精确值为 1.23404 时，从 1.2335 到 1.2345），或与其之差不超过精确值的 1 %，即判为正确。",
        ),
        (
            Tolerance(Fraction(1, 200), Fraction(1, 50), 2),
            "(where that is 1.204, from 1.15 to 1.25), or differs from it by at most 0.5 % of it "
            "or $0.02\\,\\unit{m/s}$. Where larger terms cancel, so that the exact value is zero or "
            "less than 5 % of",
            "或与其之差不超过精确值的 0.5 %或 $0.02\\,\\unit{m/s}$，即判为正确。",
        ),
    ],
)
def test_the_rule_of_significant_digits_in_words(
    tolerance: Tolerance, english: str, chinese: str
) -> None:
    assert english in write(make_marking_rule(tolerance, "m/s"), "en")
    assert chinese in write(make_marking_rule(tolerance, "m/s"), "zh")


@pytest.mark.parametrize(
    ("carry", "english", "chinese", "german"),
    [
        (
            "",
            "Carry at least four significant digits in every value that you write down. Write one "
            "number into each box, in the unit printed there, with four or five significant "
            "digits: 0.8660 or 0,8660. Do not",
            "计算中写下的每个数值都至少保留四位有效数字。每个答案框内填写一个数，单位已印在框内，"
            "取四位或五位有效数字，写成 0.8660 或 0,8660 均可；",
            "mit mindestens vier signifikanten Ziffern. Schreiben Sie in jedes Feld eine Zahl in "
            "der dort gedruckten Einheit, mit vier oder fünf signifikanten Ziffern: 0,8660 oder",
        ),
        (
            "carry = 3",
            "with three or four significant digits: 0.866 or 0,866.",
            "取三位或四位有效数字，写成 0.866 或 0,866 均可",
            "mit drei oder vier signifikanten Ziffern: 0,866 oder 0.866.",
        ),
        (
            "carry = 6",
            "Carry at least six significant digits in",
            "取六位或七位有效数字，写成 0.866025 或",
            "mit sechs oder sieben signifikanten Ziffern: 0,866025 oder",
        ),
    ],
)
def test_the_paper_says_how_many_figures_to_carry_and_to_give(
    tmp_path: Path, carry: str, english: str, chinese: str, german: str
) -> None:
    file = tmp_path / "bank.toml"
    file.write_text(carry + BANK, encoding="utf-8")
    bank = read_bank(file)
    assert english in write_rules(bank, "en")[0]
    assert chinese in write_rules(bank, "zh")[0]
    assert german in write_rules(bank, "de")[0]


def test_an_exam_of_an_earlier_version_asks_for_as_many_digits_as_its_tolerance_takes(
    tmp_path: Path,
) -> None:
    (tmp_path / "bank.toml").write_text(
        BANK.replace('relative = "1 %"', "figures = 6"), encoding="utf-8"
    )
    (tmp_path / "templates").mkdir()
    template = load_template("slider-crank")
    (tmp_path / "templates" / "slider-crank.toml").write_text(template.file.text, encoding="utf-8")
    chosen = {"q1": "slider-crank"}
    bank = read_kept_bank(tmp_path / "bank.toml", tmp_path / "templates", chosen)
    assert write_rules(bank, "en")[0].startswith("Carry at least seven significant digits")


def test_the_rules_leave_every_tolerance_to_the_rows(tmp_path: Path) -> None:
    file = tmp_path / "bank.toml"
    file.write_text(BANK, encoding="utf-8")
    bank = read_bank(file)
    english, chinese = write_rules(bank, "en"), write_rules(bank, "zh")
    assert len(english) == len(chinese) == 3
    assert english[-1].endswith(
        "less than 1 % of the largest of them, 1 % of that term is allowed."
    )
    assert "若较大的各项相互抵消" in chinese[-1]


def test_nothing_is_said_of_zero_where_amounts_alone_are_allowed(tmp_path: Path) -> None:
    file = tmp_path / "bank.toml"
    file.write_text(BANK.replace('relative = "1 %"', "absolute = 0.1"), encoding="utf-8")
    assert "terms cancel" not in "".join(write_rules(read_bank(file), "en"))


def test_the_rules_say_what_agreeing_to_digits_means(tmp_path: Path) -> None:
    file = tmp_path / "bank.toml"
    file.write_text(BANK.replace('relative = "1 %"', "figures = 3"), encoding="utf-8")
    assert write_rules(read_bank(file), "en")[-1] == (
        "“3 digits” means that the answer agrees with the exact value to 3 significant digits "
        "(where that is 1.2304, from 1.225 to 1.235)."
    )


def test_arrows_are_not_said_to_be_drawn_to_scale(tmp_path: Path) -> None:
    file = tmp_path / "bank.toml"
    file.write_text(BANK, encoding="utf-8")
    assert write_rules(read_bank(file), "en")[1].endswith(
        "Lengths in figures are drawn to scale; arrows and teeth are not."
    )


@given(
    st.fractions(min_value=Fraction(1, 10**6), max_value=Fraction(50)),
    st.fractions(min_value=-(10**6), max_value=10**6),
)
def test_an_answer_with_the_decimals_that_are_asked_for_is_right_whatever_its_size(
    allowed: Fraction, exact: Fraction
) -> None:
    rule = make_decimals_rule(allowed)
    assert rule is not None
    found = re.search(r"([0-9]+) decimals|(one decimal)|(before)", write(rule, "en"))
    assert found is not None
    count = int(found[1] or (1 if found[2] else 0))
    assert abs(round(exact, count) - exact) <= allowed


def test_a_tolerance_of_nothing_in_a_damaged_key_asks_for_no_decimals_and_comes_to_an_end() -> None:
    assert make_decimals_rule(Fraction(0)) is None


def test_amounts_are_printed_without_powers_of_ten_and_exactly() -> None:
    assert [
        write_plain(Fraction(text))
        for text in ("1/8", "9999", "0.000000001", "1234.123456789", "5")
    ] == ["0.125", "9999", "0.000000001", "1234.123456789", "5"]
    assert write(make_percent(Fraction(1, 200)), "en") == "0.5 %"
