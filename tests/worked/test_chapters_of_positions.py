"""Chapters of small solutions as a reader sees them: where points are, and in which direction."""

from __future__ import annotations

from tests.worked.chapters import as_read, find_untold, read_chapter, solve_small
from tests.worked.draws import kept
from tests.worked.telling import lines

FOUR_BAR = """
joints = ["pin O: ground OA", "pin A: OA AB", "pin B: AB BC", "pin C: ground BC"]
inputs = []
[points]
O = "(0, 0)"
C = "(8, 0)"
A = "(0, 6)"
B = "meet(circle(A, 6), circle(C, 8), upper)"
M = "midpoint(A, C)"
[bodies]
OA = "O A"
AB = "A B"
BC = "B C"
"""


def test_circles_that_meet() -> None:
    # A triangle of 6, 8 and 10 has its right angle at B
    solution = solve_small(FOUR_BAR, x_B="x(B) in m")
    assert read_chapter("# Positions", solution) == as_read(
        r"""
        Numbers after $\approx$ are rounded, to 4 significant digits (any angles to 2 decimals);
            where they are put in, they count in full.
        $O$ is the origin of the coordinates.
        Coordinates of $C$, $A$:
        x_{C} &= 8\,\unit{m}
        y_{C} &= 0
        x_{A} &= 0
        y_{A} &= 6\,\unit{m}
        $B$ lies on the circle about $A$ of radius $6$ and on the circle about $C$ of radius $8$, on
            the left of the line from $A$ to $C$. The law of cosines in the triangle $ACB$ gives its
            angle at $A$:
        AC &= \sqrt{x_{C}^{2} + y_{A}^{2}} = \sqrt{(8\,\unit{m})^{2} + (6\,\unit{m})^{2}} =
            10\,\unit{m}
        \cos\angle CAB &= \frac{36 + AC^{2} - 64}{2 \cdot 6AC} = \frac{36 + (10\,\unit{m})^{2} -
            64}{2 \cdot 6 \cdot 10\,\unit{m}} = 0.6
        \angle CAB &\approx 53.13^\circ
        From $A$ the point $B$ is seen in the direction of $AC$ turned through this angle
            counter-clockwise:
        \tan\angle(x,\overrightarrow{AC}) &= -\frac{y_{A}}{x_{C}} =
            -\frac{6\,\unit{m}}{8\,\unit{m}} = -0.75
        \angle(x,\overrightarrow{AC}) &\approx -36.87^\circ
        \angle(x,\overrightarrow{AC}) + \angle CAB &= -36.87^\circ + 53.13^\circ \approx 16.26^\circ
        x_{B} &= 6\cos(\angle(x,\overrightarrow{AC}) + \angle CAB) = 6\cos 16.26^\circ =
            5.76\,\unit{m}
        y_{B} &= y_{A} + 6\sin(\angle(x,\overrightarrow{AC}) + \angle CAB) = 6\,\unit{m} + 6\sin
            16.26^\circ = 7.68\,\unit{m}
        """
    )


def test_a_distance_in_centimetres() -> None:
    solution = solve_small(FOUR_BAR, AC="distance(A, C) in cm", OM="distance(O, M) in m")
    assert not find_untold(
        r"""
        AC &= \sqrt{x_{C}^{2} + y_{A}^{2}} = \sqrt{(8\,\unit{m})^{2} + (6\,\unit{m})^{2}} =
            10\,\unit{m} = 1000\,\unit{cm}
        OM &= \sqrt{x_{M}^{2} + y_{M}^{2}} = \sqrt{(4\,\unit{m})^{2} + (3\,\unit{m})^{2}} =
            5\,\unit{m}
        """,
        solution,
    )


def test_an_angle_in_degrees() -> None:
    solution = solve_small(FOUR_BAR, gamma="angle((1, 0), C - A) in deg")
    assert not find_untold(
        r"""
        $\gamma$ is the angle from the $x$ axis to $\overrightarrow{AC}$, positive counter-clockwise.
        \gamma &= \angle(x,\overrightarrow{AC}) \approx -36.87^\circ
        """,
        solution,
    )


def test_an_angle_in_radians() -> None:
    solution = solve_small(FOUR_BAR, gamma="angle((1, 0), A - C) in rad")
    assert not find_untold(
        r"""
        $\gamma$ is the angle from the $x$ axis to $\overrightarrow{CA}$, positive counter-clockwise.
        \tan\gamma &= -\frac{y_{A}}{x_{C}} = -\frac{6\,\unit{m}}{8\,\unit{m}} = -0.75
        The cosine is negative, the sine positive: $\gamma$ lies between $90^\circ$ and
            $180^\circ$.
        \gamma &\approx 143.13^\circ \approx 2.498\,\unit{rad}
        """,
        solution,
    )


def test_a_component_along_a_direction() -> None:
    solution = solve_small(FOUR_BAR, u="along(A - O, C - A) in m")
    assert not find_untold(
        r"""
        The component of $\overrightarrow{OA}$ in the direction of $\overrightarrow{AC}$ is their
            scalar product over the length of the latter:
        AC &= \sqrt{x_{C}^{2} + y_{A}^{2}} = \sqrt{(8\,\unit{m})^{2} + (6\,\unit{m})^{2}} =
            10\,\unit{m}
        u &= -\frac{y_{A}^{2}}{AC} = -\frac{(6\,\unit{m})^{2}}{10\,\unit{m}} = -3.6\,\unit{m}
        """,
        solution,
    )


def test_an_angle_that_a_triangle_has_given_is_not_found_by_coordinates_again() -> None:
    page = list(lines(kept("watt-linkage")))
    (found,) = (line for line in page if line.strip().startswith(r"\psi_{BC} &"))
    assert r"&= \angle(x,\overrightarrow{BD}) + \angle DBC" in found
    assert [line for line in page if "\\tan\\psi_{BC}" in line] == []


TANGENT = """
joints = ["pin C: ground arm", "pin M: ground disc"]
inputs = [{ motion = "arm turns", velocity = "1" }, { motion = "disc turns", velocity = "1" }]
[points]
C = "(0, 0)"
M = "(4, 3)"
T = "polar(C, sqrt(distance(C, M)**2 - l**2), direction(C, M) + asin(l/distance(C, M)))"
[bodies]
arm = "C T"
disc = "M"
"""


def test_a_distance_and_a_direction_are_found_before_they_place_a_point() -> None:
    said = read_chapter("# Positions", solve_small(TANGENT, y="y(T) in m"))
    places = [said.find(part) for part in ("CM &= ", r"\tan\angle", "y_{T} &= ")]
    assert -1 not in places
    assert places == sorted(places)


WATT = """
joints = ["pin O: ground OA", "pin A: OA AB", "pin B: AB CBD", "pin C: ground CBD",
    "pin D: CBD DF", "pin F: DF EF", "pin E: ground EF"]
inputs = [{ motion = "OA turns", velocity = "omega" }]
[points]
O = "(0, 0)"
C = "(4, 0)"
E = "(8, 0)"
A = "polar(O, 1, 5*pi/12)"
B = "meet(circle(A, 4), circle(C, 12/5), upper)"
D = "toward(C, B, 18/5)"
F = "meet(circle(D, 4), circle(E, 3), left of D->E)"
[bodies]
OA = "O A"
AB = "A B"
CBD = "C B D"
DF = "D F"
EF = "E F"
"""


def test_an_angle_without_a_small_exact_form_turns_a_direction_that_has_one() -> None:
    # The direction from D to E is exact, the angle at D is not; by hand F = (7.944, 2.999)
    said = read_chapter("# Positions", solve_small(WATT, x_F="x(F) in m"))
    assert r"\angle EDF &\approx 33.28^\circ" in said
    assert r"+ \angle EDF &= -41.91^\circ + 33.28^\circ \approx -8.63^\circ" in said
    assert r"x_{F} &= x_{D} + 4\cos(\angle(x,\overrightarrow{DE}) + \angle EDF) = " in said
    assert r"4\cos(-8.63^\circ) \approx 7.944\,\unit{m}" in said
