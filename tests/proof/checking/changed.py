"""The slider-crank with a change, and the crank with wider domains, as tests of `check` have
them.
"""

from __future__ import annotations

from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.checking import check
from kinegrade.proof.report import Report

SLIDER = load_template("slider-crank").file.text


WIDE = (
    ("draw = [1, 2]", 'draw = "1 .. 2 step 0.1"'),
    ('[0, "1/2", 3]', '"0.1 .. 0.9 step 0.1"'),
    ("[2, 1000000, 20000000]", '"2 .. 9 step 1"'),
)


def checked(old: str, new: str) -> Report:
    assert SLIDER.count(old) == 1
    return check(read_template("slider-crank", SLIDER.replace(old, new)), sample=6)
