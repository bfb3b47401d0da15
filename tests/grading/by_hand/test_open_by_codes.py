"""What is still to be marked by hand, where answers were typed by the codes of papers: `open.csv`
has these codes, and marks given by it follow the papers as the answers do; of marks given by ids it
is said that they stay.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.grading.by_hand.hand_marking import (
    ADA,
    SOFYA,
    faults,
    give,
    grade,
    open_exam_students,
)
from tests.small_class import kinegrade, table


@pytest.fixture
def coded(folder: Path) -> Path:
    """The same class, its answers typed by codes and marked."""
    file = folder / "answers.csv"
    text = file.read_text(encoding="utf-8")
    for each in open_exam_students(folder):
        text = text.replace(f"\n{each.student},", f"\n{each.paper},")
    file.write_text(text, encoding="utf-8")
    assert grade(folder).exit_code == 0
    return folder


def exchange(folder: Path) -> None:
    """Ada gets Sofya's paper, and Sofya hers."""
    sofya = open_exam_students(folder)[1].paper
    assert kinegrade("exchange", folder / "EXAM", sofya, ADA).exit_code == 0


def fill_in(folder: Path) -> Path:
    """open.csv with 2 points for Ada and 1 for Sofya, elsewhere."""
    text = (folder / "MARKS" / "open.csv").read_text(encoding="utf-8-sig")
    file = folder / "filled.csv"
    filled = text.replace("q2,2.5,,", "q2,2.5,2,", 1).replace("q2,2.5,,", "q2,2.5,1,", 1)
    file.write_text(filled, encoding="utf-8")
    return file


def read_points(folder: Path) -> list[tuple[str, str, str]]:
    rows = table(folder / "MARKS" / "manual.csv")
    return [(row["student"], row["points"], row["paper"]) for row in rows]


def test_codes_stand_in_the_list_only_where_answers_were_typed_by_them(folder: Path) -> None:
    assert [row["paper"] for row in table(folder / "MARKS" / "open.csv")] == ["", ""]
    exchange(folder)
    assert grade(folder, "--manual", fill_in(folder), "--own-papers").exit_code == 0
    assert read_points(folder) == [(ADA, "2", ""), (SOFYA, "1", "")]


def test_marks_by_the_list_follow_the_papers_before_and_after_they_are_given(coded: Path) -> None:
    ada, sofya = (each.paper for each in open_exam_students(coded))
    assert [row["paper"] for row in table(coded / "MARKS" / "open.csv")] == [ada, sofya]
    filled = fill_in(coded)
    exchange(coded)
    done = grade(coded, "--manual", filled)
    assert done.exit_code == 0, done.stderr
    assert "filled.csv: 2 marks by hand that were given by the code of a paper" in done.stderr
    assert read_points(coded) == [(ADA, "1", sofya), (SOFYA, "2", ada)]
    exchange(coded)
    assert grade(coded).exit_code == 0
    assert read_points(coded) == [(ADA, "2", ada), (SOFYA, "1", sofya)]


def test_of_marks_by_id_it_is_said_once_that_they_stay_though_the_answers_go(coded: Path) -> None:
    give(coded, f"{ADA},q2,2,\n{SOFYA},q2,1,\n{SOFYA},bonus,1,\n")
    exchange(coded)
    said = (
        f"MARKS/manual.csv: 2 marks by hand that were given by ids stay with students whose papers "
        "have changed hands since, while answers typed by codes go with the papers "
        f"({ADA} q2, {SOFYA} q2) - give those anew with --manual that are of the paper"
    )
    assert said in grade(coded).stderr
    assert "stay with students" not in grade(coded).stderr
    assert read_points(coded)[0] == (ADA, "2", "")


def test_nothing_is_said_of_marks_by_id_where_answers_were_typed_by_ids(folder: Path) -> None:
    give(folder, f"{ADA},q2,2,\n{SOFYA},q2,1,\n")
    exchange(folder)
    assert "stay with students" not in grade(folder, "--own-papers").stderr


def test_a_list_whose_ids_or_codes_were_sorted_alone_is_refused(coded: Path) -> None:
    ada, sofya = (each.paper for each in open_exam_students(coded))
    filled = fill_in(coded)
    text = filled.read_text(encoding="utf-8")
    for one, other in ((ada, sofya), (ADA, SOFYA)):
        turned = text.replace(one, "X").replace(other, one).replace("X", other)
        filled.write_text(turned, encoding="utf-8")
        codes = [line.split(",")[2] for line in turned.splitlines()[1:]]
        said = faults(grade(coded, "--manual", filled), coded)
        owners = {ada: ADA, sofya: SOFYA}
        assert [line.partition(" - ")[0] for line in said] == [
            f'filled.csv:{line}: {code}: the paper with this code is that of "{owners[code]}"'
            for line, code in enumerate(codes, 2)
        ]


def test_a_list_of_an_earlier_version_has_no_codes_and_is_read(coded: Path) -> None:
    rows = table(coded / "MARKS" / "open.csv")
    names = [name for name in rows[0] if name != "paper"]
    lines = [names, *([row[name] for name in names] for row in rows)]
    text = "".join(",".join(line) + "\n" for line in lines)
    (coded / "MARKS" / "open.csv").write_text(text, encoding="utf-8")
    filled = fill_in(coded)
    assert grade(coded, "--manual", filled).exit_code == 0
    assert read_points(coded) == [(ADA, "2", ""), (SOFYA, "1", "")]
