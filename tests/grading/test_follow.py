"""Follow-through: the key first, an error charged once, and nothing for nothing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.keys import Key
from kinegrade.grading.judging.decision import Decision, decide
from kinegrade.grading.judging.follow import Decided, Follows, follow_answers
from kinegrade.grading.judging.judge import Verdict
from kinegrade.grading.policy.policy import Ruling, Void
from kinegrade.grading.typed.answers import read
from kinegrade.numbers.tolerance import ONE_PER_CENT
from kinegrade.stated_marking import StatedTolerance
from tests.grading.policies import policy_of
from tests.said import said

ASKS = {"omega_AB": "rad/s", "alpha_AB": "rad/s^2", "a_B": "m/s^2", "phi": "deg"}
KEYS = {"omega_AB": Fraction(2), "alpha_AB": Fraction(8), "a_B": Fraction(24), "phi": Fraction(350)}
NOTHING: Mapping[str, Fraction] = {}
AS_PRINTED = Ruling()


def consequence(
    student: str, question: str, own: Mapping[str, Fraction], later: str
) -> tuple[Fraction, ...]:
    """alpha = 2 omega^2, a_B = omega^2 + alpha + 12, phi = 175 omega: as long as they have
    something to follow from.
    """
    omega, alpha = own.get("omega_AB"), own.get("alpha_AB")
    if later == "a_B" and (omega or alpha):
        return ((omega or 2) ** 2 + (alpha or 2 * (omega or 2) ** 2) + 12,)
    if omega is None or later not in ("alpha_AB", "phi"):
        return ()
    return (2 * omega**2 if later == "alpha_AB" else 175 * omega,)


follows = Follows(consequence)


def decided(
    typed: Mapping[str, str],
    ruling: Ruling = AS_PRINTED,
    mistakes: Mapping[str, Fraction] = NOTHING,
) -> list[Decided]:
    """The answers in the order of ASKS, as they are decided without follow-through."""
    found = []
    for name, unit in ASKS.items():
        key = Key(KEYS[name], ONE_PER_CENT, Fraction(360) if name == "phi" else None, mistakes)
        reading = read(typed.get(name, ""), unit)
        found.append(
            Decided(
                Ask("q1", name, unit, Fraction(3)),
                reading,
                key,
                ruling,
                decide(reading, key, ruling, (), lambda text, unit=unit: read(text, unit)),
            )
        )
    return found


def followed(ruling: Ruling = AS_PRINTED, **typed: str) -> dict[str, Decision]:
    return follow_answers("007", decided(typed, ruling), follows)


def test_nothing_follows_in_a_question_of_which_one_answer_is_absurd() -> None:
    """omega_AB = 3.1 leads to 19.22, and that to 40.83; 1 is no angle beside 350."""
    sensible = {"omega_AB": "3.1", "alpha_AB": "19.2", "a_B": "40.8"}
    assert set(followed(**sensible)) == {"alpha_AB", "a_B"}
    assert followed(**sensible, phi="1") == {}
    assert set(followed(**sensible, phi="0")) == {"alpha_AB", "a_B"}


def test_an_answer_that_follows_from_the_own_earlier_one_gets_all_points_and_a_reason() -> None:
    found = followed(omega_AB="3.1", alpha_AB="19.3")
    assert list(found) == ["alpha_AB"]
    verdict, share = found["alpha_AB"]
    assert (verdict.kind, share) == ("follow-through", 1)
    assert said(verdict.reason) == (
        "follows from the student's q1.omega_AB = 3.1: 19.22, difference 0.08, allowed 0.1922"
    )


@pytest.mark.parametrize(
    ("typed", "kinds"),
    [
        ("19.4122", ["alpha_AB"]),
        ("19.0278", ["alpha_AB"]),
        ("19.4123", []),
        ("19.0277", []),
        ("-19.22", []),
        ("19.22 rad/s^2", ["alpha_AB"]),
        ("19.22 m", []),
        ("abc", []),
        ("", []),
        ("1922/100", ["alpha_AB"]),
    ],
)
def test_it_is_held_against_what_follows_by_the_rule_of_its_ask(
    typed: str, kinds: list[str]
) -> None:
    assert list(followed(omega_AB="3.1", alpha_AB=typed)) == kinds


def test_the_key_is_tried_first() -> None:
    assert followed(omega_AB="3", alpha_AB="8", a_B="24") == {}
    # Right, and so no follow-through from it
    assert followed(omega_AB="2.01", alpha_AB="8.2") == {}


@pytest.mark.parametrize("omega", ["", "abc", "3 m", "0", "-0", "121", "0.099", "1e40"])
def test_nothing_follows_from_what_is_missing_zero_or_beyond_any_sense(omega: str) -> None:
    seen: list[str] = []

    def asked(
        student: str, question: str, own: Mapping[str, Fraction], later: str
    ) -> tuple[Fraction]:
        seen.append(later)
        return (Fraction(5),)

    assert (
        follow_answers("007", decided({"omega_AB": omega, "alpha_AB": "5"}), Follows(asked)) == {}
    )
    assert seen == []


def test_an_answer_follows_from_those_before_it_only() -> None:
    assert followed(alpha_AB="18", omega_AB="") == {}
    backwards = list(reversed(decided({"omega_AB": "3", "alpha_AB": "18"})))
    assert follow_answers("007", backwards, follows) == {}
    in_plan_order = Follows(consequence, lambda question, asks: [[ask] for ask in ASKS])
    assert list(follow_answers("007", backwards, in_plan_order)) == ["alpha_AB"]


def test_an_error_is_charged_once_however_far_it_goes() -> None:
    found = followed(omega_AB="3", alpha_AB="18", a_B="39")
    assert {ask: said(verdict.reason) for ask, (verdict, _) in found.items()} == {
        "alpha_AB": "follows from the student's q1.omega_AB = 3: 18, difference 0, allowed 0.18",
        # As alpha_AB does
        "a_B": "follows from the student's q1.omega_AB = 3: 39, difference 0, allowed 0.39",
    }


def test_a_new_error_is_charged_and_followed_too() -> None:
    found = followed(omega_AB="3", alpha_AB="20", a_B="41")
    assert {ask: said(verdict.reason) for ask, (verdict, _) in found.items()} == {
        "a_B": "follows from the student's q1.omega_AB = 3 and q1.alpha_AB = 20: 41, difference 0, "
        "allowed 0.41"
    }


def test_somebody_may_go_on_from_one_own_answer_and_not_from_the_other() -> None:
    found = followed(omega_AB="3", alpha_AB="20", a_B="36")  # 2^2 + 20 + 12
    assert (
        said(found["a_B"][0].reason)
        == "follows from the student's q1.alpha_AB = 20: 36, difference 0, allowed 0.36"
    )
    found = followed(omega_AB="3", alpha_AB="20", phi="525")
    assert (
        said(found["phi"][0].reason)
        == "follows from the student's q1.omega_AB = 3: 525, difference 0, allowed 5.25"
    )


def test_a_right_answer_in_between_stays_right() -> None:
    # with phi = 10 omega + alpha, where alpha would follow from omega: but this student has alpha
    # right
    def by_both(
        student: str, question: str, own: Mapping[str, Fraction], later: str
    ) -> tuple[Fraction, ...]:
        omega = own.get("omega_AB", Fraction(2))
        value = 10 * omega + own.get("alpha_AB", 2 * omega**2)
        return (value,) if later == "phi" and {"omega_AB", "alpha_AB"} & own.keys() else ()

    found = follow_answers(
        "007", decided({"omega_AB": "3", "alpha_AB": "7.99", "phi": "37.99"}), Follows(by_both)
    )
    assert said(found["phi"][0].reason) == (
        "follows from the student's q1.omega_AB = 3 and q1.alpha_AB = 7.99: 37.99, "
        "difference 0, allowed 0.3799"
    )
    assert (
        follow_answers(
            "007", decided({"a_B": "9", "alpha_AB": "7.95", "phi": "27.95"}), Follows(by_both)
        )
        == {}
    )


def test_angles_follow_with_any_number_of_turns() -> None:
    assert list(followed(omega_AB="3", phi="165")) == ["phi"]


def test_a_credit_of_the_policy() -> None:
    half, none = Ruling(follow_through=Fraction(1, 2)), Ruling(follow_through=Fraction(0))
    assert followed(half, omega_AB="3", alpha_AB="18")["alpha_AB"][1] == Fraction(1, 2)
    assert followed(none, omega_AB="3", alpha_AB="18") == {}


def test_the_best_credit_counts() -> None:
    mistakes = {"coriolis-halved": Fraction(18)}
    for share, kinds in (("1/2", ["alpha_AB"]), ("3/4", [])):
        ruling = Ruling(
            follow_through=Fraction(2, 3), mistakes={"coriolis-halved": Fraction(share)}
        )
        answers = decided({"omega_AB": "3", "alpha_AB": "18"}, ruling, mistakes)
        assert answers[1].decision[0].kind == "mistake"
        assert list(follow_answers("007", answers, follows)) == kinds


def test_a_tolerance_of_the_policy_holds_for_what_follows_too() -> None:
    wide = Ruling(room=StatedTolerance(relative=Fraction(1, 10)))
    assert list(followed(wide, omega_AB="3", alpha_AB="19.7")) == ["alpha_AB"]
    # Omega is right now, and what follows does not count
    assert followed(wide, omega_AB="2.2", alpha_AB="9.68") == {}


def test_a_void_answer_stays_as_it_is() -> None:
    answers = decided({"omega_AB": "3", "alpha_AB": "18"})
    void = Decided(
        answers[1].ask,
        answers[1].reading,
        answers[1].key,
        answers[1].ruling,
        (Verdict("void", ""), Fraction(0)),
    )
    assert follow_answers("007", [answers[0], void], follows) == {}


@pytest.mark.parametrize(
    ("text", "shares"),
    [
        ("", ("1", "1", "1")),
        ("credit.follow-through = '50 %'", ("1/2", "1/2", "1/2")),
        ("credit.follow-through = 0", ("0", "0", "0")),
        (
            "credit.follow-through = 0.5\n[questions.q1]\ncredit.follow-through = "
            "'1/4'\n[questions.q1.asks.v_B]\n"
            "credit = { follow-through = 1 }",
            ("1", "1/4", "1/2"),
        ),
        ("[questions.q1]\ncredit = { follow-through = 0, wrong-unit = 1 }", ("0", "0", "1")),
    ],
)
def test_what_stands_nearer_to_the_ask_goes_first(
    tmp_path: Path, text: str, shares: tuple[str, ...]
) -> None:
    policy = policy_of(text, tmp_path)
    found = [policy.ruling(column).follow_through for column in ("q1.v_B", "q1.omega_AB", "q2.phi")]
    assert found == [Fraction(share) for share in shares]


def test_no_credit_for_going_on_from_next_to_nothing() -> None:
    # a_B = omega^2 + alpha + 12: with omega gone and alpha right, 20 is a forgotten omega^2, or one
    # of 0.02^2
    assert followed(omega_AB="0.12", alpha_AB="8", a_B="20") == {}
    assert list(followed(omega_AB="3", alpha_AB="8", a_B="29")) == ["a_B"]
    # In proportion to it: nothing is forgotten
    assert list(followed(omega_AB="0.12", phi="21")) == ["phi"]


def test_answers_of_one_stage_follow_from_each_other_and_one_is_charged() -> None:
    def each_other(
        student: str, question: str, own: Mapping[str, Fraction], later: str
    ) -> tuple[Fraction, ...]:
        if later == "alpha_AB" and "omega_AB" in own:
            return (4 * own["omega_AB"], 5 * own["omega_AB"])
        if later == "omega_AB" and "alpha_AB" in own:
            return (own["alpha_AB"] / 4, own["alpha_AB"] / 5)
        return ()

    together = Follows(each_other, lambda question, asks: [asks])
    for alpha in ("12", "15"):  # by either way of going on
        found = follow_answers("007", decided({"omega_AB": "3", "alpha_AB": alpha}), together)
        assert list(found) == ["alpha_AB"]  # of as many points: the first is charged
    assert follow_answers("007", decided({"omega_AB": "3", "alpha_AB": "13"}), together) == {}
    # What is right is no basis, wherever it stands
    assert follow_answers("007", decided({"omega_AB": "3", "alpha_AB": "8"}), together) == {}


def test_no_credit_for_the_same_number_twice() -> None:
    def the_same(
        student: str, question: str, own: Mapping[str, Fraction], later: str
    ) -> tuple[Fraction, ...]:
        return (own["omega_AB"],) if "omega_AB" in own else ()

    assert follow_answers("007", decided({"omega_AB": "7", "a_B": "7"}), Follows(the_same)) == {}
    assert list(
        follow_answers("007", decided({"omega_AB": "7", "a_B": "7.01"}), Follows(the_same))
    ) == ["a_B"]
    # Where the right numbers are one, so are the student's
    answers = decided({"omega_AB": "7", "a_B": "7"})
    equal = [replace(answer, key=answers[0].key) for answer in answers]
    assert list(follow_answers("007", equal, Follows(the_same))) == ["a_B"]


def test_a_slip_of_sign_alone_is_no_copy_where_the_same_number_follows_from_it() -> None:
    def opposite(
        student: str, question: str, own: Mapping[str, Fraction], later: str
    ) -> tuple[Fraction, ...]:
        return (-own["omega_AB"],) if "omega_AB" in own else ()

    found = follow_answers("007", decided({"omega_AB": "-2", "a_B": "2"}), Follows(opposite))
    assert list(found) == ["a_B"]
    assert follow_answers("007", decided({"omega_AB": "-3", "a_B": "3"}), Follows(opposite)) == {}


HALF = Ruling(follow_through=Fraction(1, 2))


@pytest.mark.parametrize(
    ("void", "share", "credit"),
    [(None, "1", 1), (None, "1/2", "1/2"), ("drop", "0", 1), ("full", "0", 1)],
)
def test_what_follows_from_an_answer_with_full_credit_has_it_too(
    void: Void | None, share: str, credit: str
) -> None:
    answers = decided({"omega_AB": "3", "alpha_AB": "18", "a_B": "39"}, HALF)
    accepted = Verdict("accepted", ""), Fraction(share)
    answers[0] = replace(answers[0], ruling=replace(HALF, void=void), decision=accepted)
    found = follow_answers("007", answers, follows)
    assert {name: each[1] for name, each in found.items()} == {
        "alpha_AB": Fraction(credit),
        "a_B": Fraction(credit),
    }


def test_what_follows_from_a_charged_answer_as_well_has_the_credit_for_follow_through() -> None:
    answers = decided({"omega_AB": "3", "alpha_AB": "20", "a_B": "41"}, HALF)
    answers[0] = replace(answers[0], decision=(Verdict("accepted", ""), Fraction(1)))
    ((name, (_, share)),) = follow_answers("007", answers, follows).items()
    assert (name, share) == ("a_B", Fraction(1, 2))
