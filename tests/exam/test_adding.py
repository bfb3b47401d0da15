"""`kinegrade generate --add`: late students get papers of an exam that exists, and no other
paper changes.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
from click.testing import Result
from openpyxl import load_workbook

from tests.printed_text import read_pages
from tests.problem.crank import crank_text
from tests.small_class import contents, key_lines, kinegrade, table

BANK = """title = {{ en = "Quiz", zh = "小测" }}
course = "Mechanics"
{options}
[[questions]]
template = "slider-crank"
asks = {{ v_B = 3, omega_AB = 2 }}
[[questions]]
template = "crank.toml"
draw = {{ h = [1], r = "1 .. 5 step 1", omega = "1 .. 4 step 1" }}
"""
WORDS = ("--reproducible", "spring")
LATE = {"late1": "Li, Late", "=2": "=Later"}


def roster(students: dict[str, str]) -> str:
    rows = "".join(f'{student},"{name}"\n' for student, name in students.items())
    return f"student,name\n{rows}"


CLASS = {"s0": "Ann", "a/b": "王伟", "s2": "Zoë"}


def write(folder: Path, options: str = "", students: dict[str, str] = CLASS) -> Path:
    (folder / "bank.toml").write_text(BANK.format(options=options), encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    (folder / "roster.csv").write_text(roster(students), encoding="utf-8")
    (folder / "late.csv").write_text(roster(LATE), encoding="utf-8")
    return folder


def generate(folder: Path, *options: str | Path) -> Result:
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / "EXAM", "--allow-odd-ids", *options)


def generated(folder: Path, *options: str | Path) -> Path:
    result = generate(folder, *options)
    assert result.exit_code == 0, result.stderr
    return folder


def add(folder: Path, *options: str | Path, late: str = "late.csv") -> Result:
    return generate(folder, "--add", folder / late, *options)


def added(folder: Path, *options: str | Path) -> Result:
    result = add(folder, *options)
    assert result.exit_code == 0, result.stderr
    return result


def refused(folder: Path, *options: str | Path) -> list[str]:
    """The lines of the refusal; all stays as it was."""
    before = contents(folder)
    result = add(folder, *options)
    assert (result.exit_code, result.stdout) == (2, "")
    assert contents(folder) == before
    lines = result.stderr.splitlines()
    assert [line for line in lines if not line.startswith("error: ")] == []
    return [line.removeprefix("error: ").replace(f"{folder}/", "") for line in lines]


def pages(file: Path) -> list[str]:
    return read_pages(file)


def drawn(folder: Path, question: int) -> list[str]:
    return [json.dumps(line["questions"][question]["drawn"]) for line in key_lines(folder / "EXAM")]


@pytest.fixture(scope="module")
def grown(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class whose exam has grown; EXAM-BEFORE is what it was."""
    folder = generated(write(tmp_path_factory.mktemp("grown")), *WORDS, "--solutions")
    shutil.copytree(folder / "EXAM", folder / "EXAM-BEFORE")
    result = added(folder)
    assert result.stderr == f"{folder / 'EXAM'}: 2 papers added, 3 stay as they are\n"
    return folder


@pytest.fixture
def folder(tmp_path: Path, unchanged: Path) -> Path:
    """A class whose exam may grow."""
    return Path(shutil.copytree(unchanged, tmp_path / "class"))


@pytest.fixture(scope="module")
def unchanged(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return generated(write(tmp_path_factory.mktemp("unchanged")), *WORDS)


REWRITTEN = {
    "answers.csv",
    "answers.xlsx",
    "exam.json",
    "key.jsonl",
    "key.npz",
    "key.pdf",
    "papers.pdf",
    "solutions.pdf",
}


def test_nothing_else_changes(grown: Path) -> None:
    before, after = contents(grown / "EXAM-BEFORE"), contents(grown / "EXAM")
    new = {f"{kind}/{name}.pdf" for kind in ("papers", "solutions") for name in ("late1", "%3D2")}
    assert after.keys() == before.keys() | new
    assert {name for name in before if before[name] != after[name]} == REWRITTEN
    assert after["key.jsonl"].startswith(before["key.jsonl"])
    assert after["answers.csv"].startswith(before["answers.csv"])


def test_the_books_have_the_pages_of_all(grown: Path) -> None:
    for name in ("papers", "solutions"):
        before, after = (pages(grown / exam / f"{name}.pdf") for exam in ("EXAM-BEFORE", "EXAM"))
        assert after[: len(before)] == before
        first = pages(grown / "EXAM" / name / "late1.pdf")
        assert after[len(before) : len(before) + len(first)] == first
    key = " ".join(pages(grown / "EXAM" / "key.pdf"))
    codes = [line["paper"] for line in key_lines(grown / "EXAM")]
    assert len(set(codes)) == 5
    assert [code for code in codes if code not in key] == []


def test_late_students_stand_last_in_head_and_sheets(grown: Path) -> None:
    head = json.loads((grown / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    students = [*CLASS, *LATE]
    assert [each["student"] for each in head["students"]] == students
    sheet = table(grown / "EXAM" / "answers.csv")
    assert [(row["student"], row["name"]) for row in sheet[3:]] == [
        ("late1", "Li, Late"),
        ("=2", "'=Later"),
    ]
    book = load_workbook(grown / "EXAM" / "answers.xlsx").active
    assert book is not None
    assert [row[0].value for row in book.iter_rows(min_row=3)] == students


def test_an_added_paper_is_printed_again_byte_for_byte(grown: Path) -> None:
    for name in ("late1", "s0"):
        for kind, options in (("papers", ()), ("solutions", ("--solution",))):
            paper = kinegrade("paper", grown / "EXAM", name, *options).stdout_bytes
            assert paper == (grown / "EXAM" / kind / f"{name}.pdf").read_bytes()


def test_it_is_the_exam_that_force_writes_for_a_grown_roster(grown: Path, tmp_path: Path) -> None:
    write(tmp_path, students={**CLASS, **LATE})
    shutil.copytree(grown / "EXAM-BEFORE", tmp_path / "EXAM")
    generated(tmp_path, "--force", "--solutions")
    books = {"papers.pdf", "solutions.pdf"}  # the same pages
    forced, grew = contents(tmp_path / "EXAM"), contents(grown / "EXAM")
    assert forced.keys() == grew.keys()
    assert {name for name in forced if forced[name] != grew[name]} <= books


def test_force_with_the_grown_roster_keeps_all_papers(grown: Path, tmp_path: Path) -> None:
    write(tmp_path, students={**LATE, **CLASS})
    shutil.copytree(grown / "EXAM", tmp_path / "EXAM")
    result = generate(tmp_path, "--force")
    assert "5 papers keep their numbers, 0 changed, 0 gone, 0 new" in result.stderr
    assert contents(tmp_path / "EXAM" / "papers") == contents(grown / "EXAM" / "papers")


def test_sorted_rosters_give_the_same_papers(grown: Path, tmp_path: Path) -> None:
    write(tmp_path, students=dict(sorted(CLASS.items())))
    shutil.copytree(grown / "EXAM-BEFORE", tmp_path / "EXAM")
    (tmp_path / "late.csv").write_text(roster(dict(sorted(LATE.items()))), encoding="utf-8")
    added(tmp_path)
    assert contents(tmp_path / "EXAM" / "papers") == contents(grown / "EXAM" / "papers")


@pytest.mark.sampled(6, by="options")
@pytest.mark.parametrize(
    ("bank", "options"),
    [
        ("", ("--also", "html")),
        ("", ()),
        ("versions = 2", ("--paper-size", "letter", "--share-with-group", "--solutions")),
        ("versions = 5", ()),
        ('engine = "latex"', ()),
        ('engine = "latex"', ("--solutions",)),
        ("shuffle = true", ("--seed", "x", "--lang", "zh", "--method", "pole", "--solutions")),
    ],
)
def test_papers_are_like_those_of_the_others(
    tmp_path: Path, bank: str, options: tuple[str, ...]
) -> None:
    generated(write(tmp_path, bank), *options)
    before, mode = contents(tmp_path / "EXAM"), (tmp_path / "EXAM").stat().st_mode
    added(tmp_path)
    after = contents(tmp_path / "EXAM")
    kept = {name for name in before if name not in {*REWRITTEN, "tex/key.tex"}}
    assert {name: after[name] for name in kept} == {name: before[name] for name in kept}
    new = {name.replace("s0", "late1") for name in before if "/s0." in name}
    assert new <= after.keys()
    assert (tmp_path / "EXAM").stat().st_mode == mode
    assert all(not drawn(tmp_path, 0)[:3].count(each) for each in drawn(tmp_path, 0)[3:]) or (
        "versions = 2" in bank
    )
    paper = kinegrade("paper", tmp_path / "EXAM", "late1").stdout_bytes
    assert paper == after["papers/late1.pdf"]
    assert generate(tmp_path, "--force").exit_code == 2  # the others' roster
    (tmp_path / "roster.csv").write_text(roster({**CLASS, **LATE}), encoding="utf-8")
    again = generate(
        tmp_path, "--force", *(each for each in options if each not in ("--seed", "x"))
    )
    assert "5 papers keep their numbers, 0 changed, 0 gone, 0 new" in again.stderr
    assert contents(tmp_path / "EXAM" / "papers") == contents_of(after, "papers")


def contents_of(files: dict[str, bytes], folder: str) -> dict[str, bytes]:
    start = f"{folder}/"
    return {
        name.removeprefix(start): data for name, data in files.items() if name.startswith(start)
    }


def test_a_class_grows_twice(folder: Path) -> None:
    added(folder)
    before = contents(folder / "EXAM")
    (folder / "roster.csv").write_text(roster({**LATE, **CLASS}), encoding="utf-8")
    (folder / "late.csv").write_text(roster({f"x{n}": "N" for n in range(9)}), encoding="utf-8")
    assert "9 papers added, 5 stay as they are" in added(folder, "--jobs", "2").stderr
    after = contents(folder / "EXAM")
    kept = before.keys() - REWRITTEN
    assert {name: after[name] for name in kept} == {name: before[name] for name in kept}
    assert after["key.jsonl"].startswith(before["key.jsonl"])
    assert [len(set(drawn(folder, question))) for question in (0, 1)] == [14, 14]
    assert sorted(line["place"] for line in key_lines(folder / "EXAM")) == list(range(14))


@pytest.mark.left(beside="test_a_class_grows_twice")
def test_several_processes_print_the_same(folder: Path, tmp_path: Path, small_parts: int) -> None:
    late = {f"x{number}": "N" for number in range(2 * small_parts)}
    (folder / "late.csv").write_text(roster(late), encoding="utf-8")
    other = Path(shutil.copytree(folder, tmp_path / "other"))
    added(folder, "--jobs", "1")
    added(other, "--jobs", "2")
    assert contents(folder) == contents(other)


def test_too_few_combinations_are_said_or_refused(folder: Path) -> None:
    late = {f"x{number}": "N" for number in range(18)}
    (folder / "late.csv").write_text(roster(late), encoding="utf-8")
    said = "q2 (crank): 20 of the 20 combinations of values are fit for 21 students, so some have"
    (line,) = refused(folder, "--strict")
    assert line.startswith(said)
    result = add(folder)
    assert result.exit_code == 1
    assert f"complaint: {said}" in result.stderr
    assert "18 papers added, 3 stay as they are" in result.stderr


def test_answers_that_were_typed_stay_and_all_are_marked(folder: Path) -> None:
    sheet = folder / "EXAM" / "answers.csv"
    text = sheet.read_text(encoding="utf-8-sig").replace(",", ";")
    sheet.write_text(re.sub("^s0;.*", 's0;Ann;0,5;"1;2";;', text, flags=re.M), encoding="utf-8")
    assert kinegrade("grade", folder / "EXAM", sheet, "-o", folder / "MARKS").exit_code in (0, 1)
    added(folder)
    rows = table(sheet)
    assert [row["student"] for row in rows] == [*CLASS, *LATE]
    assert list(rows[0].values())[2:4] == ["0,5", "1;2"]
    assert not any(list(rows[3].values())[2:])
    after = folder / "AFTER"
    assert kinegrade("grade", folder / "EXAM", sheet, "-o", after).exit_code in (0, 1)
    grades = {name: table(folder / name / "grades.csv") for name in ("MARKS", "AFTER")}
    assert grades["AFTER"][:3] == grades["MARKS"]
    assert {row["student"] for row in grades["AFTER"]} == {*CLASS, *LATE}


def test_marks_made_before_are_still_good(folder: Path) -> None:
    exam, marks = folder / "EXAM", folder / "MARKS"
    assert kinegrade("grade", exam, exam / "answers.csv", "-o", marks).exit_code in (0, 1)
    added(folder)
    report = kinegrade("report", exam, marks, "-o", folder / "report.html")
    assert report.exit_code == 0, report.stderr
    feedback = kinegrade("feedback", exam, marks, "-o", folder / "FEEDBACK", "--format", "md")
    assert feedback.exit_code in (0, 1), feedback.stderr
    assert "3 sheets" in feedback.stderr


def test_a_row_that_was_typed_for_a_late_student_is_not_written_twice(folder: Path) -> None:
    sheet = folder / "EXAM" / "answers.csv"
    sheet.write_text(sheet.read_text(encoding="utf-8") + "late1,Li,7\n", encoding="utf-8")
    added(folder)
    assert [row["student"] for row in table(sheet)] == [*CLASS, *LATE]
    assert table(sheet)[3]["q1.v_B"] == "7"


def test_a_sheet_that_was_moved_away_is_written_anew(folder: Path) -> None:
    (folder / "EXAM" / "answers.csv").unlink()
    added(folder)
    assert [row["student"] for row in table(folder / "EXAM" / "answers.csv")] == [*CLASS, *LATE]


def test_a_sheet_without_ids_is_refused(folder: Path) -> None:
    (folder / "EXAM" / "answers.csv").write_text("who,q1.v_B\ns0,1\n", encoding="utf-8")
    (line,) = refused(folder)
    assert line.startswith('EXAM/answers.csv: no column "student" - expected the answer sheet')


def test_answers_typed_into_the_workbook_stay(folder: Path) -> None:
    book = folder / "EXAM" / "answers.xlsx"
    filled = load_workbook(book)
    filled.active["D3"] = "1.5"
    filled.save(book)
    typed = book.read_bytes()
    result = added(folder)
    said = "answers.xlsx stays as it was typed; type the answers of "
    assert f'{said}"late1", "=2" into a new row' in result.stderr
    assert book.read_bytes() == typed
    again = generate(folder, "--force", "--accept-changes")
    assert "holds answers.xlsx, edited or added" in again.stderr


def test_what_people_put_into_the_folder_stays_and_is_known_as_theirs(folder: Path) -> None:
    template = folder / "EXAM" / "papers" / "s0.docx"
    template.write_bytes(b"a paper that a person wrote for Word")
    (folder / "EXAM" / "papers" / "notes.txt").write_text("mine", encoding="utf-8")
    before = contents(folder / "EXAM" / "papers")
    added(folder)
    after = contents(folder / "EXAM" / "papers")
    assert {name: after[name] for name in before} == before
    assert {"late1.docx", "%3D2.docx"} <= after.keys()
    head = json.loads((folder / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    assert "papers/s0.docx" not in head["editable"]


def test_the_bank_and_its_templates_must_be_those_of_the_exam(folder: Path) -> None:
    bank, crank = folder / "bank.toml", folder / "crank.toml"
    bank.write_text(bank.read_text(encoding="utf-8") + "\n# mine\n", encoding="utf-8")
    crank.write_text(crank.read_text(encoding="utf-8") + "\n# mine\n", encoding="utf-8")
    said = (
        "differs from what was given - expected the bank and the templates that the exam was "
        "generated from - give those, or write another exam"
    )
    assert refused(folder) == [f"EXAM/bank.toml: {said}", f"EXAM/templates/crank.toml: {said}"]


def test_an_exam_whose_shipped_template_another_version_has_otherwise_takes_late_students(
    folder: Path,
) -> None:
    copy = folder / "EXAM" / "templates" / "slider-crank.toml"
    earlier = f"{copy.read_text(encoding='utf-8')}# as an earlier version had it\n"
    copy.write_text(earlier, encoding="utf-8")
    said = added(folder).stderr
    assert (
        "the exam's copies hold of templates/slider-crank.toml, which differs from that of the "
        "installed kinegrade"
    ) in said
    assert copy.read_text(encoding="utf-8") == earlier
    assert (folder / "EXAM" / "papers" / "late1.pdf").exists()


def test_who_was_assigned_a_spare_paper_need_not_be_in_the_roster(tmp_path: Path) -> None:
    exam = generated(write(tmp_path), *WORDS, "--spare", "1") / "EXAM"
    code = json.loads((exam / "exam.json").read_text(encoding="utf-8"))["spares"][0]["paper"]
    assert kinegrade("assign", exam, code, "0099").exit_code == 0
    added(tmp_path)
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    assert [each["student"] for each in head["students"]] == [*CLASS, "0099", *LATE]


def test_a_class_generated_again_needs_who_was_assigned_a_spare_paper_in_the_roster(
    tmp_path: Path,
) -> None:
    exam = generated(write(tmp_path), *WORDS, "--spare", "1") / "EXAM"
    code = json.loads((exam / "exam.json").read_text(encoding="utf-8"))["spares"][0]["paper"]
    assert kinegrade("assign", exam, code, "0099", "--name", "Dora").exit_code == 0
    result = generate(tmp_path, "--force")
    assert result.exit_code == 2
    assert "1 would be gone (0099)" in result.stderr
    assert "also who was assigned a spare paper or withdrew" in result.stderr
    key = (exam / "key.jsonl").read_text(encoding="utf-8")
    (tmp_path / "roster.csv").write_text(roster({**CLASS, "0099": "Dora"}), encoding="utf-8")
    generated(tmp_path, "--force")
    assert sorted((exam / "key.jsonl").read_text(encoding="utf-8").splitlines()) == sorted(
        key.splitlines()
    )


def test_a_bank_without_a_template_of_the_exam_is_refused(folder: Path) -> None:
    bank = folder / "bank.toml"
    text = bank.read_text(encoding="utf-8").replace('"crank.toml"', '"other.toml"')
    bank.write_text(text, encoding="utf-8")
    (folder / "crank.toml").rename(folder / "other.toml")
    lines = refused(folder)
    assert lines[0].startswith("EXAM/bank.toml: differs from what was given - ")
    assert lines[1].startswith("EXAM/templates: crank is not in the bank - expected the bank and")


def test_the_roster_must_be_that_of_the_exam(folder: Path) -> None:
    students = {"s0": "Anna", "s2": "Zoë", "new": "New"}
    (folder / "roster.csv").write_text(roster(students), encoding="utf-8")
    (folder / "late.csv").write_text(roster({"s2": "Zoë", "x": "X"}), encoding="utf-8")
    assert [line.replace("EXAM/exam.json", "HEAD") for line in refused(folder)] == [
        'roster.csv: no student "a/b" - expected everyone who has a paper in EXAM - add the line, '
        "or, where only the id has changed, use kinegrade exchange --new-id",
        'roster.csv:2: name "Anna" of student "s0" - expected "Ann", as in HEAD - correct the line',
        'roster.csv:4: student "new" has no paper in EXAM - expected the students of the exam - '
        "list late students in the file of --add alone",
        'late.csv:2: student "s2" (Zoë) has a paper in EXAM already - expected students without '
        "one - delete the line",
    ]


def test_an_id_that_would_rename_the_files_of_another_is_refused(tmp_path: Path) -> None:
    folder = generated(write(tmp_path, students={"S0": "Ann", "s2": "Zoë"}), *WORDS)
    (folder / "late.csv").write_text(roster({"s0": "Bob", "S2": "Tom"}), encoding="utf-8")
    assert refused(folder) == [
        'late.csv: an id differs from "S0" in capitals alone, so that their files would be one - '
        "expected ids that differ in more - correct the id, or write the exam again with --force "
        "and a roster of all"
    ]
    (folder / "late.csv").write_text(roster({"S2": "Tom"}), encoding="utf-8")
    added(folder)
    assert (folder / "EXAM" / "papers" / "%532.pdf").exists()


def test_a_folder_that_is_no_exam_is_refused(tmp_path: Path) -> None:
    (line,) = refused(write(tmp_path))
    assert line.startswith("EXAM/exam.json: cannot be read (No such file or directory) - ")


@pytest.mark.parametrize(
    "option", ["--new-numbers", "--lang=en", "--solutions", "--seed=x", "--engine=typst"]
)
def test_what_the_exam_says_is_not_said_again(folder: Path, option: str) -> None:
    before = contents(folder)
    result = add(folder, option)
    assert result.exit_code == 2
    name = option.partition("=")[0].replace("--no-s", "--s")
    assert f"--add makes papers like those of EXAM: leave out {name}\n" in result.stderr
    assert contents(folder) == before


@pytest.mark.parametrize("name", ["papers.pdf", "solutions.pdf"])
def test_a_book_that_is_missing_is_refused(folder: Path, name: str) -> None:
    assert kinegrade("solutions", folder / "EXAM").exit_code == 0
    (folder / "EXAM" / name).unlink()
    (line,) = refused(folder)
    assert line.startswith(f"EXAM/{name}: is missing - expected the {name[:-4]} of all students")


def test_a_key_that_says_otherwise_is_refused(folder: Path) -> None:
    key = folder / "EXAM" / "key.jsonl"
    text = key.read_text(encoding="utf-8")
    key.write_text(re.sub(r'"decimal": ?"', '"decimal": "123', text, count=1), encoding="utf-8")
    (line,) = refused(folder)
    assert "decimal, value state different numbers - expected the same one" in line


def test_a_key_of_other_tolerances_is_refused(folder: Path) -> None:
    key = folder / "EXAM" / "key.jsonl"
    text = key.read_text(encoding="utf-8")
    key.write_text(re.sub(r'"relative": ?0.01', '"relative": 0.005', text, count=1), "utf-8")
    assert [line for line in refused(folder) if 'student "s0", q1: ' not in line] == []


def test_a_secret_that_was_taken_out_is_refused(folder: Path) -> None:
    head = folder / "EXAM" / "exam.json"
    text = head.read_text(encoding="utf-8").replace('"reproducible"', '"taken"')
    head.write_text(text, encoding="utf-8")
    (line,) = refused(folder)
    assert line.startswith("EXAM/exam.json: does not hold the secret")


def test_a_name_that_no_font_prints_is_complained_of(folder: Path) -> None:
    (folder / "late.csv").write_text(roster({"x": "\U00012000"}), encoding="utf-8")
    said = "x: the name has characters that no font prints, they stand as code points"
    assert refused(folder, "--strict") == [said]
    result = add(folder)
    assert result.exit_code == 1
    assert f"complaint: {said}\n" in result.stderr


def test_a_key_without_its_last_line_end_is_not_broken(folder: Path) -> None:
    key = folder / "EXAM" / "key.jsonl"
    key.write_bytes(key.read_bytes().rstrip(b"\n"))
    added(folder)
    assert [line["student"] for line in key_lines(folder / "EXAM")] == [*CLASS, *LATE]


def as_format_1(exam: Path) -> None:
    """What earlier versions wrote: no places, no values as drawn, no paper size, no digests."""
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    left_out = ("paper_size", "engine", "editable")
    old = {name: value for name, value in head.items() if name not in left_out} | {"format": 1}
    (exam / "exam.json").write_text(json.dumps(old), encoding="utf-8")
    lines = key_lines(exam)
    for line in lines:
        del line["place"]
        for question in line["questions"]:
            del question["drawn"]
    text = "".join(f"{json.dumps(line)}\n" for line in lines)
    (exam / "key.jsonl").write_text(text, encoding="utf-8")


def test_an_exam_of_format_1_grows_and_grows(folder: Path) -> None:
    as_format_1(folder / "EXAM")
    before = contents(folder / "EXAM")
    added(folder)
    (folder / "roster.csv").write_text(roster({**CLASS, **LATE}), encoding="utf-8")
    (folder / "late.csv").write_text(roster({f"x{n}": "N" for n in range(15)}), encoding="utf-8")
    assert "15 papers added, 5 stay as they are" in added(folder).stderr
    after = contents(folder / "EXAM")
    kept = before.keys() - REWRITTEN
    assert {name: after[name] for name in kept} == {name: before[name] for name in kept}
    assert after["key.jsonl"].startswith(before["key.jsonl"])
    lines = key_lines(folder / "EXAM")
    assert [line.get("place") for line in lines[:3]] == [None] * 3
    assert sorted(line["place"] for line in lines[3:]) == list(range(3, 20))
    for question in (0, 1):
        values = [
            json.dumps({name: each["exact"] for name, each in found["parameters"].items()})
            for found in (line["questions"][question] for line in lines)
        ]
        assert len(set(values)) == 20


def test_a_late_id_that_an_exam_has_but_for_zeros_is_refused_unless_it_is_wanted(
    tmp_path: Path,
) -> None:
    folder = write(tmp_path, students={"03100111": "Ann"})
    (folder / "late.csv").write_text(roster({"3100111": "Ann"}), encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv", "-o", folder / "EXAM"
    assert kinegrade("generate", *files).exit_code == 0
    late = "--add", folder / "late.csv"
    refused = kinegrade("generate", *files, *late)
    assert refused.exit_code == 2
    assert refused.stderr.splitlines() == [
        'error: late.csv:2: student "03100111" has a paper already, and "3100111" differs from that '
        "id by zeros in front alone - use one id for one person, or add --allow-odd-ids if they are "
        "several people"
    ]
    assert kinegrade("generate", *files, *late, "--allow-odd-ids").exit_code == 0


def test_a_seat_of_the_exam_is_not_that_of_a_late_student_too(tmp_path: Path) -> None:
    folder = write(tmp_path)
    seats = "student,name,room,seat\ns0,Ann,Hall,1\na/b,Bo,Hall,2\ns2,Cy,Aula,1\n"
    (folder / "roster.csv").write_text(seats, encoding="utf-8")
    generated(folder, *WORDS)
    late = "student,name,room,seat\ns7,Di,Hall,2\ns8,Ed,Aula,2\n"
    (folder / "late.csv").write_text(late, encoding="utf-8")
    assert refused(folder) == [
        'late.csv:2: seat 2 in room Hall is that of student "a/b" already - give another seat'
    ]
