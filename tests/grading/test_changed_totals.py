"""A total that was changed by hand in grades.csv is not handed out as if it had been marked: rows
are named.
"""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import msgspec
import pytest

from kinegrade.marks_folder.grade_list import GradeList
from kinegrade.marks_folder.writing import MarksWriter
from tests.grading.marked_folder import RIGHT, mark_class
from tests.small_class import kinegrade

MENDING = (
    "expected the file as kinegrade grade wrote it - grade again; to change marks, grade by "
    "a --policy"
)
COMMANDS = (
    "report EXAM MARKS -o OUT",
    "feedback EXAM MARKS -o OUT --format md",
    "diff MARKS MARKS -o OUT",
    "sharing EXAM MARKS -o OUT",
    "grade EXAM answers.csv -o OUT --never-lower MARKS",
    "export MARKS --to xlsx -o OUT",
    "export MARKS --to generic --exam EXAM -o OUT",
    "export MARKS --to canvas --title Quiz -o OUT",
)


@pytest.fixture
def marks(tmp_path: Path) -> Path:
    """Three students: all right, all wrong, nothing handed in."""
    return mark_class(tmp_path, {"7": RIGHT, "8": ("9", "9", "9"), "9": ()})[1]


def refused(marks: Path, command: str = COMMANDS[0]) -> list[str]:
    """The refusals of a command, without the path of the folder and what is to be done."""
    names = ("EXAM", "MARKS", "OUT", "answers.csv")
    places = {name: str(marks.parent / name) for name in names}
    result = kinegrade(*(places.get(word, word) for word in command.split()))
    assert (result.exit_code, result.stdout) == (2, ""), result.stderr
    assert not (marks.parent / "OUT").exists()
    lines = [line.removeprefix(f"error: {marks}/") for line in result.stderr.splitlines()]
    assert all(line.endswith(f" - {MENDING}") for line in lines), lines
    return [line.removesuffix(f" - {MENDING}") for line in lines]


def change(marks: Path, old: str, new: str, name: str = "grades.csv") -> None:
    text = (marks / name).read_text(encoding="utf-8")
    assert old in text, text
    (marks / name).write_text(text.replace(old, new), encoding="utf-8")


@pytest.mark.parametrize("command", COMMANDS)
def test_a_total_that_the_marks_do_not_give_is_refused_by_every_command(
    marks: Path, command: str
) -> None:
    change(marks, "8,Student 8,0,0,0,", "8,Student 8,0,0,5,")
    assert refused(marks, command) == ['grades.csv:3: student "8": total is 5, 0 by marks.csv']


def test_all_rows_are_named_with_all_that_is_wrong(marks: Path) -> None:
    change(marks, "8,Student 8,0,0,0,9.5", "8,Student 8,1,0,0,10")
    change(marks, "7,Student 7,7,2.5,9.5,", "7,Student 7,7,2.5,9,")
    assert refused(marks) == [
        'grades.csv:2: student "7": total is 9, 9.5 by marks.csv',
        'grades.csv:3: student "8": q1 is 1, 0 by marks.csv; out_of is 10, 9.5 by marks.csv',
    ]


def test_a_percentage_that_the_total_contradicts_is_refused(marks: Path) -> None:
    change(marks, ",9.5,9.5,100,", ",9.5,9.5,99,")
    assert refused(marks)[0] == 'grades.csv:2: student "7": percent is 99, 100 by the total'


def test_students_who_were_left_out_added_or_doubled_are_named(marks: Path) -> None:
    lines = (marks / "grades.csv").read_text(encoding="utf-8").splitlines(keepends=True)
    head, seven, eight, _ = lines
    added = seven.replace("7,Student 7", "6,Student 6")
    (marks / "grades.csv").write_text("".join([head, seven, eight, eight, added]), encoding="utf-8")
    assert sorted(refused(marks)) == [
        'grades.csv: student "9" has marks and no row here',
        'grades.csv:4: student "8": stands there twice',
        'grades.csv:5: student "6": has no lines in marks.csv',
    ]


def test_a_column_that_was_deleted_is_missed_once(marks: Path) -> None:
    change(marks, ",q2,", ",bonus,")
    faults = refused(marks)
    assert faults[0] == "grades.csv: no column q2"
    assert faults[1] == 'grades.csv:2: student "7": bonus is 2.5, 0 by marks.csv'


def test_lines_of_one_student_that_were_sorted_apart_are_refused(marks: Path) -> None:
    lines = (marks / "marks.csv").read_text(encoding="utf-8").splitlines(keepends=True)
    (marks / "marks.csv").write_text("".join([lines[0], *lines[2:], lines[1]]), encoding="utf-8")
    result = kinegrade("export", marks, "--to", "moodle", "--force", "-o", marks.parent / "OUT")
    assert result.exit_code == 2
    assert 'marks.csv:10: the lines of student "7" do not stand together' in result.stderr


def test_a_class_that_was_changed_as_a_whole_is_not_listed_without_end(tmp_path: Path) -> None:
    _, marks = mark_class(tmp_path, {str(number): RIGHT for number in range(30)})
    change(marks, ",9.5,9.5,", ",9,9.5,")
    faults = refused(marks)
    assert len(faults) == 21
    assert faults[-1] == "grades.csv: 10 more rows do not agree with marks.csv"


def test_a_kept_total_is_held_against_what_was_kept(marks: Path) -> None:
    folder = marks.parent
    (folder / "policy.toml").write_text(
        "[questions.q1.asks.v_B]\nvoid = 'drop'\n[questions.q2]\nvoid = 'drop'\n", encoding="utf-8"
    )
    answers = folder / "answers.csv"
    answers.write_text(answers.read_text(encoding="utf-8").replace("7,1.732,0", "7,1.732,5"))
    first = kinegrade("grade", folder / "EXAM", answers, "-o", folder / "FIRST")
    assert first.exit_code in (0, 1), first.stderr
    again = kinegrade(
        *("grade", folder / "EXAM", answers, "-o", marks, "--force"),
        *("--policy", folder / "policy.toml", "--never-lower", folder / "FIRST"),
    )
    assert "1 student keeps an earlier total" in again.stderr
    out = folder / "report.html"
    kept = kinegrade("report", folder / "EXAM", marks, "-o", out)
    assert kept.exit_code == 0, kept.stderr
    total = (marks / "kept.csv").read_text(encoding="utf-8").splitlines()[1].split(",")[6]
    change(marks, f",{total},", ",3,")
    assert refused(marks) == [f'grades.csv:2: student "7": total is 3, {total} by kept.csv']
    (marks / "kept.csv").unlink()
    assert refused(marks) == ['grades.csv:2: student "7": total is 3, 0 by marks.csv']


def test_thirds_of_points_add_up_though_each_is_rounded(marks: Path) -> None:
    folder = marks.parent
    third = 'points = 1\naccept = [{ value = "5", credit = "1/3" }]\n'
    asks = "q1.asks.v_B", "q1.asks.omega_AB", "q2.asks.a_B"
    policy = "".join(f"[questions.{ask}]\n{third}" for ask in asks)
    (folder / "policy.toml").write_text(policy, encoding="utf-8")
    (folder / "answers.csv").write_text(
        "student,q1.v_B,q1.omega_AB,q2.a_B\n8,5,5,5\n", encoding="utf-8"
    )
    arguments = "grade", folder / "EXAM", folder / "answers.csv", "-o", marks, "--force"
    graded = kinegrade(*arguments, "--policy", folder / "policy.toml")
    assert graded.exit_code in (0, 1), graded.stderr
    assert "8,Student 8,0.6667,0.3333,1,3," in (marks / "grades.csv").read_text(encoding="utf-8")
    assert (marks / "marks.csv").read_text(encoding="utf-8").count(",0.3333,1,") == 3
    assert kinegrade("diff", marks, marks).exit_code == 0
    sheets = folder / "FEEDBACK"
    done = kinegrade("feedback", folder / "EXAM", marks, "-o", sheets, "--format", "md")
    assert done.exit_code == 0, done.stderr
    texts = [path.read_text(encoding="utf-8") for path in (sheets / "sheets").iterdir()]
    assert texts
    assert [text for text in texts if "of an earlier marking" in text] == []


@pytest.mark.parametrize(
    ("status", "problem"),
    [
        ("absent", "status is absent, and marks.csv has answers"),
        ("excused", 'status is "excused", neither marked nor absent'),
    ],
)
def test_a_status_that_was_changed_is_refused(marks: Path, status: str, problem: str) -> None:
    with_status(marks, {"7": status, "8": "marked", "9": "absent"})
    assert refused(marks) == [f'grades.csv:2: student "7": {problem}']


def with_status(marks: Path, statuses: dict[str, str]) -> None:
    """Gives grades.csv a last column status with these words."""
    head, *rows = (marks / "grades.csv").read_text(encoding="utf-8").splitlines()
    if head.endswith(",status"):
        head, rows = head.removesuffix(",status"), [row.rpartition(",")[0] for row in rows]
    told = [f"{row},{statuses[row.partition(',')[0]]}" for row in rows]
    (marks / "grades.csv").write_text("\n".join([f"{head},status", *told]) + "\n", encoding="utf-8")


def test_a_folder_of_an_earlier_version_without_status_is_read(marks: Path) -> None:
    with_status(marks, {"7": "marked", "8": "marked", "9": "absent"})
    for name in ("with", "without"):
        out = marks.parent / f"{name}.html"
        assert kinegrade("report", marks.parent / "EXAM", marks, "-o", out).exit_code == 0
        lines = (marks / "grades.csv").read_text(encoding="utf-8").splitlines()
        cut = [line.rpartition(",")[0] for line in lines]
        (marks / "grades.csv").write_text("\n".join(cut) + "\n", encoding="utf-8")


def test_one_row_of_many_alike_is_named(tmp_path: Path) -> None:
    _, marks = mark_class(tmp_path, {f"{number:02}": RIGHT for number in range(1, 31)})
    change(marks, "29,Student 29,7,2.5,9.5,9.5,", "29,Student 29,7,2.5,9.4,9.5,")
    assert refused(marks) == ['grades.csv:30: student "29": total is 9.4, 9.5 by marks.csv']


def test_marks_that_contradict_themselves_are_not_handed_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mark_class(tmp_path, {"7": RIGHT})
    written = MarksWriter.grades

    def write_wrongly(
        writer: MarksWriter,
        questions: tuple[str, ...],
        grades: GradeList,
        *more: object,
        **others: object,
    ) -> None:
        wrong = grades.changed(lambda grade: msgspec.structs.replace(grade, kept=Fraction(3)))
        written(writer, questions, wrong, *more, **others)  # type: ignore[arg-type]

    monkeypatch.setattr(MarksWriter, "grades", write_wrongly)
    names = ("EXAM", "answers.csv", "-o", "OUT")
    result = kinegrade("grade", *(name if name == "-o" else str(tmp_path / name) for name in names))
    assert result.exit_code == 2
    assert 'student "7": total is 3, 9.5 by marks.csv' in result.stderr
    assert not (tmp_path / "OUT").exists()
