"""Grades by a scale: in grades.csv, on feedback, in the report, in a comparison and in exports;
absent students have none.
"""

from __future__ import annotations

import json
import re
from io import BytesIO
from pathlib import Path

import pytest
from openpyxl import Workbook, load_workbook

from tests.grading.marked_folder import COLUMNS, RIGHT, Page, mark_class
from tests.small_class import contents, kinegrade, table

GERMAN = '[scale]\nkind = "german"\n'
ANSWERS = {  # of 9.5 points: all, 7, 4, none, and nobody there
    "7": RIGHT,
    "8": ("1.732", "0", "9"),
    "9": ("1.732", "9", "9"),
    "10": ("9", "9", "9"),
    "11": (),
}


@pytest.fixture
def exam(tmp_path: Path) -> Path:
    """An exam whose bank states no scale, and answers.csv beside it."""
    return mark_class(tmp_path / "class", ANSWERS)[0]


def mark(exam: Path, policy: str = GERMAN, name: str = "GRADED", *options: str | Path) -> Path:
    """The class marked by a policy."""
    file = exam.parent / "policy.toml"
    file.write_text(policy, encoding="utf-8")
    marks = exam.parent / name
    wishes = "--policy", file, *options
    done = kinegrade("grade", exam, exam.parent / "answers.csv", "-o", marks, *wishes)
    assert done.exit_code < 2, done.stderr
    return marks


def state_in_bank(exam: Path, scale: dict[str, object]) -> None:
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    (exam / "exam.json").write_text(json.dumps({**head, "scale": scale}), encoding="utf-8")


def grades(marks: Path) -> list[str]:
    return [row["grade"] for row in table(marks / "grades.csv")]


def test_grades_stand_in_a_column_of_their_own_and_absent_students_have_none(exam: Path) -> None:
    marks = mark(exam)
    assert grades(marks) == ["1.0", "2.7", "5.0", "5.0", ""]
    assert table(marks / "scale.csv")[-3:] == [
        {"grade": "4.0", "from": "50", "result": "passed"},
        {"grade": "5.0", "from": "0", "result": "failed"},
        {"grade": "", "from": "", "result": "absent"},
    ]


def test_absent_students_get_the_word_of_the_scale(exam: Path) -> None:
    assert grades(mark(exam, f'{GERMAN}absent = "n.e."'))[-1] == "n.e."


def test_without_a_scale_there_is_no_column_and_no_file(exam: Path) -> None:
    marks = mark(exam, "attempts = 'last'")
    assert "grade" not in table(marks / "grades.csv")[0]
    assert not (marks / "scale.csv").exists()


def test_what_was_done_says_how_many_passed(exam: Path) -> None:
    (exam.parent / "p.toml").write_text(GERMAN, encoding="utf-8")
    files = exam, exam.parent / "answers.csv", "-o", exam.parent / "M"
    said = kinegrade("grade", *files, "--policy", exam.parent / "p.toml").stderr
    assert "grades: 2 of 4 passed, with 50 % or more; 1 absent" in said


def test_the_scale_of_a_policy_is_used_in_place_of_the_banks_and_that_is_said(exam: Path) -> None:
    state_in_bank(exam, {"kind": "letters"})
    answers = exam.parent / "answers.csv"
    plain = kinegrade("grade", exam, answers, "-o", exam.parent / "LETTERS")
    assert "in place of" not in plain.stderr
    assert grades(exam.parent / "LETTERS") == ["A", "C", "F", "F", ""]
    policy = exam.parent / "p.toml"
    policy.write_text(GERMAN, encoding="utf-8")
    said = kinegrade("grade", exam, answers, "-o", exam.parent / "M", "--policy", policy).stderr
    assert f"{policy}: its scale is used in place of the bank's" in said
    assert grades(exam.parent / "M")[1] == "2.7"
    policy.write_text("attempts = 'last'", encoding="utf-8")
    said = kinegrade("grade", exam, answers, "-o", exam.parent / "N", "--policy", policy).stderr
    assert "in place of" not in said
    assert grades(exam.parent / "N")[1] == "C"


def test_a_damaged_scale_of_an_exam_is_refused(exam: Path) -> None:
    state_in_bank(exam, {"kind": "french"})
    done = kinegrade("grade", exam, exam.parent / "answers.csv", "-o", exam.parent / "M")
    assert done.exit_code == 2
    assert "scale.kind" in done.stderr


def test_no_grade_is_given_while_a_question_is_to_be_marked_by_hand(exam: Path) -> None:
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    head["by_hand"] = [{"question": "q3", "points": "5"}]
    (exam / "exam.json").write_text(json.dumps(head), encoding="utf-8")
    state_in_bank(exam, {"kind": "german"})
    done = kinegrade("grade", exam, exam.parent / "answers.csv", "-o", exam.parent / "M")
    assert "no grades yet" in done.stderr
    assert "grade" not in table(exam.parent / "M" / "grades.csv")[0]


@pytest.mark.parametrize("form", ["md", "html"])
def test_feedback_shows_the_grade_and_no_rank(exam: Path, form: str) -> None:
    sheets = exam.parent / "F"
    wishes = "-o", sheets, "--format", form
    assert kinegrade("feedback", exam, mark(exam), *wishes).exit_code == 0
    text = Page((sheets / "sheets" / f"8.{form}").read_text(encoding="utf-8")).text
    assert re.search(r"Grade:?\s*2\.7", text)
    assert "Grade" not in (sheets / "sheets" / f"11.{form}").read_text(encoding="utf-8")
    assert "rank" not in text.lower()


def test_feedback_on_paper_shows_the_grade(exam: Path) -> None:
    from pypdf import PdfReader

    sheets = exam.parent / "F"
    assert kinegrade("feedback", exam, mark(exam), "-o", sheets, "--jobs", "1").exit_code == 0
    graded, absent = (
        PdfReader(sheets / "sheets" / f"{student}.pdf").pages[0].extract_text()
        for student in ("8", "11")
    )
    assert re.search(r"Grade\s*2\.7", graded)
    assert "Grade" not in absent


def report(exam: Path, marks: Path, *options: str) -> str:
    page = exam.parent / "report.html"
    done = kinegrade("report", exam, marks, "-o", page, "--force", *options)
    assert done.exit_code == 0, done.stderr
    return page.read_text(encoding="utf-8")


def test_the_report_has_the_distribution_and_the_pass_rate(exam: Path) -> None:
    text = Page(report(exam, mark(exam))).text
    assert "2 of 4 passed (50 %); 1 absent" in text
    lines = [" ".join(line.split()) for line in text.splitlines()]
    assert [line for line in lines if line.startswith(("1.0", "2.7", "5.0"))] == [
        "1.095.0 %125 %", "2.770.0 %125 %", "5.00.0 %250 %",
    ]  # fmt: skip
    assert "Ranks" not in text


def test_many_grades_are_listed_where_somebody_has_them(exam: Path) -> None:
    text = report(exam, mark(exam, '[scale]\nkind = "hundred"'))
    found = re.search(r'<table class="grades">.*?</table>', text, re.DOTALL)
    assert found is not None
    assert found[0].count("<tr>") == 1 + 4


def test_ranks_are_listed_when_they_are_asked_for_and_equal_totals_share_one(exam: Path) -> None:
    answers = {**ANSWERS, "12": RIGHT}
    exam, marks = mark_class(exam.parent / "more", answers)
    text = report(exam, marks, "--ranks")
    found = re.search(r'<table class="ranks">.*?</table>', text, re.DOTALL)
    assert found is not None
    rows = re.findall(r'<tr><td class="number">([0-9]+)</td><td>([0-9]+)</td>', found[0])
    assert rows == [("1", "7"), ("1", "12"), ("3", "8"), ("4", "9"), ("5", "10")]


def test_a_comparison_shows_other_grades_for_the_same_points(exam: Path) -> None:
    before, after = mark(exam), mark(exam, f'{GERMAN}pass = "40 %"', "MILDER")
    output = exam.parent / "diff.csv"
    shown = kinegrade("diff", before, after, "-o", output).stdout
    rows = [row for row in table(output) if row["what"] == "grade"]
    assert [(row["student"], row["before"], row["after"]) for row in rows] == [
        ("8", "2.7", "2.3"), ("9", "5.0", "4.0"),
    ]  # fmt: skip
    assert re.search(r"grade\s+5\.0\s+4\.0", shown)
    assert "0 up" in shown or "unchanged" in shown


def test_the_grade_sheet_and_the_workbook_have_the_grade(exam: Path) -> None:
    marks = mark(exam)
    sheet, book = exam.parent / "sheet.csv", exam.parent / "book.xlsx"
    assert kinegrade("export", marks, "--to", "generic", "-o", sheet).exit_code == 0
    assert [row["Grade by scale"] for row in table(sheet)] == ["1.0", "2.7", "5.0", "5.0"]
    assert kinegrade("export", marks, "--to", "xlsx", "-o", book).exit_code == 0
    page = load_workbook(BytesIO(book.read_bytes()))["grades"]
    assert [cell.value for cell in list(page.columns)[-1]] == [
        "grade",
        "1.0",
        "2.7",
        "5.0",
        "5.0",
        None,
    ]


def test_a_system_that_takes_points_gets_points_alone(exam: Path) -> None:
    marks, sheet = mark(exam), exam.parent / "canvas.csv"
    done = kinegrade("export", marks, "--to", "canvas", "--title", "Quiz", "-o", sheet)
    assert done.exit_code == 0, done.stderr
    assert "2.7" not in sheet.read_text(encoding="utf-8")


def test_marking_again_gives_the_same_bytes(exam: Path) -> None:
    assert contents(mark(exam)) == contents(mark(exam, GERMAN, "AGAIN"))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (",marked,2.7", ",marked,1.0", '"8": grade is "1.0", "2.7" by the scale'),
        (",absent,", ",absent,4.0", '"11": grade is "4.0", "" by the scale'),
        ("2.7,70,passed", "2.7,70/0,passed", "70/0"),
        ("2.7,70,passed", "2.7,70,fine", "passed, failed or absent"),
        ("5.0,0,failed", "5.0,10,failed", "the last grade does not begin at 0"),
    ],
)
def test_grades_that_were_changed_by_hand_are_refused(
    exam: Path, old: str, new: str, said: str
) -> None:
    marks = mark(exam)
    changed = 0
    for name in ("grades.csv", "scale.csv"):
        text = (marks / name).read_text(encoding="utf-8")
        changed += text.count(old)
        (marks / name).write_text(text.replace(old, new), encoding="utf-8")
    assert changed == 1
    done = kinegrade("export", marks, "--to", "xlsx", "-o", exam.parent / "book.xlsx")
    assert done.exit_code == 2
    assert said in done.stderr


def test_a_total_that_stands_earns_the_grade(exam: Path) -> None:
    before = mark(exam)
    policy = f"{GERMAN}[questions.q1.asks.v_B]\npoints = 0\n"
    after = mark(exam, policy, "STANDS", "--never-lower", before)
    assert [row["grade"] for row in table(after / "grades.csv")] == grades(before)


def test_a_third_of_a_point_does_not_make_a_grade_look_changed(exam: Path) -> None:
    """The total is written rounded; the grade is that of the exact one."""
    policy = (
        '[scale]\ngrades = { A = "2/3", B = 0 }\npass = "2/3"\n'
        "[questions.q1.asks.v_B]\npoints = 2\n[questions.q1.asks.omega_AB]\npoints = 1\n"
        '[questions.q2]\nvoid = "drop"\n'
    )
    marks = mark(exam, policy)
    assert grades(marks)[2] == "A"
    assert len(COLUMNS) == 3
    assert kinegrade("diff", marks, marks).exit_code == 0


def write_office(folder: Path) -> Path:
    """An office's list of all, with a word in the cell of somebody who was ill."""
    book = Workbook()
    sheet = book.active
    assert sheet is not None
    for row in (("Matrikelnr.", "Note"), *((student, None) for student in ANSWERS)):
        sheet.append(row)
    book.save(folder / "office.xlsx")
    return folder / "office.xlsx"


def fill_office(folder: Path, marks: Path, *options: str) -> tuple[list[object], str]:
    """The grades in the office's list, and what was said."""
    filled, place = folder / "filled.xlsx", ("--into", write_office(folder), "--column", "Note")
    done = kinegrade("export", marks, "--to", "xlsx", *place, "-o", filled, "--force", *options)
    if done.exit_code > 1:
        return [], done.stderr
    sheet = load_workbook(filled).active
    assert sheet is not None
    return [sheet.cell(row, 2).value for row in range(2, 2 + len(ANSWERS))], done.stderr


def test_an_office_gets_grades_of_the_scale_where_it_is_told(exam: Path) -> None:
    """As numbers, with which its formulas count; a word as a text; where points were filled in, it
    is said that there are grades.
    """
    marks = mark(exam, f'{GERMAN}absent = "n. e. <&>"')
    points, said = fill_office(exam.parent, marks)
    assert points == [9.5, 7, 4, 0, None]
    assert "points were filled in; --of-scale fills in the grades of the scale" in said
    grades, said = fill_office(exam.parent, marks, "--of-scale", "--ungraded")
    assert grades == [1, 2.7, 5, 5, "n. e. <&>"]
    assert "--of-scale" not in said
    assert fill_office(exam.parent, marks, "--of-scale")[0] == [1, 2.7, 5, 5, None]


def test_grades_of_a_scale_are_for_an_office_alone_and_have_to_be_there(exam: Path) -> None:
    marks = mark(exam, "attempts = 'last'")
    assert "nobody has a grade of a scale" in fill_office(exam.parent, marks, "--of-scale")[1]
    graded = mark(exam, name="ALSO")
    wrong = fill_office(exam.parent, graded, "--of-scale", "--maximum", "100")[1]
    assert "--of-scale: the grades of the scale go into an office's workbook" in wrong
