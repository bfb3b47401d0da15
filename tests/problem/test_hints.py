"""The `[figure]` table: what an author may write, and what is said about a fault."""

from __future__ import annotations

import pytest

from kinegrade.errors import TemplateError
from kinegrade.files.fields.document import toml_table
from kinegrade.problem.template.hints import (
    Angle,
    BodyFrame,
    FigureHints,
    Length,
    Moving,
    Radius,
    Rimmed,
    Turning,
)
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.problem.template.sections.figure import Names, read_figure
from kinegrade.problem.template.sections.opening import TEMPLATE

POINTS, BODIES = {"O", "A", "B"}, {"OA", "AB"}


def read(text: str) -> FigureHints:
    table = toml_table("crank.toml", f"[figure]\n{text}", TEMPLATE)
    hints = read_figure(table, Names(POINTS, BODIES))
    table.faults.require_none()
    return hints


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
            { symbol = "a_B", moves = "B", rate = "acceleration" },
        ]
        labels = { A = "A_1", B = false, OA = "1" }
        shapes = { AB = "bent" }
        supports = { O = "left" }
        axes = "aside"
        frames = [
            { at = "A", to = "B", x = "x_1", y = "y_1" },
            { at = "B", from = "O", to = "up", along = "y", x = "x_2", y = "y_2" },
        ]
    """)
    assert hints.lengths == (Length("r", "O", "A"), Length("h", "A", "B", "vertical"))
    assert hints.angles == (Angle("\\varphi", "O", "right", "A", "ccw"),)
    assert hints.radii == (Radius("r_1", "O", "ground", "B"),)
    assert hints.circles == (Rimmed("OA", "O", "B"),)
    assert hints.lines == (("O", "B"),)
    assert hints.arrows == (
        Turning("\\omega", "OA", "cw"),
        Moving("v_B", "B", "left"),
        Moving("a_B", "B", None, "acceleration"),
    )
    assert dict(hints.labels) == {"A": "A_1", "B": None, "OA": "1"}
    assert dict(hints.shapes) == {"AB": "bent"}
    assert dict(hints.supports) == {"O": "left"}
    assert hints.axes == "aside"
    assert hints.frames == (
        BodyFrame("x_1", "y_1", "A", "A", "B"),
        BodyFrame("x_2", "y_2", "B", "O", "up", "y"),
    )


def test_no_table_no_marks() -> None:
    assert read("") == FigureHints()


def test_all_faults_come_at_once() -> None:
    assert faults("""
        lengths = [{ symbol = "r", from = "O", to = "C" }]
        angles = "none"
        shapes = { AB = "geer" }
        axis = true
    """) == (
        'crank.toml:3: figure.lengths[1].to: no point "C" - known here: A, B, O',
        'crank.toml:4: figure.angles: "none" - expected a list of tables like [{ symbol = "r", ... }]',
        'crank.toml:5: figure.shapes.AB: "geer" - expected gear, cam, bent, bar, bare, through, cylinder, arc, rope, load, jaw, disc, geneva or rack',
        'crank.toml:6: figure.axis: unknown key - did you mean axes = "origin", radii = [{ symbol = "R", centre = "O" }] or lines = [["O", "A"]]? (all of them: kinegrade words figure)',
    )


@pytest.mark.parametrize("shape", ["rope", "load"])
def test_the_ground_is_no_rope(shape: str) -> None:
    text = write_starter_text() + f'shapes = {{ ground = "{shape}" }}\n'
    with pytest.raises(TemplateError) as refused:
        read_template("rocker", text)
    assert str(refused.value).split("figure.shapes.ground: ")[1] == (
        "the ground is drawn as no rope - a fixed rope is a body of its own: a point D of it, "
        '"pin D: ground rope" and "rope translates" among the joints, and rope = "rope" here'
    )


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "supports = { O = 'below', Q = 'up' }",
            [
                "supports.Q: unknown point - known here: A, B, O",
                'supports.O: "below" - expected right, up, left or down',
            ],
        ),
        ("axes = 1", ["axes: 1 - expected origin or aside"]),
        ("labels = []", ["labels: a list - expected a table like { O = 'O_1' }"]),
        (
            "labels = { Q = 'x' }",
            ["labels.Q: unknown point or body - known here: A, AB, B, O, OA, ground"],
        ),
        (
            "labels = { A = 3 }",
            ["labels.A: 3 - expected LaTeX math without dollar signs, like '\\omega_{AB}'"],
        ),
        (
            "radii = [{ symbol = 'r', center = 'O' }]",
            [
                'radii[1].center: unknown key - did you mean "centre"? (known here: centre, of, symbol, through)'
            ],
        ),
        ("radii = [{ symbol = 'r' }]", ["radii[1].centre: missing"]),
        (
            "radii = [{ symbol = 'r', centre = 'O', through = 'Q' }]",
            ['radii[1].through: no point "Q" - known here: A, B, O'],
        ),
        (
            "circles = [{ body = 'O', centre = 'O', through = 'A' }]",
            ['circles[1].body: no body "O" - did you mean "OA"? (known here: AB, OA, ground)'],
        ),
        ("circles = [{ body = 'OA', centre = 'O' }]", ["circles[1].through: missing"]),
        (
            "circles = [{ body = 'OA', centre = 'O', through = 'O' }]",
            ['circles[1].through: a circle about "O" through itself - expected another point'],
        ),
        (
            "lines = ['O', 'B']",
            [
                'lines[1]: "O" - expected two points, like lines = [["O", "B"]]',
                'lines[2]: "B" - expected two points, like lines = [["O", "B"]]',
            ],
        ),
        ("lines = [['O', 'O']]", ['lines[1]: a line from "O" to itself - expected two points']),
        ("lines = 'OB'", ['lines: "OB" - expected a list']),
        ("lines = [['O', 'A'], ['O', 'Q']]", ['lines[2]: no point "Q" - known here: A, B, O']),
        (
            "arrows = [{ symbol = 'r', turns = 'O' }]",
            ['arrows[1].turns: no body "O" - did you mean "OA"? (known here: AB, OA)'],
        ),
        (
            "arrows = [{ symbol = 'r', turns = 'OA', sense = 'up' }]",
            ['arrows[1].sense: "up" - expected ccw or cw'],
        ),
        (
            "arrows = [{ symbol = 'v', moves = 'A', along = 'norht' }]",
            [
                'arrows[1].along: no point or side "norht" - did you mean "right"? (known here: A, B, O, down, left, right, up)'
            ],
        ),
        (
            "arrows = [{ symbol = 'v', turns = 'OA', rate = 'speed' }]",
            ['arrows[1].rate: "speed" - expected velocity or acceleration'],
        ),
        (
            "frames = [{ at = 'Q', to = 'A', x = 'x', y = 'y', along = 'z' }]",
            [
                'frames[1].at: no point "Q" - known here: A, B, O',
                'frames[1].along: "z" - expected x or y',
            ],
        ),
        ("frames = [{ at = 'O', x = 'x', y = 'y' }]", ["frames[1].to: missing"]),
        (
            "lengths = [{ symbol = '#read', from = 'O', to = 'A' }]",
            [
                'lengths[1].symbol: "#read" has characters no symbol needs - use letters, digits, _ ^ { } \' and LaTeX commands'
            ],
        ),
        (
            "lengths = [{ symbol = '\\inptu', from = 'O', to = 'A' }]",
            ['lengths[1].symbol: unknown LaTeX command \\inptu - did you mean "infty"?'],
        ),
        (
            "lengths = [{ symbol = 'r_', from = 'O', to = 'A' }]",
            [
                'lengths[1].symbol: "r_" is incomplete - close every brace, give every _ and ^ one thing'
            ],
        ),
    ],
)
def test_a_fault_is_reported_with_its_place(text: str, expected: list[str]) -> None:
    assert faults(text) == tuple(f"crank.toml:2: figure.{fault}" for fault in expected)


def test_a_right_angle_is_three_points_with_the_corner_in_the_middle() -> None:
    assert read('right_angles = [["O", "A", "B"]]').right_angles == (("O", "A", "B"),)
    expected = (
        "expected three different points with the corner in the middle, "
        'like right_angles = [["C", "D", "E"]]'
    )
    assert faults('right_angles = [["O", "A", "O"], ["O", "A"], ["O", "A", "D"]]') == (
        f"crank.toml:2: figure.right_angles[1]: a list - {expected}",
        f"crank.toml:2: figure.right_angles[2]: a list - {expected}",
        'crank.toml:2: figure.right_angles[3]: no point "D" - known here: A, B, O',
    )
