"""Students who wrote another paper than their own get that paper; through the command line."""

from __future__ import annotations

import csv
import shutil
from pathlib import Path

import pytest
from pypdf import PdfReader

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.records import ExamHead
from tests.small_class import BANK, contents, generate, kinegrade, table, write_class


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with an exam that has a spare paper; not to be changed."""
    folder = write_class(tmp_path_factory.mktemp("exchanged"))
    assert generate(folder, "EXAM", "--spare", "1", "--solutions").exit_code == 0
    return folder


@pytest.fixture(scope="module")
def made_in_versions(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with an exam in two versions; not to be changed."""
    folder = write_class(tmp_path_factory.mktemp("versions"))
    (folder / "bank.toml").write_text(f"versions = 2\n{BANK}", encoding="utf-8")
    assert generate(folder).exit_code == 0
    return folder


@pytest.fixture
def exam(made: Path, tmp_path: Path) -> Path:
    """The exam with a spare paper, to be changed."""
    shutil.copytree(made, tmp_path, dirs_exist_ok=True)
    return tmp_path / "EXAM"


@pytest.fixture
def versions(made_in_versions: Path, tmp_path: Path) -> Path:
    """The exam in two versions, to be changed."""
    shutil.copytree(made_in_versions, tmp_path, dirs_exist_ok=True)
    return tmp_path / "EXAM"


def read_totals(exam: Path, answers: str) -> dict[str, str]:
    """The totals by student, by these answers."""
    sheet = exam.with_name("typed.csv")
    sheet.write_text(answers, encoding="utf-8")
    marks = exam.with_name("MARKS")
    kinegrade("grade", exam, sheet, "-o", marks, "--force", "--own-papers")
    with (marks / "grades.csv").open(encoding="utf-8-sig", newline="") as lines:
        return {row["student"]: row["total"] for row in csv.DictReader(lines)}


def right_answer(exam: Path, student: str) -> str:
    """What is right for the first ask of a student's paper."""
    return str(open_exam(exam).keys.line_of(student).questions[0].asks["v_B"].decimal)


def read_codes(head: ExamHead) -> dict[str, str]:
    return {each.student: each.paper for each in head.everybody}


def test_two_students_who_wrote_each_others_papers_are_marked_by_these(exam: Path) -> None:
    before, codes = contents(exam), read_codes(open_exam(exam).head)
    written = {"007": right_answer(exam, "0012"), "0012": right_answer(exam, "007")}
    answers = "student,q1.v_B\n" + "".join(f"{who},{what}\n" for who, what in written.items())
    assert read_totals(exam, answers)["007"] == read_totals(exam, answers)["0012"] == "0"
    done = kinegrade("exchange", exam, codes["0012"], "007")
    assert done.exit_code == 0, done.stderr
    assert done.stderr == (
        f'{exam}: "007" has paper {codes["0012"]} now, and "0012" has paper {codes["007"]} now; '
        "grade again what was graded before\n"
    )
    assert read_totals(exam, answers)["007"] == read_totals(exam, answers)["0012"] == "3"
    after = contents(exam)
    assert set(after) == set(before)
    same = {name for name in after if after[name] == before[name]}
    assert {"papers/spare-1.pdf", "spares.jsonl", "bank.toml", "spare-key.pdf"} <= same
    assert "papers/007.pdf" not in same
    paper = PdfReader(exam / "papers" / "007.pdf").pages[0].extract_text()
    assert codes["0012"] in paper
    for student in ("007", "0012"):
        again = kinegrade("paper", exam, student)
        assert again.stdout_bytes == after[f"papers/{student}.pdf"], again.stderr
        solution = kinegrade("paper", exam, student, "--solution")
        assert solution.stdout_bytes == after[f"solutions/{student}.pdf"]
    back = kinegrade("exchange", exam, codes["007"], "007")
    assert back.exit_code == 0, back.stderr
    left = contents(exam)
    assert {name for name in left if left[name] != before[name]} <= {"exam.json", "key.npz"}


def test_marks_by_the_papers_as_they_were_are_no_longer_used(exam: Path) -> None:
    read_totals(exam, "student,q1.v_B\n007,1\n")
    code = open_exam(exam).head.candidates["0012"].paper
    assert kinegrade("exchange", exam, code, "007").exit_code == 0
    marks, sheets = exam.with_name("MARKS"), exam.with_name("FEEDBACK")
    for command in (("feedback", exam, marks, "-o", sheets), ("explain", exam, marks, "007")):
        refused = kinegrade(*command)
        assert refused.exit_code == 2
        said = "the key of the exam was corrected, or papers changed hands, after these marks"
        assert said in refused.stderr


def test_whoever_wrote_a_spare_paper_in_place_of_the_own_one_gets_it(exam: Path) -> None:
    codes = read_codes(open_exam(exam).head)
    spare, right = codes["spare-1"], right_answer(exam, "spare-1")
    done = kinegrade("exchange", exam, spare, "0012")
    assert done.exit_code == 0, done.stderr
    said = f'"0012" has paper {spare} now, and {codes["0012"]} is a spare paper; grade again'
    assert said in done.stderr
    assert read_totals(exam, f"student,q1.v_B\n0012,{right}\n")["0012"] == "3"
    assert [each.paper for each in open_exam(exam).head.spares] == [codes["0012"]]
    assigned = kinegrade("assign", exam, codes["0012"], "0099")
    assert assigned.exit_code == 0, assigned.stderr


def test_a_spare_paper_that_was_assigned_to_a_mistyped_id_is_passed_on(exam: Path) -> None:
    code = open_exam(exam).head.spares[0].paper
    assert kinegrade("assign", exam, code, "0990", "--name", "Dora Noble").exit_code == 0
    sheet = exam / "answers.csv"
    sheet.write_text(sheet.read_text("utf-8-sig").replace("Noble,,", "Noble,1.5,"), "utf-8-sig")
    refused = kinegrade("assign", exam, code, "0099", "--name", "Dora Noble")
    assert refused.exit_code == 2
    assert "it was assigned to the wrong student, use kinegrade exchange" in refused.stderr
    done = kinegrade("exchange", exam, code, "0099")
    assert done.exit_code == 0, done.stderr
    assert (
        f'EXAM: paper {code} is that of "0099", Dora Noble, now, and no longer of "0990"'
        in done.stderr
    )
    folder = open_exam(exam)
    assert folder.students == ("007", "0012", "a/b", "=2", "0099")
    assert folder.head.candidates["0099"].paper == code
    assert "0099,Dora Noble,1.5," in sheet.read_text("utf-8-sig")
    assert "0990" not in sheet.read_text("utf-8-sig")
    assert not list(exam.glob("**/0990*"))
    assert (exam / "solutions" / "0099.pdf").exists()
    assert "0990" not in "".join(
        page.extract_text() for page in PdfReader(exam / "spare-key.pdf").pages
    )


def test_what_was_marked_for_a_mistyped_id_goes_on_with_its_paper(exam: Path) -> None:
    code, right = open_exam(exam).head.spares[0].paper, right_answer(exam, "spare-1")
    assert kinegrade("assign", exam, code, "0990").exit_code == 0
    sheet, hands, marks = (exam.with_name(name) for name in ("typed.csv", "hands.csv", "MARKS"))
    sheet.write_text(f"student,q1.v_B\n0990,{right}\n", encoding="utf-8")
    hands.write_text("student,question,points\n0990,bonus,2\n", encoding="utf-8")
    again = "grade", exam, sheet, "-o", marks, "--force", "--own-papers"
    kinegrade(*again, "--manual", hands)
    shutil.copytree(marks, before := exam.with_name("BEFORE"))
    assert kinegrade("exchange", exam, code, "0099").exit_code == 0
    done = kinegrade(*again)
    assert done.exit_code == 1, done.stderr
    said = 'typed.csv: 1 student id is an earlier one: "0990" for "0099"'
    assert said in done.stderr
    assert "1 mark by hand carried over" in done.stderr
    assert {row["student"]: row["total"] for row in table(marks / "grades.csv")}["0099"] == "5"
    sheet.write_text("student,q1.v_B\n0099,?\n", encoding="utf-8")
    lower = *again[:3], "-o", exam.with_name("NEW"), "--never-lower", before, "--own-papers"
    assert "no student" not in kinegrade(*lower).stderr
    kept = {row["student"]: row["total"] for row in table(exam.parent / "NEW" / "grades.csv")}
    assert kept["0099"] == "5"


def test_a_student_who_sat_another_version_is_marked_by_that(versions: Path) -> None:
    head = open_exam(versions).head
    first = head.students[0]
    other = next(each for each in head.students if each.version != first.version)
    right = right_answer(versions, other.student)
    done = kinegrade("exchange", versions, other.version, first.student)
    assert done.exit_code == 0, done.stderr
    changed = open_exam(versions).head.students[0]
    assert changed.version == other.version
    assert changed.paper == f"{other.version}{first.paper[1:]}"
    said = f'"{first.student}" has version {other.version} now, paper {changed.paper}; grade again'
    assert said in done.stderr
    answers = f"student,q1.v_B\n{first.student},{right}\n{other.student},{right}\n"
    totals = read_totals(versions, answers)
    assert totals[first.student] == totals[other.student] == "3"
    again = kinegrade("paper", versions, first.student)
    assert again.stdout_bytes == (versions / "papers" / f"{first.student}.pdf").read_bytes()


@pytest.mark.parametrize(
    ("code", "student", "said"),
    [
        ("XXXX-XXXX", "007", 'no paper has the code "XXXX-XXXX" - known here: '),
        ("OF 007", "007", 'is that of "007" already - name the paper that was written'),
        ("OF 007", "0099", 'is that of "007" already - only a spare paper that was assigned'),
        ("OF spare-1", "0099", '"0099" has no paper to exchange - kinegrade assign gives'),
    ],
)
def test_what_cannot_be_exchanged_is_refused_and_nothing_is_written(
    exam: Path, code: str, student: str, said: str
) -> None:
    before, codes = contents(exam), read_codes(open_exam(exam).head)
    written = codes.get(code.removeprefix("OF "), code)
    result = kinegrade("exchange", exam, written, student)
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert said in line
    assert contents(exam) == before


def test_a_paper_passed_on_to_somebody_else_has_that_name(exam: Path) -> None:
    code = open_exam(exam).head.spares[0].paper
    kinegrade("assign", exam, code, "0990", "--name", "Zoe", "--email", "zoe@example.org")
    done = kinegrade("exchange", exam, code, "0099", "--name", "Dora Noble")
    assert done.exit_code == 0, done.stderr
    owner = open_exam(exam).head.candidates["0099"]
    assert (owner.name, owner.email) == ("Dora Noble", "")
    own = kinegrade("exchange", exam, code, "007", "--name", "Eve")
    assert '"007" is in the exam already, with a name of the roster - leave out' in own.stderr


def test_a_workbook_that_was_typed_into_has_the_codes_before(exam: Path) -> None:
    (exam / "answers.xlsx").write_bytes((exam / "answers.xlsx").read_bytes() + b"typed")
    code = open_exam(exam).head.candidates["0012"].paper
    done = kinegrade("exchange", exam, code, "007")
    assert "answers.xlsx stays as it was typed; the codes in its column paper are" in done.stderr


def test_a_workbook_that_was_typed_into_has_the_ids_before(exam: Path) -> None:
    (exam / "answers.xlsx").write_bytes((exam / "answers.xlsx").read_bytes() + b"typed")
    done = kinegrade("exchange", exam, "0012", "4711", "--new-id")
    assert "answers.xlsx stays as it was typed; rows with ids of before count" in done.stderr


def test_the_own_version_and_one_that_nobody_has_are_refused(versions: Path) -> None:
    first = open_exam(versions).head.students[0]
    own = kinegrade("exchange", versions, first.version, first.student)
    assert "already - name the paper that was written" in own.stderr
    folder = versions / "exam.json"
    folder.write_text(folder.read_text("utf-8").replace('"B"\n', '"B",\n  "C"\n'), "utf-8")
    unheld = kinegrade("exchange", versions, "C", first.student)
    assert unheld.exit_code == 2
    assert "nobody has version C" in unheld.stderr


def test_a_quiz_of_versions_says_where_it_stands_who_has_which(versions: Path) -> None:
    done = kinegrade("quiz", versions, "--to", "moodle-xml", "-o", versions.with_name("quiz"))
    assert "who has which version: the letter before the code, in the column paper" in done.stderr
    pooled = ("--variants", "2", "-o", versions.with_name("pool.xml"))
    assert "who has which" not in kinegrade("quiz", versions, "--to", "moodle-xml", *pooled).stderr


def test_papers_of_which_a_pool_was_made_are_not_exchanged(exam: Path) -> None:
    pooled = ("--to", "moodle-xml", "--variants", "2", "-o", exam.with_name("pool.xml"))
    assert kinegrade("quiz", exam, *pooled).exit_code in (0, 1)
    before, code = contents(exam), open_exam(exam).head.candidates["0012"].paper
    refused = kinegrade("exchange", exam, code, "007")
    assert refused.exit_code == 2
    assert "a quiz pool was made of these papers" in refused.stderr
    assert "answers to the pool need no exchange" in refused.stderr
    assert contents(exam) == before


def test_a_pool_that_nobody_answered_is_given_up_for_an_exchange(exam: Path) -> None:
    pooled = ("--to", "moodle-xml", "--variants", "2", "-o", exam.with_name("pool.xml"))
    kinegrade("quiz", exam, *pooled)
    right, code = right_answer(exam, "0012"), open_exam(exam).head.candidates["0012"].paper
    assert "--drop-pool removes the pool" in kinegrade("exchange", exam, code, "007").stderr
    done = kinegrade("exchange", exam, code, "007", "--drop-pool")
    assert done.exit_code == 0, done.stderr
    gone = f"{exam / 'variants.jsonl'} is gone: responses to that pool can no longer be marked"
    assert gone in done.stderr
    assert not (exam / "variants.jsonl").exists()
    assert read_totals(exam, f"student,q1.v_B\n007,{right}\n")["007"] == "3"
    assert kinegrade("verify", exam, "--all").exit_code == 0
    assert kinegrade("quiz", exam, *pooled, "--force").exit_code in (0, 1)
