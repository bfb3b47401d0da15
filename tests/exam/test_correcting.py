"""`kinegrade reprint`: a typo in a template is corrected after papers were generated, and all numbers
stay.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
from click.testing import Result

from tests.printed_text import read_text
from tests.problem.crank import crank_text
from tests.small_class import VANISHING, contents, generate, key_lines, kinegrade, write_class

TYPO = ("The crank {{ r }} turns", "The corrected crank {{ r }} turns")
LARGE_PRINT = "student,name,format\n007,Ann,\n0012,Bob,large print\n"
OTHER_ANSWER = ('"y(velocity(A))"', '"2*y(velocity(A))"')


@pytest.fixture
def exam(small_class: Path, tmp_path: Path) -> Path:
    """An exam whose second question is the crank."""
    return Path(shutil.copytree(small_class / "EXAM", tmp_path / "EXAM"))


def generate_for(roster: str, folder: Path, *options: str) -> Path:
    """An exam like that of the small class, for the students of another roster."""
    (write_class(folder) / "roster.csv").write_text(roster, encoding="utf-8")
    assert generate(folder, "EXAM", *options).exit_code == 0
    return folder / "EXAM"


def correct(exam: Path, *changes: tuple[str, str], options: tuple[str, ...] = ()) -> Result:
    """Reprint with a template that has these changes."""
    file = exam.parent / "crank.toml"
    file.write_text(crank_text(VANISHING, *changes), encoding="utf-8")
    return kinegrade("reprint", exam, "--template", file, "--jobs", "1", *options)


def mark_before_and_after(exam: Path) -> Path:
    """The folder with OLD and NEW, the marks by the key before and after a correction of it."""
    folder = exam.parent
    (folder / "answers.csv").write_text("student,q2.v_y\n007,4\n", encoding="utf-8")
    mark = ("grade", exam, folder / "answers.csv", "-o")
    assert kinegrade(*mark, folder / "OLD").exit_code in (0, 1)
    assert correct(exam, OTHER_ANSWER, options=("--accept-changes",)).exit_code == 1
    assert kinegrade(*mark, folder / "NEW").exit_code in (0, 1)
    return folder


def read(paper: Path) -> str:
    return read_text(paper)


def test_the_text_is_new_and_all_numbers_stay(exam: Path) -> None:
    before, key = contents(exam), (exam / "key.jsonl").read_bytes()
    result = correct(exam, TYPO)
    assert (result.exit_code, result.stderr) == (
        0,
        f"{exam}: 4 papers printed again with the corrected template\n",
    )
    assert (exam / "key.jsonl").read_bytes() == key
    assert "The corrected crank" in (exam / "templates" / "crank.toml").read_text(encoding="utf-8")
    for paper in ("papers/007.pdf", "papers.pdf"):
        assert "The corrected crank" in read(exam / paper)
    after = contents(exam)
    assert after.keys() == before.keys()
    assert before["papers/007.pdf"] != after["papers/007.pdf"]
    same = ("bank.toml", "answers.csv", "key.pdf", "templates/slider-crank.toml")
    assert {name: after[name] for name in same} == {name: before[name] for name in same}


def test_a_paper_printed_alone_is_the_one_of_the_folder(exam: Path) -> None:
    assert correct(exam, TYPO).exit_code == 0
    alone = exam.parent / "alone.pdf"
    assert kinegrade("paper", exam, "0012", "-o", alone).exit_code == 0
    assert alone.read_bytes() == (exam / "papers" / "0012.pdf").read_bytes()


def test_the_uncorrected_template_changes_nothing(exam: Path) -> None:
    before = contents(exam)
    assert correct(exam).exit_code == 0
    assert contents(exam) == before


def test_spare_papers_and_booklets_of_rooms_are_printed_again(tmp_path: Path) -> None:
    exam = generate_for("student,name,room\n007,Ann,A\n0012,Bob,B\n", tmp_path, "--spare", "1")
    before = contents(exam)
    assert {"rooms/A.pdf", "spares.jsonl"} <= before.keys()
    assert correct(exam).exit_code == 0
    assert contents(exam) == before
    assert correct(exam, TYPO).exit_code == 0
    for name in ("rooms/A.pdf", *(name for name in before if name.startswith("papers/"))):
        assert "The corrected crank" in read(exam / name)


@pytest.mark.left(beside="test_spare_papers_and_booklets_of_rooms_are_printed_again")
def test_worked_solutions_are_printed_again(exam: Path) -> None:
    assert kinegrade("solutions", exam, "--jobs", "1").exit_code == 0
    before = contents(exam)
    assert correct(exam, TYPO).exit_code == 0
    assert contents(exam).keys() == before.keys()


def test_another_answer_is_refused_for_each_student(exam: Path) -> None:
    before = contents(exam)
    result = correct(exam, OTHER_ANSWER)
    assert (result.exit_code, result.stdout) == (2, "")
    lines = result.stderr.splitlines()
    whose = [line.split(" is ")[0] for line in lines[:-1]]
    students = ["007", "0012", "a/b", "=2"]
    assert whose == [f'error: student "{each}", q2: v_y' for each in students]  # once each
    assert lines[-1].endswith(
        "key.jsonl: the correction changes answers, givens or points - correct the words alone; "
        "where the key was wrong, let a policy accept what is right or void the question (kinegrade "
        "grade --policy) if papers have been handed out, or use --accept-changes and mark all "
        "answers again"
    )
    assert ".EXAM" not in result.stderr
    assert contents(exam) == before


def test_accepted_changes_are_said_and_stand_in_the_key(exam: Path) -> None:
    old = {line["student"]: line for line in key_lines(exam)}
    result = correct(exam, OTHER_ANSWER, options=("--accept-changes",))
    assert result.exit_code == 1
    assert 'complaint: student "=2", q2: v_y is 4 by the key, but 8 follows' in result.stderr
    last = result.stderr.splitlines()[-1]
    assert "marks that were given before follow the old key - mark all answers again" in last
    for line in key_lines(exam):
        first, crank, third = line["questions"]
        was = old[line["student"]]["questions"]
        assert (first, third) == (was[0], was[2])
        assert crank["asks"]["v_y"]["value"] == 2 * was[1]["asks"]["v_y"]["value"]
        assert crank["drawn"] == was[1]["drawn"]
    assert kinegrade("paper", exam, "007", "-o", exam.parent / "one.pdf").exit_code == 0


def test_the_bank_as_it_was_before_the_key_was_corrected_is_told(exam: Path) -> None:
    correct(exam, OTHER_ANSWER, options=("--accept-changes",))
    again = generate(write_class(exam.parent), "EXAM", "--force")
    assert again.exit_code == 2
    assert (
        "templates/crank.toml stand here as before the correction by reprint: give them as "
        f"{exam} has them, choose another folder, or" in again.stderr
    )


def test_marks_given_before_a_correction_of_the_key_are_not_used(exam: Path) -> None:
    folder = mark_before_and_after(exam)
    said = (
        f"error: {folder}/OLD: the key of the exam was corrected, or papers changed hands, after "
        "these marks - expected marks by the key as it is now - mark all answers again with kinegrade grade"
    )
    for command, options in (
        ("feedback", ("-o", folder / "SHEETS")),
        ("report", ("-o", folder / "report.html")),
        ("sharing", ("-o", folder / "sharing.csv")),
        ("explain", ("007",)),
    ):
        refused = kinegrade(command, exam, folder / "OLD", *options)
        assert (refused.exit_code, refused.stderr.splitlines()) == (2, [said]), command
        assert kinegrade(command, exam, folder / "NEW", *options).exit_code in (0, 1), command
    filled = ("--to", "moodle", "--exam", exam, "-o", folder / "moodle.csv")
    assert kinegrade("export", folder / "OLD", *filled).stderr.splitlines() == [said]
    kept = kinegrade("archive", exam, "--marks", folder / "OLD", "-o", folder / "kept.zip")
    assert (kept.exit_code, kept.stderr.splitlines()) == (2, [said])
    assert not (folder / "kept.zip").exists()
    (folder / "NEW" / "corrections.csv").write_text("corrections\nmany\n", encoding="utf-8")
    damaged = kinegrade("report", exam, folder / "NEW", "-o", folder / "again.html").stderr
    assert 'NEW/corrections.csv:2: corrections is "many" - expected a whole number' in damaged


def test_marks_by_the_key_before_and_after_a_correction_are_not_merged(exam: Path) -> None:
    folder = mark_before_and_after(exam)
    merge = ("--prefer", "better", "-o", folder / "ALL")
    for both in (("OLD", "NEW"), ("NEW", "OLD")):
        done = kinegrade("merge", *(folder / name for name in both), *merge)
        assert done.exit_code == 2
        assert done.stderr.splitlines()[0] == (
            f"error: {folder}/OLD: has marks of the same exam as {folder}/NEW by a key that has "
            "been corrected since, or papers have changed hands - mark all answers again with "
            "kinegrade grade"
        )
    assert not (folder / "ALL").exists()


def test_an_exam_beside_marks_tells_that_its_key_was_corrected(exam: Path) -> None:
    folder = exam.parent
    (folder / "answers.csv").write_text("student,q2.v_y\n007,4\n", encoding="utf-8")
    kinegrade("grade", exam, folder / "answers.csv", "-o", folder / "OLD")
    correct(exam, OTHER_ANSWER, options=("--accept-changes",))
    kinegrade("grade", exam, folder / "answers.csv", "-o", folder / "NEW")
    said = (
        f"complaint: {folder}/OLD: the key of {exam} was corrected, or papers "
        "changed hands, after these marks - mark all "
        "answers again with kinegrade grade"
    )
    for name, expected in (("OLD", [said]), ("NEW", [])):
        for command in (
            ("export", folder / name, "--to", "moodle", "-o", folder / "moodle.csv", "--force"),
            ("export", folder / name, "--to", "xlsx", "-o", folder / "all.xlsx", "--force"),
            ("term", folder / name, "-o", folder / "term.csv", "--force"),
        ):
            lines = kinegrade(*command).stderr.splitlines()
            assert [each for each in lines if "was corrected" in each] == expected, command


def test_of_an_exam_and_a_corrected_copy_beside_marks_both_are_named(exam: Path) -> None:
    folder = exam.parent
    (folder / "answers.csv").write_text("student,q2.v_y\n007,4\n", encoding="utf-8")
    kinegrade("grade", exam, folder / "answers.csv", "-o", folder / "MARKS")
    shutil.copytree(exam, folder / "TRIED")
    head = (exam / "exam.json").read_text(encoding="utf-8")
    corrected = json.dumps({**json.loads(head), "corrections": 1})
    (folder / "TRIED" / "exam.json").write_text(corrected, encoding="utf-8")
    export = "export", folder / "MARKS", "--to", "moodle", "-o", folder / "moodle.csv"
    (line,) = [each for each in kinegrade(*export).stderr.splitlines() if "corrected" in each]
    assert line == (
        f"complaint: {folder}/MARKS: the key of {folder}/TRIED was corrected, or papers "
        "changed hands, after these marks, "
        f"but not in its copy {exam} - if the first one counts, mark all answers again with "
        "kinegrade grade; if the copy does, move the first one elsewhere"
    )


def test_a_given_of_another_unit_is_refused(exam: Path) -> None:
    result = correct(exam, ('r     = { unit = "m"', 'r     = { unit = "cm"'))
    assert result.exit_code == 2
    assert "q2: r is in m by the key, in cm by the template" in result.stderr


def test_a_template_that_the_exam_does_not_have_is_refused(exam: Path) -> None:
    file = exam.parent / "cranc.toml"
    file.write_text(crank_text(VANISHING), encoding="utf-8")
    before = contents(exam)
    result = kinegrade("reprint", exam, "--template", file)
    assert result.exit_code == 2
    assert result.stderr.startswith(f'error: {file}: {exam} has no template "cranc" - expected')
    assert 'did you mean "crank"' in result.stderr
    assert contents(exam) == before


def test_a_faulty_template_is_refused(exam: Path) -> None:
    result = correct(exam, ("{{ h.value }} above", "above"))
    assert result.exit_code == 2
    assert "the parameter h is not given to the student" in result.stderr


def test_a_first_proof_is_a_paper_of_the_bank(small_class: Path, tmp_path: Path) -> None:
    proof = tmp_path / "proof.pdf"
    bank = small_class / "bank.toml"
    assert kinegrade("sample", bank, "-o", proof, "--lang", "zh").exit_code == 0
    assert "期中测验" in read(proof)
    first = proof.read_bytes()
    assert kinegrade("sample", bank, "-o", proof).exit_code == 2  # it is there already
    assert kinegrade("sample", bank, "-o", proof, "--lang", "zh", "--force").exit_code == 0
    assert proof.read_bytes() == first
    refused = kinegrade("sample", bank, "-o", tmp_path / "de.pdf", "--lang", "de")
    assert (refused.exit_code, (tmp_path / "de.pdf").exists()) == (2, False)


def add_late(folder: Path, bank: Path) -> Result:
    (folder / "late.csv").write_text("student,name\n0199,Neu\n", encoding="utf-8")
    files = bank, folder / "roster.csv", "-o", folder / "EXAM", "--add", folder / "late.csv"
    return kinegrade("generate", *files, "--allow-odd-ids", "--jobs", "1")


@pytest.mark.parametrize("given", ["as it was", "as it was corrected"])
def test_late_students_get_the_corrected_template_whichever_is_given(
    small_class: Path, tmp_path: Path, given: str
) -> None:
    folder = Path(shutil.copytree(small_class, tmp_path / "class"))
    template = folder / "crank.toml"
    before = template.read_text(encoding="utf-8")
    template.write_text(crank_text(VANISHING, TYPO), encoding="utf-8")
    corrected = kinegrade("reprint", folder / "EXAM", "--template", template, "--jobs", "1")
    assert corrected.exit_code == 0, corrected.stderr
    template.write_text(before.replace("turns with", "spins with"), encoding="utf-8")
    refused = add_late(folder, folder / "bank.toml")
    assert f"{folder}/EXAM/templates/crank.toml: differs from what was given" in refused.stderr
    if given == "as it was":
        template.write_text(before, encoding="utf-8")
    else:
        template.write_text(crank_text(VANISHING, TYPO), encoding="utf-8")
    added = add_late(folder, folder / "bank.toml")
    assert added.stderr == f"{folder / 'EXAM'}: 1 paper added, 4 stay as they are\n"
    assert "The corrected crank" in read(folder / "EXAM" / "papers" / "0199.pdf")


@pytest.mark.parametrize("named", ["slider-crank", "slider-crank.toml"])
def test_a_corrected_copy_of_a_shipped_template_may_stand_beside_the_bank(
    small_class: Path, tmp_path: Path, named: str
) -> None:
    folder = Path(shutil.copytree(small_class, tmp_path / "class"))
    exam, bank, own = folder / "EXAM", folder / "bank.toml", folder / "slider-crank.toml"
    shipped = (exam / "templates" / "slider-crank.toml").read_text(encoding="utf-8")
    own.write_text(shipped.replace("The crank $OA$", "The crank arm $OA$"), encoding="utf-8")
    assert kinegrade("reprint", exam, "--template", own, "--jobs", "1").exit_code == 0
    if named == "slider-crank":
        own.unlink()
    text = bank.read_text(encoding="utf-8")
    bank.write_text(text.replace('"slider-crank"', f'"{named}"'), encoding="utf-8")
    added = add_late(folder, bank)
    assert added.stderr == f"{exam}: 1 paper added, 4 stay as they are\n"
    assert "The crank arm" in read(exam / "papers" / "0199.pdf")


STEPS = """title = "Quiz"
course = "M"
[[questions]]
name = "car"
statement = "A car starts from rest with {{ a }}. How far does it go in {{ t }}?"
parameters.a = { unit = "m/s^2", draw = "1.0 .. 3.0 step 0.1" }
parameters.t = { unit = "s", draw = [4, 5, 6] }
steps.s = "a*t**2"
asks.s = { unit = "m", means = "distance", points = 3 }
"""
HALVED = ('"a*t**2"', '"a*t**2/2"')


@pytest.mark.parametrize("given", [STEPS, STEPS.replace(*HALVED)])
def test_late_students_get_the_corrected_steps_of_a_question_whichever_bank_is_given(
    tmp_path: Path, given: str
) -> None:
    bank, exam = tmp_path / "bank.toml", tmp_path / "EXAM"
    bank.write_text(STEPS, encoding="utf-8")
    (tmp_path / "roster.csv").write_text("student,name\n0101,Ada\n0102,Bo\n", encoding="utf-8")
    assert kinegrade("generate", bank, tmp_path / "roster.csv", "-o", exam).exit_code == 0
    kept = exam / "templates" / "car.toml"
    kept.write_text(kept.read_text(encoding="utf-8").replace(*HALVED), encoding="utf-8")
    reprint = ("reprint", exam, "--template", kept, "--accept-changes", "--jobs", "1")
    assert kinegrade(*reprint).exit_code == 1
    bank.write_text(given, encoding="utf-8")
    added = add_late(tmp_path, bank)
    assert added.stderr == f"{exam}: 1 paper added, 2 stay as they are\n"
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    assert (head["corrections"], len(head["students"])) == (1, 3)
    late = key_lines(exam)[-1]["questions"][0]
    a, t = (float(late["drawn"][name]) for name in "at")
    assert late["asks"]["s"]["value"] == pytest.approx(a * t**2 / 2)
    bank.write_text(given.replace("points = 3", "points = 4"), encoding="utf-8")
    assert "bank.toml: differs from what was given" in add_late(tmp_path, bank).stderr


def test_large_print_makes_nobody_elses_paper_longer(tmp_path: Path) -> None:
    exam = generate_for(LARGE_PRINT, tmp_path)
    before = contents(exam)
    assert correct(exam).exit_code == 0
    assert contents(exam) == before


def test_an_exam_that_large_print_had_made_longer_gets_its_pages_back(tmp_path: Path) -> None:
    exam = generate_for(LARGE_PRINT, tmp_path)
    before = contents(exam)
    head = exam / "exam.json"
    head.write_text(re.sub(r'"pages": *\d+', '"pages":40', head.read_text("utf-8")), "utf-8")
    assert correct(exam).exit_code == 0
    assert contents(exam) == before
