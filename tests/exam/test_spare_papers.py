"""Papers without a student, and how they come to belong to one; through the command line."""

from __future__ import annotations

import csv
import shutil
from pathlib import Path
from typing import Any

import pytest
from pypdf import PdfReader

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.owners import assigning
from tests.small_class import BANK, ROSTER, contents, generate, kinegrade, write_class

CHANGED = (
    "changed while this command ran, perhaps by another one; what stands there stays - "
    "expected one command at a time - give this command again"
)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with an exam that has two spare papers, questions shuffled; not to be changed."""
    folder = write_class(tmp_path_factory.mktemp("spare"))
    (folder / "bank.toml").write_text(f"shuffle = true\n{BANK}", encoding="utf-8")
    result = generate(folder, "EXAM", "--spare", "2", "--solutions", "--also", "html")
    assert result.exit_code == 0, result.stderr
    return folder


@pytest.fixture
def exam(made: Path, tmp_path: Path) -> Path:
    """The exam, to be changed."""
    shutil.copytree(made, tmp_path, dirs_exist_ok=True)
    return tmp_path / "EXAM"


def list_codes(exam: Path) -> list[str]:
    """The codes of the spare papers."""
    return [each.paper for each in open_exam(exam).head.spares]


def read_ids(sheet: Path) -> list[str]:
    """Whose rows an answer sheet has."""
    with sheet.open(encoding="utf-8-sig", newline="") as lines:
        return [row["student"] for row in csv.DictReader(lines)]


def test_a_spare_paper_has_a_code_and_lines_to_write_on(exam: Path) -> None:
    code, _ = list_codes(exam)
    text = PdfReader(exam / "papers" / "spare-1.pdf").pages[0].extract_text()
    assert code in text
    assert "spare" not in text
    page = (exam / "papers" / "spare-1.html").read_text(encoding="utf-8")
    assert page.count("________________________") == 2
    again = kinegrade("paper", exam, code.lower().replace("-", ""))
    assert again.stdout_bytes == (exam / "papers" / "spare-1.pdf").read_bytes()
    assert open_exam(exam).students == ("007", "0012", "a/b", "=2")
    assert read_ids(exam / "answers.csv") == ["007", "0012", "a/b", "=2"]


def test_an_assigned_paper_is_that_of_the_student(exam: Path, tmp_path: Path) -> None:
    before, code = contents(exam), list_codes(exam)[0]
    line = open_exam(exam).keys.line_of("spare-1")
    done = kinegrade("assign", exam, code, "0099", "--name", "Dora Noble")
    assert done.exit_code == 0, done.stderr
    assert f'EXAM: paper {code} is that of "0099"; 1 spare paper is left' in done.stderr
    after, folder = contents(exam), open_exam(exam)
    assert folder.keys.line_of("0099").questions == line.questions
    assert folder.head.candidates["0099"].paper == code
    own = {"papers/0099.pdf", "papers/0099.html", "solutions/0099.pdf"}
    assert set(after) - set(before) == own
    gone = {name.replace("0099", "spare-1") for name in own}
    assert set(before) - set(after) == gone
    changed = {name for name in set(after) & set(before) if after[name] != before[name]}
    assert changed == {
        "answers.csv",
        "answers.xlsx",
        "exam.json",
        "key.jsonl",
        "key.npz",
        "spare-key.pdf",
        "spares.jsonl",
        "papers.pdf",
        "solutions.pdf",
    }
    assert "Dora Noble" in PdfReader(exam / "papers" / "0099.pdf").pages[0].extract_text()
    key = "".join(page.extract_text() for page in PdfReader(exam / "spare-key.pdf").pages)
    assert "Dora Noble" in key
    assert "spare-1" not in key
    assert "spare-2" in key
    assert kinegrade("paper", exam, "0099").stdout_bytes == after["papers/0099.pdf"]
    right = folder.keys.line_of("0099").questions[0].asks["v_B"].decimal
    (tmp_path / "answers.csv").write_text(f"paper,q1.v_B\n{code},{right}\n", encoding="utf-8")
    kinegrade("grade", exam, tmp_path / "answers.csv", "-o", tmp_path / "MARKS")
    with (tmp_path / "MARKS" / "grades.csv").open(encoding="utf-8-sig", newline="") as lines:
        totals = {row["student"]: row["total"] for row in csv.DictReader(lines)}
    assert totals["0099"] == "3"


def test_an_exam_is_whole_after_a_spare_paper_was_assigned(exam: Path) -> None:
    assert kinegrade("assign", exam, list_codes(exam)[0], "0099", "--name", "Dora").exit_code == 0
    result = kinegrade("verify", exam)
    assert (result.exit_code, "not as it was generated" in result.stderr) == (0, False)
    (exam / "papers" / "0099.html").write_text("edited", encoding="utf-8")
    (exam / "papers" / "007.html").unlink()
    said = kinegrade("verify", exam).stderr.splitlines()
    assert sorted(line for line in said if "not as it was generated" in line) == [
        f"complaint: {exam}/papers/{name}.html: is not as it was generated"
        for name in ("007", "0099")
    ]


def test_of_two_papers_assigned_at_once_the_second_is_refused(
    exam: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    codes = list_codes(exam)

    def come_first(*arguments: Any) -> Candidate:
        monkeypatch.undo()
        kinegrade("assign", exam, codes[1], "0098")
        return assigning.make_owner(*arguments)

    monkeypatch.setattr(assigning, "make_owner", come_first)
    done = kinegrade("assign", exam, codes[0], "0099")
    assert done.exit_code == 2
    assert done.stderr == f"error: {exam}: {CHANGED}\n"
    assert list_codes(exam) == codes[:1]
    assert "0098" in open_exam(exam).students


def test_answers_typed_into_the_workbook_outlive_an_assigned_paper(exam: Path) -> None:
    typed = (exam / "answers.xlsx").read_bytes() + b"typed"
    (exam / "answers.xlsx").write_bytes(typed)
    result = kinegrade("assign", exam, list_codes(exam)[0], "1009")
    assert result.exit_code == 0, result.stderr
    assert 'stays as it was typed; type the answers of "1009" into a new row' in result.stderr
    assert (exam / "answers.xlsx").read_bytes() == typed


@pytest.mark.left(beside="test_an_assigned_paper_is_that_of_the_student")
def test_spare_and_assigned_papers_outlive_a_class_that_grows_or_is_set_again(
    exam: Path, tmp_path: Path
) -> None:
    first, second = list_codes(exam)
    assert kinegrade("assign", exam, first, "0099", "--name", "Dora").exit_code == 0
    paper, spare = (exam / "papers" / f"{name}.pdf" for name in ("0099", "spare-2"))
    printed = paper.read_bytes(), spare.read_bytes()
    (tmp_path / "roster.csv").write_text(f"{ROSTER}0099,Dora,\n", encoding="utf-8")
    (tmp_path / "late.csv").write_text("student,name\n0100,Eve\n", encoding="utf-8")
    files = (tmp_path / "bank.toml", tmp_path / "roster.csv", "-o", exam, "--allow-odd-ids")
    added = kinegrade("generate", *files, "--add", tmp_path / "late.csv")
    assert added.exit_code == 0, added.stderr
    assert list_codes(exam) == [second]
    (tmp_path / "roster.csv").write_text(f"{ROSTER}0099,Dora,\n0100,Eve,\n", encoding="utf-8")
    again = generate(tmp_path, "EXAM", "--force", "--spare", "2", "--solutions", "--also", "html")
    assert again.exit_code == 0, again.stderr
    assert "6 papers keep their numbers, 0 changed, 0 gone, 0 new" in again.stderr
    assert (paper.read_bytes(), spare.read_bytes()) == printed
    assert list_codes(exam)[0] == second
    codes = [each.paper for each in open_exam(exam).head.students]
    assert len({*codes, *list_codes(exam)}) == 8


@pytest.mark.parametrize(
    ("code", "student", "said"),
    [
        ("XXXX-XXXX", "0099", 'no spare paper has the code "XXXX-XXXX" - the codes of spare'),
        ("CODE", "0012", '"0012" has a paper already - expected students without one'),
        (
            "CODE",
            "12",
            'student "0012" has a paper already, and "12" differs from that id by zeros',
        ),
        ("CODE", " ", "EXAM/exam.json: "),
        ("OF 0012", "0099", 'is that of "0012" already'),
    ],
)
def test_what_cannot_be_assigned_is_refused_and_nothing_is_written(
    exam: Path, code: str, student: str, said: str
) -> None:
    before = contents(exam)
    codes = {"CODE": list_codes(exam)[0], "OF 0012": open_exam(exam).head.candidates["0012"].paper}
    result = kinegrade("assign", exam, codes.get(code, code), student)
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert said in line
    assert contents(exam) == before


def test_an_exam_without_spare_papers_says_how_late_students_get_theirs(tmp_path: Path) -> None:
    write_class(tmp_path)
    assert generate(tmp_path).exit_code == 0
    assert not (tmp_path / "EXAM" / "spares.jsonl").exists()
    result = kinegrade("assign", tmp_path / "EXAM", "XXXX-XXXX", "0099")
    assert "all spare papers are assigned, or there were none; late students" in result.stderr


@pytest.mark.parametrize(
    ("header", "row", "said"),
    [
        ("student", "{code}", "{code} is a spare paper, which is nobody's yet - not graded until"),
        ("student,paper", "007,{code}", "the paper with this code is a spare one - marked as the"),
    ],
)
def test_answers_on_a_spare_paper_that_is_nobodys_say_how_it_is_assigned(
    exam: Path, tmp_path: Path, header: str, row: str, said: str
) -> None:
    code = list_codes(exam)[0]
    sheet = tmp_path / "answers.csv"
    sheet.write_text(f"{header},q1.v_B\n{row.format(code=code)},1\n", encoding="utf-8")
    result = kinegrade("grade", exam, sheet, "-o", tmp_path / "MARKS")
    assert said.format(code=code) in result.stderr
    way = "exchange" if "paper" in header else "assign"
    assert f"kinegrade {way} EXAM {code}" in result.stderr
