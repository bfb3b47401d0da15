"""A question derived again is the one that was set, or it is refused: nothing contradicts the key."""

from __future__ import annotations

import re
from collections.abc import Callable
from decimal import Decimal
from math import inf, nextafter
from typing import Any

import msgspec
import pytest
from msgspec.structs import replace

from kinegrade.errors import ExamError
from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.bank.blueprint import Bank, BankQuestion
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.folder.key.lines import KeyQuestion, StatedTolerance
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.exam.setting.derivation import derive_question
from kinegrade.exam.setting.key_record import make_key_question
from kinegrade.exam.setting.setting import SetQuestion
from kinegrade.expressions.reading import read_expression
from tests.problem.draws import draw_filter
from tests.small_class import write_class

REMEDY = (
    "expected both to agree - restore the exam folder as it was generated, or use the version "
    "of kinegrade that made it"
)

WHERE = 'key.jsonl: student "007", q1'
Change = Callable[[KeyQuestion], KeyQuestion]


@pytest.fixture(scope="module")
def bank(tmp_path_factory: pytest.TempPathFactory) -> Bank:
    return read_bank(write_class(tmp_path_factory.mktemp("class")) / "bank.toml")


@pytest.fixture(scope="module")
def kept(bank: Bank, tmp_path_factory: pytest.TempPathFactory) -> tuple[KeyQuestion, ...]:
    """The questions of the first paper as a folder keeps them."""
    folder = write_class(tmp_path_factory.mktemp("roster"))
    setting = deal_exam(bank, Roster.read(folder / "roster.csv", odd_ids=True), FromWords("spring"))
    paper = next(iter(setting.papers()))
    return tuple(make_key_question(question, {}) for question in paper.questions)


def earlier(question: KeyQuestion) -> KeyQuestion:
    """The question as folders of format 1 keep it, without the values as they were drawn."""
    return msgspec.structs.replace(question, drawn={})


def changed_ask(**fields: Any) -> Change:
    def change(question: KeyQuestion) -> KeyQuestion:
        ask = msgspec.structs.replace(question.asks["v_B"], **fields)
        return msgspec.structs.replace(question, asks={**question.asks, "v_B": ask})

    return change


def changed_parameter(**fields: Any) -> Change:
    def change(question: KeyQuestion) -> KeyQuestion:
        parameter = msgspec.structs.replace(question.parameters["r"], **fields)
        parameters = {**question.parameters, "r": parameter}
        return msgspec.structs.replace(question, parameters=parameters)

    return change


def without(part: str, name: str) -> Change:
    def change(question: KeyQuestion) -> KeyQuestion:
        left = {each: value for each, value in getattr(question, part).items() if each != name}
        return msgspec.structs.replace(question, **{part: left})

    return change


def derive(question: BankQuestion, kept: KeyQuestion) -> SetQuestion:
    """The question by its key, where terms cancel by the roundings of four figures."""
    return derive_question(
        question, kept, WHERE, draw_filter(question.template).dealt.find_roundings
    )


@pytest.mark.parametrize("form", [earlier, lambda question: question])
def test_what_is_derived_again_is_the_key(
    bank: Bank, kept: tuple[KeyQuestion, ...], form: Change
) -> None:
    for question, line in zip(bank.questions, kept, strict=True):
        derived = derive(question, form(line))
        assert earlier(make_key_question(derived, {})) == earlier(line)
        assert derived.question is question


@pytest.mark.parametrize(
    "change",
    [
        changed_ask(exact=None),
        changed_ask(exact="sqrt(2)*sqrt(3)"),  # may be printed in many ways: its decimal decides
        changed_ask(decimal=None),
    ],
)
def test_another_way_of_stating_the_same_is_the_same(
    bank: Bank, kept: tuple[KeyQuestion, ...], change: Change
) -> None:
    derived = derive(bank.questions[0], change(kept[0]))
    assert make_key_question(derived, {}) == kept[0]


def test_the_last_digits_of_another_version_do_not_matter(
    bank: Bank, kept: tuple[KeyQuestion, ...]
) -> None:
    ask = kept[0].asks["v_B"]
    assert ask.decimal is not None
    assert ask.value is not None
    neighbour = Decimal(repr(nextafter(float(ask.value), inf)))
    last = int(ask.decimal[-1])
    other_digits = {
        "decimal": ask.decimal[:-1] + str(last - 1 if last else 1),
        "value": neighbour,
    }
    derive(bank.questions[0], changed_ask(**other_digits)(kept[0]))
    with pytest.raises(ExamError, match=r"v_B is .* by the key"):
        derive(bank.questions[0], changed_ask(decimal=ask.decimal[:-6])(kept[0]))


def test_a_value_known_as_a_double_only_decides_as_far_as_doubles_go(
    bank: Bank, kept: tuple[KeyQuestion, ...]
) -> None:
    rounded = changed_parameter(exact=None)(earlier(kept[0]))
    found = derive(bank.questions[0], rounded).drawn.solution["v_B"]
    assert found.value == pytest.approx(float(kept[0].asks["v_B"].value), rel=1e-12)


TOLERANCE = StatedTolerance(Decimal("0.05"), Decimal(0))


@pytest.mark.parametrize(
    ("change", "difference"),
    [
        (changed_ask(decimal="5"), r"v_B is 5 by the key, but \S+ follows from the"),
        (changed_ask(value=Decimal(5)), r"v_B is 5 by the key, but \S+ follows from the"),
        (changed_ask(exact="5/2"), r"v_B is 5/2 by the key, but \S+ follows from the"),
        (changed_ask(decimal="much"), r"v_B is much by the key, but"),
        (changed_ask(unit="mm/s"), "v_B is in mm/s by the key, in m/s by the template"),
        (
            changed_ask(exact=None, decimal=None, value=None),
            "v_B has no value in the key",
        ),
        (
            changed_ask(tolerance=TOLERANCE),
            "v_B: tolerance is relative 0.05, absolute 0 by the key, relative 0.01, absolute 0 by "
            "the bank",
        ),
        (changed_ask(points=Decimal(4)), "v_B: points is 4 by the key, 3 by the bank"),
        (changed_ask(period=Decimal(360)), "v_B: period is 360 by the key, none by the bank"),
        (changed_parameter(value=Decimal(9)), r"r is 9 by the key, but \S+ follows"),
        (changed_parameter(exact="9"), r"r is 9 by the key, but \S+ follows from the"),
        (changed_parameter(unit="mm"), "r is in mm by the key, in m by the template"),
        (without("asks", "v_B"), "the key has the asks a_B, the templates a_B, v_B"),
        (
            without("parameters", "r"),
            "the key has the parameters alpha, k, omega, phi, the templates alpha, k, omega, phi, r",
        ),
    ],
)
def test_a_key_that_says_something_else_is_refused(
    bank: Bank, kept: tuple[KeyQuestion, ...], change: Change, difference: str
) -> None:
    with pytest.raises(ExamError) as caught:
        derive(bank.questions[0], change(kept[0]))
    message = str(caught.value)
    assert re.search(re.escape(f"{WHERE}: ") + difference, message), message
    assert message.endswith(REMEDY)


def test_all_differences_are_said_at_once(bank: Bank, kept: tuple[KeyQuestion, ...]) -> None:
    changed = changed_ask(decimal="5", points=Decimal(4))(kept[0])
    with pytest.raises(ExamError) as caught:
        derive(bank.questions[0], changed)
    assert len(caught.value.problems) == 2


@pytest.mark.parametrize(
    ("values", "reason"),
    [
        ({"r": "rr"}, 'r: unknown name "rr"'),
        ({"r": "1", "q": "2"}, 'no parameter "q"'),
        ({"k": "1/10"}, "slider-crank"),
    ],
)
def test_values_that_give_no_mechanism_are_refused(
    bank: Bank, kept: tuple[KeyQuestion, ...], values: dict[str, str], reason: str
) -> None:
    drawn = {**kept[0].drawn, **values}
    with pytest.raises(ExamError) as caught:
        derive(bank.questions[0], msgspec.structs.replace(kept[0], drawn=drawn))
    message = str(caught.value)
    assert message.startswith(f"{WHERE}: no longer follows (slider-crank: ")
    assert reason in message
    assert message.endswith(REMEDY)


def test_an_answer_at_infinity_is_refused(bank: Bank, kept: tuple[KeyQuestion, ...]) -> None:
    """An edited template may ask for what is nowhere."""
    question = bank.questions[0]
    asks = question.template.asks
    far = replace(asks["v_B"], quantity=read_expression("x(pole(AB))"), unit=asks["v_B"].unit)
    template = replace(question.template, asks={**asks, "v_B": far})
    with pytest.raises(ExamError, match=r"v_B is .* by the key"):
        derive(replace(question, template=template), kept[0])
