"""A crank that turns, as a template's text, and what is said of it with passages replaced."""

from __future__ import annotations

import pytest

from kinegrade.errors import KinegradeError, TemplateError
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template

CRANK = """
family = "crank"
source = "by hand"
joints = ["pin O: ground OA"]
inputs = [{ motion = "OA turns", velocity = "omega" }]
conditions = ["r < 2"]
title = { en = "Crank", zh = "曲柄" }
statement = { en = "{{ r }} {{ phi }} {{ omega }}", zh = "{{ r }} {{ phi }} {{ omega }}" }

[parameters]
r = { unit = "m", draw = [1, "3/2"], means = { en = "length", zh = "长" } }
phi = { unit = "deg", draw = "0 .. 90 step 30", published = "60", means = { en = "angle", zh = "角" } }
omega = { unit = "rad/s", draw = [2], means = { en = "rate", zh = "角速度" } }

[lengths]
half = "r/2"

[points]
O = "(0, 0)"
A = "polar(O, r, phi)"
M = "polar(O, half, phi)"

[bodies]
OA = "O A M"

[asks]
v_A = { quantity = "magnitude(velocity(A))", unit = "m/s", means = { en = "speed", zh = "速度" } }

[[published]]
source = "v = omega r"
gives = { v_A = "omega*r" }
"""


def changed(*changes: tuple[str, str]) -> str:
    """The crank's template with the first of each of some texts replaced; each must occur."""
    text = CRANK
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


def faults(*changes: tuple[str, str], name: str = "crank") -> list[str]:
    """The faults of the crank's template with some texts replaced."""
    with pytest.raises(TemplateError) as refusal:
        read_template(name, changed(*changes))
    assert [
        problem
        for problem in refusal.value.problems
        if not ("\n" not in problem and len(problem) < 700)
    ] == []
    return list(refusal.value.problems)


def solving(*changes: tuple[str, str], **values: str) -> str:
    """What solving the changed template refuses, read as an exam keeps it: without a look at
    dimensions.
    """
    with pytest.raises(KinegradeError) as refusal:
        solve_template(read_template("crank", changed(*changes), kept=True), values)
    assert [problem for problem in refusal.value.problems if "\n" in problem] == []
    return str(refusal.value)


def refused(text: str, name: str = "crank") -> tuple[str, ...]:
    """The problems of a template at its default values; none when it is solved."""
    try:
        solve_template(read_template(name, text), {})
    except KinegradeError as error:
        return error.problems
    return ()


def one_line_each(problems: tuple[str, ...]) -> bool:
    return all(problem and "\n" not in problem for problem in problems)
