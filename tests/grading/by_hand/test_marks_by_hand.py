"""Marks by hand beside those of the machine: taken from a file, kept apart, carried over, never lost
in silence; and all that can be wrong with such a file is told at once.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from openpyxl import Workbook, load_workbook

import kinegrade as library
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.marks_folder.folder import open_marks
from tests.exam.test_by_hand import CRANK, THEORY, mark_right
from tests.exam.test_by_hand import HEAD as EXAM_HEAD
from tests.grading.by_hand.hand_marking import (
    ADA,
    HEAD,
    SOFYA,
    faults,
    give,
    grade,
    open_exam_students,
    totals,
)
from tests.small_class import kinegrade, table


def test_a_question_an_ask_and_a_bonus_are_marked_and_the_machine_is_kept_beside(
    folder: Path,
) -> None:
    marked = give(folder, f'{ADA},q2,2,\n{ADA},q3.omega_AB,1,"right, by luck"\n{SOFYA},2,2.5,\n'
                  f"{SOFYA},bonus,1.5,neat\n")  # fmt: skip
    assert marked.exit_code == 0, marked.stderr
    assert "4 marks by hand, 1 in place of other points by the machine" in marked.stderr
    assert "still to be marked" not in marked.stderr
    assert totals(folder) == {ADA: ("6", "9.5"), SOFYA: ("11", "9.5")}
    first = table(folder / "MARKS" / "grades.csv")[0]
    assert list(first)[2:6] == ["q1", "q2", "q3", "bonus"]
    assert not (folder / "MARKS" / "open.csv").exists()
    kept = {(row["student"], row["question"]): row for row in table(folder / "MARKS/manual.csv")}
    luck = kept[ADA, "q3.omega_AB"]
    assert (luck["points"], luck["machine"], luck["out_of"]) == ("1", "4", "4")
    assert luck["comment"] == "right, by luck"
    lines = table(folder / "MARKS" / "marks.csv")
    assert {row["points"] for row in lines if row["ask"] == "omega_AB"} == {"4"}


def test_the_list_of_open_questions_is_filled_in_and_given_back_as_it_is(folder: Path) -> None:
    file = folder / "MARKS" / "open.csv"
    text = file.read_text(encoding="utf-8-sig")
    file.write_text(text.replace("q2,2.5,,", 'q2,2.5,"1,5",good'), encoding="utf-8")
    lost = faults(grade(folder), folder)
    assert lost == [
        "MARKS/open.csv: the points typed into 2 rows would be lost "
        f"- grade again with --manual {folder}/MARKS/open.csv".replace(f"{folder}/", "")
    ]
    assert grade(folder, "--manual", file).exit_code == 0
    assert totals(folder) == {ADA: ("8.5", "9.5"), SOFYA: ("8.5", "9.5")}


def test_who_has_no_mark_yet_is_named_and_counts_as_nothing_meanwhile(folder: Path) -> None:
    marked = give(folder, f"{ADA},q2,2,\n")
    assert marked.exit_code == 1
    said = f'student "{SOFYA}" has no points by hand for question 2, which count as 0 until then'
    assert said in marked.stderr
    assert totals(folder)[SOFYA] == ("7", "9.5")
    moodle = kinegrade("export", folder / "MARKS", "--to", "moodle", "-o", folder / "m.csv")
    assert moodle.exit_code == 1
    assert said in moodle.stderr


def test_a_term_names_who_has_no_mark_yet(folder: Path) -> None:
    give(folder, f"{ADA},q2,2,\n")
    done = kinegrade("term", folder / "MARKS", "-o", folder / "term.csv")
    said = f'MARKS: student "{SOFYA}" has no points by hand for question 2, which count as 0 until'
    assert done.exit_code == 1
    assert said in done.stderr


def test_marks_by_hand_are_carried_over_replaced_and_taken_back(folder: Path) -> None:
    give(folder, f"{ADA},q2,2,\n{SOFYA},q2,1,\n")
    again = grade(folder)
    assert "2 marks by hand carried over from " in again.stderr
    assert totals(folder) == {ADA: ("9", "9.5"), SOFYA: ("8", "9.5")}
    changed = give(folder, f"{SOFYA},q2,2,looked again\n")
    assert "1 mark by hand of " in changed.stderr
    assert "replaced by a new one" in changed.stderr
    assert totals(folder)[SOFYA] == ("9", "9.5")
    kept = folder / "MARKS" / "manual.csv"
    same = grade(folder, "--manual", kept)
    assert same.exit_code == 0
    assert "carried over" not in same.stderr
    lines = kept.read_text(encoding="utf-8-sig").splitlines(keepends=True)
    kept.write_text("".join(line for line in lines if SOFYA not in line), encoding="utf-8")
    assert grade(folder).exit_code == 1
    assert totals(folder)[SOFYA] == ("7", "9.5")


def test_a_mark_by_hand_below_what_the_machine_gives_now_is_told(folder: Path) -> None:
    rows = (folder / "answers.csv").read_text(encoding="utf-8-sig")
    wrong = [
        {**row, "q1.v_B": "99"} if row["student"] == ADA else row
        for row in table(folder / "answers.csv")
    ]
    text = write_csv_text(list(wrong[0]), [list(row.values()) for row in wrong])
    (folder / "answers.csv").write_text(text, encoding="utf-8")
    decided = give(folder, f"{ADA},q1,1,sketch\n{ADA},q2,2,\n{SOFYA},q2,2,\n")
    assert "the machine gives" not in decided.stderr
    (folder / "answers.csv").write_text(rows, encoding="utf-8")
    corrected = grade(folder)
    assert corrected.exit_code == 1
    assert (
        f'manual.csv: q1: "{ADA}": 1 by hand, and the machine gives 3 now, which gave 0 when that '
        "was decided - the mark by hand stands - to take it back, delete its row in manual.csv"
    ) in corrected.stderr
    assert "the machine gives" not in grade(folder).stderr


@pytest.mark.parametrize("place", ["q1", "q1.v_B"])
def test_marks_by_hand_of_what_is_dropped_later_are_left_out_and_said(
    folder: Path, place: str
) -> None:
    give(folder, f"{ADA},{place},2,sketch\n{ADA},q2,2,\n{SOFYA},q2,1,\n")
    policy = folder / "policy.toml"
    policy.write_text("[questions.q1]\nvoid = 'drop'\n", encoding="utf-8")
    options = "--policy", policy, "--since", folder / "MARKS", "--reason", "q1 was wrong"
    dropped = grade(folder, *options, marks="MARKS2")
    assert dropped.exit_code == 0, dropped.stderr
    assert totals(folder, "MARKS2") == {ADA: ("6", "6.5"), SOFYA: ("5", "6.5")}
    file = folder / "MARKS" / "manual.csv"
    assert f"{file}: 1 mark by hand is for what the policy drops: it is kept" in dropped.stderr
    again = grade(folder, "--policy", policy, "--manual", file)
    assert f"{file}: 1 mark by hand is for what the policy drops: it is kept" in again.stderr


@pytest.mark.parametrize("options", [["--never-lower"], ["--reason", "appeals", "--since"]])
def test_a_new_folder_takes_those_of_the_marking_that_it_follows(
    folder: Path, options: list[str]
) -> None:
    give(folder, f"{ADA},q2,2,\n{SOFYA},q2,1,\n")
    follow = grade(folder, *options, folder / "MARKS", marks="MARKS2")
    assert "2 marks by hand carried over" in follow.stderr
    assert totals(folder, "MARKS2") == totals(folder)


def test_several_files_are_one_and_a_code_stands_for_an_id(folder: Path) -> None:
    exam = table(folder / "EXAM" / "answers.csv")
    assert [row["student"] for row in exam] == [ADA, SOFYA]
    codes = {each.student: each.paper for each in open_exam_students(folder)}
    other = folder / "other.csv"
    other.write_text(f"paper,question,points\n{codes[SOFYA].lower()},2,1\n", encoding="utf-8")
    marked = give(folder, f"{ADA},2,2,\n", "--manual", other)
    assert marked.exit_code == 0, marked.stderr
    assert totals(folder) == {ADA: ("9", "9.5"), SOFYA: ("8", "9.5")}


def test_a_program_gives_one_file_or_several(folder: Path) -> None:
    file = folder / "one.csv"
    file.write_text(f"{HEAD}{ADA},q2,2,\n", encoding="utf-8")
    exam = library.open_exam(folder / "EXAM")
    for place, manual in (("ONE", str(file)), ("SEVERAL", [file])):
        options = library.GradeOptions(manual=manual)
        graded = library.grade(exam, folder / "answers.csv", folder / place, options=options)
        assert graded.marks.by_hand[ADA]["q2"].points == 2


def test_feedback_report_diff_and_exports_have_them(folder: Path) -> None:
    shutil.copytree(folder / "MARKS", folder / "BEFORE")
    rows = f"{ADA},q2,2,good\n{ADA},3a,1,by luck\n{SOFYA},q1,0,copied\n{SOFYA},q2,0,\n"
    assert give(folder, f"{rows}{SOFYA},bonus,1.5,neat\n").exit_code == 0
    exam, marks = folder / "EXAM", folder / "MARKS"
    sheets = folder / "FEEDBACK"
    assert kinegrade("feedback", exam, marks, "-o", sheets, "--format", "md").exit_code == 0
    ada = (sheets / "sheets" / f"{ADA}.md").read_text(encoding="utf-8")
    assert "## Question 2 · Poles (2 / 2.5)\n\ngood\n" in ada
    assert "**marked by hand**. by luck | 1 / 4 |" in ada
    sofya = (sheets / "sheets" / f"{SOFYA}.md").read_text(encoding="utf-8")
    assert "(0 / 3)\n\nMarked by hand: copied\n" in sofya
    assert "## Bonus (+1.5)\n\nneat\n" in sofya
    changes = kinegrade("diff", folder / "BEFORE", marks).stdout
    assert "right -> marked by hand: by luck" in changes
    assert "by hand: copied" in changes
    report = folder / "report.html"
    assert kinegrade("report", exam, marks, "-o", report).exit_code == 0
    page = report.read_text(encoding="utf-8")
    assert "Marked by hand" in page
    assert "still to be" not in page
    moodle = folder / "moodle.csv"
    done = kinegrade("export", marks, "--to", "moodle", "-o", moodle)
    assert done.exit_code == 0, done.stderr
    lines = moodle.read_text(encoding="utf-8-sig").splitlines()
    assert lines[1].endswith(",6,1: 3/3; 2: 2/2.5; 3: 1/4")
    assert lines[2].endswith(",5.5,1: 0/3; 2: 0/2.5; 3: 4/4; bonus: +1.5")
    each = kinegrade(
        "export", marks, "--to", "generic", "--per-question", "-o", folder / "each.csv"
    )
    assert each.exit_code == 0, each.stderr
    assert totals(folder)[SOFYA] == ("5.5", "9.5")
    assert [mark.column for mark in open_marks(marks).by_hand[ADA].values()] == [
        "q2",
        "q3.omega_AB",
    ]


def test_a_spreadsheet_shows_them_on_a_sheet_of_their_own(folder: Path) -> None:
    assert give(folder, f"{ADA},q2,2,0.07\n{SOFYA},q2,1,=1+1\n").exit_code == 0
    book = folder / "all.xlsx"
    done = kinegrade("export", folder / "MARKS", "--to", "xlsx", "-o", book)
    assert done.exit_code == 0, done.stderr
    rows = [[cell.value for cell in row] for row in load_workbook(book)["manual"].iter_rows()]
    assert rows[1:] == [
        [ADA, "q2", 2, 2.5, None, "0.07", None],
        [SOFYA, "q2", 1, 2.5, None, "=1+1", None],
    ]


def test_marks_by_hand_come_from_a_workbook_too(folder: Path) -> None:
    book = Workbook()
    sheet = book.active
    assert sheet is not None
    for row in (["Matrikelnummer", "Aufgabe", "Punkte", "Kommentar"], [1001, 2, 1.5, "gut"]):
        sheet.append(row)
    sheet.append(["1002", "2", "0,5", None])
    book.save(folder / "hand.xlsx")
    assert grade(folder, "--manual", folder / "hand.xlsx").exit_code == 0
    assert totals(folder) == {ADA: ("8.5", "9.5"), SOFYA: ("7.5", "9.5")}


def test_a_folder_that_waits_for_marks_by_hand_is_not_merged_with_graded_ones(
    folder: Path,
) -> None:
    policy = folder / "policy.toml"
    policy.write_text('[scale]\ngrades = { A = "90 %", B = 0 }\npass = 0\n', encoding="utf-8")
    by_scale = "--policy", policy
    assert grade(folder, *by_scale, marks="WAITING").exit_code == 0
    assert give(folder, f"{ADA},q2,2,\n{SOFYA},q2,1,\n", *by_scale).exit_code == 0
    places = folder / "MARKS", folder / "WAITING", "-o", folder / "ALL"
    (said,) = faults(kinegrade("merge", *places, "--prefer", "last"), folder)
    assert said.startswith("WAITING: question 2 is still to be marked by hand")


def test_equal_marks_for_one_thing_keep_the_comments_of_both(folder: Path) -> None:
    rows = f"{ADA},q2,2,clear\n{ADA},q2,2,but late\n{ADA},q2,2,clear\n"
    assert give(folder, rows).exit_code == 1
    (mark,) = table(folder / "MARKS" / "manual.csv")
    assert (mark["points"], mark["comment"]) == ("2", "clear / but late")


def test_who_only_wrote_words_is_not_absent(folder: Path) -> None:
    answers = folder / "answers.csv"
    first, second, third = answers.read_text(encoding="utf-8").splitlines()
    answers.write_text(f"{first}\n{second.split(',')[0]},,\n{third}\n", encoding="utf-8")
    grade(folder)
    assert table(folder / "MARKS" / "grades.csv")[0]["status"] == "absent"
    only = give(folder, f"{SOFYA},q2,1,\n")
    assert only.exit_code == 0, only.stderr  # nobody waits for the absent
    give(folder, f"{ADA},q2,2,\n")
    row = table(folder / "MARKS" / "grades.csv")[0]
    assert (row["total"], row["status"]) == ("2", "marked")


def test_an_id_without_its_zeros_is_repaired_and_said_and_comments_stay_as_they_are(
    tmp_path: Path,
) -> None:
    (tmp_path / "bank.toml").write_text(EXAM_HEAD + CRANK + THEORY, encoding="utf-8")
    (tmp_path / "roster.csv").write_text("student,name\n007,A\n008,B\n", encoding="utf-8")
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    assert kinegrade("generate", *files, "-o", tmp_path / "EXAM").exit_code == 0
    mark_right(tmp_path)
    said = give(tmp_path, "7,q2,2,=fine\n8,q2,1,\n").stderr
    assert "by-hand.csv: 2 student ids are not as in the exam" in said
    for _ in range(2):
        assert grade(tmp_path).exit_code == 0
    rows = table(tmp_path / "MARKS" / "manual.csv")
    assert [(row["student"], row["comment"]) for row in rows] == [("007", "'=fine"), ("008", "")]
    assert open_marks(tmp_path / "MARKS").by_hand["007"]["q2"].comment == "=fine"


def test_a_bonus_of_more_points_than_the_exam_has_is_told_of(folder: Path) -> None:
    done = give(folder, f"{ADA},bonus,1000,\n{SOFYA},bonus,9.5,\n")
    assert done.exit_code == 0, done.stderr
    assert (
        "by-hand.csv:2: the bonus is 1000 points, more than the 9.5 of the whole exam - it counts as "
        "it stands; check it\n"
    ) in done.stderr
    assert "by-hand.csv:3" not in done.stderr


def test_a_student_may_be_named_by_the_address(folder: Path) -> None:
    for student in (ADA, SOFYA):
        new = "--new-id", "--email", f"{student}@Example.org"
        assert kinegrade("exchange", folder / "EXAM", student, student, *new).exit_code == 0
    give(folder, f"{ADA}@example.org,q2,2,\n")
    (row,) = table(folder / "MARKS" / "manual.csv")
    assert (row["student"], row["points"]) == (ADA, "2")
    (unknown,) = faults(give(folder, "nobody@example.org,q2,2,\n"), folder)
    assert 'no student "nobody@example.org" in the exam' in unknown
