"""What can be wrong with a file of marks by hand: told at once, and nothing is written."""

from __future__ import annotations

from pathlib import Path

from openpyxl import Workbook

from tests.exam.test_by_hand import CRANK, SLEEVE, THEORY, WHEEL, mark_right, set_exam
from tests.grading.by_hand.hand_marking import ADA, SOFYA, faults, give, grade, open_exam_students
from tests.small_class import kinegrade, table


def test_a_decimal_comma_without_quotes_is_no_comment(folder: Path) -> None:
    what = 'points are "1" and the comment is "5", which a decimal comma without quotes leaves too'
    do = 'if one number is meant, write "1,5" in quotes or with a point; if not, add a word to the'
    cut = give(folder, f"{ADA},q2,1,5\n")
    assert faults(cut, folder) == [f"by-hand.csv:2: q2: {what} - {do} comment"]
    assert give(folder, f'{ADA},q2,"1,5",\n{SOFYA},q2,1,task 5\n').exit_code == 0


def test_all_that_is_wrong_is_told_at_once_and_nothing_is_written(folder: Path) -> None:
    before = (folder / "MARKS" / "grades.csv").read_bytes()
    wrong = give(
        folder,
        "1009,q2,2,\n"
        f"{ADA},q7,1,\n"
        f"{ADA},q2,3,\n"
        f"{ADA},q2,-1,\n"
        f"{ADA},q1,,forgotten\n"
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
            f'by-hand.csv:6: q1: points are "" - {expected}',
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
    do = "manual.csv was saved after the totals: grade again into this folder with --force"
    assert refused.stderr.endswith(f"- {do}\n")
    file.write_text(text.replace(f"{ADA},q2,", f"{ADA},q1.v_B,"), encoding="utf-8")
    damaged = kinegrade("export", folder / "MARKS", "--to", "moodle", "-o", folder / "m.csv")
    assert "manual.csv:2: question is " in damaged.stderr
    assert "an ask such as q1.v_B with what the machine gave" in damaged.stderr


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


def test_a_question_for_hands_keeps_its_number_on_shuffled_papers(tmp_path: Path) -> None:
    bank = "shuffle = true\n" + CRANK + THEORY + SLEEVE + WHEEL
    assert set_exam(tmp_path, bank, "--reproducible", "any order").exit_code == 0
    mark_right(tmp_path)
    assert give(tmp_path, f"{ADA},2,1,\n{SOFYA},2,2,\n").exit_code == 0
    given = table(tmp_path / "MARKS" / "manual.csv")
    assert [(row["question"], row["points"]) for row in given] == [("q2", "1"), ("q2", "2")]
