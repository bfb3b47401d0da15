"""solve and show at the command line: what they print of an instance, which asks, and which settings are refused."""

from __future__ import annotations

import json
from math import radians, sin
from pathlib import Path

import pytest
from pypdf import PdfReader

import kinegrade as api
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.small_class import errors, kinegrade


def sine(degrees: float) -> float:
    return sin(radians(degrees))


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", find_template_names())
@pytest.mark.parametrize("language", ["en", "zh"])
def test_show_tells_parameters_asks_and_the_number_of_instances(name: str, language: str) -> None:
    problem = api.template(name)
    result = kinegrade("show", name, "--lang", language)
    assert result.exit_code == 0
    combinations = {"en": "drawable combinations: ", "zh": "可抽取的组合："}[language]
    assert f"{combinations}{problem.template.combinations}" in result.stdout
    words = result.stdout.split()
    assert set(problem.template.parameters) | set(problem.template.asks) <= set(words)


def test_show_typesets_a_sample(tmp_path: Path) -> None:
    page = tmp_path / "page.pdf"
    assert kinegrade("show", "slider-crank", "-o", page).exit_code == 0
    first = page.read_bytes()
    assert first.startswith(b"%PDF-")
    assert "already exists" in kinegrade("show", "slider-crank", "-o", page).stderr
    assert kinegrade("show", "slider-crank", "-o", page, "--force").exit_code == 0
    assert page.read_bytes() == first
    assert (
        kinegrade("show", "slider-crank", "-o", page, "--force", "--seed", "other").exit_code == 0
    )
    assert page.read_bytes() != first


def test_values_that_mirror_a_mechanism_are_seen_at_the_terminal() -> None:
    """Whoever checks by hand takes another mechanism for a wrong key."""
    name, other = "rolling-wheel-pin-slotted-rocker", "the wheel is to the right of D"
    shown = kinegrade("show", name).stdout
    said = shown[shown.index("words that depend on values") : shown.index("\nparameters")]
    assert [line.split() for line in said.splitlines()[1:3]] == [
        ["side", "v_O", ">", "0", "to", "the", "left"],
        ["side", "otherwise", "to", "the", "right"],
    ]
    mirrored = kinegrade("solve", name, "--set", "v_O=-2").stdout
    assert other in " ".join(mirrored.split())
    assert mirrored.index("The centre O") < mirrored.index("v_rel")
    assert other not in kinegrade("solve", name).stdout
    record = json.loads(kinegrade("solve", name, "--set", "v_O=-2", "--json").stdout)
    assert record["answers"]["v_rel"]["exact"]


def test_solve_prints_the_promised_json() -> None:
    result = kinegrade("solve", "slider-crank", "--set", "r=1/5", "--set", "phi=60", "--json")
    record = json.loads(result.stdout)
    assert list(record) == ["template", "parameters", "answers"]
    assert record["template"] == "slider-crank"
    assert {**record["parameters"]["r"], "decimal": ""} == {
        "exact": "1/5",
        "value": 0.2,
        "unit": "m",
        "decimal": "",
    }
    assert record["parameters"]["k"]["exact"] == "sqrt(3)"
    assert list(record["answers"]) == ["v_B", "omega_AB", "alpha_AB", "a_B"]
    answer = record["answers"]["v_B"]
    assert (answer["exact"], answer["unit"]) == ("2*sqrt(3)/15", "m/s")
    assert answer["value"] == 2 * 3**0.5 / 15


def test_an_enclosure_has_no_exact_text() -> None:
    record = json.loads(
        kinegrade("solve", "slider-crank", "--set", "r=1/5", "--set", "phi=40", "--json").stdout
    )
    assert record["parameters"]["phi"] == {
        "exact": "40",
        "value": 40.0,
        "unit": "deg",
        "decimal": "40",
    }
    assert record["answers"]["v_B"]["exact"] is None
    speed = sine(40) / 5 + sine(80) / (10 * (3 - sine(40) ** 2) ** 0.5)
    assert record["answers"]["v_B"]["value"] == pytest.approx(speed, rel=1e-15)
    assert "(certified enclosure)" in kinegrade("solve", "slider-crank", "--set", "phi=40").stdout


@pytest.mark.parametrize("options", [(), ("--exact",)])
def test_a_long_exact_form_is_printed_on_request(options: tuple[str, ...]) -> None:
    table = kinegrade("solve", "slider-crank", "--set", "phi=45", "--set", "k=7/3", *options).stdout
    exact = next(line.split("  ")[-1].strip() for line in table.splitlines() if "a_B" in line)
    assert ("sqrt" in exact) == bool(options)
    assert exact.endswith(": --exact prints it)") != bool(options)


def test_a_pole_at_infinity_is_shown_in_the_language_of_the_terminal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ask = 'x_P = { quantity = "x(pole(AB))", unit = "m", sign = "+x", means = "where the pole is" }'
    text = load_template("slider-crank").file.text.replace("[asks]", f"[asks]\n{ask}")
    (tmp_path / "pole.toml").write_text(text, encoding="utf-8")
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    solved = kinegrade("solve", str(tmp_path / "pole.toml"), "--set", "phi=90")
    assert [line.split() for line in solved.stdout.splitlines() if line.startswith("x_P")] == [
        ["x_P", "无穷大", "m", "无穷大"]
    ]


def test_a_solution_with_an_answer_at_infinity_is_typeset(tmp_path: Path) -> None:
    ask = 'x_P = { quantity = "x(pole(AB))", unit = "m", points = 1, means = "where it is" }'
    text = load_template("slider-crank").file.text.replace("[asks]", f"[asks]\n{ask}")
    (tmp_path / "pole.toml").write_text(text, encoding="utf-8")
    pdf = tmp_path / "pole.pdf"
    kinegrade("solve", str(tmp_path / "pole.toml"), "--set", "phi=90", "-o", str(pdf))
    assert "∞" in "".join(page.extract_text() for page in PdfReader(pdf).pages)


def test_solve_prints_a_table() -> None:
    lines = kinegrade("solve", "slider-crank", "--set", "alpha=0").stdout.splitlines()
    assert lines[0].split() == ["r", "1", "m", "1"]
    assert ["v_B", "1.154700538", "m/s", "2*sqrt(3)/3"] in [line.split() for line in lines]


ON_REQUEST = "bar-pushing-rolling-disc"


def test_solve_works_out_the_asks_that_are_named_or_all(tmp_path: Path) -> None:
    template = load_template(ON_REQUEST)
    assert set(template.asked()) < set(template.asks)
    texts = {}
    for asked in ((), ("--asks", "all"), ("--asks", " a_B ,v_B, v_B")):
        name = "slider-crank" if "a_B" in str(asked) else ON_REQUEST
        page = tmp_path / f"{len(texts)}.pdf"
        shown = kinegrade("solve", name, *asked, "-o", page, "--json").stdout
        answers = list(json.loads(shown)["answers"])
        texts[asked] = "".join(each.extract_text() for each in PdfReader(page).pages)
        assert answers == (["v_B", "a_B"] if "a_B" in str(asked) else list(template.asks))
    assert len(texts["--asks", "all"]) > len(texts[()])


def test_asks_that_there_are_not_are_refused_with_the_nearest() -> None:
    known = "(known here: a_B, alpha_AB, omega_AB, v_B)"
    assert errors("solve", "slider-crank", "--asks", "v_C,a_B, omega") == [
        f'slider-crank: no ask "v_C": did you mean "v_B"? {known}',
        f'slider-crank: no ask "omega": did you mean "omega_AB"? {known}',
    ]


@pytest.mark.parametrize(
    ("setting", "problem"),
    [
        ("r", '--set "r": expected NAME=VALUE, like r=1/5'),
        ("=3", '--set "=3": expected NAME=VALUE, like r=1/5'),
        ("r=", '--set "r=": expected NAME=VALUE, like r=1/5'),
        ("R=1", 'slider-crank: no parameter "R": did you mean "r"?'),
        (
            "r=1 m",
            'slider-crank: r = 1 m: "1 m", character 3: found "m", expected an operator or the end',
        ),
        ("r=sqrt(-1)", "slider-crank: r: sqrt(...): square root of a negative number"),
        ("r=__import__('os')", "slider-crank: r = __import__('os'): "),
        ("r=9**9**9", "slider-crank: r: a power must be a whole number of at most 16"),
        (
            "r=1e99**16",
            "a value is beyond 1e308, which JSON numbers do not reach: give smaller ones",
        ),
        (
            "k=1/9",
            "slider-crank: points.B: the circle about A of radius 0.1111 does not reach the line y "
            "= 0",
        ),
        ("r=" + "(" * 999, "slider-crank: r = ("),
        ("r=\udcff", "slider-crank: r = "),
    ],
)
def test_a_bad_setting_is_refused_in_one_line(setting: str, problem: str) -> None:
    (line,) = errors("solve", "slider-crank", "--json", "--set", setting)
    assert line.startswith(problem)


def test_all_bad_settings_are_told_at_once() -> None:
    assert errors("solve", "slider-crank", "--set", "r", "--set", "k=1", "--set", "k=2") == [
        '--set "r": expected NAME=VALUE, like r=1/5',
        "--set k: given twice: give it once",
    ]
    assert len(errors("solve", "slider-crank", "--set", "r=x", "--set", "k=y")) == 2
