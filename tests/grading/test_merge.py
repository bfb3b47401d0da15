"""The marks of a make-up exam, put together with those of the exam."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import Result

from kinegrade.marks_folder.folder import open_marks
from tests.grading.marked_folder import RIGHT, Page, mark_class
from tests.small_class import generate, kinegrade, table, write_class

LATER = {"007": RIGHT, "S9": ("1.732", "9", "9")}
FIRST = {"007": (), "0012": RIGHT, "S8": ("1.732", "9", "9")}
BANK = """title = "Midterm"
course = "Mechanics"
tolerance = {{ relative = "1 %" }}
[[questions]]
template = "{}"
asks = {{ v_B = 3 }}
"""


@pytest.fixture
def both(tmp_path: Path) -> Path:
    """A folder with first/ and later/, an exam and its marks in each; 007 was absent at first, S9
    was not in the first exam.
    """
    mark_class(tmp_path / "first", FIRST)
    mark_class(tmp_path / "later", LATER)
    return tmp_path


def merge(folder: Path, *options: str) -> Result:
    """Both MARKS into ALL."""
    files = folder / "first" / "MARKS", folder / "later" / "MARKS", "-o", folder / "ALL"
    return kinegrade("merge", *files, *options)


def totals(folder: Path) -> dict[str, tuple[str, str]]:
    """Points and status by student."""
    rows = table(folder / "ALL" / "grades.csv")
    return {row["student"]: (row["total"], row["status"]) for row in rows}


def test_who_was_absent_has_the_marks_of_the_make_up_exam(both: Path) -> None:
    done = merge(both)
    assert done.exit_code == 0, done.stderr
    assert f"{both / 'ALL'}: 4 students, 2 of whom by other marks" in done.stderr
    assert totals(both) == {
        "0012": ("9.5", "marked"),
        "S8": ("4", "marked"),
        "007": ("9.5", "marked"),
        "S9": ("4", "marked"),
    }
    merged = open_marks(both / "ALL")
    assert set(merged.elsewhere) == {"007", "S9"}
    assert merged.elsewhere["007"] == str(both / "later" / "MARKS")


def test_a_folder_that_is_given_twice_is_refused(both: Path) -> None:
    """Everybody in it was said to have handed in several times, or nobody was."""
    first = both / "first" / "MARKS"
    again = first.parent / "." / ".." / "first" / "MARKS"
    for options in ((), ("--prefer", "better")):
        done = kinegrade("merge", first, again, "-o", both / "ALL", *options)
        assert (done.exit_code, done.stderr) == (2, f"error: {again}: given twice\n")
    assert not (both / "ALL").exists()


def test_an_id_with_two_names_is_remarked_on(both: Path) -> None:
    grades = both / "later" / "MARKS" / "grades.csv"
    renamed = grades.read_text(encoding="utf-8-sig").replace("Student 007", "Ute Ohm")
    grades.write_text(renamed, encoding="utf-8-sig")
    said = (
        f'{both / "later" / "MARKS"}: student "007" is "Ute Ohm" here, and "Student 007" in '
        f"{both / 'first' / 'MARKS'} - put together by the id; check whose marks they are"
    )
    assert f"complaint: {said}\n" in merge(both).stderr
    term = kinegrade(
        "term", both / "first" / "MARKS", both / "later" / "MARKS", "-o", both / "t.csv"
    )
    assert 'student "007" is "Ute Ohm" here, and "Student 007" in' in term.stderr


def test_exports_and_report_show_all(both: Path) -> None:
    merge(both)
    listed = both / "grades.csv"
    done = kinegrade("export", both / "ALL", "--to", "generic", "-o", listed)
    assert done.exit_code == 0, done.stderr
    assert "grades of 4 students" in done.stderr
    page = both / "report.html"
    done = kinegrade("report", both / "first" / "EXAM", both / "ALL", "-o", page)
    assert done.exit_code == 0, done.stderr
    assert "4 of 4" in Page(page.read_text(encoding="utf-8")).text
    moodle = (both / "ALL" / "moodle.csv").read_text(encoding="utf-8-sig")
    assert moodle.count("9.5") == 2


def test_feedback_sharing_and_explanations_leave_other_papers_alone(both: Path) -> None:
    merge(both)
    exam, marks = both / "first" / "EXAM", both / "ALL"
    kinegrade("feedback", exam, marks, "-o", both / "SHEETS", "--format", "md")
    assert {each["student"] for each in table(both / "SHEETS" / "feedback.csv")} == {"0012", "S8"}
    done = kinegrade("explain", exam, marks, "007")
    assert done.exit_code == 2
    assert f'the marks of "007" were merged from "{both / "later" / "MARKS"}"' in done.stderr
    assert "name that folder, and the exam by which it was marked" in done.stderr
    assert kinegrade("explain", exam, marks, "0012").exit_code == 0
    assert kinegrade("sharing", exam, marks, "-o", both / "sharing.csv").exit_code == 0


def test_who_handed_in_twice_is_refused_with_both_totals(both: Path, tmp_path: Path) -> None:
    mark_class(tmp_path / "again", {**LATER, "0012": ("1.732", "9", "9")})
    (both / "later").rename(both / "before")
    (tmp_path / "again").rename(both / "later")
    done = merge(both)
    assert done.exit_code == 2
    assert 'student "0012" handed in several times: 9.5 of 9.5 in' in done.stderr
    assert "4 of 9.5 in" in done.stderr
    assert "add --prefer first, last or better" in done.stderr
    assert not (both / "ALL").exists()
    for preference, points in (("first", "9.5"), ("last", "4"), ("better", "9.5")):
        assert merge(both, "--prefer", preference, "--force").exit_code == 0
        assert totals(both)["0012"] == (points, "marked")


def test_another_maximum_is_said(both: Path) -> None:
    policy = both / "policy.toml"
    policy.write_text('[questions.q2]\nvoid = "drop"\n', encoding="utf-8")
    later = both / "later"
    files = later / "EXAM", later / "answers.csv", "-o", later / "MARKS", "--force"
    assert kinegrade("grade", *files, "--policy", policy).exit_code == 0
    done = merge(both)
    assert done.exit_code == 1
    assert "its maximum is 7 points, not 9.5, for 2 students - compare percentages" in done.stderr
    assert totals(both)["007"] == ("7", "marked")


def test_what_was_merged_is_merged_again(both: Path) -> None:
    merge(both)
    mark_class(both / "third", {"T1": RIGHT})
    files = both / "ALL", both / "third" / "MARKS", "-o", both / "MORE"
    assert kinegrade("merge", *files).exit_code == 0
    more = open_marks(both / "MORE")
    assert set(more.elsewhere) == {"007", "S9", "T1"}
    assert more.elsewhere["007"] == str(both / "later" / "MARKS")
    assert len(more.totals.students) == 5


def test_a_make_up_exam_may_have_other_questions(both: Path) -> None:
    marks = both / "later" / "MARKS"
    for name in ("marks.csv", "grades.csv"):
        file = marks / name
        file.write_text(file.read_text(encoding="utf-8").replace("q2", "q5"), encoding="utf-8")
    assert merge(both).exit_code == 0
    rows = {row["student"]: row for row in table(both / "ALL" / "grades.csv")}
    assert (rows["007"]["q2"], rows["007"]["q5"]) == ("", "2.5")
    assert (rows["0012"]["q2"], rows["0012"]["q5"]) == ("2.5", "")
    page = both / "report.html"
    done = kinegrade("report", both / "first" / "EXAM", both / "ALL", "-o", page)
    assert done.exit_code == 0, done.stderr


UNLIKE = (
    "complaint: {0}/later/MARKS: question {1} is not that of the same number in {0}/first/MARKS: "
    "both stand in one column of grades.csv - merged.csv says whose points are from which"
)


def test_a_question_that_asks_something_else_under_the_same_number_is_named(both: Path) -> None:
    file = both / "later" / "MARKS" / "marks.csv"
    file.write_text(file.read_text(encoding="utf-8").replace(",a_B,", ",v_C,"), encoding="utf-8")
    done = merge(both)
    assert done.exit_code == 1
    assert done.stderr.splitlines()[1:] == [UNLIKE.format(both, "q2")]


def test_a_question_of_another_template_is_named_where_the_exams_stand_beside(
    tmp_path: Path,
) -> None:
    for name, template in (("first", "slider-crank"), ("later", "bar-pushing-rolling-disc")):
        folder = tmp_path / name
        folder.mkdir()
        write_class(folder)
        (folder / "bank.toml").write_text(BANK.format(template), encoding="utf-8")
        student = "007" if name == "first" else "0012"
        (folder / "answers.csv").write_text(f"student,q1.v_B\n{student},1\n", encoding="utf-8")
        assert generate(folder, "EXAM", "--no-papers").exit_code == 0
        files = folder / "EXAM", folder / "answers.csv", "-o", folder / "MARKS"
        assert kinegrade("grade", *files).exit_code in (0, 1)
    said = merge(tmp_path).stderr.splitlines()
    assert UNLIKE.format(tmp_path, "q1") in said


def mark_by(folder: Path, policy: str) -> Result:
    """Marks the class in a folder again, by that policy."""
    (folder / "policy.toml").write_text(policy, encoding="utf-8")
    files = folder / "EXAM", folder / "answers.csv", "-o", folder / "MARKS", "--force"
    return kinegrade("grade", *files, "--policy", folder / "policy.toml")


def test_grades_by_one_scale_are_merged_and_by_two_are_refused(both: Path) -> None:
    scale = '[scale]\ngrades = { A = "90 %", B = 0 }\npass = 0\n'
    for name in ("first", "later"):
        assert mark_by(both / name, scale).exit_code in (0, 1)
    assert merge(both).exit_code == 0
    graded = {row["student"]: row["grade"] for row in table(both / "ALL" / "grades.csv")}
    assert graded == {"0012": "A", "S8": "B", "007": "A", "S9": "B"}
    assert open_marks(both / "ALL").scale == open_marks(both / "first" / "MARKS").scale
    mark_by(both / "later", scale.replace("90 %", "80 %"))
    refused = merge(both, "--force")
    assert refused.exit_code == 2
    said = (
        f"error: {both / 'later' / 'MARKS'}: its grades are not by the scale of"
        f" {both / 'first' / 'MARKS'} - mark both by a policy with the same scale"
    )
    assert refused.stderr.splitlines() == [said]


@pytest.mark.parametrize("order", [("first", "later"), ("later", "first")])
@pytest.mark.parametrize("preference", ["first", "last", "better"])
@pytest.mark.parametrize("rewarded", ["0012", "S8", "007"])
def test_a_bonus_in_one_exam_alone_goes_with_the_marks_that_stand(
    tmp_path: Path, order: tuple[str, str], preference: str, rewarded: str
) -> None:
    mark_class(tmp_path / "first", FIRST)
    mark_class(tmp_path / "later", {**LATER, "S8": RIGHT})
    by_hand, first = tmp_path / "by-hand.csv", tmp_path / "first"
    by_hand.write_text(f"student,question,points\n{rewarded},bonus,1.5\n", encoding="utf-8")
    again = "-o", first / "MARKS", "--force", "--manual", by_hand
    assert kinegrade("grade", first / "EXAM", first / "answers.csv", *again).exit_code < 2
    folders = [tmp_path / name / "MARKS" for name in order]
    done = kinegrade("merge", *folders, "-o", tmp_path / "ALL", "--prefer", preference)
    assert done.exit_code < 2, done.stderr
    merged = open_marks(tmp_path / "ALL")
    apart = [open_marks(folder).totals.by_student for folder in folders]
    for student, total in merged.totals.by_student.items():
        assert total.total in [each[student].total for each in apart if student in each]
    assert {sums.student for sums in merged.sums} == merged.totals.by_student.keys()
    exported = kinegrade("export", tmp_path / "ALL", "--to", "xlsx", "-o", tmp_path / "all.xlsx")
    assert exported.exit_code < 2, exported.stderr
