"""A question that only hands mark, dropped by a policy: it counts for nobody and is waited for no
longer, and the marks that it had are kept until the policy is withdrawn.
"""

from __future__ import annotations

from pathlib import Path

from tests.grading.by_hand.hand_marking import ADA, SOFYA, faults, give, grade, totals
from tests.small_class import kinegrade, table

DROPPED = '[questions.q2]\nvoid = "drop"\n'
SCALE = '[scale]\ngrades = { A = "90 %", B = 0 }\npass = 0\n'


def by_policy(folder: Path, text: str) -> tuple[str, Path]:
    """The options for a policy of this text."""
    file = folder / "policy.toml"
    file.write_text(text, encoding="utf-8")
    return "--policy", file


def test_a_question_of_hands_that_is_dropped_is_not_waited_for(folder: Path) -> None:
    marked = grade(folder, *by_policy(folder, SCALE + DROPPED))
    assert marked.exit_code == 0, marked.stderr
    assert "still to be marked" not in marked.stderr
    assert "grades: 2 of 2 passed" in marked.stderr
    assert totals(folder) == {ADA: ("7", "7"), SOFYA: ("7", "7")}
    assert not (folder / "MARKS" / "open.csv").exists()


def test_its_marks_are_kept_and_count_again_without_the_policy(folder: Path) -> None:
    give(folder, f"{ADA},q2,2,well seen\n{SOFYA},q2,0,\n{SOFYA},q1,1,late\n")
    dropped = grade(folder, *by_policy(folder, DROPPED))
    assert "2 marks by hand are for what the policy drops: they are kept in left-out.csv and do " \
        "not count" in dropped.stderr  # fmt: skip
    assert totals(folder) == {ADA: ("7", "7"), SOFYA: ("5", "7")}
    kept = table(folder / "MARKS" / "left-out.csv")
    assert [(row["student"], row["points"], row["comment"]) for row in kept] == [
        (ADA, "2", "well seen"),
        (SOFYA, "0", ""),
    ]
    assert "2 marks by hand are for what" in grade(folder, *by_policy(folder, DROPPED)).stderr
    back = grade(folder)
    assert "2 marks by hand carried over from " in back.stderr
    assert totals(folder) == {ADA: ("9", "9.5"), SOFYA: ("5", "9.5")}
    assert not (folder / "MARKS" / "left-out.csv").exists()


def test_a_newer_mark_takes_the_place_of_one_that_was_left_out(folder: Path) -> None:
    give(folder, f"{ADA},q2,2,\n{SOFYA},q2,1,\n")
    grade(folder, *by_policy(folder, DROPPED))
    again = give(folder, f"{ADA},q2,1.5,looked again\n")
    assert "1 mark by hand of " in again.stderr
    assert totals(folder) == {ADA: ("8.5", "9.5"), SOFYA: ("8", "9.5")}


def test_marks_for_an_ask_that_is_dropped_are_kept_too(folder: Path) -> None:
    give(folder, f"{ADA},q3.omega_AB,1,\n{ADA},q2,2,\n{SOFYA},q2,2,\n")
    grade(folder, *by_policy(folder, '[questions.q3]\nvoid = "drop"\n'))
    assert totals(folder) == {ADA: ("5", "5.5"), SOFYA: ("5", "5.5")}
    grade(folder)
    assert totals(folder)[ADA] == ("6", "9.5")


def test_whoever_answered_only_what_is_dropped_handed_in(folder: Path) -> None:
    empty = folder / "answers.csv"
    empty.write_text(f"student,q1.v_B\n{ADA},1\n", encoding="utf-8")
    give(folder, f"{SOFYA},q2,2,\n{ADA},q2,2,\n", *by_policy(folder, DROPPED))
    status = {row["student"]: row["status"] for row in table(folder / "MARKS" / "grades.csv")}
    assert status[SOFYA] == "marked"


def test_two_marks_for_what_is_dropped_are_told_as_for_what_counts(folder: Path) -> None:
    before = (folder / "MARKS" / "grades.csv").read_bytes()
    rows = f"{ADA},q2,2,one\n{ADA},q2,1,other\n{ADA},q1,0,\n{ADA},q1,3,\n{SOFYA},q1,2,\n"
    rows += f"{SOFYA},q1.v_B,1,\n"
    text = DROPPED + '[questions.q1]\nvoid = "drop"\n'
    for options in ((), by_policy(folder, text)):
        assert sorted(faults(give(folder, rows, *options), folder)) == [
            f'by-hand.csv:3: student "{ADA}" has 1 points for q2 here and 2 at by-hand.csv:2 '
            "- keep one of them",
            f'by-hand.csv:5: student "{ADA}" has 3 points for q1 here and 0 at by-hand.csv:4 '
            "- keep one of them",
            f'by-hand.csv:7: student "{SOFYA}" has points for q1.v_B and, at by-hand.csv:6, for '
            "the whole question - keep one of them",
        ]
    assert (folder / "MARKS" / "grades.csv").read_bytes() == before


def test_feedback_says_that_the_question_was_taken_out(folder: Path) -> None:
    grade(folder, *by_policy(folder, DROPPED))
    place = "-o", folder / "FEEDBACK", "--format", "html"
    assert kinegrade("feedback", folder / "EXAM", folder / "MARKS", *place).exit_code == 0
    (sheet, *_) = sorted((folder / "FEEDBACK").glob("**/*1001*.html"))
    text = sheet.read_text(encoding="utf-8")
    assert "This was taken out of the marking." in text
    assert "to be marked by hand" not in text


def test_other_rules_for_a_question_of_hands_are_refused_with_what_to_do(folder: Path) -> None:
    rules = '[questions.q2]\nvoid = "full"\ntolerance = "1 %"\n[questions.q9]\nvoid = "drop"\n'
    said = faults(grade(folder, *by_policy(folder, rules)), folder)
    do = (
        "it is marked by hand: give its points in a file of marks, with kinegrade grade --manual, "
        'or leave it out with void = "drop"'
    )
    assert said == [
        f'policy.toml:2: questions.q2.void: "full" gives points that only hands give - {do}',
        f"policy.toml:3: questions.q2.tolerance: unknown key - {do}",
        "policy.toml:4: questions.q9: unknown question - known here: q1, q2, q3",
    ]
