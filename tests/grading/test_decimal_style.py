"""What 1,234 and 1.234 mean in a file: declared, or shown by a student's other answers, or by all
others that tell.
"""

from __future__ import annotations

import pytest

from kinegrade.grading.typed.answers import PAPERS_RULE, Reading, read
from kinegrade.grading.typed.decimal_style import Mark, find_file_style, gather_evidence
from kinegrade.sign_conventions import Convention
from tests.said import said


@pytest.mark.parametrize(("cells", "decimal", "groups"), [
    (["1,234", "1.234", "12", "x", ""], "", ""), (["0,5"], ",", ""), (["0.5"], ".", ""), (["v = 12,5 m/s"], ",", ""),
    (["v_2 = 12,5"], ",", ""), (["0，5"], ",", ""), ([",5"], ",", ""), (["0,5", "0.5"], ",.", ""),
    (["1,234.5"], ".", ","), (["1.234,5"], ",", "."), (["1,234,567"], "", ","), (["1 234,5"], ",", " "),
    (["1'234"], "", ""), (["0,5", "1,234.5"], ",.", ","), (["1,23,4"], "", ""), (["1,234e3"], ",", ""),
    (["1,234×10^3"], ",", ""), ([","], "", ""), (["9" * 300 + ",5"], "", ""),
])  # fmt: skip
def test_only_cells_beyond_doubt_count(cells: list[str], decimal: str, groups: str) -> None:
    found = gather_evidence(cells)
    assert (found.decimal, found.groups) == (set(decimal), set(groups))


def reading(
    typed: str, own: list[str], others: list[list[str]], declared: Mark | None = None
) -> Reading:
    """`typed` by a student with the answers `own`, in a file with `others`."""
    rows = [[typed, *own], *others]
    return read(typed, "m", find_file_style(rows, declared).of_row(rows[0]))


@pytest.mark.parametrize(("typed", "own", "others", "declared", "value", "text"), [
    ("1,234", [], [], None, 1.234, "a comma is the decimal mark, and nothing in the file says "
                                   "otherwise"),
    ("1.234", [], [], None, 1.234, ""),
    ("1,234", ["0,5"], [["0.5"]] * 9, None, 1.234, ""),
    ("1,234", ["0,5", "0.5"], [], None, 1.234, ""),
    ("1,234", [], [["0.5"]], "comma", 1.234, ""),
    ("1,234", ["0.5"], [], None, 1234, "the point is the decimal mark in this student's other "
                                       "answers"),
    ("1,234", ["0.5"], [["12"]] * 9, None, 1234, "the point is the decimal mark in this student's "
                                                 "other answers"),
    ("1,234", ["2,345.6"], [["0,5"]] * 9, None, 1234, "this student groups digits by commas "
                                                      "elsewhere"),
    ("1,234", ["12"], [["0.5"], ["2.5"]], None, 1234,
     "the point is the decimal mark in the answers of 2 students, and the comma in no student's"),
    ("1,234", [], [["1,234,567"], ["12"]], None, 1.234,
     "a comma is the decimal mark, as the papers say; but it groups digits in the answers of 1 student"),
    ("1.234", [], [["1.234.567"], ["12"]], None, 1.234,
     "a point is the decimal mark, as the papers say; but it groups digits in the answers of 1 student"),
    ("1.234", [], [["1.234.567"], ["1.234,5"]], None, 1.234,
     "a point is the decimal mark, as the papers say; but it groups digits in the answers of 2 students"),
    ("1.234", ["0.5"], [["1.234.567"], ["1.234.567"]], None, 1.234, ""),
    ("1.234", [], [["1.234.567"], ["0.5"]], None, 1.234, ""),
    # One of four tells: too little to group others' digits
    ("1,234", [], [["0.5"], ["12"], ["13"]], None, 1.234,
     "a comma is the decimal mark, as the papers say; so it is in the answers of 0 students, "
     "the point in those of 1 student"),
    ("1,234", ["0.5"], [["0,5"]], None, 1.234,
     "a comma is the decimal mark, as the papers say; but this student's other answers have a "
     "decimal point"),
    ("1.234", ["0,5"], [["0.5"]], None, 1.234,
     "a point is a decimal point, as the papers say; but this student's other answers have a decimal comma"),
    ("1.234", ["0,5", "0.5"], [["0.5"]], None, 1.234, ""),
    ("1.234", ["0,5"], [["2,5"]], None, 1.234,
     "a point is a decimal point, as the papers say; all other unambiguous answers have a decimal "
     "comma (if points group digits: --decimal comma)"),
    ("1.234", ["2.345,6"], [["0.5"]] * 9, None, 1234, "this student groups digits by points "
                                                      "elsewhere"),
    ("1,234", ["0,5"], [], "point", 1234, "the decimal mark was declared to be the point"),
    ("1.234", [], [["0.5"]], "comma", 1234, "the decimal mark was declared to be the comma"),
])  # fmt: skip
def test_one_lone_mark(
    typed: str,
    own: list[str],
    others: list[list[str]],
    declared: Mark | None,
    *,
    value: float,
    text: str,
) -> None:
    found = reading(typed, own, others, declared)
    assert float(found.value or 0) == value
    assert said(found.remark) == (text and f"read as {found.read_as}: {text}")


@pytest.mark.parametrize(
    ("typed", "convention", "text"),
    [
        ("-2,236", None, "read as -2.236: "),
        ("−2,236 m/s", None, "read as -2.236: "),
        ("v = -2,236E0", None, ""),
        ("-2 236", None, "read as -2236: a blank groups"),
        ("-2,236 mm/s", None, "read as -2.236: "),
        ("2,236 rad/s clockwise", "ccw", "read as -2.236: "),
        ("-2,236*sqrt(3)", None, '"2,236" read as 2.236: '),
    ],
)
def test_a_minus_is_in_the_remark_about_its_number(
    typed: str, convention: Convention | None, text: str
) -> None:
    found = read(typed, "rad/s" if convention else "m/s", PAPERS_RULE, convention)
    assert found.value is not None
    assert found.value < 0
    assert said(found.remark).startswith(text)
    assert bool(found.remark) == bool(text)


def test_commas_in_both_ways_are_unreadable() -> None:
    assert said(reading("1,234", ["1,234.5", "0,5"], []).reason) == (
        '"1,234" can mean 1.234 or 1234: this student uses commas in both ways; ask, or declare '
        "the decimal mark"
    )


@pytest.mark.parametrize("others", [[], [["0,5"]] * 5, [["0.5"]] * 5, [["0,5"], ["0.5"]]])
def test_what_leaves_no_doubt_depends_on_no_style(others: list[list[str]]) -> None:
    for typed, value in (
        ("0,866", 0.866),
        ("0.866", 0.866),
        ("1,234.5", 1234.5),
        ("1.234,5", 1234.5),
        ("12", 12),
    ):
        found = reading(typed, [], others)
        assert (float(found.value or 0), found.remark) == (value, "")
