"""Alternatives: each student gets one of several templates, or some of a tag; papers, answer sheets,
marks and reports know which.
"""

from __future__ import annotations

import csv
import json
import shutil
from collections import Counter
from pathlib import Path

import openpyxl
import pytest
from click.testing import Result

from tests.printed_text import read_text
from tests.small_class import contents, key_lines, kinegrade, table

HEAD = """title = { en = "Midterm", zh = "期中测验" }
course = "Mechanics"
"""
CRANK = """
[[questions]]
template = "slider-crank"
asks = { v_B = 3 }
"""
ANY = """
[[questions]]
any = ["bar-through-swivelling-sleeve", "crossed-belt-drive"]
asks = "velocity"
points = 6
"""
TAGGED = """
[[questions]]
tag = "curved-track"
per-student = true
points = 9
"""
THEORY = """
[[questions]]
text = { en = "Why?", zh = "为什么？" }
points = 2
"""
TITLES = {"q2a": "Bar sliding through a swivelling sleeve", "q2b": "Crossed belt on a turning arm"}
STUDENTS = ("1001", "1002", "1003", "1004")


def set_exam(folder: Path, bank: str, *options: str) -> Result:
    """What `generate` says of a bank for four students."""
    (folder / "bank.toml").write_text(HEAD + bank, encoding="utf-8")
    roster = "student,name\n" + "".join(f"{each},Student {each}\n" for each in STUDENTS)
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / "EXAM", "--reproducible", "x", *options)


def find_held(exam: Path) -> dict[str, list[str]]:
    """The questions of each paper, by student, in the order of the key."""
    return {
        line["student"]: [each["question"] for each in line["questions"]]
        for line in key_lines(exam)
    }


def mark(folder: Path, *options: str | Path, other: str = "", code: int = 0) -> Path:
    """A marks folder in which everybody answered what the key says, but 1001 nothing of q1, and
    typed `other` into the first cell that is not on the paper.
    """
    blank = table(folder / "EXAM" / "answers.csv")
    for row, line in zip(blank, key_lines(folder / "EXAM"), strict=True):
        for question in line["questions"]:
            for name, ask in question["asks"].items():
                row[f"{question['question']}.{name}"] = ask["decimal"]
    blank[0]["q1.v_B"] = ""
    strange = next(name for name in list(blank[0])[2:] if not blank[0][name] and name[:2] == "q2")
    blank[0][strange] = other
    with (folder / "answers.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(blank[0]))
        writer.writeheader()
        writer.writerows(blank)
    marks = folder / "MARKS"
    made = kinegrade("grade", folder / "EXAM", folder / "answers.csv", "-o", marks, *options)
    assert made.exit_code == code, made.stderr
    return marks


def read_pdf(path: Path) -> str:
    """The text of all pages, its words one blank apart."""
    return read_text(path)


@pytest.fixture(scope="module")
def exam_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam with an alternative and a question in words, its marks beside it."""
    folder = tmp_path_factory.mktemp("alternatives")
    made = set_exam(folder, CRANK + ANY + THEORY, "--spare", "1")
    assert made.exit_code == 0, made.stderr
    assert "each paper holds one of these; how many hold which: q2a (bar-through" in made.stderr
    mark(folder)
    return folder


def test_each_student_gets_one_and_equally_many_get_each(exam_folder: Path) -> None:
    held = find_held(exam_folder / "EXAM")
    assert [
        questions for questions in held.values() if questions[0] != "q1" or len(questions) != 2
    ] == []
    assert Counter(questions[1] for questions in held.values()) == {"q2a": 2, "q2b": 2}


def test_a_paper_and_the_key_show_that_one_alone(exam_folder: Path) -> None:
    exam = exam_folder / "EXAM"
    for student, (_, held) in find_held(exam).items():
        paper = read_pdf(exam / "papers" / f"{student}.pdf")
        shown = {name for name, title in TITLES.items() if title in paper}
        assert shown == {held}
        assert f"(no. {held[1:]} in the answer sheet)" in paper
        assert " 3 6 2 11 " in paper  # the marker's table: three questions and the total
    for name, papers in (("key.pdf", len(STUDENTS)), ("spare-key.pdf", 1)):
        key = read_pdf(exam / name)
        assert key.count(TITLES["q2a"]) + key.count(TITLES["q2b"]) == papers


def test_a_paper_is_the_same_again_and_verified(exam_folder: Path, tmp_path: Path) -> None:
    exam, again = exam_folder / "EXAM", tmp_path / "again.pdf"
    assert kinegrade("paper", exam, "1003", "-o", again).exit_code == 0
    assert again.read_bytes() == (exam / "papers" / "1003.pdf").read_bytes()
    verified = kinegrade("verify", exam)
    assert verified.exit_code == 0, verified.stderr
    assert "the keys of 5 of 5 papers solved again" in verified.stderr


def test_the_workbook_shades_what_a_student_does_not_have(exam_folder: Path) -> None:
    exam = exam_folder / "EXAM"
    _, header, *rows = openpyxl.load_workbook(exam / "answers.xlsx").active.iter_rows()
    for row in rows:
        held = find_held(exam)[row[0].value]
        grey = {
            name.value
            for name, cell in zip(header, row, strict=True)
            if cell.fill.fill_type == "solid"
        }
        assert grey == {name.value for name in header[3:] if name.value.split(".")[0] not in held}


def test_nobody_is_marked_by_hand_for_what_is_not_on_the_paper(
    exam_folder: Path, tmp_path: Path
) -> None:
    exam = exam_folder / "EXAM"
    held = find_held(exam)["1002"]
    other = "q2b" if "q2a" in held else "q2a"
    file = tmp_path / "manual.csv"
    file.write_text(f"student,question,points\n1002,{other},1\n", encoding="utf-8")
    marks = "-o", tmp_path / "MARKS", "--manual", file
    done = kinegrade("grade", exam, exam_folder / "answers.csv", *marks)
    assert done.exit_code == 2
    own = "q2a" if "q2a" in held else "q2b"
    expected = f'expected {own}, which the paper of "1002" has'
    do = "correct the row, or delete it here"
    said = f'question {other[1:]} is not on the paper of "1002" - {expected} - {do}'
    assert said in done.stderr
    file.write_text("student,question,points\n1002,q2,1\n", encoding="utf-8")
    number = kinegrade("grade", exam, exam_folder / "answers.csv", *marks)
    assert f'"q2" is no question or ask of the exam - {expected}' in number.stderr


def test_a_mark_by_hand_for_what_the_paper_holds_no_longer_is_kept_and_named(
    exam_folder: Path, tmp_path: Path
) -> None:
    shutil.copytree(exam_folder, tmp_path, dirs_exist_ok=True)
    exam, held = tmp_path / "EXAM", find_held(exam_folder / "EXAM")
    one, other = "1002", next(each for each in held if held[each] != held["1002"])
    file, files = tmp_path / "manual.csv", (tmp_path / "EXAM", tmp_path / "answers.csv")
    file.write_text(f"student,question,points\n{one},{held[one][1]},1\n", encoding="utf-8")
    made = kinegrade("grade", *files, "-o", tmp_path / "FIRST", "--manual", file)
    assert made.exit_code == 0, made.stderr
    for folder, again in (("FIRST", "SECOND"), ("SECOND", "THIRD")):
        assert kinegrade("exchange", exam, one, other).exit_code == 0
        since = "--since", tmp_path / folder, "--reason", "exchanged", "--own-papers"
        done = kinegrade("grade", *files, "-o", tmp_path / again, *since)
        assert done.exit_code < 2, done.stderr
        said = "1 mark by hand is for a question that the student's paper does not hold: it is kept"
        assert (said in done.stderr) == (again == "SECOND")
    left, counted = (table(tmp_path / each) for each in ("SECOND/left-out.csv", "THIRD/manual.csv"))
    assert [(row["student"], row["question"], row["points"]) for row in (*left, *counted)] == [
        (one, held[one][1], "1")
    ] * 2
    assert kinegrade("diff", tmp_path / "FIRST", tmp_path / "SECOND").exit_code == 0


def test_marks_are_of_what_each_paper_holds(exam_folder: Path) -> None:
    held = find_held(exam_folder / "EXAM")
    for row in table(exam_folder / "MARKS" / "grades.csv"):
        points = {name: row[name] for name in ("q1", "q2a", "q2b") if row[name]}
        q1 = "0" if row["student"] == "1001" else "3"
        assert points == {"q1": q1, held[row["student"]][1]: "6"}
        assert row["out_of"] == "9"
    lines = {(row["student"], row["question"]) for row in table(exam_folder / "MARKS/marks.csv")}
    assert lines == {(student, name) for student in held for name in held[student]}


def test_feedback_report_and_export_of_totals(exam_folder: Path, tmp_path: Path) -> None:
    exam, marks = exam_folder / "EXAM", exam_folder / "MARKS"
    feedback = tmp_path / "FEEDBACK"
    assert kinegrade("feedback", exam, marks, "-o", feedback, "--format", "md").exit_code == 0
    held = find_held(exam)["1002"][1]
    sheet = (feedback / "sheets" / "1002.md").read_text(encoding="utf-8")
    assert f"## Question 2 (no. {held[1:]} in the answer sheet) · {TITLES[held]} (6 / 6)" in sheet
    assert "## Question 3 (to be marked by hand" in sheet
    assert kinegrade("report", exam, marks, "-o", tmp_path / "report.html").exit_code == 0
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert report.count("given to 2 students") == 4  # two asks of each
    moodle = tmp_path / "moodle.csv"
    kinegrade("export", marks, "--to", "moodle", "-o", moodle)
    assert ",9,1: 3/3; 2: 6/6" in moodle.read_text(encoding="utf-8-sig")


def test_why_a_mark_is_as_it_is_by_the_number_that_the_paper_prints(exam_folder: Path) -> None:
    exam, marks = exam_folder / "EXAM", exam_folder / "MARKS"
    held = find_held(exam)["1002"][1]
    by_name = kinegrade("explain", exam, marks, "1002", held)
    assert by_name.exit_code == 0, by_name.stderr
    for said_on_paper in (held[1:], "2"):
        assert kinegrade("explain", exam, marks, "1002", said_on_paper).output == by_name.output


def test_single_questions_and_quizzes_are_refused(exam_folder: Path, tmp_path: Path) -> None:
    exam, marks = exam_folder / "EXAM", exam_folder / "MARKS"
    arguments = ("--to", "generic", "--title", "Midterm", "--per-question")
    made = kinegrade("export", marks, *arguments, "-o", tmp_path / "grades.csv")
    assert made.exit_code == 2
    assert "questions q2a, q2b are alternatives, which not all students had" in made.stderr
    quiz = kinegrade("quiz", exam, "--to", "qti21", "-o", tmp_path / "quiz.zip")
    assert quiz.exit_code == 2
    assert "questions 2a and 2b are alternatives, and a quiz asks everybody the same" in quiz.stderr
    assert not (tmp_path / "quiz.zip").exists()


def test_points_out_of_unlike_maxima_are_not_exported_as_they_are(
    exam_folder: Path, tmp_path: Path
) -> None:
    policy = tmp_path / "policy.toml"
    policy.write_text('[questions.q2a]\nvoid = "drop"\n', encoding="utf-8")
    exam, answers, marks = exam_folder / "EXAM", exam_folder / "answers.csv", tmp_path / "MARKS"
    made = kinegrade("grade", exam, answers, "-o", marks, "--policy", policy)
    said = f"{marks}/moodle.csv: totals are scaled to 9 points, as not all students could get"
    assert said in made.stderr
    assert {row["Grade"] for row in table(marks / "moodle.csv")} == {"9", "6"}
    assert {row["out_of"] for row in table(marks / "grades.csv")} == {"3", "9"}
    for system in ("moodle", "generic"):
        export = "export", marks, "--to", system, "-o", tmp_path / f"{system}.csv"
        refused = kinegrade(*export)
        assert refused.exit_code == 2
        assert "not all students could get the same points - expected one" in refused.stderr
        assert kinegrade(*export, "--maximum", "9").exit_code in (0, 1)
    for stated in ("9", "6"):
        gradebook = tmp_path / f"of-{stated}.csv"
        rows = "".join(f"N,{place},{each},{each},S,\n" for place, each in enumerate(STUDENTS))
        head = "Student,ID,SIS User ID,SIS Login ID,Section,Midterm (7)\n"
        gradebook.write_text(f"{head}    Points Possible,,,,,{stated}\n{rows}", "utf-8")
        into = "export", marks, "--to", "canvas", "--into", gradebook, "--column", "Midterm (7)"
        refused = kinegrade(*into, "-o", tmp_path / "into.csv")
        assert refused.exit_code == 2
        assert (
            f"counts {stated} there, and not all students could get the same points - expected one "
            "maximum - add --scale to scale all grades to it"
        ) in refused.stderr
        assert "correct the item" not in refused.stderr
        scaled = kinegrade(*into, "--scale", "-o", tmp_path / f"scaled-{stated}.csv")
        assert scaled.exit_code in (0, 1), scaled.stderr


def test_what_is_typed_for_the_other_alternative_is_complained_of_and_kept(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + ANY).exit_code == 0
    other = {"q2a": "2b", "q2b": "2a"}[find_held(tmp_path / "EXAM")["1001"][1]]
    (tmp_path / "policy.toml").write_text(f'[questions.q{other}]\nvoid = "full"\n', "utf-8")
    marks = mark(tmp_path, "--policy", tmp_path / "policy.toml", other="12.5", code=1)
    (complaint,) = table(marks / "complaints.csv")
    assert complaint["content"] == "12.5"
    assert complaint["problem"] == f'question {other} is not on the paper of "1001"'
    assert complaint["done"] == "kept here, not marked"
    row = table(marks / "grades.csv")[0]
    assert (row["total"], row["out_of"], row[f"q{other}"]) == ("6", "9", "")


def test_the_best_attempt_is_not_chosen_by_what_a_paper_does_not_ask(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + ANY).exit_code == 0
    (tmp_path / "policy.toml").write_text('attempts = "best"\n', encoding="utf-8")
    mark(tmp_path)
    first, *others = table(tmp_path / "answers.csv")
    held = find_held(tmp_path / "EXAM")["1001"]
    nothing = {name: "" if name.startswith(held[1]) else cell for name, cell in first.items()}
    zeros = {name: "0" for name in first if name.split(".")[0] in {"q2a", "q2b"} - {*held}}
    with (tmp_path / "twice.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(first))
        writer.writeheader()
        writer.writerows([first, {**nothing, **zeros}, *others])
    marks, sheet = tmp_path / "BEST", tmp_path / "twice.csv"
    policy = ("--policy", tmp_path / "policy.toml")
    made = kinegrade("grade", tmp_path / "EXAM", sheet, "-o", marks, *policy)
    assert "Traceback" not in made.stderr
    assert table(marks / "grades.csv")[0]["total"] == "6"


def test_late_students_and_spare_papers_have_one_and_nobody_elses_changes(tmp_path: Path) -> None:
    bank = "shuffle = true\n" + CRANK + ANY
    assert set_exam(tmp_path, bank, "--spare", "1").exit_code == 0
    exam, late = tmp_path / "EXAM", tmp_path / "late.csv"
    before = contents(exam / "papers")
    lines = key_lines(exam)
    late.write_text("student,name\n1009,Lise Meitner\n", encoding="utf-8")
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    added = kinegrade("generate", *files, "-o", exam, "--add", late)
    assert added.exit_code == 0, added.stderr
    code = json.loads((exam / "exam.json").read_text(encoding="utf-8"))["spares"][0]["paper"]
    assigned = kinegrade("assign", exam, code, "1010")
    assert assigned.exit_code == 0, assigned.stderr
    assert key_lines(exam)[: len(lines)] == lines
    after = contents(exam / "papers")
    assert {name: after[name] for name in before if "spare" not in name} == {
        name: paper for name, paper in before.items() if "spare" not in name
    }
    assert [questions for questions in find_held(exam).values() if len(questions) != 2] == []
    assert {*find_held(exam)} == {*STUDENTS, "1009", "1010"}


@pytest.mark.left(beside="test_each_student_gets_one_and_equally_many_get_each")
def test_some_of_a_tag_for_each_student(tmp_path: Path) -> None:
    made = set_exam(tmp_path, CRANK + TAGGED + "number = 2\n" + ANY)
    assert made.exit_code == 0, made.stderr
    for held in find_held(tmp_path / "EXAM").values():
        drawn = [name for name in held if name.startswith("q2")]
        assert len({*drawn}) == 2
        assert [name for name in held if name not in drawn][1] in ("q4a", "q4b")
    mark(tmp_path)


@pytest.mark.parametrize(
    "choices",
    [
        [{"questions": ["q2a", "q9"], "given": 1}],
        [{"questions": ["q2a", "q2b"], "given": 2}],
        [{"questions": ["q2a", "q2a"], "given": 1}],
    ],
)
def test_damaged_choices_are_refused(
    exam_folder: Path, tmp_path: Path, choices: list[dict[str, object]]
) -> None:
    head = json.loads((exam_folder / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    (tmp_path / "EXAM").mkdir()
    text = json.dumps(head | {"choices": choices})
    (tmp_path / "EXAM" / "exam.json").write_text(text, encoding="utf-8")
    refused = kinegrade("verify", tmp_path / "EXAM")
    assert refused.exit_code == 2
    assert "expected questions of the exam, each once, more than each paper holds" in refused.stderr


def test_a_key_with_both_alternatives_is_refused(exam_folder: Path, tmp_path: Path) -> None:
    exam = tmp_path / "EXAM"
    exam.mkdir()
    for name, content in contents(exam_folder / "EXAM").items():
        (exam / name).parent.mkdir(parents=True, exist_ok=True)
        (exam / name).write_bytes(content)
    lines = key_lines(exam)
    others = [each for line in lines for each in line["questions"][1:]]
    held = lines[0]["questions"][1]["question"]
    lines[0]["questions"].append(next(each for each in others if each["question"] != held))
    text = "".join(json.dumps(line) + "\n" for line in lines)
    (exam / "key.jsonl").write_text(text, encoding="utf-8")
    marked = kinegrade("grade", exam, exam_folder / "answers.csv", "-o", tmp_path / "MARKS")
    assert marked.exit_code == 2
    assert "asks" in marked.stderr


def test_a_policy_for_all_alternatives_is_told_how_each_is_called(
    exam_folder: Path, tmp_path: Path
) -> None:
    policy, exam = tmp_path / "policy.toml", exam_folder / "EXAM"
    policy.write_text('[questions.q2]\nvoid = "full"\n', encoding="utf-8")
    files = exam, exam / "answers.csv", "-o", tmp_path / "MARKS"
    refused = kinegrade("grade", *files, "--policy", policy)
    assert refused.exit_code == 2
    assert (
        "questions.q2: unknown question - its alternatives are questions of their own: name each of "
        '"q2a" and "q2b"'
    ) in refused.stderr
