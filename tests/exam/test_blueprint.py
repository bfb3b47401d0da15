"""What a bank leaves to be drawn: never a template twice, decided by the secret, refused where it
cannot be done.
"""

from __future__ import annotations

from collections import Counter
from itertools import permutations
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import BankError
from kinegrade.exam.bank.bank import read_blueprint
from kinegrade.exam.bank.blueprint import Bank, Blueprint
from kinegrade.exam.bank.matching import match_slots
from tests.exam.folder_of_cranks import write_shelf
from tests.problem.crank import crank_text

HEAD = 'title = "Midterm"\ncourse = "Mechanics"\n'
SECRETS = [f"seed {number}" for number in range(60)]


@pytest.fixture(scope="module")
def shelf(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_shelf(tmp_path_factory.mktemp("shelf") / "templates")


def blueprint(shelf: Path, text: str) -> Blueprint:
    file = shelf.parent / "bank.toml"
    file.write_text(
        HEAD + "".join(f"[[questions]]\n{entry}\n" for entry in text.split("; ")), encoding="utf-8"
    )
    return read_blueprint(file, shelf)


def faults(shelf: Path, text: str) -> list[str]:
    with pytest.raises(BankError) as caught:
        blueprint(shelf, text.replace(", ", "\n"))
    file = str(shelf.parent / "bank.toml")
    return [problem.removeprefix(file) for problem in caught.value.problems]


def names(bank: Bank) -> list[str]:
    return [question.template.name for question in bank.questions]


def test_what_is_drawn_is_of_the_family_or_has_the_tag(shelf: Path) -> None:
    plan = blueprint(shelf, 'family = "crank"\nnumber = 2; tag = "acceleration"; tag = "round"')
    for secret in SECRETS:
        first, second, third, fourth = names(plan.bank(secret))
        assert {first[:5], second[:5], third[:4], fourth} == {"crank", "gear", "cam"}
    assert [question.identifier for question in plan.bank("").questions] == ["q1", "q2", "q3", "q4"]


def test_the_secret_alone_decides_and_every_template_has_its_chance(shelf: Path) -> None:
    plan = blueprint(shelf, 'family = "crank"; tag = "velocity"')
    assert [names(plan.bank(secret)) for secret in SECRETS] == [
        names(plan.bank(secret)) for secret in SECRETS
    ]
    first, second = (
        Counter(names(plan.bank(secret))[place] for secret in SECRETS) for place in (0, 1)
    )
    assert set(first) == {"crank-1", "crank-2", "crank-3"}
    assert set(second) == {*first, "cam"}
    assert min(*first.values(), *second.values()) >= 5


def test_no_template_stands_twice_in_an_exam_not_even_beside_one_that_is_named(shelf: Path) -> None:
    plan = blueprint(
        shelf,
        'tag = "velocity"\nnumber = 3; template = "crank-2"; tag = "acceleration"\nnumber = 2',
    )
    for secret in SECRETS:
        drawn = names(plan.bank(secret))
        assert sorted(drawn) == ["cam", "crank-1", "crank-2", "crank-3", "gear-1", "gear-2"]
        assert drawn[3] == "crank-2"


def test_a_greedy_choice_that_leaves_nothing_for_a_later_question_is_mended(shelf: Path) -> None:
    plan = blueprint(shelf, 'tag = "velocity"; family = "crank"\nnumber = 3')
    assert [secret for secret in SECRETS if names(plan.bank(secret))[0] != "cam"] == []


def test_a_template_file_beside_the_bank_takes_the_place_of_the_shipped_one(shelf: Path) -> None:
    (shelf.parent / "crank-1.toml").write_text(crank_text() + "# mine\n", encoding="utf-8")
    plan = blueprint(shelf, 'template = "crank-1.toml"; family = "crank"\nnumber = 2')
    assert {name for secret in SECRETS for name in names(plan.bank(secret))[1:]} == {
        "crank-2",
        "crank-3",
    }


def test_points_are_shared_out_as_each_template_weighs(shelf: Path) -> None:
    (question,) = blueprint(shelf, 'family = "gear"\npoints = 10').bank("").questions
    assert {ask.name: ask.points for ask in question.asks} == {"v_x": 3, "a_x": 7}
    (question,) = (
        blueprint(
            shelf, 'family = "gear"\nasks = "velocity"\npoints = 5\ntolerance = { absolute = 1 }'
        )
        .bank("")
        .questions
    )
    ((name, points, tolerance),) = [
        (ask.name, ask.points, ask.tolerance.absolute) for ask in question.asks
    ]
    assert (name, points, tolerance) == ("v_x", 5, 1)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            'family = "geer"',
            [
                ':4: questions[1].family: no shipped template has the family "geer" - did you mean '
                '"gear"? '
                "(known here: cam, crank, gear)"
            ],
        ),
        (
            'tag = "flat"',
            [
                ':4: questions[1].tag: no shipped template has the tag "flat" - known here: '
                "acceleration, round, "
                "velocity"
            ],
        ),
        (
            'family = "gear", number = 3',
            [
                ":5: questions[1].number: 3 different templates are to be drawn, 2 can be had besides "
                "those of the other questions - draw fewer"
            ],
        ),
        (
            'template = "gear-1"; family = "gear"; tag = "acceleration"',
            [
                ":7: questions[3].number: 1 template is to be drawn, 0 can be had "
                "besides those of the other questions - draw fewer"
            ],
        ),
        (
            'family = "gear", number = 0, without = ["gear-3"], draw = { r = [1] }',
            [
                ":5: questions[1].number: 0 - expected a whole number from 1 to 50",
                ':6: questions[1].without[1]: "gear-3" would not be drawn - did you mean "gear-2"? (known '
                "here: gear-1, gear-2)",
                ":7: questions[1].draw: unknown key - known here: asks, bonus, family and 8 more",
            ],
        ),
        (
            'family = "gear", without = ["gear-1", "gear-2"]'.replace('1", ', '1",'),
            [':5: questions[1].without: leaves no template of the family "gear" - leave out fewer'],
        ),
        (
            'family = "gear", without = "gear-1"',
            [':5: questions[1].without: "gear-1" - expected a list like ["slider-crank"]'],
        ),
        (
            'family = "gear", points = 1; family = "crank", points = true; family = "cam", points '
            "= 1001",
            [
                ":5: questions[1].points: gear-1 asks 2 quantities - expected a point for each",
                ":8: questions[2].points: true - expected a whole number from 1 to 1000",
                ":11: questions[3].points: 1001 - expected a whole number from 1 to 1000",
            ],
        ),
        (
            'family = "gear", asks = { v_x = 1 }',
            [":5: questions[1].asks: a table - expected position, velocity or acceleration"],
        ),
        (
            'family = "crank", asks = "acceleration"',
            [':5: questions[1].asks: no template of the family "crank" asks this with points'],
        ),
        (
            'tag = "velocity", number = 50; tag = "velocity", number = 50',
            [
                ":3: questions: 100 questions - expected at most 50",
                ":5: questions[1].number: 50 different templates are to be drawn, 4 can be had "
                "besides those of the other questions - draw fewer",
                ":8: questions[2].number: 50 different templates are to be drawn, 0 can be had "
                "besides those of the other questions - draw fewer",
            ],
        ),
    ],
)
def test_what_cannot_be_drawn_is_refused_before_a_secret_is_known(
    shelf: Path, text: str, expected: list[str]
) -> None:
    assert faults(shelf, text) == expected


def test_a_faulty_template_on_the_shelf_is_told(tmp_path: Path) -> None:
    shelf = write_shelf(tmp_path / "templates")
    (shelf / "gear-1.toml").write_text("title = 3", encoding="utf-8")
    found = faults(shelf, 'family = "gear"')
    assert found[0] == ": gear-1.toml: family: missing - expected in every template"
    # Where nothing is drawn the shelf is not read
    assert len(blueprint(shelf, 'template = "gear-2"').slots) == 1


def test_a_statement_that_lacks_something_is_told_where_it_may_be_drawn(tmp_path: Path) -> None:
    shelf = write_shelf(tmp_path / "templates")
    gear = (shelf / "gear-1.toml").read_text(encoding="utf-8")
    unused = '[[text.place]]\nen = "above"\nzh = "上"\n\n[parameters]'
    (shelf / "gear-1.toml").write_text(gear.replace("[parameters]", unused), encoding="utf-8")
    assert faults(shelf, 'family = "gear"') == [
        ": gear-1.toml: text.place: stands in no statement: write {{ place }} there"
    ]
    assert len(blueprint(shelf, 'family = "crank"').slots) == 1
    assert len(blueprint(shelf, 'family = "gear"\nwithout = ["gear-1"]').slots) == 1


NAMES = "abcd"
WISHES = st.dictionaries(
    st.sampled_from(["q1", "q2", "q3", "q4"]),
    st.permutations(NAMES).flatmap(
        lambda order: st.integers(0, 4).map(lambda count: order[:count])
    ),
    max_size=4,
)


@given(WISHES)
def test_as_many_slots_as_possible_are_served_each_with_a_wish_of_its_own(
    wanted: dict[str, list[str]],
) -> None:
    chosen = match_slots(wanted)
    assert [(slot, name) for slot, name in chosen.items() if name not in wanted[slot]] == []
    assert len(set(chosen.values())) == len(chosen)
    best = max(
        sum(name in wanted[slot] for slot, name in zip(wanted, order, strict=False))
        for order in permutations(NAMES)
    )
    assert len(chosen) == best
