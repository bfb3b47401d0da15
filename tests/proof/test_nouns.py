"""`check` takes the nouns of asks and givens for what the statement calls by them."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.claims.claims import find_false_claims
from kinegrade.proof.claims.swaps import find_swapped_givens
from tests.said import all_said

LINKAGE = """family = "four-bar"
source = "worked out by hand"
language = "en"
title = "T"
statement = '''SAID {{ a }} {{ b }} {{ c }} {{ d }} {{ omega }}'''
joints = ["pin O: ground OA", "pin A: OA AB", "pin B: AB CB", "pin C: ground CB"]
inputs = [{ motion = "OA turns", velocity = "omega" }]
[parameters]
a = { unit = "m", draw = [2], means = "LENGTH" }
b = { unit = "m", draw = [7], means = "coupler" }
c = { unit = "m", draw = [9], means = "rocker" }
d = { unit = "m", draw = [6], means = "distance" }
omega = { unit = "rad/s", draw = [10], means = "angular velocity of the DRIVER" }
[points]
O = "(0, 0)"
C = "(d, 0)"
A = "(0, a)"
B = "meet(circle(A, b), circle(C, c), upper)"
[bodies]
OA = "O A"
AB = "A B"
CB = "C B"
[asks]
found = { quantity = "QUANTITY", unit = "UNIT", points = 1, means = "MEANS" }
"""
SAID = "the crank $OA$, the connecting rod $AB$, the two rockers $OA$ and $CB$, the piston $B$."
SAGT = "die Kurbel $OA$, die Pleuelstange $AB$, die Schwinge $CB$, der Kolben $B$."
WRONG = "and the quantity is of {}: write the one that is meant in both places"


def find(means: str, quantity: str = "omega(CB)", length: str = "length", said: str = SAID) -> str:
    """What is wrong with the words of the linkage, each fault on a line."""
    text = LINKAGE.replace("SAID", said).replace("MEANS", means).replace("QUANTITY", quantity)
    text = text.replace("UNIT", "m/s" if "velocity" in quantity else "rad/s")
    text = text.replace("LENGTH", length).replace("DRIVER", "driver")
    template = read_template("linkage", text)
    return "\n".join(all_said(find_false_claims(template, [solve_template(template, {}, ())])))


@pytest.mark.parametrize(
    ("means", "quantity", "right"),
    [
        ("angular velocity of the crank", "omega(CB)", False),
        ("angular velocity of the crank", "omega(OA)", True),
        ("angular velocity of the rocker", "omega(CB)", True),
        ("angular velocity of the rocker", "omega(AB)", False),
        ("angular velocity of the driver", "omega(AB)", False),
        ("angular velocity of the driver", "omega(OA)", True),
        ("speed of the piston", "magnitude(velocity(B))", True),
        ("speed of the piston", "magnitude(velocity(A))", False),
        ("speed of the end of the connecting rod", "magnitude(velocity(A))", True),
        ("angular velocity of the connecting rod AB", "omega(CB)", True),  # letters without dollars
        ("angular velocity of the lever", "omega(CB)", True),  # nothing says what it is
    ],
)
def test_a_noun_that_the_statement_gives_to_another_body_is_a_fault(
    means: str, quantity: str, right: bool
) -> None:
    assert (find(means, quantity) == "") == right


def test_the_fault_of_a_noun_names_it() -> None:
    fault = 'asks.found.means: it says "of the crank", ' + WRONG.format("CB")
    assert find("angular velocity of the crank") == fault


@pytest.mark.parametrize(
    ("means", "right"),
    [("Winkelgeschwindigkeit der Kurbel", False), ("Winkelgeschwindigkeit der Schwinge", True)],
)
def test_nouns_are_declined(means: str, right: bool) -> None:
    assert (find(means, said=SAGT) == "") == right


@pytest.mark.parametrize(("means", "right"), [("曲柄的角速度", False), ("摇杆的角速度", True)])
def test_nouns_have_no_blanks_before_the_letters_in_chinese(means: str, right: bool) -> None:
    assert (find(means, said="曲柄 $OA$ 由连杆 $AB$ 带动摇杆 $CB$。") == "") == right


def test_a_length_that_is_said_to_be_of_another_body_is_a_fault() -> None:
    assert find("speed", length="length of the crank") == ""
    assert find("speed", length="length of the bar OA") == ""
    assert find("speed", length="length of the connecting rod") == (
        'parameters.a.means: it says "of the connecting rod", which is AB, and a is the length OA: '
        "correct the words, or the point"
    )


def test_givens_that_have_changed_places_are_told_by_nouns_and_by_what_follows() -> None:
    text = LINKAGE.replace('"coupler"', '"teeth of B"').replace('"rocker"', '"teeth of C"')
    said = "{{ %s }} of $A$, {{ %s }} of $B$ and {{ %s }} of the gear $C$;"
    for names, faults in ((("a", "b", "c"), 0), (("a", "c", "b"), 1)):
        template = read_template(
            "linkage",
            text.replace("SAID", said % names)
            .replace("QUANTITY", "omega(CB)")
            .replace("UNIT", "rad/s"),
        )
        found = all_said(find_swapped_givens(template))
        assert [each.count("stands where the words mean") for each in found] == [1] * faults
