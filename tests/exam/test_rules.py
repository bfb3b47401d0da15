"""The marking rule stands on the paper in words, and says what grading does."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.exam.bank import read_bank
from kinegrade.exam.blueprint import Tolerance
from kinegrade.exam.rules import marking_rule, percent, plain, rules

BANK = """
title = "Midterm"
course = "Mechanics"
tolerance = { relative = "1 %" }
[[questions]]
template = "slider-crank"
asks = { v_B = 1, a_B = { points = 2, tolerance = { absolute = 0.05 } } }
"""


@pytest.mark.parametrize(("relative", "absolute", "english", "chinese"), [
    ("1/100", "0", "by at most 1 % of that value. Where the exact value is zero, it may differ by at most 1 % of",
     "不超过精确值的 1 %即判为正确"),
    ("1/200", "1/500", "at most 0.5 % of that value, or by at most 0.002 in the unit of the table, whichever is more.",
     "0.5 %（或不超过 0.002，以表中单位计，取其大者）"),
    ("0", "1/100000", "by at most 0.00001 in the unit of the table.", "不超过 0.00001（以表中单位计）"),
])
def test_the_rule_in_words(relative: str, absolute: str, english: str, chinese: str) -> None:
    tolerance = Tolerance(Fraction(relative), Fraction(absolute))
    assert english in marking_rule(tolerance, "en")
    assert chinese in marking_rule(tolerance, "zh")


def test_an_ask_with_its_own_tolerance_is_named(tmp_path: Path) -> None:
    file = tmp_path / "bank.toml"
    file.write_text(BANK, encoding="utf-8")
    bank = read_bank(file)
    english, chinese = rules(bank, "en"), rules(bank, "zh")
    assert len(english) == len(chinese) == 4
    assert english[-1] == ("For q1, $a_{B}$: an answer is right if it differs from the exact value by at most 0.05 "
                           "in the unit of the table.")
    assert chinese[-1].startswith("q1, $a_{B}$：答案与精确值之差不超过 0.05")


def test_a_question_whose_asks_share_a_tolerance_is_named_once(tmp_path: Path) -> None:
    file = tmp_path / "bank.toml"
    file.write_text(BANK.replace(", tolerance = { absolute = 0.05 } } }", " } }\ntolerance = { relative = \"2 %\" }"),
                    encoding="utf-8")
    english = rules(read_bank(file), "en")
    assert len(english) == 4
    assert english[-1].startswith("For q1: an answer is right if it differs from the exact value by at most 2 %")


def test_amounts_are_printed_without_powers_of_ten_and_exactly() -> None:
    assert [plain(Fraction(text)) for text in ("1/8", "9999", "0.000000001", "1234.123456789", "5")] == [
        "0.125", "9999", "0.000000001", "1234.123456789", "5"]
    assert percent(Fraction(1, 200)) == "0.5 %"
