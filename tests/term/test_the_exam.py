"""The exam, what comes back and next year: rows 8 to 11, 14, 15, 20, 23 and 24 of the term, played
with a class of 137.
"""

from __future__ import annotations

import csv
import re
import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from time import process_time

import pytest
from click.testing import Result
from openpyxl import load_workbook
from pypdf import PdfReader

from kinegrade.exam.folder.exam_folder import open_exam
from tests.printed_text import read_text
from tests.problem.crank import crank_text
from tests.small_class import asks_of, contents, kinegrade, table
from tests.term.banks import MIDTERM, write_bank
from tests.term.people import CLASS, in_rooms, people, write_participants, write_registrar

MOST_SECONDS = 25.0  # of one core, for the papers of the whole class
SPARES = 3
LATE = "student,name\n0099,Grace Hopper\n"


@dataclass(frozen=True)
class Midterm:
    """A folder with bank and roster, in which EXAM is made; the seconds that took."""

    folder: Path
    seconds: float
    said: str

    @property
    def exam(self) -> Path:
        """The exam folder."""
        return self.folder / "EXAM"


def set_exam(folder: Path, count: int, spares: int) -> Midterm:
    """The midterm of so many students, from a registrar's workbook."""
    roster = write_registrar(folder / "list.xlsx", people(count))
    begin = process_time()
    wishes = "--spare", str(spares), "--jobs", "1"
    done = kinegrade("generate", write_bank(folder), roster, "-o", folder / "EXAM", *wishes)
    seconds = process_time() - begin
    assert done.exit_code == 0, done.stderr
    return Midterm(folder, seconds, done.stderr)


@pytest.fixture(scope="module")
def midterm(tmp_path_factory: pytest.TempPathFactory) -> Midterm:
    """The midterm of the whole class; not to be changed."""
    return set_exam(tmp_path_factory.mktemp("midterm"), CLASS, SPARES)


@pytest.fixture(scope="module")
def seminar(tmp_path_factory: pytest.TempPathFactory) -> Midterm:
    """The same for six."""
    return set_exam(tmp_path_factory.mktemp("seminar"), 6, 2)


@pytest.fixture
def small(seminar: Midterm, tmp_path: Path) -> Midterm:
    """The same, to be changed."""
    shutil.copytree(seminar.folder, tmp_path, dirs_exist_ok=True)
    return Midterm(tmp_path, seminar.seconds, seminar.said)


def right(exam: Path) -> Mapping[str, list[str]]:
    """Everybody's right answers, in the order of the columns."""
    key, head = asks_of(exam), open_exam(exam).head
    return {
        student: [str(key[student, column]["decimal"]) for column in head.columns]
        for student in open_exam(exam).students
    }


def mark(midterm: Midterm, file: Path, *options: str) -> Result:
    """Mark a file of answers into MARKS."""
    marks = midterm.folder / "MARKS"
    return kinegrade("grade", midterm.exam, file, "-o", marks, "--force", *options)


def write_answers(midterm: Midterm, rows: list[list[str]], delimiter: str = ",") -> Path:
    """A sheet of answers as somebody saved it."""
    path = midterm.folder / "typed.csv"
    with path.open("w", encoding="utf-8", newline="") as lines:
        sheet = csv.writer(lines, delimiter=delimiter)
        sheet.writerow(["student", *open_exam(midterm.exam).head.columns])
        sheet.writerows(rows)
    return path


def totals(midterm: Midterm) -> dict[str, tuple[str, str]]:
    """Everybody's points and status."""
    rows = table(midterm.folder / "MARKS" / "grades.csv")
    return {row["student"]: (row["total"], row["status"]) for row in rows}


def test_row_8_what_the_roster_says_of_a_student_is_on_the_paper(midterm: Midterm) -> None:
    everybody = people()
    extra = next(each for each in everybody if each.extra_time)
    text = read_text(midterm.exam / "papers" / f"{extra.student}.pdf")
    for stated in (extra.room, extra.name, "25 %", "Mechanics"):
        assert stated in text
    chinese = read_text(midterm.exam / "papers" / f"{everybody[0].student}.pdf")
    assert "期中考试" in chinese
    assert "Midterm" not in chinese
    assert "group from" in midterm.said


def test_row_8_feedback_is_in_the_language_of_the_paper(small: Midterm) -> None:
    rows = [[student, *answers] for student, answers in right(small.exam).items()]
    assert mark(small, write_answers(small, rows)).exit_code == 0
    sheets = small.folder / "FEEDBACK"
    wishes = "-o", sheets, "--format", "md"
    done = kinegrade("feedback", small.exam, small.folder / "MARKS", *wishes)
    assert done.exit_code == 0, done.stderr
    everybody = people(6)
    chinese = (sheets / "sheets" / f"{everybody[0].student}.md").read_text(encoding="utf-8")
    assert "期中考试" in chinese
    assert "力学" in chinese
    assert "理论题" in chinese
    assert "Midterm" not in chinese
    assert "Theory" not in chinese
    page = small.folder / "class.html"
    assert kinegrade("report", small.exam, small.folder / "MARKS", "-o", page).exit_code == 0
    assert re.search(r"<t[dh][^>]*>A</t[dh]>", page.read_text(encoding="utf-8"))


def test_row_9_each_room_has_a_booklet_and_papers_have_equal_pages(midterm: Midterm) -> None:
    books = {
        name: read_text(midterm.exam / "rooms" / f"{name.replace(' ', '-')}.pdf")
        for name, _ in in_rooms(people())
    }
    for room, seated in in_rooms(people()):
        places = [books[room].index(student) for student in seated]
        assert places == sorted(places)
    pages = {len(PdfReader(file).pages) for file in (midterm.exam / "papers").glob("*.pdf")}
    assert len(pages) == 1
    assert len(list((midterm.exam / "papers").glob("spare-*.pdf"))) == SPARES


def test_row_9_one_paper_again_is_the_paper_that_was_lost(midterm: Midterm, tmp_path: Path) -> None:
    student, again = people()[5].student, tmp_path / "again.pdf"
    assert kinegrade("paper", midterm.exam, student, "-o", again).exit_code == 0
    assert again.read_bytes() == (midterm.exam / "papers" / f"{student}.pdf").read_bytes()


def test_row_9_a_spare_paper_is_claimed(small: Midterm) -> None:
    code = open_exam(small.exam).head.spares[0].paper
    done = kinegrade("assign", small.exam, code, "0098", "--name", "Dora Noble")
    assert done.exit_code == 0, done.stderr
    assert "Dora Noble" in read_text(small.exam / "spare-key.pdf")
    answers = right(small.exam)["0098"]
    path = write_answers(small, [["", *answers]])
    coded = path.read_text(encoding="utf-8").replace("student", "student,paper")
    path.write_text(coded.replace("\n,", f"\n,{code},").replace("\r", ""), encoding="utf-8")
    said = mark(small, path).stderr
    assert 'marked as the paper of "0098", by its code' in said
    assert totals(small)["0098"] == ("7", "marked")


def test_row_9_a_typo_is_corrected_and_numbers_stay(small: Midterm) -> None:
    key = (small.exam / "key.jsonl").read_bytes()
    template = small.folder / "crank.toml"
    template.write_text(crank_text(), encoding="utf-8")
    again = "reprint", small.exam, "--template", template, "--jobs", "1"
    done = kinegrade(*again)
    assert done.exit_code == 0, done.stderr
    english = next(each for each in people(6) if not each.language)
    assert "The crank" in read_text(small.exam / "papers" / f"{english.student}.pdf")
    assert (small.exam / "key.jsonl").read_bytes() == key
    template.write_text(crank_text(('"y(velocity(A))"', '"2*y(velocity(A))"')), encoding="utf-8")
    assert kinegrade(*again).exit_code == 2
    accepted = kinegrade(*again, "--accept-changes")
    assert accepted.exit_code == 1
    assert "marks that were given before" in accepted.stderr


def test_row_9_a_late_student_gets_a_paper_and_nobody_else_changes(small: Midterm) -> None:
    late = small.folder / "late.csv"
    late.write_text(LATE, encoding="utf-8")
    papers = contents(small.exam / "papers")
    files = small.folder / "bank.toml", small.folder / "list.xlsx", "-o", small.exam
    done = kinegrade("generate", *files, "--add", late, "--jobs", "1")
    assert done.exit_code == 0, done.stderr
    after = contents(small.exam / "papers")
    assert set(after) - set(papers) == {"0099.pdf"}
    assert {name: after[name] for name in papers} == papers


def test_row_10_a_midterm_takes_seconds_and_solutions_come_when_asked_for(
    midterm: Midterm, small: Midterm
) -> None:
    assert midterm.seconds < MOST_SECONDS
    assert not (midterm.exam / "solutions").exists()
    student = people(6)[2].student
    assert kinegrade("solutions", small.exam, student, "--jobs", "1").exit_code == 0
    assert (small.exam / "solutions" / f"{student}.pdf").exists()


def test_row_11_generating_again_keeps_the_papers_or_is_refused(small: Midterm) -> None:
    key = (small.exam / "key.jsonl").read_bytes()
    files = small.folder / "bank.toml", small.folder / "list.xlsx", "-o", small.exam
    assert kinegrade("generate", *files, "--jobs", "1").exit_code == 2
    again = kinegrade("generate", *files, "--force", "--jobs", "1")
    assert "6 papers keep their numbers, 0 changed" in again.stderr
    assert (small.exam / "key.jsonl").read_bytes() == key
    other = kinegrade("generate", *files, "--force", "--seed", "other", "--jobs", "1")
    assert other.exit_code == 2
    assert "add --new-numbers" in other.stderr
    assert (small.exam / "key.jsonl").read_bytes() == key


def test_row_14_a_workbook_is_typed_into(small: Midterm) -> None:
    path = small.exam / "answers.xlsx"
    workbook = load_workbook(path)
    sheet = workbook.active
    assert sheet is not None
    given = right(small.exam)
    for row in sheet.iter_rows(min_row=3):
        for cell, answer in zip(row[3:], given.get(str(row[0].value), []), strict=False):
            cell.value = float(answer)
    filled = small.folder / "filled.xlsx"
    workbook.save(filled)
    done = mark(small, filled)
    assert done.exit_code == 0, done.stderr
    assert {points for points, _ in totals(small).values()} == {"7"}


def test_row_14_ids_without_their_zeros_are_repaired_and_said_once(midterm: Midterm) -> None:
    rows = [[student.lstrip("0"), *answers] for student, answers in right(midterm.exam).items()]
    (said,) = (
        line
        for line in mark(midterm, write_answers(midterm, rows)).stderr.splitlines()
        if "not as in the exam" in line
    )
    assert f"{CLASS} student ids" in said
    assert {points for points, _ in totals(midterm).values()} == {"7"}


def test_row_15_decimal_commas_hide_no_complaint(midterm: Midterm) -> None:
    rows = [
        [student, *(answer.replace(".", ",") for answer in answers)]
        for student, answers in right(midterm.exam).items()
    ]
    rows[7][1] = "?"
    done = mark(midterm, write_answers(midterm, rows, ";"))
    complaints = [line for line in done.stderr.splitlines() if line.startswith("complaint")]
    (only,) = complaints
    assert '"?" is not a number' in only


def test_row_20_absent_is_told_apart_from_zero(small: Midterm) -> None:
    given = right(small.exam)
    first, second, *others = given
    rows = [[student, *given[student]] for student in others]
    mark(small, write_answers(small, [[first, "0", "0"], *rows]))
    found = totals(small)
    assert found[first] == ("0", "marked")
    assert found[second] == ("0", "absent")


def test_row_23_next_year_nobody_gets_numbers_of_this_year(
    midterm: Midterm, tmp_path: Path
) -> None:
    roster = write_participants(tmp_path / "next.csv", people(6))
    exam = tmp_path / "EXAM"
    wishes = "-o", exam, "--avoid", midterm.exam, "--jobs", "1"
    done = kinegrade("generate", write_bank(tmp_path, MIDTERM), roster, *wishes)
    assert done.exit_code == 0, done.stderr
    dealt = [list_dealt(folder) for folder in (midterm.exam, exam)]
    assert dealt[0] & dealt[1] == set()
    assert "left" in done.stderr


def list_dealt(exam: Path) -> set[tuple[str, str]]:
    """What anybody was dealt, by question."""
    return {
        (question.question, str(sorted(question.values.items())))
        for line in open_exam(exam).keys.lines()
        for question in line.questions
    }


def test_row_24_messages_are_in_the_language_of_who_reads_them(
    small: Midterm, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    student, answers = next(iter(right(small.exam).items()))
    said = mark(small, write_answers(small, [[student, "?", *answers[1:]]])).stderr
    assert "不是一个数 - 无法识别，不得分" in said
    assert "complaint" not in said


PLAN = """[parts.midterm]
marks = ["MARKS"]
weight = "100 %"

[scale]
kind = "german"
absent = "n.e."
"""


def test_row_21_a_scale_gives_grades_and_absent_students_have_none(small: Midterm) -> None:
    given = right(small.exam)
    (best, worse, absent), rest = list(given)[:3], list(given)[3:]
    rows = [[best, *given[best]], [worse, given[worse][0], "0"], [absent, "", ""]]
    rows += [[student, "0", "0"] for student in rest]
    assert mark(small, write_answers(small, rows)).exit_code < 2
    plan = small.folder / "plan.toml"
    plan.write_text(PLAN, encoding="utf-8")
    output = small.folder / "term.csv"
    done = kinegrade("term", small.folder / "MARKS", "--plan", plan, "-o", output)
    graded = {row["student"]: (row["grade"], row["status"]) for row in table(output)}
    assert graded[best] == ("1.0", "marked")
    assert graded[worse] == ("3.7", "marked")
    assert graded[absent] == ("n.e.", "absent")
    assert {graded[student] for student in rest} == {("5.0", "marked")}
    assert f"grades: 2 of {len(given) - 1} passed" in done.stderr
