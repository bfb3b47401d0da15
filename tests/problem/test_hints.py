"""The `[figure]` table: what an author may write, and what is said about a fault."""

from __future__ import annotations

import tomllib

import pytest

from kinegrade.errors import TemplateError
from kinegrade.problem.hints import (
    Angle,
    FigureHints,
    Length,
    Moving,
    Radius,
    Rimmed,
    Turning,
    read_hints,
)

POINTS, BODIES = {"O", "A", "B"}, {"OA", "AB"}


def read(text: str) -> FigureHints:
    return read_hints(tomllib.loads(text), "crank.toml", POINTS, BODIES)


def faults(text: str) -> tuple[str, ...]:
    with pytest.raises(TemplateError) as caught:
        read(text)
    return caught.value.problems


def test_a_full_table_reads_as_written() -> None:
    hints = read(r"""
        lengths = [
            { symbol = "r", from = "O", to = "A" },
            { symbol = "h", from = "A", to = "B", along = "vertical" },
        ]
        angles = [{ symbol = '\varphi', at = "O", from = "right", to = "A", sense = "ccw" }]
        radii = [{ symbol = "r_1", centre = "O", of = "ground", through = "B" }]
        circles = [{ body = "OA", centre = "O", through = "B" }]
        lines = [["O", "B"]]
        arrows = [
            { symbol = '\omega', turns = "OA", sense = "cw" },
            { symbol = "v_B", moves = "B", along = "left" },
        ]
        labels = { A = "A_1", B = false, OA = "1" }
        shapes = { AB = "bent" }
        axes = true
    """)
    assert hints.lengths == (Length("r", "O", "A"), Length("h", "A", "B", "vertical"))
    assert hints.angles == (Angle("\\varphi", "O", "right", "A", "ccw"),)
    assert hints.radii == (Radius("r_1", "O", "ground", "B"),)
    assert hints.circles == (Rimmed("OA", "O", "B"),)
    assert hints.lines == (("O", "B"),)
    assert hints.arrows == (Turning("\\omega", "OA", "cw"), Moving("v_B", "B", "left"))
    assert dict(hints.labels) == {"A": "A_1", "B": None, "OA": "1"}
    assert dict(hints.shapes) == {"AB": "bent"}
    assert hints.axes


def test_no_table_no_marks() -> None:
    assert read("") == FigureHints()


def test_all_faults_come_at_once() -> None:
    assert faults("""
        lengths = [{ symbol = "r", from = "O", to = "C" }]
        angles = "none"
        shapes = { AB = "geer" }
        axis = true
    """) == (
        "crank.toml: figure.lengths[1].to: no point 'C'; known here: A, B, O",
        'crank.toml: figure.angles: expected a list of tables; write [{ symbol = "r", ... }]',
        "crank.toml: figure.shapes.AB: no shape 'geer'; "
        'did you mean "gear"? (known here: bar, bent, cam, gear, through)',
        'crank.toml: figure.axis: unknown entry; did you mean "axes"?',
    )


@pytest.mark.parametrize(
    ("text", "fragment"),
    [
        ("axes = 1", "figure.axes: expected true or false"),
        ("labels = []", "figure.labels: expected a table of names and values"),
        ("labels = { Q = 'x' }", "figure.labels.Q: nothing has this name"),
        ("labels = { A = 3 }", "figure.labels.A: not a symbol"),
        (
            "radii = [{ symbol = 'r', center = 'O' }]",
            "figure.radii[1]: unknown entry 'center'; did you mean \"centre\"?",
        ),
        (
            "radii = [{ symbol = 'r' }]",
            "figure.radii[1]: 'centre' is missing; needed here: symbol, centre",
        ),
        (
            "radii = [{ symbol = 'r', centre = 'O', through = 'Q' }]",
            "figure.radii[1].through: no point 'Q'",
        ),
        (
            "circles = [{ body = 'O', centre = 'O', through = 'A' }]",
            "figure.circles[1].body: no body 'O'",
        ),
        ("circles = [{ body = 'OA', centre = 'O' }]", "figure.circles[1]: 'through' is missing"),
        (
            "circles = [{ body = 'OA', centre = 'O', through = 'O' }]",
            "figure.circles[1]: a circle about 'O' through itself; name another point for "
            "'through'",
        ),
        ("lines = ['O', 'B']", 'figure.lines[1]: expected two points; write lines = [["O", "B"]]'),
        ("lines = [['O', 'O']]", "figure.lines[1]: expected two points"),
        ("lines = 'OB'", "figure.lines[1]: expected two points"),
        ("lines = [['O', 'A'], ['O', 'Q']]", "figure.lines[2]: no point 'Q'"),
        ("arrows = [{ symbol = 'r', turns = 'O' }]", "figure.arrows[1].turns: no body 'O'"),
        (
            "arrows = [{ symbol = 'r', turns = 'OA', sense = 'up' }]",
            "figure.arrows[1].sense: no choice 'up'",
        ),
        (
            "arrows = [{ symbol = 'v', moves = 'A', along = 'norht' }]",
            "figure.arrows[1].along: no point or side 'norht'",
        ),
        (
            "lengths = [{ symbol = '#read', from = 'O', to = 'A' }]",
            "has characters no symbol needs",
        ),
        (
            r"lengths = [{ symbol = '\inptu', from = 'O', to = 'A' }]",
            r"unknown LaTeX command \inptu",
        ),
        ("lengths = [{ symbol = 'r_', from = 'O', to = 'A' }]", "is incomplete"),
    ],
)
def test_a_fault_is_named_with_its_place(text: str, fragment: str) -> None:
    assert any(fragment in fault for fault in faults(text))
