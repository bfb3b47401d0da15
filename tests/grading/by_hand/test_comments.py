"""What is said of an answer that has no points yet stays until it has some."""

from __future__ import annotations

from pathlib import Path

from tests.grading.by_hand.hand_marking import ADA, SOFYA, faults, give, grade, totals
from tests.small_class import table


def read_comments(folder: Path) -> dict[str, str]:
    """The comments of the list of open questions, by student."""
    return {row["student"]: row["comment"] for row in table(folder / "MARKS" / "open.csv")}


def test_a_row_with_a_comment_alone_is_open_and_its_comment_is_kept(folder: Path) -> None:
    marked = give(folder, f"{ADA},q2,2,\n{SOFYA},q2,,ask her\n")
    assert marked.exit_code == 1
    assert f'student "{SOFYA}" has no points by hand for question 2' in marked.stderr
    assert "by-hand.csv: 1 row has no points yet" in marked.stderr
    assert totals(folder)[ADA] == ("9", "9.5")
    assert read_comments(folder) == {SOFYA: "ask her"}


def test_a_comment_in_the_list_that_is_replaced_is_carried_over(folder: Path) -> None:
    file = folder / "MARKS" / "open.csv"
    text = file.read_text(encoding="utf-8-sig")
    file.write_text(text.replace("q2,2.5,,", "q2,2.5,,=illegible", 1), encoding="utf-8")
    assert grade(folder).exit_code == 0
    first, second = read_comments(folder).values()
    assert ("illegible" in first, second) == (True, "")
    again = read_comments(folder)
    assert grade(folder).exit_code == 0
    assert read_comments(folder) == again


def test_a_comment_alone_on_what_the_machine_marks_is_refused(folder: Path) -> None:
    (said,) = faults(give(folder, f"{ADA},q1,,why\n"), folder)
    assert said.startswith('by-hand.csv:2: q1: points are "" - expected')


def test_a_comment_alone_beside_a_mark_is_refused(folder: Path) -> None:
    (said,) = faults(give(folder, f"{ADA},q2,2,\n{ADA},q2,,why\n"), folder)
    assert said.startswith('by-hand.csv: 1001: q2: points are "" - expected a number')
