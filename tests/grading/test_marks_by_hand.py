"""Marks by hand beside those of the machine: taken from a file, kept apart, carried over, never lost
in silence; and all that can be wrong with such a file is told at once.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from click.testing import Result
from openpyxl import Workbook, load_workbook

import kinegrade as library
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.records import Candidate
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.marks_folder.folder import open_marks
from tests.exam.test_by_hand import CRANK, SLEEVE, THEORY, WHEEL, mark_right, set_exam
from tests.exam.test_by_hand import HEAD as EXAM_HEAD
from tests.small_class import kinegrade, table

HEAD = "student,question,points,comment\n"
ADA, SOFYA = "1001", "1002"


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of two machine-marked questions, of 3 and 4 points, and between them one of 2.5 for
    hands, and MARKS in which both students have everything right; not to be changed.
    """
    folder = tmp_path_factory.mktemp("by-hand")
    assert set_exam(folder, CRANK + THEORY + SLEEVE).exit_code == 0
    mark_right(folder)
    return folder


@pytest.fixture
def folder(made: Path, tmp_path: Path) -> Path:
    """The same, to be changed."""
    shutil.copytree(made, tmp_path, dirs_exist_ok=True)
    return tmp_path


def grade(folder: Path, *options: str | Path, marks: str = "MARKS") -> Result:
    """Mark again into the same folder."""
    place = "-o", folder / marks, "--force"
    return kinegrade("grade", folder / "EXAM", folder / "answers.csv", *place, *options)


def give(folder: Path, rows: str, *options: str | Path, name: str = "by-hand.csv") -> Result:
    """Mark again with these marks by hand."""
    file = folder / name
    file.write_text(HEAD + rows, encoding="utf-8")
    return grade(folder, "--manual", file, *options)


def totals(folder: Path, marks: str = "MARKS") -> dict[str, tuple[str, str]]:
    """Everybody's total, and what it is out of."""
    rows = table(folder / marks / "grades.csv")
    return {row["student"]: (row["total"], row["out_of"]) for row in rows}


def faults(result: Result, folder: Path) -> list[str]:
    """The lines of a refusal, without the place of the folder."""
    assert result.exit_code == 2
    return [
        line.removeprefix("error: ").replace(f"{folder}/", "")
        for line in result.stderr.splitlines()
    ]


def test_a_decimal_comma_without_quotes_is_no_comment(folder: Path) -> None:
    what = 'points are "1" and the comment is "5", which a decimal comma without quotes leaves too'
    do = 'if one number is meant, write "1,5" in quotes or with a point; if not, add a word to the'
    cut = give(folder, f"{ADA},q2,1,5\n")
    assert faults(cut, folder) == [f"by-hand.csv:2: q2: {what} - {do} comment"]
    assert give(folder, f'{ADA},q2,"1,5",\n{SOFYA},q2,1,task 5\n').exit_code == 0


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


def open_exam_students(folder: Path) -> tuple[Candidate, ...]:
    """The students of the exam with their codes."""
    return open_exam(folder / "EXAM").head.students


def test_all_that_is_wrong_is_told_at_once_and_nothing_is_written(folder: Path) -> None:
    before = (folder / "MARKS" / "grades.csv").read_bytes()
    wrong = give(
        folder,
        "1009,q2,2,\n"
        f"{ADA},q7,1,\n"
        f"{ADA},q2,3,\n"
        f"{ADA},q2,-1,\n"
        f"{ADA},q2,,forgotten\n"
        f"{SOFYA},q3,1,\n"
        f"{SOFYA},q3,2,\n"
        f"{SOFYA},3a,1,\n"
        f"{SOFYA},q2,1,slow, but right\n"
        ",q2,1,\n",
    )
    expected = "expected a number of zero or more with at most 4 decimals"
    assert sorted(faults(wrong, folder)) == sorted(
        [
            'by-hand.csv:2: no student "1009" in the exam',
            'by-hand.csv:3: "q7" is no question or ask of the exam '
            "- expected such as q2, q1.v_B, q3.omega_AB, or bonus",
            "by-hand.csv:4: q2: 3 points of 2.5 "
            "- points on top are a row of their own, question bonus",
            f'by-hand.csv:5: q2: points are "-1" - {expected}',
            f'by-hand.csv:6: q2: points are "" - {expected}',
            f'by-hand.csv:8: student "{SOFYA}" has 2 points for q3 here and 1 at by-hand.csv:7 '
            "- keep one of them",
            f'by-hand.csv:9: student "{SOFYA}" has points for q3.omega_AB and, at by-hand.csv:7, '
            "for the whole question - keep one of them",
            "by-hand.csv:10: the line has 5 cells, the header 4 - correct the row",
            "by-hand.csv:11: no student id",
        ]
    )
    assert (folder / "MARKS" / "grades.csv").read_bytes() == before


def test_a_code_of_another_paper_beside_an_id_is_refused(folder: Path) -> None:
    ada, sofya = (each.paper for each in open_exam_students(folder))
    file = folder / "coded.csv"
    rows = f"student,paper,question,points\n{ADA},{sofya},q2,1\n{ADA},XXXX,q2,1\n"
    file.write_text(rows, encoding="utf-8")
    assert faults(grade(folder, "--manual", file), folder) == [
        f'coded.csv:2: {sofya}: the paper with this code is that of "{SOFYA}" '
        f'- correct the code or the id; the id is that of "{ADA}"',
        "coded.csv:3: XXXX: no paper of the exam has this code",
    ]
    assert ada != sofya


def test_a_program_gives_one_file_or_several(folder: Path) -> None:
    file = folder / "one.csv"
    file.write_text(f"{HEAD}{ADA},q2,2,\n", encoding="utf-8")
    exam = library.open_exam(folder / "EXAM")
    for place, manual in (("ONE", str(file)), ("SEVERAL", [file])):
        options = library.GradeOptions(manual=manual)
        graded = library.grade(exam, folder / "answers.csv", folder / place, options=options)
        assert graded.marks.by_hand[ADA]["q2"].points == 2


def test_columns_that_are_missing_are_named(folder: Path) -> None:
    file = folder / "list.csv"
    file.write_text("name,marks\nAda,2\n", encoding="utf-8")
    assert faults(grade(folder, "--manual", file), folder) == [
        'list.csv: no column "student", "question" '
        "- expected columns such as student, question, points, comment"
    ]


def test_a_manual_file_that_was_edited_against_the_totals_is_refused(folder: Path) -> None:
    give(folder, f"{ADA},q2,2,\n{SOFYA},q2,1,\n")
    file = folder / "MARKS" / "manual.csv"
    text = file.read_text(encoding="utf-8-sig")
    file.write_text(text.replace(f"{ADA},q2,2,", f"{ADA},q2,1,"), encoding="utf-8")
    refused = kinegrade("export", folder / "MARKS", "--to", "moodle", "-o", folder / "m.csv")
    assert refused.exit_code == 2
    assert "q2 is 2, 1 by manual.csv" in refused.stderr
    file.write_text(text.replace(f"{ADA},q2,", f"{ADA},q1.v_B,"), encoding="utf-8")
    damaged = kinegrade("export", folder / "MARKS", "--to", "moodle", "-o", folder / "m.csv")
    assert "manual.csv:2: question is " in damaged.stderr
    assert "an ask such as q1.v_B with what the machine gave" in damaged.stderr


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
        [ADA, "q2", 2, 2.5, None, "0.07"],
        [SOFYA, "q2", 1, 2.5, None, "=1+1"],
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


def test_points_shown_as_per_cent_and_points_of_merged_cells_are_refused(folder: Path) -> None:
    book = Workbook()
    sheet = book.active
    assert sheet is not None
    for row in (["student", "question", "points"], [ADA, "q2", 0.5], [SOFYA, "q2", None]):
        sheet.append(row)
    sheet["C2"].number_format = "0%"
    book.save(folder / "percent.xlsx")
    (said,) = faults(grade(folder, "--manual", folder / "percent.xlsx"), folder)
    assert 'percent.xlsx:2: q2: points are "50%"' in said
    sheet["C2"].number_format = "General"
    sheet.merge_cells("C2:C3")
    book.save(folder / "merged.xlsx")
    (said,) = faults(grade(folder, "--manual", folder / "merged.xlsx"), folder)
    assert said.startswith("merged.xlsx:3: the cells C2:C3 are merged into one - correct")


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


def test_on_shuffled_papers_a_number_alone_names_no_question(tmp_path: Path) -> None:
    bank = "shuffle = true\n" + CRANK + THEORY + SLEEVE + WHEEL
    assert set_exam(tmp_path, bank, "--reproducible", "any order").exit_code == 0
    mark_right(tmp_path)
    assert faults(give(tmp_path, f"{ADA},1,1,\n"), tmp_path) == [
        'by-hand.csv:2: "1" is no question or ask of the exam - expected such as q2, q1.v_B, '
        "q3.omega_AB, q4.omega, or bonus: the papers are shuffled, so a number alone is another "
        "question on each"
    ]
    assert give(tmp_path, f"{ADA},q1,1,\n{ADA},q2,1,\n{SOFYA},q2,1,\n").exit_code == 0


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
