"""A statement prints its parameters and its texts in both languages, and can do nothing else."""

from __future__ import annotations

import pytest

from kinegrade.errors import TemplateError
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import write_statement
from kinegrade.problem.statement_faults import check_statements, find_statement_faults
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.problem.crank import crank

ENGLISH = "en = '''The crank {{ r }} turns with {{ omega }}; $A$ is {{ h.value }} above $O$.'''"

ALLOWED = (
    "only {{ name }}, {{ name.value }}, {{ name.size }}, {{ BODY.turning }} and {{ POINT.moving }} "
    "are filled in"
)


def printed(**values: str) -> str:
    template = crank()
    return write_statement(template, solve_template(template, values).parameters, "en")


def faults(english: str) -> tuple[str, ...]:
    with pytest.raises(TemplateError) as caught:
        crank((ENGLISH, f"en = '''{english} {{{{ r }}}} {{{{ omega }}}} {{{{ h }}}}'''"))
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
    assert expected in write_statement(
        template, solve_template(template, {"phi": value}).parameters, "en"
    )


def test_the_languages_carry_the_same_numbers() -> None:
    template = crank()
    parameters = solve_template(template, {"r": "0.25", "h": "1/8"}).parameters
    for language in ("en", "zh"):
        text = write_statement(template, parameters, language)
        assert r"$r = 0.25\,\unit{m}$" in text
        assert r"$0.125\,\unit{m}$" in text
    assert text.startswith("曲柄")


@pytest.mark.parametrize("name", find_template_names())
def test_shipped_statements_are_sound(name: str) -> None:
    assert find_statement_faults(load_template(name)) == []


NOT_FILLED_IN = [
    "{% for x in r %}{% endfor %}",
    "{% include 'secret' %}",
    "{% set x = 1 %}",
    "{# a remark #}",
    "{{ 7*7 }}",
    "{{ r | upper }}",
    "{{ r.value() }}",
    "{{ r['value'] }}",
    "{{ 9**9**9**9 }}",
    "{{ 'x'*3000000000 }}",
    "{{ r.__class__ }}",
    "{{ r.symbol }}",
    "{{ r.value.upper }}",
    "{{ }}",
    "{{ " + "(" * 5000,
    "{{ r",
]


@pytest.mark.parametrize("text", NOT_FILLED_IN)
def test_what_is_no_name_is_refused_when_the_template_is_read_in_one_line(text: str) -> None:
    (problem, *_) = found = faults(text)
    assert problem.startswith("crank.toml:10: statement.en: {")
    assert problem.endswith(f" - {ALLOWED}")
    assert [problem for problem in found if not ("\n" not in problem and len(problem) < 180)] == []


def test_a_passage_that_is_no_name_is_refused_in_a_text_as_well() -> None:
    wording = "[[text.speed]]\nen = '{{ 7*7 }}'\nzh = '{{ speed }}'\n\n[parameters]"
    with pytest.raises(TemplateError) as caught:
        crank(
            ("[parameters]", wording),
            ("{{ omega }};", "{{ speed }} {{ speed.value }} {{ omega }};"),
        )
    assert caught.value.problems == (
        "crank.toml:10: statement.en: {{ speed.value }}: a text has no value - write {{ speed }}",
        f"crank.toml:14: text.speed[1].en: {{{{ 7*7 }}}} - {ALLOWED}",
        "crank.toml:15: text.speed[1].zh: {{ speed }}: no such parameter - known here: h, omega, r",
    )


def test_all_faults_of_both_languages_come_at_once() -> None:
    with pytest.raises(TemplateError) as caught:
        crank((ENGLISH, "en = '''{{ R }} {{ r }} {{ self }}'''"), ("{{ h.value }}。", "{{ H }}。"))
    assert caught.value.problems == (
        'crank.toml:10: statement.en: {{ R }}: no such parameter - did you mean "r"? '
        "(known here: h, omega, r)",
        "crank.toml:10: statement.en: {{ self }}: no such parameter - known here: h, omega, r",
        'crank.toml:11: statement.zh: {{ H }}: no such parameter - did you mean "h"? '
        "(known here: h, omega, r)",
    )


def test_a_parameter_that_a_student_is_not_given_is_reported_for_each_language() -> None:
    template = crank((ENGLISH, "en = '''{{ r }}'''"), ("{{ h.value }}。", "。"))
    with pytest.raises(TemplateError) as caught:
        check_statements(template)
    assert caught.value.problems == (
        "crank.toml: statement.en: the parameter h is not given to the student: write {{ h }}",
        "crank.toml: statement.en: the parameter omega is not given to the student: write {{ omega "
        "}}",
        "crank.toml: statement.zh: the parameter h is not given to the student: write {{ h }}",
    )


def test_braces_of_latex_are_text() -> None:
    template = crank(("The crank", r"$\frac{a}{b_{c}}$ the crank"))
    parameters = solve_template(template, {"h": "1/2"}).parameters
    assert write_statement(template, parameters, "en").startswith(r"$\frac{a}{b_{c}}$ the crank $r")


def test_a_statement_that_would_fill_a_book_is_refused_instead_of_typeset() -> None:
    template = crank(("The crank", "The crank {{ r }}" * 1500))
    parameters = solve_template(template, {"h": "1/2"}).parameters
    with pytest.raises(TemplateError, match=r"characters once it is filled in: at most 20000 are"):
        write_statement(template, parameters, "en")
