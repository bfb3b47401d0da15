"""Two markings of one class held against each other, and earlier totals that stand: through real
files.
"""

from __future__ import annotations

import csv
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kinegrade.errors import TableError
from kinegrade.grading.kept_totals import EarlierTotals, never_lower
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.lms.grades import moodle
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.rows import StudentTotal
from kinegrade.reports.comparison import compare
from kinegrade.reports.comparison_writing import (
    HEADER,
    write_comparison_csv,
    write_comparison_text,
)
from tests.grading.policies import marked, policy_of, regraded
from tests.small_class import kinegrade

WORDS = open_catalogue(ENGLISH)
ANSWERS = """student,name,q1.v_B,q1.omega_AB,q2.a_B
007,王伟,1.76,0,-0.125
0012,"O'Neil, Zoë",9,0,-0.125
S9,x,1.7 m,0,
12,Ann,,,"=1+1"
"""
POLICY = """
tolerance.relative = "2 %"
[questions.q1.asks.omega_AB]
points = 1.5
[questions.q2.asks.a_B]
accept = [{ value = "0", student = "S9" }]
"""
TABLE = """\
student  name           what         before  after  change  why
007      王伟           total           5.5      8    +2.5  out of 9.5 -> 8
                        q1.v_B            0      4      +4  wrong -> right: key 1.73205, difference 0.0279492, \
allowed 0.034641 by the policy
                        q1.omega_AB       3    1.5    -1.5  right, worth 3 -> 1.5: key 0, difference 0, allowed 0.002 \
by the policy
0012     O'Neil, Zoë    total           5.5      4    -1.5  out of 9.5 -> 8
                        q1.omega_AB       3    1.5    -1.5  right, worth 3 -> 1.5: key 0, difference 0, allowed 0.002 \
by the policy
S9       =HYPERLINK(1)  total             3    1.5    -1.5  out of 9.5 -> 8
                        q1.omega_AB       3    1.5    -1.5  right, worth 3 -> 1.5: key 0, difference 0, allowed 0.002 \
by the policy
12       Ann            total             0      0       0  out of 9.5 -> 8
                        q1.omega_AB       0      0       0  blank, worth 3 -> 1.5
1 up, 2 down, 1 unchanged; mean change -0.125 points, +5.35 percentage points"""


@pytest.fixture
def answered(exam_folder: Path) -> Path:
    """The small exam's folder, with answers beside it."""
    (exam_folder.parent / "answers.csv").write_text(ANSWERS, encoding="utf-8")
    return exam_folder


def rows_of(file: Path) -> list[dict[str, str]]:
    with file.open(encoding="utf-8-sig", newline="") as stream:
        return list(csv.DictReader(stream))


def test_a_marking_does_not_differ_from_itself(answered: Path) -> None:
    marks = regraded(answered, "MARKS", POLICY)
    comparison = compare(MarksFolder(marks), MarksFolder(marks))
    assert comparison.changes == ()
    assert write_comparison_csv(comparison, WORDS).decode("utf-8-sig") == ",".join(HEADER) + "\n"
    assert write_comparison_text(comparison, WORDS) == (
        "0 up, 0 down, 4 unchanged; mean change 0 points, 0 percentage points"
    )


def test_who_changes_by_how_much_and_why(answered: Path) -> None:
    first, second = regraded(answered, "MARKS"), regraded(answered, "MARKS2", POLICY)
    assert write_comparison_text(compare(MarksFolder(first), MarksFolder(second)), WORDS) == TABLE
    back = compare(MarksFolder(second), MarksFolder(first))
    assert (back.up, back.down, back.mean_points) == (2, 1, Fraction(1, 8))
    assert [change.student for change in back.changes] == ["007", "0012", "S9", "12"]


def test_the_file_of_changes_has_verdicts_answers_and_reasons_of_both(answered: Path) -> None:
    first, second = regraded(answered, "MARKS"), regraded(answered, "MARKS2", POLICY)
    result = kinegrade("diff", first, second, "-o", answered.parent / "changes.csv")
    assert (result.exit_code, result.stdout, result.stderr) == (0, f"{TABLE}\n", "")
    total, answer, *_ = rows_of(answered.parent / "changes.csv")
    assert list(total.values()) == [
        "007",
        "王伟",
        "total",
        "5.5",
        "8",
        "+2.5",
        "9.5",
        "8",
        *[""] * 6,
    ]
    assert list(answer.values()) == [
        "007",
        "王伟",
        "q1.v_B",
        "0",
        "4",
        "+4",
        "4",
        "4",
        "wrong",
        "right",
        "1.76",
        "1.76",
        "key 1.73205, difference 0.0279492, allowed 0.0173205",
        "key 1.73205, difference 0.0279492, allowed 0.034641 by the policy",
    ]
    again = kinegrade("diff", first, second, "-o", answered.parent / "changes.csv")
    assert (again.exit_code, "already exists" in again.stderr) == (2, True)


def test_cells_of_the_file_do_not_run_in_a_spreadsheet(answered: Path) -> None:
    first, second = (
        regraded(answered, "MARKS"),
        regraded(answered, "MARKS2", "[questions.q2]\nvoid = 'drop'"),
    )
    rows = list(
        csv.DictReader(
            write_comparison_csv(compare(MarksFolder(first), MarksFolder(second)), WORDS)
            .decode("utf-8-sig")
            .splitlines()
        )
    )
    assert {row["name"] for row in rows if row["student"] == "S9"} == {"'=HYPERLINK(1)"}
    assert [row["response_after"] for row in rows if row["student"] == "12"] == ["", "'=1+1"]


def test_changes_are_shown_in_the_language_of_the_terminal_and_written_in_the_one_asked_for(
    answered: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = regraded(answered, "MARKS"), regraded(answered, "MARKS2")
    for name in ("grades.csv", "marks.csv"):
        text = (second / name).read_text(encoding="utf-8").replace("0012,", "0013,")
        (second / name).write_text(text, encoding="utf-8")
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    done = kinegrade("diff", first, second, "-o", answered.parent / "changes.csv")
    assert done.exit_code == 0, done.stderr
    assert "0 人上升、0 人下降、3 人不变；2 人仅在其中一份中" in done.stdout
    rows = rows_of(answered.parent / "changes.csv")
    assert rows[0]["reason_after"] == "only in the first"
    kinegrade("diff", first, second, "-o", answered.parent / "zh.csv", "--lang", "zh")
    assert rows_of(answered.parent / "zh.csv")[0]["reason_after"] == "仅在第一份中"


def test_students_and_asks_of_one_marking_only_are_told(answered: Path) -> None:
    first, second = regraded(answered, "MARKS"), regraded(answered, "MARKS2")
    for name in ("grades.csv", "marks.csv"):
        lines = (second / name).read_text(encoding="utf-8").splitlines(keepends=True)
        kept = [
            line.replace("0012,", "0013,")
            for line in lines
            if not line.startswith(("007,", "12,q2,a_B"))
        ]
        (second / name).write_text("".join(kept), encoding="utf-8")
    comparison = compare(MarksFolder(first), MarksFolder(second))
    told = [(change.student, *(ask.column for ask in change.asks)) for change in comparison.changes]
    assert told == [
        ("007", "q1.v_B", "q1.omega_AB", "q2.a_B"),
        ("0012", "q1.v_B", "q1.omega_AB", "q2.a_B"),
        ("12", "q2.a_B"),
        ("0013", "q1.v_B", "q1.omega_AB", "q2.a_B"),
    ]
    text = write_comparison_text(comparison, WORDS)
    assert text.endswith(
        "0 up, 0 down, 2 unchanged; 3 in one of the two only; "
        "mean change 0 points, 0 percentage points"
    )
    assert [line.split()[-3:] for line in text.splitlines() if " total " in line] == [
        ["in", "the", "first"],
        ["in", "the", "first"],
        ["in", "the", "second"],
    ]
    (unchanged,) = [line for line in text.splitlines() if line.startswith("12 ")]
    assert unchanged.split()[:3] == ["12", "Ann", "q2.a_B"]  # and no total of 0 and 0


def test_an_answer_of_another_row_is_shown(answered: Path) -> None:
    with (answered.parent / "answers.csv").open("a", encoding="utf-8") as stream:
        stream.write("12,Ann,1.73,\x1b[31m,\n")
    text = write_comparison_text(
        compare(
            MarksFolder(regraded(answered, "MARKS", "attempts = 'first'")),
            MarksFolder(regraded(answered, "MARKS2")),
        ),
        WORDS,
    )
    assert 'q1.v_B            0      4      +4  "" -> "1.73", blank -> right: key 1.73205' in text
    assert "\x1b" not in text


def test_nobody_falls_below_an_earlier_total(answered: Path) -> None:
    first = regraded(answered, "MARKS")
    second = regraded(
        answered, "MARKS2", "[questions.q1.asks.omega_AB]\nvoid = 'drop'", before=first
    )
    assert [row["total"] for row in rows_of(second / "grades.csv")] == [
        "3.7632",
        "3.7632",
        "2.0527",
        "0",
    ]
    kept = rows_of(second / "kept.csv")
    assert list(kept[0].values()) == [
        "007",
        "王伟",
        "5.5",
        "9.5",
        "2.5",
        "6.5",
        "3.7632",
        "earlier total kept: 5.5 of 9.5 before, 2.5 of 6.5 by this marking",
    ]
    assert [row["name"] for row in kept] == ["王伟", "O'Neil, Zoë", "'=HYPERLINK(1)"]
    assert "earlier total kept: 3 of 9.5 before, 0 of 6.5 by this marking" in write_comparison_text(
        compare(MarksFolder(first), MarksFolder(second)), WORDS
    )
    assert moodle.export(MarksFolder(second)).splitlines()[1] == (
        "007,王伟,3.7632,1: 0/4; 2: 2.5/2.5; an earlier total stands"
    )


def test_with_equal_points_the_earlier_total_itself_stands(answered: Path) -> None:
    first = regraded(answered, "MARKS", "tolerance.relative = '2 %'")
    second = regraded(answered, "MARKS2", before=first)
    assert [row["total"] for row in rows_of(second / "grades.csv")] == ["9.5", "5.5", "3", "0"]
    assert [row["student"] for row in rows_of(second / "kept.csv")] == ["007"]
    assert compare(MarksFolder(first), MarksFolder(second)).down == 0


def test_never_lower_through_the_command_line_may_replace_the_marks_it_looks_at(
    answered: Path,
) -> None:
    policy = answered.parent / "policy.toml"
    policy.write_text(
        "[questions.q1.asks.omega_AB]\nvoid = 'full'\n[questions.q2]\nvoid = 'drop'\n",
        encoding="utf-8",
    )
    arguments = (
        "grade",
        answered,
        answered.parent / "answers.csv",
        "-o",
        answered.parent / "MARKS",
    )
    assert kinegrade(*arguments).exit_code == 1
    result = kinegrade(
        *arguments, "--policy", policy, "--never-lower", answered.parent / "MARKS", "--force"
    )
    assert "kept.csv: 2 students keep an earlier total" in result.stderr
    assert kinegrade(*arguments, "--force").exit_code == 1
    assert not (answered.parent / "MARKS" / "kept.csv").exists()


def test_an_earlier_student_who_is_not_in_the_exam_is_a_complaint() -> None:
    marks, kept = never_lower(
        marked("007,2,0,30\n"), EarlierTotals({"008": total("008", Fraction(9), 9)})
    )
    assert kept == ()
    assert str(marks.complaints[0]) == (
        'grades.csv: student: student "008" has earlier marks but is not in the exam - nothing kept'
    )


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        (
            "grades.csv",
            None,
            "cannot be read (No such file or directory) - expected a folder made by kinegrade grade - "
            "check the name",
        ),
        (
            "grades.csv",
            "student,name,total\n1,x,2\n",
            "no column out_of - expected the file as kinegrade grade wrote it - grade again",
        ),
        (
            "grades.csv",
            "student,name,total,out_of\n1,x,2,-3\n",
            'grades.csv:2: out_of is "-3" - expected a number of zero or more - grade again',
        ),
        (
            "grades.csv",
            "student,name,total,out_of\n1,x,2\n",
            "grades.csv:2: the line has 3 cells, the header 4 - expected the file as kinegrade grade "
            "wrote it - grade again",
        ),
    ],
)
def test_a_folder_that_is_none_of_marks_is_refused(
    tmp_path: Path, name: str, content: str | None, reason: str
) -> None:
    if content is not None:
        (tmp_path / name).write_text(content, encoding="utf-8")
    with pytest.raises(TableError) as caught:
        _ = MarksFolder(tmp_path).totals
    assert str(caught.value).endswith(reason)
    assert str(caught.value).startswith(str(tmp_path))


def total(student: str, points: Fraction, out_of: int) -> StudentTotal:
    return StudentTotal(2, student, student, {}, points, Fraction(out_of), None, None, None)


AMOUNTS = st.fractions(0, 1, max_denominator=60)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.lists(st.tuples(AMOUNTS, st.integers(1, 40)), min_size=3, max_size=3),
    st.sampled_from(["", "[questions.q1]\nvoid = 'drop'", "[questions.q2.asks.phi]\npoints = 7"]),
)
def test_never_lower_never_lowers(
    tmp_path: Path, earlier: list[tuple[Fraction, int]], policy: str
) -> None:
    new = marked("007,2,0,30\nS9,2,9,\n12,,,30\n", policy_of(policy, tmp_path))
    before = {
        student: total(student, (share * out_of * 10**4 // 1) / Fraction(10**4), out_of)
        for student, (share, out_of) in zip(("007", "S9", "12"), earlier, strict=True)
    }
    marks, kept = never_lower(new, EarlierTotals(before))
    for alone, grade in zip(new.grades, marks.grades, strict=True):
        old = before[grade.student].share
        assert grade.total >= alone.total
        assert round(grade.total, 4) >= old * grade.out_of - Fraction(1, 20000)
        assert grade.kept is None or grade.total / grade.out_of >= old
    assert {each.student for each in kept} == {
        grade.student for grade in marks.grades if grade.kept is not None
    }
