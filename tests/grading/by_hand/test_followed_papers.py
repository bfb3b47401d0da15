"""A mark by hand that was given by the code of a paper follows the paper when it changes hands, as
the answers by that code do; one that was given by an id stays with the student.
"""

from __future__ import annotations

from pathlib import Path

from kinegrade.exam.folder.exam_folder import open_exam
from tests.exam.test_by_hand import CRANK, THEORY, mark_right, set_exam
from tests.grading.by_hand.hand_marking import ADA, SOFYA, faults, grade, open_exam_students
from tests.small_class import kinegrade, table


def give_by_code(folder: Path, rows: str) -> None:
    """Mark again with these marks by hand; `ADA` and `SOFYA` stand for the codes of their papers."""
    ada, sofya = (each.paper for each in open_exam_students(folder))
    file = folder / "coded.csv"
    text = rows.replace("ADA", ada).replace("SOFYA", sofya)
    file.write_text(f"student,question,points,comment\n{text}", encoding="utf-8")
    done = grade(folder, "--manual", file)
    assert done.exit_code == 0, done.stderr


def exchange(folder: Path) -> None:
    """Ada gets Sofya's paper, and Sofya hers."""
    sofya = open_exam_students(folder)[1].paper
    done = kinegrade("exchange", folder / "EXAM", sofya, ADA)
    assert done.exit_code == 0, done.stderr


def read_points(folder: Path) -> dict[tuple[str, str], str]:
    """What hands gave, by student and by what was marked."""
    rows = table(folder / "MARKS" / "manual.csv")
    return {(row["student"], row["question"]): row["points"] for row in rows}


def test_a_mark_by_code_follows_the_paper(folder: Path) -> None:
    give_by_code(folder, "ADA,q2,2,the sheet of Ada\nSOFYA,q2,1,\n")
    codes = [each.paper for each in open_exam_students(folder)]
    assert [row["paper"] for row in table(folder / "MARKS" / "manual.csv")] == codes
    exchange(folder)
    done = grade(folder, "--own-papers")
    assert (
        "MARKS/manual.csv: 2 marks by hand that were given by the code of a paper are those of "
        "whoever has it now"
    ) in done.stderr
    assert read_points(folder) == {(ADA, "q2"): "1", (SOFYA, "q2"): "2"}
    again = grade(folder, "--own-papers")
    assert "whoever has it now" not in again.stderr
    assert read_points(folder) == {(ADA, "q2"): "1", (SOFYA, "q2"): "2"}


def test_a_mark_by_id_stays_with_the_student(folder: Path) -> None:
    give_by_code(folder, f"{ADA},q2,2,\n{SOFYA},q2,1,\n")
    exchange(folder)
    assert "whoever has it now" not in grade(folder, "--own-papers").stderr
    assert read_points(folder) == {(ADA, "q2"): "2", (SOFYA, "q2"): "1"}


def test_marks_by_code_and_by_id_that_meet_are_told(folder: Path) -> None:
    give_by_code(folder, f"ADA,q2,2,\n{SOFYA},q2,1,\n")
    exchange(folder)
    assert faults(grade(folder, "--own-papers"), folder) == [
        f'MARKS/manual.csv:3: student "{SOFYA}" has 1 points for q2 here and 2 at '
        "MARKS/manual.csv:2 - give the points that count now with --manual: they take the place of "
        "these"
    ]


def test_marks_that_meet_while_their_question_is_dropped_are_told(folder: Path) -> None:
    policy = folder / "policy.toml"
    policy.write_text('[questions.q2]\nvoid = "drop"\n', encoding="utf-8")
    options = "--own-papers", "--policy", policy
    for rows in (f"ADA,q2,2,\n{SOFYA},q2,1,\n", f"{SOFYA},q2,1,\nADA,q2,2,\n"):
        give_by_code(folder, rows)
        assert grade(folder, *options).exit_code == 0
        exchange(folder)
        (said,) = faults(grade(folder, *options), folder)
        assert f'student "{SOFYA}" has ' in said
        exchange(folder)


def test_a_mark_by_the_code_of_a_paper_that_is_nobodys_now_is_refused(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + THEORY, "--spare", "1", "--no-papers").exit_code == 0
    mark_right(tmp_path)
    give_by_code(tmp_path, f"ADA,q2,2,\n{SOFYA},q2,1,\n")
    ada = open_exam_students(tmp_path)[0].paper
    exam = tmp_path / "EXAM"
    spare = open_exam(exam).head.spares[0].paper
    assert kinegrade("exchange", exam, spare, ADA).exit_code == 0
    said = faults(grade(tmp_path, "--own-papers"), tmp_path)
    assert said == [
        f"MARKS/manual.csv:2: {ada}: {ada} is a spare paper, which is nobody's yet "
        f"- give it to its student by kinegrade assign or exchange, or correct the row"
    ]
