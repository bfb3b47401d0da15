"""Draws are addressed: whoever is drawn, and whatever else the exam holds, an address gives the
same value for ever.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections import Counter
from hashlib import sha256
from hmac import new as hmac

import pytest

from kinegrade.errors import DrawError
from kinegrade.problem.drawing import (
    LARGEST,
    MAX_ATTEMPTS,
    REASONS,
    SMALLEST,
    Deck,
    Refused,
    address,
    examine,
)
from kinegrade.problem.holding import holds
from kinegrade.problem.template import Template
from tests.problem.crank import crank

STUDENTS = ("007", "0012", "12", "Ω-王")

# The promise for ten years: secret "spring", question "q1", first attempts. These lines are never
# edited.
PROMISED = {
    "007": {"r": "4", "h": "11", "omega": "29"},
    "0012": {"r": "2", "h": "16", "omega": "27"},
    "12": {"r": "4", "h": "3", "omega": "14"},
    "Ω-王": {"r": "2", "h": "12", "omega": "58"},
}
DOMAINS = {
    "r": tuple(map(str, range(1, 8))),
    "h": tuple(map(str, range(1, 21))),
    "omega": tuple(map(str, range(1, 61))),
}


def deck(template: Template | None = None, **domains: tuple[str, ...]) -> Deck:
    return Deck(template or crank(), ("v_x",), "spring", "q1", domains or DOMAINS)


def refusal(template: Template, **values: str) -> Refused:
    with pytest.raises(Refused) as caught:
        examine(template, {"r": "2", "h": "1/2", "omega": "2", **values}, template.asked())
    return caught.value


def test_a_secret_gives_the_values_that_it_gave_ten_years_ago() -> None:
    assert {student: deck().values(student, 0) for student in STUDENTS} == PROMISED


def test_an_address_is_the_hmac_of_its_parts_each_with_its_length() -> None:
    message = b"\x00\x00\x00\x02q1\x00\x00\x00\x03\xe7\x8e\x8b\x00\x00\x00\x0212"
    expected = int.from_bytes(hmac(b"spring", message, sha256).digest(), "big")
    assert address("spring", "q1", "王", 12) == expected
    assert address("spring", "q1", "1", 2) != address("spring", "q1", "12", "")


def test_another_process_draws_the_same() -> None:
    code = (
        "import json; from tests.problem.test_drawing import *;"
        "print(json.dumps({student: deck().values(student, 3) for student in STUDENTS}))"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        check=True,
        env={**os.environ, "PYTHONHASHSEED": "7", "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    assert json.loads(ran.stdout) == {student: deck().values(student, 3) for student in STUDENTS}


def test_a_new_parameter_leaves_the_values_of_the_others() -> None:
    before = deck(crank(), h=("1", "2", "3")).values("007", 0)
    first = '[parameters]\ne = { unit = "m", draw = [1, 2], means = { en = "e", zh = "e" } }\n'
    wider = crank(("[parameters]\n", first))
    after = deck(wider, h=("1", "2", "3")).values("007", 0)
    assert list(after) == ["e", "r", "h", "omega"]
    assert {name: after[name] for name in before} == before


def test_students_at_the_end_leave_the_draws_of_those_before() -> None:
    full, part = (deck(h=("1/2", "1"), r=("2", "3"), omega=("2", "3")) for _ in range(2))
    longer = [full.draw(str(number)).values for number in range(7)]
    assert [part.draw(str(number)).values for number in range(4)] == longer[:4]


def test_questions_and_secrets_draw_independently() -> None:
    other = Deck(crank(), ("v_x",), "spring", "q2", DOMAINS)
    secret = Deck(crank(), ("v_x",), "Spring", "q1", DOMAINS)
    draws = [
        [one.values(str(number), 0) for number in range(20)] for one in (deck(), other, secret)
    ]
    assert draws[0] != draws[1] != draws[2] != draws[0]


def test_every_value_is_drawn_about_equally_often() -> None:
    one = deck()
    counts = Counter(one.values(str(number), 0)["r"] for number in range(2100))
    assert sorted(counts) == sorted(DOMAINS["r"])
    chi_square = sum((count - 300) ** 2 / 300 for count in counts.values())
    assert chi_square < 22.5  # 6 degrees of freedom: 99.9 %


def test_no_two_of_a_class_are_alike_and_every_refusal_is_counted() -> None:
    few = deck(r=("2", "3"), h=("1/2", "1"), omega=("2", "3", "4"))
    drawn = [tuple(few.draw(str(number)).values.values()) for number in range(12)]
    assert len(set(drawn)) == few.combinations() == 12
    assert set(few.refused) == {"duplicate"}
    with pytest.raises(DrawError, match=re.escape("12 combinations are drawable")) as caught:
        few.draw("13")
    assert "q1 (crank): no acceptable instance for student 13 in 400 draws" in str(caught.value)
    assert "widen the domains" in str(caught.value)
    assert len(caught.value.problems) == 1


@pytest.mark.parametrize(
    ("values", "reason", "detail"),
    [
        ({"omega": "20000000"}, "condition", "omega < 10000000"),
        (
            {"h": "3"},
            "mechanism",
            "crank: points.A: the circle about O of radius 2 does not reach the line y = 3",
        ),
        ({"h": "0"}, "degenerate", "v_x is zero"),
        ({"omega": "1000000"}, "absurd", "v_x is -500000 m/s"),
    ],
)
def test_an_instance_is_refused_for_a_reason(
    values: dict[str, str], reason: str, detail: str
) -> None:
    refused = refusal(crank(), **values)
    assert refused.reason == reason
    assert str(refused).startswith(detail)


def test_all_reasons_are_counted_by_name() -> None:
    mixed = Deck(crank(), ("v_x",), "spring", "q1")
    mixed.draw("1")
    mixed.draw("2")  # r = 1 and r = 2 with h = 1/2 and omega = 2: there are no more
    counted = r"so far: absurd \d+, condition \d+, degenerate \d+, duplicate \d+, mechanism \d+\)"
    with pytest.raises(DrawError, match=counted):
        mixed.draw("3")
    assert set(mixed.refused) == set(REASONS) - {
        "rounding",
        "mistake",
        "decimals",
    }  # a crank's speed gives no room for these
    assert sum(mixed.refused.values()) >= MAX_ATTEMPTS


def test_zero_is_a_proper_answer_where_the_template_says_so() -> None:
    vanishing = crank(('sign = "+x", points', 'sign = "+x", vanishes = true, points'))
    solution = examine(vanishing, {"r": "2", "h": "0", "omega": "2"}, ("v_x",))
    assert solution["v_x"].is_zero


def test_only_the_answers_asked_for_must_be_sensible() -> None:
    assert examine(crank(), {"r": "2", "h": "2", "omega": "2"}, ("v_x",))["v_x"].exact == "-4"
    with pytest.raises(Refused, match="v_y is zero"):
        examine(crank(), {"r": "2", "h": "2", "omega": "2"}, ("v_x", "v_y"))


def test_the_bounds_of_sensible_answers_are_sensible_themselves() -> None:
    for size in (SMALLEST, LARGEST):
        assert examine(crank(), {"r": "2", "h": "1", "omega": f"{size:.3f}"}, ("v_x",)).answers
    assert refusal(crank(), h="1", omega="0.0009999").reason == "absurd"
    assert refusal(crank(), h="1", omega="100000.1").reason == "absurd"


@pytest.mark.parametrize(
    ("condition", "held"),
    [
        ("h < r", True),
        ("r < h", False),
        ("r < 2", False),
        ("r <= 2", True),
        ("sqrt(3) < r*sqrt(3)/2", False),
        ("sqrt(3) <= r*sqrt(3)/2", True),
        ("sin(r) < 1", True),
        ("1/(r - 2) < 1", False),
        ("sqrt(h - r) < 9", False),
        ("atan(h) < pi/2", True),
        ("pi/2 < atan(h)", False),
        ("pi/4 < pi/3", True),
        ("0 < atan(h)", True),
        ("r > 2", False),
        ("r >= 2", True),
        ("r > h", True),
        ("sqrt(3)*r == sqrt(12)", True),
        ("r == h", False),
        ("sin(r) == cos(r)", False),
    ],
)
def test_conditions_are_decided_exactly_at_their_bounds(condition: str, held: bool) -> None:
    template = crank(("omega < 10000000", condition), kept=True)
    assert (
        holds(template, template.scheme.conditions[0], {"r": "2", "h": "1/2", "omega": "1"}) is held
    )


def test_an_unreachable_class_is_refused_although_combinations_abound() -> None:
    hopeless = deck(r=("1",), h=("3", "4"), omega=tuple(map(str, range(1, 200))))
    with pytest.raises(DrawError, match=re.escape("(refused so far: mechanism 400)")):
        hopeless.draw("007")
