"""Columns that answer nothing, and what is said of them."""

from __future__ import annotations

from fractions import Fraction

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.keyed_exam import KeyedExam
from kinegrade.files.tables import parse_table
from kinegrade.grading.sheets.columns import find_columns
from kinegrade.grading.sheets.extra_columns import find_extra_columns
from tests.said import said

ASKS = tuple(
    Ask(question, ask, "m/s", Fraction(1))
    for question, ask in (("q1", "v_B"), ("q1", "omega_AB"), ("q2", "omega_AB"))
)


def test_no_two_columns_are_said_to_be_the_same_ask() -> None:
    table = parse_table(b"student,v_B,omega_AB,OMEGA_AB,omega_AB\n7,1,2,3,4\n", "answers.csv")
    told = find_extra_columns(table, find_columns(table, ASKS), KeyedExam(ASKS, ()))
    assert [(each.content, said(each.done)) for each in told] == [
        ("2: 2", 'ignored; head it "q1.omega_AB" if that one is meant'),
        ("2: 3", 'ignored; head it "q2.omega_AB" if that one is meant'),
        ("2: 4", 'ignored; head it "q1.omega_AB" if that one is meant'),
    ]
