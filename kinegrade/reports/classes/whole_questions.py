"""Questions that a hand marked as a whole, as the class report counts them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import nan

import numpy as np

from kinegrade.marks_folder.hand_marks import ByHand
from kinegrade.marks_folder.rows import StudentTotal
from kinegrade.reports.classes.item_statistics import Points


def find_whole_shares(students: Sequence[StudentTotal], by_hand: ByHand) -> Mapping[str, Points]:
    """By question the share of its points that each student got for the whole of it by hand; NaN
    for who has no such mark.
    """
    found: dict[str, Points] = {}
    for place, each in enumerate(students):
        for mark in by_hand.get(each.student, {}).values():
            if not mark.ask and mark.out_of:
                shares = found.setdefault(mark.question, np.full(len(students), nan))
                shares[place] = float(mark.points / mark.out_of)
    return found
