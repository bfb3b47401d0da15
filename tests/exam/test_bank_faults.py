"""What is wrong with a bank: every fault is told at once, with its place and with what was expected."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import BankError
from kinegrade.exam.bank.bank import MAX_BYTES, read_bank
from tests.exam.written_banks import HEAD, QUESTION, SHARE, faults

AMOUNT = (
    "expected a number of zero or more like 2.5, at most 9 digits before the point and 12 after it"
)


KIND = (
    "expected position, velocity, acceleration or a table of asks with their points, "
    "like { v_B = 3 }"
)


ONE_OF = (
    'expected one of template = "...", any = [...], family = "...", tag = "...", text = "..." '
    "and a table steps"
)


HONEST = (
    "honest widens a relative tolerance only, and significant figures are not widened - "
    'expected a table like { relative = "1 %", honest = true }'
)


def test_every_fault_is_told_at_once(tmp_path: Path) -> None:
    found = faults(
        tmp_path,
        """
titel = "Midterm"
shuffle = "yes"
versions = 27
engine = "word"
course = { ef = "Mechanics" }
date = 3
tolerance = { relative = "100 %", size = 1 }
[[questions]]
tempalte = "slider-crank"
[[questions]]
template = "slider-crank"
asks = { v_C = 3, v_B = 0, omega_AB = "2 %", a_B = { points = 1001, weight = 2 } }
draw = { q = [1], k = [1, 1], r = ["x"], phi = "90 .. 0 step 15" }
tolerance = { relative = "0 %" }
points = 3
number = 2
""",
    )
    assert found == [
        'bank.toml:2: titel: unknown key - did you mean "title"?',
        'bank.toml:3: shuffle: "yes" - expected true or false',
        "bank.toml:4: versions: 27 - expected a whole number from 1 to 26",
        'bank.toml:5: engine: "word" - expected typst or latex',
        'bank.toml:6: course: unknown: "ef" - expected a language with a catalogue - '
        "known here: de, en, zh",
        'bank.toml:7: date: 3 - expected a text or a date, like "spring 2026" or 2026-05-01',
        "bank.toml:8: tolerance.size: unknown key - known here: absolute, figures, "
        "honest, relative",
        'bank.toml:10: questions[1].tempalte: unknown key - did you mean "template"?',
        'bank.toml:13: questions[2].asks.v_C: unknown ask of slider-crank - did you mean "v_B"? '
        "(known here: a_B, alpha_AB, omega_AB, v_B)",
        "bank.toml:13: questions[2].asks.v_B: 0 - expected points above 0, at most 1000",
        f'bank.toml:13: questions[2].asks.omega_AB: "2 %" - {AMOUNT}',
        "bank.toml:13: questions[2].asks.a_B.weight: unknown key - known here: points, tolerance",
        "bank.toml:13: questions[2].asks.a_B.points: 1001 - expected points above 0, at most 1000",
        "bank.toml:14: questions[2].draw.q: unknown parameter - known here: alpha, k, omega, phi, r",
        "bank.toml:14: questions[2].draw.k: 2 values - expected 1 to 2000 of them, each once",
        'bank.toml:14: questions[2].draw.r: unknown name "x": known here: pi',
        'bank.toml:14: questions[2].draw.phi: "90 .. 0 step 15" - expected a step above zero, '
        "the last value not before the first, and at most 2000 values",
        "bank.toml:15: questions[2].tolerance: allows nothing - expected a tolerance above zero",
        "bank.toml:16: questions[2].points: asks gives the points already "
        "- leave one of the two out",
        "bank.toml:17: questions[2].number: unknown key - known here: asks, bonus, draw and 6 more",
    ]


@pytest.mark.parametrize(
    ("line", "fault"),
    [
        ("questions = 3", ":3: questions: 3 - expected tables [[questions]]"),
        ("questions = []", ":3: questions: 0 tables - expected 1 to 50 tables [[questions]]"),
        (
            "[[questions]]\n" * 51,
            ":3: questions: 51 tables - expected 1 to 50 tables [[questions]]",
        ),
        (
            QUESTION + "asks = 3",
            f":5: questions[1].asks: 3 - {KIND}",
        ),
        (
            QUESTION + "asks = {}",
            f":5: questions[1].asks: a table - {KIND}",
        ),
        (
            QUESTION + 'asks = "position"',
            ":5: questions[1].asks: slider-crank gives points to nothing of this - expected a "
            "table of asks with their points, like { v_B = 3 }",
        ),
        (
            QUESTION + "points = 3",
            ":5: questions[1].points: slider-crank asks 4 quantities - expected a point for each",
        ),
        (
            QUESTION + "points = 9.5",
            ":5: questions[1].points: 9.5 - expected a whole number from 1 to 1000",
        ),
        (QUESTION + 'family = "rolling"', f":3: questions[1]: template and family - {ONE_OF}"),
        ("[[questions]]\nnumber = 2", f":3: questions[1]: no template - {ONE_OF}"),
        (
            "[[questions]]\ntag = 3",
            ':4: questions[1].tag: 3 - expected a text in quotation marks, "..."',
        ),
        (
            '[[questions]]\ntag = "velocty"',
            ':4: questions[1].tag: no shipped template has the tag "velocty" - did you mean '
            '"velocity"?',
        ),
        (
            '[[questions]]\nfamily = "rolling"\nwithout = ["slider-crank", 3]',
            ':5: questions[1].without[2]: 3 - expected a text in quotation marks, "..."',
        ),
        (
            '[[questions]]\nfamily = "rolling"\nasks = "sped"',
            ':5: questions[1].asks: "sped" - expected position, velocity or acceleration',
        ),
        (
            QUESTION + "draw = [1]",
            ":5: questions[1].draw: a list - expected a table like { k = [2, 3] }",
        ),
        (
            QUESTION + "tolerance = 0.01",
            ':5: questions[1].tolerance: 0.01 - expected a table like { relative = "1 %" }, '
            '{ absolute = 0.01 }, { figures = 3 } or "honest"',
        ),
        (
            QUESTION + "tolerance = { figures = 1 }",
            ":5: questions[1].tolerance.figures: 1 - expected a whole number from 2 to 6",
        ),
        (
            QUESTION + "tolerance = { figures = 3.0 }",
            ":5: questions[1].tolerance.figures: 3.0 - expected a whole number from 2 to 6",
        ),
        ("carry = 2", ":3: carry: 2 - expected a whole number from 3 to 6"),
        ("carry = 7", ":3: carry: 7 - expected a whole number from 3 to 6"),
        ('carry = "four"', ':3: carry: "four" - expected a whole number from 3 to 6'),
        (
            'tolerance = "honestly"',
            ':3: tolerance: "honestly" - expected a table like { relative = "1 %" }, '
            '{ absolute = 0.01 }, { figures = 3 } or "honest"',
        ),
        (
            QUESTION + 'tolerance = { relative = "1 %", honest = "yes" }',
            ':5: questions[1].tolerance.honest: "yes" - expected true or false',
        ),
        (QUESTION + "tolerance = { honest = true }", f":5: questions[1].tolerance: {HONEST}"),
        (
            QUESTION + "tolerance = { absolute = 0.1, honest = true }",
            f":5: questions[1].tolerance: {HONEST}",
        ),
        (
            QUESTION + "tolerance = { relative = 0.01, figures = 3, honest = true }",
            f":5: questions[1].tolerance: {HONEST}",
        ),
        (
            QUESTION + "tolerance = {}",
            ":5: questions[1].tolerance: allows nothing - expected a tolerance above zero",
        ),
        (
            QUESTION + 'tolerance = { relative = "100 %" }',
            ":5: questions[1].tolerance: a relative tolerance of 100 % - expected one below 100 %",
        ),
        (
            QUESTION + 'tolerance = { relative = "-1 %" }',
            f':5: questions[1].tolerance.relative: "-1 %" - {SHARE}',
        ),
        (
            QUESTION + 'tolerance = { relative = "1/3" }',
            ":5: questions[1].tolerance: too finely stated - expected decimals of at most 15 digits",
        ),
        (
            QUESTION + "asks = { v_B = 999.1234567890123 }",
            f":5: questions[1].asks.v_B: 999.1234567890123 - {AMOUNT}",
        ),
        (
            QUESTION + "tolerance = { absolute = 123456.123456789012 }",
            ":5: questions[1].tolerance: too finely stated - expected decimals of at most 15 digits",
        ),
        (
            QUESTION + "tolerance = { relative = nan }",
            f":5: questions[1].tolerance.relative: nan - {SHARE}",
        ),
        (
            QUESTION + 'tolerance = { absolute = "1 %" }',
            f':5: questions[1].tolerance.absolute: "1 %" - {AMOUNT}',
        ),
        (
            QUESTION + "asks = { v_B = true }",
            f":5: questions[1].asks.v_B: true - {AMOUNT}",
        ),
        (
            QUESTION + f"asks = {{ v_B = 0x{'F' * 9000} }}",
            ": a whole number of more than 60 digits: round it - expected a bank file in TOML - fix it",
        ),
        (
            QUESTION + f"draw = {{ k = [0x{'F' * 9000}] }}",
            ": a whole number of more than 60 digits: round it - expected a bank file in TOML - fix it",
        ),
        (
            QUESTION + 'asks = { "v\\nB" = 1 }',
            ':5: questions[1].asks.v·B: unknown ask of slider-crank - did you mean "v_B"? '
            "(known here: a_B, alpha_AB, omega_AB, v_B)",
        ),
    ],
)
def test_a_fault_says_what_was_expected(tmp_path: Path, line: str, fault: str) -> None:
    assert f"bank.toml{fault}" in faults(tmp_path, HEAD + line)


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        (b"\xff\xfe\x00", "not UTF-8 at byte 0 - expected a bank file in UTF-8 - fix it"),
        (b"title = ", "Invalid value (at end of document) - expected a bank file in TOML"),
        (b"title = " + b"1" * 5000, "a whole number of more than 60 digits: round it"),
        (b"a = " + b"[" * 20000, "nested too deeply: write it more simply"),
        (
            b"#" * (MAX_BYTES + 1),
            f"too large - expected a bank file of at most {MAX_BYTES} bytes - check",
        ),
        (b"", 'title: missing - expected a text, or texts by language like { en = "..." }'),
    ],
)
def test_what_is_no_bank_is_refused(tmp_path: Path, content: bytes, problem: str) -> None:
    file = tmp_path / "bank.toml"
    file.write_bytes(content)
    with pytest.raises(BankError) as caught:
        read_bank(file)
    assert caught.value.problems[0].startswith(f"{file}: {problem}")


def test_a_bank_that_is_not_there_is_refused(tmp_path: Path) -> None:
    for file, reason in (
        (tmp_path / "none.toml", "No such file or directory"),
        (tmp_path, "Is a directory"),
    ):
        with pytest.raises(
            BankError, match=rf"cannot be read \({reason}\) - expected a bank file - check the name"
        ):
            read_bank(file)


@pytest.mark.parametrize(
    ("written", "fault"),
    [
        ('"half"', 'credit: "half" - expected a table like { follow-through = "1/2" }'),
        (
            "{ follow-trough = 1 }",
            'credit.follow-trough: unknown key - did you mean "follow-through"?',
        ),
        (
            "{ wrong-unit = 2 }",
            f"credit.wrong-unit: 2 - {SHARE}",
        ),
        (
            '{ wrong-unit = "1/0" }',
            f'credit.wrong-unit: "1/0" - {SHARE}',
        ),
        (
            "{ mistakes = 1 }",
            'credit.mistakes: 1 - expected a table like { coriolis-halved = "1/2" }',
        ),
        (
            "{ mistakes = { coriolis-halfed = 1 } }",
            "credit.mistakes.coriolis-halfed: unknown mistake - "
            'did you mean "coriolis-halved", "coriolis-dropped" or "coriolis-reversed"?',
        ),
    ],
)
def test_faults_of_credit_are_told(tmp_path: Path, written: str, fault: str) -> None:
    (found,) = faults(tmp_path, f"{HEAD}credit = {written}\n{QUESTION}")
    assert found.startswith(f"bank.toml:3: {fault}")


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("title =", "titel =", 'bank.toml:1: titel: unknown key - did you mean "title"?'),
        (
            "[[questions]]",
            "[[question]]",
            'bank.toml:4: question: unknown key - did you mean "questions" or "versions"?',
        ),
        (
            "relative =",
            "realtive =",
            'bank.toml:3: tolerance.realtive: unknown key - did you mean "relative"? '
            "(known here: absolute, figures, honest, relative)",
        ),
    ],
)
def test_one_misspelt_key_of_a_bank_is_one_message(
    tmp_path: Path, old: str, new: str, fault: str
) -> None:
    text = (
        'title = "Quiz"\ncourse = "Mechanics"\ntolerance = { relative = "1 %" }\n'
        '[[questions]]\ntemplate = "slider-crank"\n'
    )
    assert faults(tmp_path, text.replace(old, new)) == [fault]
