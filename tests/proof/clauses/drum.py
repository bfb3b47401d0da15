"""Two loads on a stepped drum, and an offset slider-crank, with other words for them."""

from __future__ import annotations

from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.claims import find_false_claims
from kinegrade.proof.clauses.clauses import find_false_clauses
from tests.said import all_said

_DRUM = """family = "pulleys"
source = "worked out by hand"
language = "en"
title = "T"
statement = '''A drum turns about the fixed axis $O$. A rope carries the load $A$, another one the load $B$.
SAID {{ R }} {{ r }} {{ v }}'''
joints = [
  "pin O: ground drum",
  "one translates",
  "two translates",
  "A of one slides on line(A, pi/2)",
  "B of two slides on line(B, pi/2)",
  "circle(O, R) of drum rolls on line(A, pi/2) of one",
  "circle(O, r) of drum rolls on line(B, pi/2) of two",
]
inputs = [{ motion = "A of one moves along -y", velocity = "v" }]
[parameters]
R = { unit = "m", draw = [3], means = "radius of the rim" }
r = { unit = "m", draw = [1], means = "radius of the hub" }
v = { unit = "m/s", draw = [2], means = "speed of $A$" }
[points]
O = "(0, 0)"
A = "(-R, -3*R)"
B = "(r, -2*R)"
P = "(0, R)"
[bodies]
drum = "O P"
one = "A"
two = "B"
[asks]
found = { quantity = "omega(drum)", unit = "rad/s", points = 1, means = "a" }
"""
_SLIDER = """family = "slider-crank"
source = "worked out by hand"
language = "en"
title = "T"
statement = '''The crank $OA$ and the rod $AB$ with its midpoint $G$; the slider $B$ moves in a guide.
SAID {{ r }} {{ l }} {{ e }} {{ phi }} {{ v }} {{ a }}'''
joints = ["pin O: ground OA", "pin A: OA AB", "B of AB slides on line(H, 0)"]
inputs = [{ motion = "B of AB moves along -x", velocity = "v", acceleration = "-a" }]
[parameters]
r = { unit = "m", draw = [1], means = "length of the crank" }
l = { unit = "m", draw = [3], means = "length of the rod" }
e = { unit = "m", draw = ["1/2"], means = "offset of the guide" }
phi = { unit = "deg", draw = [30, 70], means = "angle" }
v = { unit = "m/s", draw = [2], means = "speed" }
a = { unit = "m/s^2", draw = [2], means = "acceleration" }
[points]
O = "(0, 0)"
H = "(0, -e)"
A = "polar(O, r, phi)"
B = "meet(circle(A, l), line(H, 0), right)"
G = "midpoint(A, B)"
[bodies]
OA = "O A"
AB = "A B G"
[asks]
found = { quantity = "omega(OA)", unit = "rad/s", points = 1, means = "a" }
"""
_MECHANISMS = {"drum": _DRUM, "slider": _SLIDER}


def find_faults(mechanism: str, said: str, **choices: list[str]) -> list[str]:
    """What is wrong with these words for it, in two instances where there are as many."""
    return all_said(find_false_clauses(*_solve(mechanism, said, **choices)))


def find_all_faults(mechanism: str, said: str) -> list[str]:
    """The same with what whole sentences of the catalogues say."""
    template, solved = _solve(mechanism, said)
    return all_said([*find_false_clauses(template, solved), *find_false_claims(template, solved)])


def _solve(mechanism: str, said: str, **choices: list[str]) -> tuple[Template, list[Solution]]:
    template = read_template("t", _MECHANISMS[mechanism].replace("SAID", said))
    angles = {"phi": template.parameters["phi"].choices} if mechanism == "slider" else {}
    values = [{"phi": each} for each in (angles | choices).get("phi", ())]
    values = values or [{}] * (mechanism == "drum")
    solved = [solve_template(template, each, ()) for each in values]
    return template, solved
