"""`check` tells givens that have changed places in the statement, and answers printed there."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.claims import find_false_claims
from kinegrade.proof.claims.swaps import note_printed_answers
from tests.problem.turning_crank import CRANK
from tests.said import all_said


def crank(said: str, *givens: tuple[str, str]) -> Template:
    """The crank with more tooth counts, by names and what they mean, and words about them."""
    added = "".join(
        f'\n{name} = {{ unit = "1", draw = [20], means = {{ en = "{means}", zh = "{means}" }} }}'
        for name, means in givens
    )
    text = CRANK.replace("[parameters]", f"[parameters]{added}")
    text = text.replace('en = "{{ r }} ', f"en = '''{said}. {{{{ r }}}} ")
    return read_template("crank", text.replace('{{ omega }}", zh', "{{ omega }}''', zh", 1))


@pytest.mark.parametrize(
    ("said", "means"),
    [
        ("gear 2, with {{ %s }} teeth, and gear 3, with {{ %s }}", "teeth of gear %s"),
        ("Rad $2$ hat {{ %s.value }}, Rad $3$ {{ %s.value }} Zähne", "Zähne von Rad %s"),
        ("大轮 $2$（齿数 {{ %s.value }}）与小轮 $3$（齿数 {{ %s.value }}）", "轮 %s 的齿数"),
    ],
)
def test_two_givens_that_have_changed_places_are_a_fault(said: str, means: str) -> None:
    def find(*names: str) -> list[str]:
        template = crank(said % names, ("k", means % 2), ("l", means % 3))
        return all_said(find_false_claims(template, [solve_template(template, {}, ())]))

    assert find("k", "l") == []
    assert find("l", "k") == [
        "statement: l stands where the words mean k, and k where they mean l: exchange the two"
    ]


def test_givens_of_several_parts_that_have_changed_places_are_a_fault() -> None:
    def find(*names: str) -> list[str]:
        one, other = (f"{{{{ {name} }}}}" for name in names)
        said = f"the module of gears 1 and 2 is {one}, that of gears 3 and 4 is {other}"
        template = crank(said, ("k", "module of gears 1 and 2"), ("l", "module of gears 3 and 4"))
        return all_said(find_false_claims(template, [solve_template(template, {}, ())]))

    assert find("k", "l") == []
    assert find("l", "k") == [
        "statement: l stands where the words mean k, and k where they mean l: exchange the two"
    ]


def test_givens_of_parts_that_are_not_named_have_no_places() -> None:
    template = crank("a gear of {{ l }} and one of {{ k }}", ("k", "gear 2"), ("l", "gear 3"))
    assert all_said(find_false_claims(template, [solve_template(template, {}, ())])) == []


@pytest.mark.parametrize(
    ("number", "noted"),
    [(r"$2\,\mathrm{m/s}$", True), ("2 m/s", True), ("2.0 m/s", True), ("9.81 m/s", False)],
)
def test_an_answer_of_the_source_as_text_is_noted(number: str, noted: bool) -> None:
    template = crank(f"It moves at {number}")
    speed = solve_template(template, {}, ("v_A",))["v_A"]
    assert speed.value == 2
    remarks = all_said(note_printed_answers(template, ("v_A",)))
    assert [each.split(":")[0].split("text, ")[1] for each in remarks] == [
        "the answer of v_A at the source's values"
    ] * noted
