"""A new mark by hand takes the place of an earlier one, whatever has become of that since; and what
counts no longer is kept apart or refused with a way on.
"""

from __future__ import annotations

from pathlib import Path

from tests.grading.by_hand.hand_marking import ADA, SOFYA, faults, give, totals
from tests.small_class import table

LOWER = "[questions.q3.asks.omega_AB]\npoints = 1\n"


def lowered(folder: Path) -> tuple[str, Path]:
    """The options for a policy by which q3 is worth less."""
    file = folder / "policy.toml"
    file.write_text(LOWER, encoding="utf-8")
    return "--policy", file


def test_a_mark_above_what_a_policy_leaves_is_refused_with_a_way_that_works(folder: Path) -> None:
    give(folder, f"{ADA},q3,4,\n{SOFYA},q3.omega_AB,3,\n{SOFYA},q2,1,\n{ADA},q2,1,\n")
    do = "give the points that count now with --manual: they take the place of these"
    assert faults(give(folder, f"{ADA},bonus,1,\n", *lowered(folder)), folder) == [
        f"MARKS/manual.csv:2: q3: 4 points of 1 - {do}",
        f"MARKS/manual.csv:4: q3.omega_AB: 3 points of 1 - {do}",
    ]
    done = give(folder, f"{ADA},q3,0.5,\n{SOFYA},q3.omega_AB,1,\n", *lowered(folder))
    assert done.exit_code == 0, done.stderr
    assert "2 marks by hand of " in done.stderr
    assert "2 marks by hand carried over" in done.stderr
    assert totals(folder) == {ADA: ("4.5", "6.5"), SOFYA: ("5", "6.5")}


def test_points_for_a_whole_question_take_the_place_of_those_for_its_asks(folder: Path) -> None:
    give(folder, f"{ADA},q3.omega_AB,4,\n{SOFYA},q3,3,\n{SOFYA},q2,1,\n{ADA},q2,1,\n")
    assert faults(give(folder, f"{SOFYA},q3.omega_AB,1,\n"), folder) == [
        f'by-hand.csv:2: student "{SOFYA}" has points for q3.omega_AB and, at '
        "MARKS/manual.csv:4, for the whole question - give the points of the whole question with "
        "--manual: they take the place of both"
    ]
    done = give(folder, f"{ADA},q3,2,\n{SOFYA},q3,1,\n")
    assert done.exit_code == 0, done.stderr
    assert "2 marks by hand of " in done.stderr
    given = {
        (row["student"], row["question"]): row["points"]
        for row in table(folder / "MARKS/manual.csv")
    }
    assert given == {(ADA, "q2"): "1", (ADA, "q3"): "2", (SOFYA, "q2"): "1", (SOFYA, "q3"): "1"}
