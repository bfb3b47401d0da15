"""The best of several attempts, chosen with the marks by hand, which stand for all of them."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.grading.by_hand.hand_marking import ADA, SOFYA, give, totals
from tests.small_class import table

TRIES = '[tries]\npenalty = "40 %"\n'


def mark_attempts(folder: Path, rows: str, policy: str = "") -> tuple[str, ...]:
    """What each has by the first attempt, the last and the best; Ada has first q3 right, then q1,
    Sofya first q3, then both.
    """
    file = folder / "answers.csv"
    ada, sofya = table(file)
    sheet = [
        (ADA, "", ada["q3.omega_AB"]), (ADA, ada["q1.v_B"], ""),
        (SOFYA, "", sofya["q3.omega_AB"]), (SOFYA, sofya["q1.v_B"], sofya["q3.omega_AB"]),
    ]  # fmt: skip
    lines = ["student,q1.v_B,q3.omega_AB", *map(",".join, sheet)]
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    found = []
    for attempts in ("first", "last", "best"):
        rules = folder / "policy.toml"
        rules.write_text(f'attempts = "{attempts}"\n{policy}', encoding="utf-8")
        (folder / "MARKS" / "manual.csv").unlink(missing_ok=True)
        done = give(folder, rows, "--policy", rules)
        assert done.exit_code < 2, done.stderr
        found.append(" ".join(total for total, _ in totals(folder).values()))
    return tuple(found)


@pytest.mark.parametrize(
    ("rows", "policy", "expected"),
    [
        (f"{ADA},q3,4,on paper\n", "", ("4 4", "7 7", "7 7")),
        (f"{ADA},q3.omega_AB,0,\n{SOFYA},q1,0,\n", "", ("0 4", "3 4", "3 4")),
        # What a try costs is of all that can be had, with what only hands mark
        (f"{ADA},bonus,1,\n{ADA},q2,2,\n{SOFYA},q2,0,\n", TRIES,
         ("7 4", "2.2 3.2", "7 4")),
    ],
)  # fmt: skip
def test_the_best_attempt_is_the_best_with_the_marks_by_hand(
    folder: Path, rows: str, policy: str, expected: tuple[str, ...]
) -> None:
    assert mark_attempts(folder, rows, policy) == expected
