"""Students written by hand, of some templates or all: what their marks say.

    python -m tests.by_hand [--students 30] [--turns 4] [--words spring] [TEMPLATE ...]

For each claim it prints how many answers were tried, the share that failed, and one answer of each
kind of failure.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.by_hand.claims import Count, following, honest, mistaken
from tests.by_hand.class_list import TAUGHT
from tests.by_hand.exceptions import NEEDS_FOUR_FIGURES
from tests.by_hand.school import FOUR_FIGURES, THREE_FIGURES, make_exam


def main() -> None:
    """Make an exam for each rule of marking and try every claim on it."""
    parser = argparse.ArgumentParser(prog="python -m tests.by_hand")
    parser.add_argument("templates", nargs="*", default=list(TAUGHT), metavar="TEMPLATE")
    parser.add_argument("--students", type=int, default=30)
    parser.add_argument("--turns", type=int, default=4)
    parser.add_argument("--words", default="by hand")
    asked = parser.parse_args()
    with TemporaryDirectory() as folder:
        place, class_size, words = Path(folder), asked.students, asked.words
        four = make_exam(place / "four", asked.templates, class_size, FOUR_FIGURES, words)
        show("exact", honest(four))
        show("four figures", honest(four, 4))
        show("mistaken", mistaken(four, asked.turns))
        show("following", following(four, asked.turns))
        rough = [name for name in asked.templates if name not in NEEDS_FOUR_FIGURES]
        if rough:
            three = make_exam(place / "three", rough, class_size, THREE_FIGURES, words)
            show("three figures", honest(three, 3))


def show(claim: str, found: Count) -> None:
    """Print what a claim came to."""
    print(f"== {claim}: {found.tried.total()} tried, {found.share:.2%} failed")
    print(found)


if __name__ == "__main__":
    main()
