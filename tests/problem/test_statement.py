"""A statement prints its parameters in both languages, and can do nothing else."""

from __future__ import annotations

import re

import pytest

from kinegrade.errors import TemplateError
from kinegrade.problem.library import load_template, template_names
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import check_statements, statement
from tests.problem.crank import crank

ENGLISH = "en = '''The crank {{ r }} turns with {{ omega }}; $A$ is {{ h.value }} above $O$.'''"


def printed(**values: str) -> str:
    template = crank()
    return statement(template, solve_template(template, values).parameters, "en")


def faults(english: str) -> tuple[str, ...]:
    with pytest.raises(TemplateError) as caught:
        check_statements(
            crank((ENGLISH, f"en = '''{english} {{{{ r }}}} {{{{ omega }}}} {{{{ h }}}}'''"))
        )
    return caught.value.problems


def test_numbers_are_printed_as_textbooks_print_them() -> None:
    assert printed(r="0.25", omega="sqrt(3)", h="1/8") == (
        r"The crank $r = 0.25\,\unit{m}$ turns with $\omega = \sqrt{3}\,\unit{rad/s}$; "
        r"$A$ is $0.125\,\unit{m}$ above $O$."
    )
    assert r"r = \frac{1}{3}\,\unit{m}" in printed(r="1/3", h="1/4")
    assert r"\omega = -2\,\unit{rad/s}" in printed(omega="-2", h="1/2")


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        ("60", r"\varphi = 60^\circ"),
        ("22.5", r"\varphi = 22.5^\circ"),
        ("pi/3", r"\varphi = 60^\circ"),
    ],
)
def test_degrees_are_printed_as_degrees(value: str, expected: str) -> None:
    template = load_template("slider-crank")
    assert expected in statement(
        template, solve_template(template, {"phi": value}).parameters, "en"
    )


def test_the_languages_carry_the_same_numbers() -> None:
    template = crank()
    parameters = solve_template(template, {"r": "0.25", "h": "1/8"}).parameters
    for language in ("en", "zh"):
        text = statement(template, parameters, language)
        assert r"$r = 0.25\,\unit{m}$" in text
        assert r"$0.125\,\unit{m}$" in text
    assert text.startswith("曲柄")


@pytest.mark.parametrize("name", template_names())
def test_shipped_statements_are_sound(name: str) -> None:
    check_statements(load_template(name))


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("{% for x in r %}{% endfor %}", "For"),
        ("{% include 'secret' %}", "Include"),
        ("{% import 'secret' as s %}", "Import"),
        ("{% set x = 1 %}", "Assign"),
        ("{{ r | upper }}", "Filter"),
        ("{{ r.value() }}", "Call"),
        ("{{ r['value'] }}", "Getitem"),
        ("{{ 9**9**9**9 }}", "Pow"),
        ("{{ 'text' }}", "Const"),
        ("{{ r.__class__ }}", "attribute .__class__"),
        ("{{ r.symbol }}", "attribute .symbol"),
        ("{{ r.value.upper }}", "attribute .upper"),
    ],
)
def test_what_is_no_parameter_is_refused(text: str, fault: str) -> None:
    assert any(
        problem.startswith(f"crank.toml: statement.en: {fault}: only {{{{ parameter }}}} and")
        for problem in faults(text)
    )
    assert all("\n" not in problem for problem in faults(text))


@pytest.mark.parametrize(
    "text", ["{{ r", "{% endfor %}", "{{ }}", "{% nonsense %}", "{{ " + "(" * 5000]
)
def test_broken_braces_are_refused_in_one_line(text: str) -> None:
    (problem,) = faults(text)
    assert problem.startswith("crank.toml: statement.en: ")
    assert problem.endswith("only {{ parameter }} is filled in")
    assert "\n" not in problem


def test_all_faults_of_both_languages_come_at_once() -> None:
    template = crank((ENGLISH, "en = '''{{ R }} {{ r }} {{ self }}'''"), ("{{ h.value }}。", "。"))
    with pytest.raises(TemplateError) as caught:
        check_statements(template)
    assert caught.value.problems == (
        "crank.toml: statement.en: {{ R }}: no such parameter",
        "crank.toml: statement.en: {{ self }}: no such parameter",
        "crank.toml: statement.en: the parameter h is not given to the student: write {{ h }}",
        "crank.toml: statement.en: the parameter omega is not given to the student: write {{ omega }}",
        "crank.toml: statement.zh: the parameter h is not given to the student: write {{ h }}",
    )


@pytest.mark.parametrize("text", ["{{ nobody }}", "{{ r"])
def test_an_unchecked_statement_is_still_refused_when_it_is_printed(text: str) -> None:
    template = crank((ENGLISH, f"en = '''{text}'''"))
    with pytest.raises(TemplateError, match=re.escape("crank.toml: statement.en: ")):
        statement(template, solve_template(template, {"h": "1/2"}).parameters, "en")
