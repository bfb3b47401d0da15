"""A student who has another id now keeps the paper, and files that have the old id are still read;
through the command line.
"""

from __future__ import annotations

import errno
import os
import shutil
from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from tests.exam.test_exchanged_papers import right_answer
from tests.small_class import ROSTER, contents, generate, kinegrade, table, write_class

NEW = ("--new-id", "--email", "new@example.org")


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with an exam that has a spare paper; not to be changed."""
    folder = write_class(tmp_path_factory.mktemp("new-ids"))
    assert generate(folder, "EXAM", "--spare", "1", "--solutions").exit_code == 0
    return folder


@pytest.fixture
def exam(made: Path, tmp_path: Path) -> Path:
    """The exam, to be changed."""
    shutil.copytree(made, tmp_path, dirs_exist_ok=True)
    return tmp_path / "EXAM"


def test_a_student_keeps_the_paper_under_a_new_id(exam: Path) -> None:
    before, right = open_exam(exam).head.candidates["0012"], right_answer(exam, "0012")
    refused = kinegrade("exchange", exam, before.paper, "4711")
    assert "a student whose id has changed keeps the paper by --new-id" in refused.stderr
    done = kinegrade("exchange", exam, "0012", "4711", *NEW)
    assert done.exit_code == 0, done.stderr
    assert done.stderr == (
        f'{exam}: "0012" is "4711" now, with paper {before.paper} as before; '
        "grade again what was graded before\n"
    )
    after = open_exam(exam).head.candidates["4711"]
    kept = (after.name, after.paper, after.was_spare, after.email)
    assert kept == (before.name, before.paper, False, "new@example.org")
    assert right_answer(exam, "4711") == right
    assert kinegrade("verify", exam, "--all").exit_code == 0
    assert not list(exam.glob("**/0012*"))
    printed = (exam / "papers" / "4711.pdf").read_bytes()
    assert kinegrade("paper", exam, "4711").stdout_bytes == printed


def test_what_was_typed_and_marked_under_the_old_id_goes_on(exam: Path) -> None:
    sheet, hands, marks = (exam.with_name(name) for name in ("typed.csv", "hands.csv", "MARKS"))
    sheet.write_text(f"student,q1.v_B\n0012,{right_answer(exam, '0012')}\n", encoding="utf-8")
    hands.write_text("student,question,points\n12,bonus,2\n", encoding="utf-8")
    again = "grade", exam, sheet, "-o", marks, "--force", "--own-papers"
    kinegrade(*again, "--manual", hands)
    kinegrade("exchange", exam, "0012", "4711", *NEW)
    done = kinegrade(*again, "--since", marks, "--reason", "new id")
    said = '1 student id is an earlier one: "0012" for "4711" - taken for this student'
    assert f"{sheet.name}: {said}" in done.stderr
    assert f"manual.csv: {said}" in done.stderr
    totals = {row["student"]: row["total"] for row in table(marks / "grades.csv")}
    assert (totals["4711"], "0012" in totals) == ("5", False)
    assert f"{len(totals)} unchanged" in done.stderr + done.stdout
    assert table(marks / "changes.csv") == []
    assert "4711" in kinegrade("explain", exam, marks, "0012").stdout


def test_answers_one_below_the_other_by_both_ids_are_those_of_one_attempt(exam: Path) -> None:
    """Those by the old id were nobody's as soon as the new one stood in the file."""
    sheet, marks = exam.with_name("typed.csv"), exam.with_name("MARKS")
    kinegrade("exchange", exam, "0012", "4711", *NEW)
    first, second, *_ = open_exam(exam).head.columns
    for one, other in (("0012", "4711"), ("4711", "0012")):
        lines = f"{one},{first},1.5\n{other},{second},2.5\n"
        sheet.write_text(f"student,ask,answer\n{lines}", encoding="utf-8")
        done = kinegrade("grade", exam, sheet, "-o", marks, "--force")
        assert "no student" not in done.stderr
        typed = {
            f"{row['question']}.{row['ask']}": row["response"]
            for row in table(marks / "marks.csv")
            if row["student"] == "4711"
        }
        assert (typed[first], typed[second]) == ("1.5", "2.5")


def test_rows_by_both_ids_are_attempts_of_one_student(exam: Path) -> None:
    sheet, marks = exam.with_name("typed.csv"), exam.with_name("MARKS")
    kinegrade("exchange", exam, "0012", "4711", *NEW)
    column = open_exam(exam).head.columns[0]
    sheet.write_text(f"student,{column}\n4711,1.5\n0012,2.5\n", encoding="utf-8")
    done = kinegrade("grade", exam, sheet, "-o", marks, "--force")
    assert "no student" not in done.stderr
    responses = [row["response"] for row in table(marks / "marks.csv") if row["student"] == "4711"]
    assert "2.5" in responses
    assert "1.5" not in responses


def test_what_was_changed_under_the_old_id_is_explained_under_the_new_one(exam: Path) -> None:
    sheet, hands, marks = (exam.with_name(name) for name in ("typed.csv", "hands.csv", "MARKS"))
    sheet.write_text("student,q1.v_B\n0012,1\n", encoding="utf-8")
    again = "grade", exam, sheet, "-o", marks, "--force", "--own-papers", "--manual", hands
    for points in (2, 3):
        hands.write_text(f"student,question,points\n0012,bonus,{points}\n", encoding="utf-8")
        known = ("--since", marks, "--reason", "a kinder look") if marks.exists() else ()
        kinegrade(*again, *known)
    kinegrade("exchange", exam, "0012", "4711", *NEW)
    kinegrade(*again, "--since", marks, "--reason", "new id")
    assert {row["student"] for row in table(marks / "changes.csv")} == {"0012"}
    assert "a kinder look" in kinegrade("explain", exam, marks, "4711").stdout


def test_markings_before_and_after_a_new_id_are_compared_by_student(exam: Path) -> None:
    sheet, first, second = (exam.with_name(name) for name in ("typed.csv", "MARKS", "AGAIN"))
    sheet.write_text(f"student,q1.v_B\n0012,{right_answer(exam, '0012')}\n", encoding="utf-8")
    kinegrade("grade", exam, sheet, "-o", first)
    kinegrade("exchange", exam, "0012", "4711", *NEW)
    kinegrade("grade", exam, sheet, "-o", second)
    assert table(second / "former-ids.csv") == [{"student": "4711", "formerly": "0012"}]
    said = kinegrade("diff", first, second).stdout
    assert "0 up, 0 down" in said
    assert "4711" not in said
    assert "0012" not in said


def test_a_term_tells_marks_that_have_the_old_id(exam: Path) -> None:
    sheet, first, second = (exam.with_name(name) for name in ("typed.csv", "QUIZ", "FINAL"))
    sheet.write_text("student,q1.v_B\n0012,1\n", encoding="utf-8")
    other = exam.with_name("OTHER")
    assert generate(exam.parent, "OTHER", "--reproducible", "another").exit_code == 0
    kinegrade("grade", other, sheet, "-o", first)
    kinegrade("exchange", exam, "0012", "4711", *NEW)
    kinegrade("grade", exam, sheet, "-o", second)
    said = kinegrade("term", first, second, "-o", exam.with_name("term.csv"))
    assert said.exit_code == 1
    assert (
        '0012: "0012" (in QUIZ) is "4711" in FINAL - mark these again; an exam that still has the '
        "old id gets the new one by kinegrade exchange EXAM OLD NEW --new-id\n"
    ) in said.stderr
    kinegrade("exchange", other, "0012", "4711", *NEW)
    kinegrade("grade", other, sheet, "-o", first, "--force")
    said = kinegrade("term", first, second, "-o", exam.with_name("term.csv"), "--force")
    assert "0012" not in said.stderr


PLAN = """parts.QUIZ.weight = "50 %"
parts.FINAL.weight = "50 %"
set-aside.QUIZ = ["0012"]
"""


def test_a_plan_of_a_term_may_have_the_old_id(exam: Path) -> None:
    sheet, first, second = (exam.with_name(name) for name in ("typed.csv", "QUIZ", "FINAL"))
    sheet.write_text("student,q1.v_B\n0012,1\n", encoding="utf-8")
    assert generate(exam.parent, "OTHER", "--reproducible", "another").exit_code == 0
    for each, marks in ((exam, first), (exam.with_name("OTHER"), second)):
        kinegrade("exchange", each, "0012", "N1", "--new-id")
        kinegrade("exchange", each, "N1", "4711", "--new-id")
        kinegrade("grade", each, sheet, "-o", marks)
    plan, term = exam.with_name("plan.toml"), exam.with_name("term.csv")
    for old in ("0012", "N1", "4711"):
        plan.write_text(PLAN.replace("0012", old), encoding="utf-8")
        done = kinegrade("term", first, second, "-o", term, "--plan", plan, "--force")
        assert done.exit_code == 0, done.stderr
        (row,) = [row for row in table(term) if row["student"] == "4711"]
        assert row["QUIZ"] == "excused"


def test_a_new_id_is_that_of_another_person_or_of_the_same_under_another_name(exam: Path) -> None:
    before = contents(exam)
    done = kinegrade("exchange", exam, "0012", "0012", "--new-id")
    assert done.exit_code == 2
    assert '"0012" has that id, and no other name, address or group is given' in done.stderr
    assert contents(exam) == before


def test_a_disk_that_is_full_is_told_of_in_one_line(
    exam: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(here: object, there: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(there))

    before = contents(exam)
    with monkeypatch.context() as patched:
        patched.setattr(shutil, "copy2", refuse)
        done = kinegrade("exchange", exam, "0012", "4711", "--new-id")
    assert done.exit_code == 2
    assert "No space left on device" in done.stderr
    advice = "make room there and give this command again; what stands there stays\n"
    assert done.stderr.endswith(f" - {advice}")
    assert "[(" not in done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert contents(exam) == before


def test_the_paper_is_found_by_the_old_id(exam: Path) -> None:
    kinegrade("exchange", exam, "0012", "N1", "--new-id")
    kinegrade("exchange", exam, "N1", "4711", "--new-id")
    printed = (exam / "papers" / "4711.pdf").read_bytes()
    for old in ("0012", "N1"):
        assert kinegrade("paper", exam, old).stdout_bytes == printed


def test_marks_before_and_after_a_new_id_are_not_merged(exam: Path) -> None:
    sheet, first, second = (exam.with_name(name) for name in ("typed.csv", "MARKS", "AGAIN"))
    sheet.write_text("student,q1.v_B\n0012,1\n", encoding="utf-8")
    assert kinegrade("grade", exam, sheet, "-o", first).exit_code == 1
    assert kinegrade("exchange", exam, "0012", "4711", *NEW).exit_code == 0
    assert kinegrade("grade", exam, sheet, "-o", second).exit_code == 1
    for pair in ((first, second), (second, first)):
        said = kinegrade("merge", *pair, "-o", exam.with_name("ALL"), "--prefer", "better")
        assert said.exit_code == 2
        assert f'0012: "0012" (in {first}) is "4711" in {second} - mark these again' in said.stderr
        assert not exam.with_name("ALL").exists()
    assert kinegrade("grade", exam, sheet, "-o", first, "--force").exit_code == 1
    said = kinegrade("merge", first, second, "-o", exam.with_name("ALL"), "--prefer", "better")
    assert said.exit_code == 0, said.stderr


def test_a_policy_may_have_the_old_id(exam: Path) -> None:
    sheet, policy, marks = (exam.with_name(name) for name in ("typed.csv", "p.toml", "MARKS"))
    sheet.write_text("student,submitted,q1.v_B\n0012,2027-05-04 12:00,7\n", encoding="utf-8")
    rules = """late = { due = "2027-05-03 12:00", penalty = "1/2", extensions = { %s } }
[questions.q1.asks.v_B]
accept = [{ value = "7", student = "0012" }]
"""
    policy.write_text(rules % '0012 = "2 days"', encoding="utf-8")
    kinegrade("exchange", exam, "0012", "4711", *NEW)
    done = kinegrade("grade", exam, sheet, "-o", marks, "--policy", policy)
    assert marks.exists(), done.stderr
    totals = {row["student"]: row for row in table(marks / "grades.csv")}
    assert (totals["4711"]["total"], totals["4711"]["subtracted"]) == ("3", "0")
    policy.write_text(rules % '0012 = "2 days", 4711 = "1 day"', encoding="utf-8")
    twice = kinegrade("grade", exam, sheet, "-o", marks, "--policy", policy, "--force")
    assert (
        'p.toml:1: late.extensions.0012: is student "4711", who has an entry, too - leave one of the '
        "two\n"
    ) in twice.stderr


def test_who_had_another_id_is_forgotten_with_it(exam: Path) -> None:
    sheet, marks = exam.with_name("typed.csv"), exam.with_name("MARKS")
    sheet.write_text("student,q1.v_B\n0012,1\n", encoding="utf-8")
    kinegrade("exchange", exam, "0012", "4711", *NEW)
    kinegrade("grade", exam, sheet, "-o", marks)
    done = kinegrade("forget", exam, marks, "--yes")
    assert done.exit_code == 0, done.stderr
    for name, text in {**contents(exam), **contents(marks)}.items():
        assert b"4711" not in text, name
        assert b"0012" not in text, name


def test_an_id_whose_zeros_come_back_is_no_other_person(exam: Path) -> None:
    done = kinegrade("exchange", exam, "0012", "12", "--new-id")
    assert done.exit_code == 0, done.stderr
    back = kinegrade("exchange", exam, "12", "0012", "--new-id", "--name", "Zoë Neal")
    assert back.exit_code == 0, back.stderr
    owner = open_exam(exam).head.candidates["0012"]
    assert (owner.name, owner.formerly) == ("Zoë Neal", ("12",))


def test_the_class_goes_on_with_a_roster_that_has_the_new_id(exam: Path) -> None:
    kinegrade("exchange", exam, "0012", "4711", "--new-id")
    folder, right = exam.parent, right_answer(exam, "4711")
    (folder / "roster.csv").write_text(ROSTER.replace("0012", "4711"), encoding="utf-8")
    (folder / "late.csv").write_text("student,name\n0815,Eve\n", encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv", "-o", exam, "--allow-odd-ids"
    added = kinegrade("generate", *files, "--add", folder / "late.csv")
    assert added.exit_code in (0, 1), added.stderr
    assert right_answer(exam, "4711") == right
    assert open_exam(exam).head.candidates["4711"].formerly == ("0012",)


def test_a_pool_stays_with_a_new_id(exam: Path) -> None:
    pooled = ("--to", "moodle-xml", "--variants", "2", "-o", exam.with_name("pool.xml"), "--force")
    kinegrade("quiz", exam, *pooled)
    student = open_exam(exam).students[0]
    done = kinegrade("exchange", exam, student, "4711", "--new-id")
    assert done.exit_code == 0, done.stderr
    assert "4711" in (exam / "variants.jsonl").read_text(encoding="utf-8")
    assert kinegrade("quiz", exam, *pooled).exit_code in (0, 1)


@pytest.mark.parametrize(
    ("paper", "student", "said"),
    [
        ("007", "0012", '"0012" has a paper already'),
        ("OF spare-1", "4711", "which is nobody's yet - kinegrade assign gives spare paper"),
        ("4711", "0815", 'no paper has the code "4711"'),
    ],
)
def test_a_new_id_that_cannot_be_is_refused_and_nothing_is_written(
    exam: Path, paper: str, student: str, said: str
) -> None:
    before = contents(exam)
    codes = {f"OF {each.student}": each.paper for each in open_exam(exam).head.everybody}
    refused = kinegrade("exchange", exam, codes.get(paper, paper), student, "--new-id")
    assert refused.exit_code == 2
    (line,) = refused.stderr.splitlines()
    assert said in line
    assert contents(exam) == before


def test_an_id_that_another_student_had_is_given_to_nobody(exam: Path) -> None:
    """Files of answers and marks that have it would be taken for those of its new owner."""
    kinegrade("exchange", exam, "0012", "4711", "--new-id")
    before, folder = contents(exam), exam.parent
    (folder / "roster.csv").write_text(ROSTER.replace("0012", "4711"), encoding="utf-8")
    (folder / "late.csv").write_text("student,name\n0012,Eve\n", encoding="utf-8")
    (spare,) = (each.paper for each in open_exam(exam).head.spares)
    (folder / "both.csv").write_text(ROSTER.replace("007", "4711"), encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv", "-o", exam, "--allow-odd-ids"
    both = folder / "bank.toml", folder / "both.csv", "-o", exam, "--allow-odd-ids"
    said = (
        'student "4711" had the id "0012" before, which files of answers and marks may still have'
    )
    for refused in (
        kinegrade("exchange", exam, "007", "0012", "--new-id"),
        kinegrade("assign", exam, spare, "0012"),
        kinegrade("generate", *files, "--add", folder / "late.csv"),
        kinegrade("generate", *both, "--force", "--spare", "1", "--solutions"),
    ):
        assert (refused.exit_code, said in refused.stderr) == (2, True), refused.stderr
        assert "where two ids were interchanged, exchange the papers" in refused.stderr
    assert contents(exam) == before


def test_two_interchanged_ids_are_put_right_by_papers_and_names(exam: Path) -> None:
    before = open_exam(exam).head.candidates
    assert kinegrade("exchange", exam, "0012", "007").exit_code == 0
    for own, other in (("0012", "007"), ("007", "0012")):
        name = before[other].name
        named = kinegrade("exchange", exam, own, own, "--new-id", "--name", name)
        assert named.exit_code == 0, named.stderr
    after = open_exam(exam).head.candidates
    for own, other in (("0012", "007"), ("007", "0012")):
        found = after[own].name, after[own].paper, after[own].formerly
        assert found == (before[other].name, before[other].paper, ())
    assert kinegrade("verify", exam, "--all").exit_code == 0


def test_a_class_generated_again_knows_the_old_ids_and_that_papers_changed_hands(
    exam: Path,
) -> None:
    folder, marks, sheet = exam.parent, exam.with_name("MARKS"), exam.with_name("typed.csv")
    sheet.write_text(f"student,q1.v_B\n0012,{right_answer(exam, '0012')}\n", encoding="utf-8")
    again = "grade", exam, sheet, "-o", marks, "--force", "--own-papers"
    kinegrade(*again)
    kinegrade("exchange", exam, "0012", "4711", "--new-id")
    (folder / "roster.csv").write_text(ROSTER.replace("0012", "4711"), encoding="utf-8")
    made = generate(folder, "EXAM", "--spare", "1", "--solutions", "--force")
    assert "4 papers keep their numbers, 0 changed, 0 gone, 0 new" in made.stderr
    refused = kinegrade("explain", exam, marks, "4711")
    assert "the key of the exam was corrected, or papers changed hands" in refused.stderr
    assert '"0012" for "4711"' in kinegrade(*again).stderr
