"""A statement may say something else at other values: which wording applies is data, and decided
exactly.
"""

from __future__ import annotations

import pytest

from kinegrade.draws.examining import Refused, solve_sensible
from kinegrade.errors import TemplateError
from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import write_statement
from kinegrade.problem.statement_faults import check_statements, find_statement_faults
from kinegrade.problem.template.template import Template
from kinegrade.proof.checking import check
from tests.problem.crank import crank
from tests.said import all_said

PLACE = """
[[text.place]]
if = "2*h < r"
en = "in the lower half"
zh = "偏下"

[[text.place]]
if = "h == sqrt(3)/2*r"
en = "at 60 degrees, {{ h.value }} up,"
zh = "成 60 度"

[[text.place]]
en = "in the upper half"
zh = "偏上"

[parameters]"""
USED = (
    ("above $O$", "above $O$, {{ place }}"),
    ("{{ h.value }}。", "{{ h.value }}，{{ place }}。"),
)
LAST = '[[text.place]]\nen = "in the upper half"\nzh = "偏上"\n'


def placed(*changes: tuple[str, str]) -> Template:
    return crank(("[parameters]", PLACE), *USED, *changes)


def printed(template: Template, language: Language = "en", **values: str) -> str:
    return write_statement(template, solve_template(template, values).parameters, language)


@pytest.mark.parametrize(
    ("r", "h", "words"),
    [
        ("1", "0.499999999999999999999999", "in the lower half"),
        ("1", "1/2", "in the upper half"),
        ("2", "sqrt(3)", r"at 60 degrees, $\sqrt{3}\,\unit{m}$ up,"),
        ("2", "1.7320508075688772935", "in the upper half"),
    ],
)
def test_the_wording_that_applies_is_decided_exactly(r: str, h: str, words: str) -> None:
    assert f"above $O$, {words}" in printed(placed(), r=r, h=h)


def test_each_language_says_the_same() -> None:
    assert printed(placed(), "zh", r="1", h="0").endswith("，偏下。")
    assert printed(placed(), "zh", r="1", h="3/4").endswith("，偏上。")


def test_values_without_a_wording_are_a_fault_for_the_author_and_are_not_drawn() -> None:
    template = placed((LAST, ""))
    report = check(template, 20)
    assert (
        "text.place: no wording applies at r = 2, h = 3, omega = 1000000: "
        'add one without "if", or a condition that keeps such values out'
    ) in all_said(report.faults)
    with pytest.raises(Refused, match="no text of place applies"):
        solve_sensible(template, {"r": "1", "h": "1/2", "omega": "2"}, ("v_x",), None)
    with pytest.raises(TemplateError, match=r"text\.place: no wording applies at r = 1, h = 1/2"):
        printed(template, r="1", h="1/2")


def test_values_that_a_condition_keeps_out_need_no_wording() -> None:
    condition = ('conditions = ["', 'conditions = ["2*h < r", "')
    assert not [
        fault
        for fault in all_said(check(placed((LAST, ""), condition), 20).faults)
        if "text" in fault
    ]


def test_a_wording_that_never_applies_is_remarked() -> None:
    remarks = all_said(check(placed(), 20).remarks)
    assert "text.place[1] applies at no values that were tried: is it needed?" in remarks


def test_a_text_that_stands_nowhere_is_a_fault() -> None:
    with pytest.raises(
        TemplateError, match=r"text\.place: stands in no statement: write \{\{ place"
    ):
        check_statements(crank(("[parameters]", PLACE)))


def test_a_text_that_one_language_lacks_leaves_no_student_without_it_in_silence() -> None:
    with pytest.raises(TemplateError) as refusal:
        check_statements(placed(("{{ h.value }}，{{ place }}。", "{{ h.value }}。")))
    assert refusal.value.problems == (
        "crank.toml: statement.zh: the text place does not stand in it: write {{ place }}",
    )


def test_a_wording_that_could_never_apply_for_its_units_is_refused_on_reading() -> None:
    with pytest.raises(TemplateError) as refusal:
        placed(('"2*h < r"', '"h < omega"'))
    assert refusal.value.problems == (
        'crank.toml:15: text.place[1].if: "h < omega": a length (m) and an angular velocity (rad/s) '
        "do not go together - check the units",
    )


def test_a_parameter_may_be_given_by_a_text_if_every_wording_gives_it() -> None:
    every = (
        ("{{ h.value }} above $O$", ""),
        ("{{ h.value }}，", ""),
        ("half", "half, {{ h }}"),
        ("成 60 度", "{{ h }}"),
        ("偏", "{{ h }} 偏"),
    )
    template = crank(("[parameters]", PLACE), *USED, *every)
    assert find_statement_faults(template) == []
    with pytest.raises(TemplateError, match="statement.en: the parameter h is not given"):
        check_statements(placed(("{{ h.value }} above $O$", "")))


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        (
            'if = "2*h < r"',
            'if = "2*H < r"',
            '15: text.place[1].if: unknown name "H" - did you mean "h"?',
        ),
        ('if = "2*h < r"', 'if = "h"', '15: text.place[1].if: "h" - expected "left < right"'),
        ('if = "2*h < r"', "if = 1", "15: text.place[1].if: 1 - expected a text in quotation"),
        ('if = "2*h < r"', "", '14: text.place[1]: without "if" it applies at all values'),
        ('if = "2*h < r"', 'when = "h < r"', "15: text.place[1].when: unknown key - did you mean"),
        ('zh = "偏下"', 'ez = "偏下"', "17: text.place[1].ez: unknown key - "),
        (
            "[[text.place]]",
            "[[text.r]]",
            "14: text.r: one name for two things: parameters.r is there too",
        ),
        (
            "[[text.place]]",
            "[[text.'1 x']]",
            "14: text.1 x: not usable as a name - expected letters of A to Z",
        ),
        (PLACE, "[text]\nplace = 'low'\n[parameters]", '14: text.place: "low" - expected a list'),
        (
            PLACE,
            "[text]\nplace = []\n[parameters]",
            "14: text.place: 0 wordings - expected 1 to 20 of them, each under its own [[text.place]]",
        ),
        (
            PLACE,
            "[text]\nplace = [1]\n[parameters]",
            "14: text.place[1]: 1 - expected a table like { if = ",
        ),
        (
            PLACE,
            "[text]\n" + "".join(f"t{n} = []\n" for n in range(21)) + "[parameters]",
            "13: text: 21 texts - expected at most 20",
        ),
    ],
)
def test_a_fault_of_a_text_is_reported_with_its_place(old: str, new: str, fault: str) -> None:
    with pytest.raises(TemplateError) as caught:
        placed((old, new))
    assert [one for one in caught.value.problems if one.startswith(f"crank.toml:{fault}")]
