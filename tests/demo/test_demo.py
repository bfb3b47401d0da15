"""The main job through the command line, on the files that are shipped: an exam for 60 students,
marked.
"""

from __future__ import annotations

import csv
import json
from collections import Counter
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path
from statistics import mean, stdev

import pytest
from click.testing import Result

from tests.demo.type_answers import (
    ABSENT,
    DOUBTFUL,
    NOTES,
    REMARKS,
    SLIPS,
    SPELLINGS,
    STRANGER,
    TWICE,
    UNREADABLE,
    WRONG_UNIT,
    ZEROS_EATEN,
    Answer,
    class_rows,
    read_keys,
    write_answers,
)
from tests.small_class import kinegrade

pytestmark = pytest.mark.xdist_group("docs")  # one worker deals the exam, for README as well
ROOT = Path(__file__).parents[2]
BANK = ROOT / "banks" / "demo.toml"
ROSTER = ROOT / "banks" / "demo-roster.csv"
ANSWERS = ROOT / "banks" / "demo-answers.csv"
OUT_OF = Decimal(34)
ODD_CELLS = UNREADABLE | WRONG_UNIT | DOUBTFUL

Lines = list[dict[str, str]]
Verdicts = dict[tuple[str, str], dict[str, str]]  # lines of marks.csv by student and column
Typed = dict[tuple[str, str], Answer]


@dataclass(frozen=True)
class Demo:
    """What the two commands left behind."""

    exam: Path
    marks: Path
    generated: Result
    graded: Result


def lines_of(path: Path) -> Lines:
    with path.open(encoding="utf-8-sig", newline="") as table:
        return list(csv.DictReader(table))


@pytest.fixture(scope="session")
def demo(tmp_path_factory: pytest.TempPathFactory) -> Demo:
    folder = tmp_path_factory.mktemp("demo")
    exam, marks = folder / "EXAM", folder / "MARKS"
    generated = kinegrade("generate", BANK, ROSTER, "-o", exam, "--reproducible", "demo", "--force")
    return Demo(exam, marks, generated, kinegrade("grade", exam, ANSWERS, "-o", marks, "--force"))


@pytest.fixture(scope="session")
def verdicts(demo: Demo) -> Verdicts:
    lines = lines_of(demo.marks / "marks.csv")
    return {(line["student"], f"{line['question']}.{line['ask']}"): line for line in lines}


@pytest.fixture(scope="session")
def counted(demo: Demo) -> Typed:
    """The typed answers that count: of two rows the last, of strangers none; an id gets its zeros
    back.
    """
    roster = {line["student"] for line in lines_of(ROSTER)}
    restored = {ZEROS_EATEN.lstrip("0"): ZEROS_EATEN}
    typed = {restored.get(row.student, row.student): row for row in class_rows(demo.exam)}
    rows = {student: row for student, row in typed.items() if student in roster}
    return {
        (student, column): answer
        for student, row in rows.items()
        for column, answer in row.answers.items()
    }


def test_every_paper_is_typeset_without_complaint(demo: Demo) -> None:
    assert demo.generated.exit_code == 0, demo.generated.stderr
    assert "complaint" not in demo.generated.stderr
    papers = sorted((demo.exam / "papers").iterdir())
    assert len(papers) == len(lines_of(ROSTER)) == 60
    assert [
        paper
        for paper in (*papers, demo.exam / "papers.pdf")
        if not paper.read_bytes().startswith(b"%PDF")
    ] == []


def test_the_shipped_answers_are_those_of_this_exam(demo: Demo, tmp_path: Path) -> None:
    write_answers(demo.exam, tmp_path / "answers.csv")
    assert (tmp_path / "answers.csv").read_bytes() == ANSWERS.read_bytes(), (
        "run `make demo-answers`"
    )


def test_grading_ends_with_complaints_and_says_them_all(demo: Demo) -> None:
    said = [line for line in demo.graded.stderr.splitlines() if line.startswith("complaint: ")]
    assert (demo.graded.exit_code, len(said)) == (1, len(lines_of(demo.marks / "complaints.csv")))


def read_line_number(note: str) -> int:
    """Of a remark as it is told behind its line."""
    return int(note.partition(":")[0])


def line_numbers(student: str) -> list[str]:
    """The lines of the answer sheet that carry this id."""
    lines = lines_of(ANSWERS)
    return [str(number) for number, line in enumerate(lines, start=2) if line["student"] == student]


def test_the_complaints_are_those_planted_and_no_others(demo: Demo) -> None:
    first, _ = line_numbers(TWICE)
    notes = [f"{line_numbers(student)[0]}: {note}" for student, note in NOTES.items()]
    planted = Counter(
        [
            ("", REMARKS, "; ".join(sorted(notes, key=read_line_number))),
            ("", "", ABSENT),
            (first, "", "a whole row"),
            (*line_numbers(STRANGER[0]), "student", "a whole row"),
            *(
                (*line_numbers(student), column, text)
                for (student, column), text in ODD_CELLS.items()
            ),
        ]
    )
    found = lines_of(demo.marks / "complaints.csv")
    assert (
        Counter((each["line"], each["column"], shown(each["content"])) for each in found) == planted
    )


def shown(content: str) -> str:
    """Rows that are kept whole are told by their many commas; formulas stand behind an
    apostrophe.
    """
    return "a whole row" if content.count(",") > 10 else content.removeprefix("'")


@pytest.mark.parametrize(
    ("line", "problem", "done"),
    [
        (TWICE, "another row for this student", "counts; this row is kept here only"),
        (STRANGER[0], f'no student "{STRANGER[0]}" in the exam', "not graded"),
    ],
)
def test_a_row_that_is_not_graded_is_kept_whole(
    demo: Demo, line: str, problem: str, done: str
) -> None:
    number = line_numbers(line)[0]
    [complaint] = [
        each
        for each in lines_of(demo.marks / "complaints.csv")
        if each["line"] == number and "," in each["content"]
    ]
    assert problem in complaint["problem"]
    assert done in complaint["done"]
    typed = ANSWERS.read_text(encoding="utf-8").splitlines()[int(number) - 1]
    assert complaint["content"] == typed


def test_who_handed_in_something_has_the_same_grade_in_moodle(demo: Demo) -> None:
    roster, grades = lines_of(ROSTER), lines_of(demo.marks / "grades.csv")
    assert [(each["student"], each["name"]) for each in grades] == [
        (each["student"], each["name"]) for each in roster
    ]
    handed_in = {
        line["student"] for line in lines_of(demo.marks / "marks.csv") if line["verdict"] != "blank"
    }
    assert {each["student"] for each in grades} - handed_in == {ABSENT}
    assert [each["student"] for each in grades if each["status"] == "absent"] == [ABSENT]
    moodle = lines_of(demo.marks / "moodle.csv")
    assert [(each["ID number"], each["Full name"], each["Grade"]) for each in moodle] == [
        (each["student"], each["name"], each["total"])
        for each in grades
        if each["student"] in handed_in
    ]


def test_totals_are_sums_of_the_marks_within_what_there_is(demo: Demo) -> None:
    points: Counter[str] = Counter()
    for line in lines_of(demo.marks / "marks.csv"):
        points[line["student"]] += Decimal(line["points"])  # type: ignore[assignment]
    for grade in lines_of(demo.marks / "grades.csv"):
        assert (
            0
            <= Decimal(grade["total"])
            == points[grade["student"]]
            <= Decimal(grade["out_of"])
            == OUT_OF
        )


def test_grades_spread_as_in_a_class(demo: Demo) -> None:
    percents = [float(grade["percent"]) for grade in lines_of(demo.marks / "grades.csv")]
    assert 50 < mean(percents) < 60
    assert 18 < stdev(percents) < 30


def test_who_handed_in_nothing_has_blanks_and_no_points(demo: Demo) -> None:
    lines = [line for line in lines_of(demo.marks / "marks.csv") if line["student"] == ABSENT]
    assert {(line["verdict"], line["points"]) for line in lines} == {("blank", "0")}


def test_an_id_whose_zeros_a_spreadsheet_ate_is_restored_and_said(
    demo: Demo, verdicts: Verdicts
) -> None:
    said = f'1 student id is not as in the exam: "{ZEROS_EATEN.lstrip("0")}" for "{ZEROS_EATEN}"'
    assert said in demo.graded.stderr
    assert {line["verdict"] for (who, _), line in verdicts.items() if who == ZEROS_EATEN} > {
        "right"
    }


def test_every_manner_of_typing_occurs_and_right_answers_stay_right(
    verdicts: Verdicts, counted: Typed
) -> None:
    right = {place: answer for place, answer in counted.items() if answer.slip == "right"}
    assert {answer.spelling for answer in right.values()} == set(SPELLINGS)
    assert {place: verdicts[place]["verdict"] for place in right} == dict.fromkeys(right, "right")
    assert [
        place for place in right if verdicts[place]["points"] != verdicts[place]["out_of"]
    ] == []


@pytest.mark.parametrize("slip", sorted(set(SLIPS) - {"blank"}))
def test_a_slip_gets_no_points(verdicts: Verdicts, counted: Typed, slip: str) -> None:
    places = [place for place, answer in counted.items() if answer.slip == slip]
    verdict = {place: verdicts[place]["verdict"] for place in places}
    alone = [place for place in places if verdict[place] != "follow-through"]
    assert {verdict[place] for place in alone} <= {"wrong", "mistake"}
    assert {verdicts[place]["points"] for place in alone} == {"0"}
    assert len(alone) >= 5
    # Two slips in one question may be one slip carried on: another answer is charged then
    for student, column in set(places) - set(alone):
        question = column.partition(".")[0]
        others = (
            answer
            for (who, where), answer in counted.items()
            if who == student and where.startswith(question) and where != column
        )
        assert any(answer.slip not in ("right", "blank") for answer in others), others


def test_blanks_and_unreadable_cells_are_told_apart(verdicts: Verdicts, counted: Typed) -> None:
    blanks = [place for place, answer in counted.items() if answer.slip == "blank"]
    assert {verdicts[place]["verdict"] for place in blanks} == {"blank"}
    assert {verdicts[place]["verdict"] for place in UNREADABLE} == {"unreadable"}
    assert {place for place, line in verdicts.items() if line["verdict"] == "unreadable"} == set(
        UNREADABLE
    )
    assert {place for place, line in verdicts.items() if line["verdict"] == "wrong unit"} == set(
        WRONG_UNIT
    )


def test_two_digits_are_right_just_when_they_are_near_enough(
    demo: Demo, verdicts: Verdicts, counted: Typed
) -> None:
    keys = read_keys(demo.exam)
    seen: Counter[bool] = Counter()
    for (student, column), answer in counted.items():
        if answer.slip == "two digits":
            value = keys[student][column].value
            near = abs(Decimal(answer.text) - value) <= abs(value) / 100
            expected = {"right"} if near else {"wrong", "mistake", "follow-through"}
            assert verdicts[student, column]["verdict"] in expected
            seen[near] += 1
    assert min(seen[True], seen[False]) > 0


def test_no_cell_of_the_marks_runs_as_a_formula(demo: Demo) -> None:
    assert formulas(demo.marks / "marks.csv", "response") == ["'=1+1"]
    assert formulas(demo.marks / "complaints.csv", "content") == ["'=1+1"]


def formulas(path: Path, column: str) -> list[str]:
    return [line[column] for line in lines_of(path) if line[column].lstrip("'").startswith("=")]


def test_the_same_exam_and_answers_give_the_same_bytes(demo: Demo, tmp_path: Path) -> None:
    kinegrade("grade", demo.exam, ANSWERS, "-o", tmp_path / "MARKS")
    assert bytes_of(tmp_path / "MARKS") == bytes_of(demo.marks)


def bytes_of(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def test_the_chinese_papers_put_the_same_questions(demo: Demo, tmp_path: Path) -> None:
    run = kinegrade(
        *("generate", BANK, ROSTER, "-o", tmp_path / "EXAM", "--reproducible", "demo"),
        *("--lang", "zh", "--no-papers"),
    )
    assert run.exit_code == 0, run.stderr
    assert (
        json.loads((tmp_path / "EXAM" / "exam.json").read_text(encoding="utf-8"))["language"]
        == "zh"
    )
    assert (tmp_path / "EXAM" / "key.jsonl").read_bytes() == (demo.exam / "key.jsonl").read_bytes()
