"""What an exam folder writes is what it reads again: every field of its records, digit by digit."""

from __future__ import annotations

import json
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import msgspec
import pytest

from kinegrade.exam.choices import Choice
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.contents import CONTENTS
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.key.exact_keys import read_key_line
from kinegrade.exam.folder.key.lines import (
    KeyLine,
    KeyQuestion,
    StatedAnswer,
    StatedNumber,
    StatedTolerance,
)
from kinegrade.exam.folder.records import (
    Candidate,
    ExamHead,
    ExamQuestion,
    HandQuestion,
    PaperBefore,
)
from kinegrade.exam.folder.writing import encode_head, encode_line, make_decimal
from tests.small_class import contents

HEAD = ExamHead(
    format=2,
    kinegrade="0.2.0",
    warning="gives the key away",
    title='Mid"term\n',
    course="力学",
    date="2026-05-01",
    kind="homework",
    due="2026-05-08 18:00 +08:00",
    language="zh",
    paper_size="letter",
    engine="latex",
    pages=4,
    method="pole",
    cycle=True,
    secret="00" * 32,
    label="spring",
    codes="11" * 32,
    versions=("A", "B"),
    credit={"follow-through": "1/2", "mistakes": {"sense-reversed": "1/4"}},
    scale={"kind": "hundred", "pass": "3/5"},
    solutions=True,
    questions=(
        ExamQuestion(
            question="q1",
            template="slider-crank",
            points=Fraction(11, 2),
            combinations=21780,
            good=1,
            refused={"mistake": 1},
            asks=(
                Ask("q1", "v_B", "m/s", Fraction(3), "not negative", "magnitude", bonus=True),
                Ask("q1", "a_B", "m/s^2", Fraction(5, 2), "to the right", bonus=True),
            ),
            bonus=True,
        ),
        ExamQuestion(question="q3", asks=(Ask("q3", "v_B", "m/s", Fraction(3)),)),
    ),
    students=(
        Candidate(
            "=2",
            "王伟",
            "wei@example.org",
            "WJPK-SNPQ",
            "A",
            "papers/%3D2.pdf",
            group="B",
            room="Hall 7",
            seat="3",
            language="zh",
            extra_time="25 %",
            print_format="large-print",
            was_spare=True,
            formerly=("0012354",),
        ),
    ),
    spares=(Candidate("spare-1", "", paper="B-C9PV-269B", file="papers/spare-1.pdf"),),
    by_hand=(HandQuestion("q2", Fraction(5), "Velocity poles", bonus=True),),
    choices=(Choice(("q1", "q3"), 1),),
    earlier={"slider-crank": ({"r": "0.35"},)},
    papers_before=(PaperBefore("007", "K7Q2-9FHM", 1),),
    corrections=1,
    forgotten=True,
    known_as="5c0ffee5",
    unprinted=True,
    given={"templates/slider-crank.toml": "0e"},
    editable={"bank.toml": "0f"},
)
ANSWER = StatedAnswer(
    exact="sqrt(3)",
    value=Decimal("1.7320508075688772"),
    unit="m/s",
    decimal="1.732050807568877293527446341505872366943",
    tolerance=StatedTolerance(Decimal("0.01"), Decimal("2.5e-7"), 3),
    period=Decimal("6.283185307179586476925286766559005768394"),
    points=Decimal("2.5"),
    mistakes={"wrong-pole": "6.86616684"},
)
LINE = KeyLine(
    student="=2",
    paper="A-WJPK-SNPQ",
    version="A",
    place=17,
    printed=("q1",),
    questions=(
        KeyQuestion(
            question="q1",
            template="slider-crank",
            parameters={"r": StatedNumber("7/20", Decimal("0.35"), "m")},
            drawn={"r": "0.35"},
            asks={"v_B": ANSWER},
        ),
    ),
)


def fields_left_at_their_default(record: msgspec.Struct) -> set[str]:
    return {
        field.name
        for field in msgspec.structs.fields(record)
        if getattr(record, field.name) in (field.default, None)
    }


@pytest.mark.parametrize(
    ("record", "left"),
    [
        (HEAD, {"reproducible", "seed"}),  # the other kinds of secrets
        (HEAD.questions[0], set()),
        (HEAD.students[0], set()),
        (LINE, set()),
        (LINE.questions[0], set()),
        (ANSWER, set()),
    ],
)
def test_these_records_have_every_field(record: Any, left: set[str]) -> None:
    """Or a new field would go unseen through the tests below."""
    assert fields_left_at_their_default(record) == left


def test_a_head_is_read_as_it_was_written(tmp_path: Path) -> None:
    (tmp_path / "exam.json").write_bytes(encode_head(HEAD))
    assert open_exam(tmp_path).head == HEAD


def test_points_stand_in_the_head_as_numbers_and_the_question_once() -> None:
    question = json.loads(encode_head(HEAD))["questions"][0]
    assert question["points"] == 5.5
    said = {"sign": "not negative", "convention": "magnitude"}
    assert question["asks"][0] == {"ask": "v_B", "unit": "m/s", "points": 3, **said}
    assert question["asks"][1]["convention"] is None


def test_a_line_is_read_as_it_was_written_digit_by_digit() -> None:
    text = encode_line(LINE)
    assert text.count(b"\n") == 1
    assert read_key_line(text) == LINE
    assert b'"value": 1.7320508075688772, ' in text
    assert b'"tolerance": {"relative": 0.01, "absolute": 2.5E-7, "figures": 3}' in text


def test_what_a_folder_does_not_keep_stands_nowhere_in_it() -> None:
    bare = KeyLine(student="7", questions=())
    assert encode_line(bare) == b'{"student": "7", "questions": []}\n'


@pytest.mark.parametrize(
    ("number", "text"), [(Fraction(3), "3"), (Fraction(5, 2), "2.5"), (Fraction(1, 1000), "0.001")]
)
def test_amounts_are_written_as_people_write_them(number: Fraction, text: str) -> None:
    assert str(make_decimal(number)) == text


def test_a_generated_folder_holds_nothing_but_what_is_named(small_class: Path) -> None:
    assert {name.split("/")[0] for name in contents(small_class / "EXAM")} <= set(CONTENTS)
