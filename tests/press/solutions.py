"""Worked solutions as the engine would derive them, for the tests of their typesetting: a
slider-crank by hand.
"""

from __future__ import annotations

from kinegrade.figure.scene import BOLD, FIRM, Label, Scene, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.vector import Vector
from kinegrade.press.sheet import SolutionSheet, WorkedQuestion
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import (
    Block,
    Heading,
    Picture,
    Pictures,
    Prose,
    TermTable,
)
from tests.worked.telling import read_display, read_term


def mechanism_scene() -> Scene:
    """The slider-crank to scale."""
    template = load_template("slider-crank")
    solution = solve_template(template, {})
    return sketch(solution.assembly.mechanism.map(float), template.figure)


def polygon_scene() -> Scene:
    """A triangle of velocities."""
    corners = [Vector(4.0, 30.0), Vector(50.0, 30.0), Vector(27.0, 4.0)]
    lines = tuple(zip(corners, corners[1:] + corners[:1], strict=True))
    places = {"v_B": Vector(27, 33), "v_A": Vector(12, 15), "v_{BA}": Vector(44, 15)}
    labels = tuple(Label(symbol, place, 6, 3) for symbol, place in places.items())
    return Scene(56.0, 36.0, 1.0, (Strokes(lines[:1], BOLD), Strokes(lines[1:], FIRM), *labels))


VELOCITY = TermTable(
    (
        read_term("", r"\boldsymbol{v}_{B}", "?", "along $Ox$"),
        read_term("=", r"\boldsymbol{v}_{A}", r"$\omega\cdot OA$", r"$\perp OA$"),
        read_term("+", r"\boldsymbol{v}_{BA}", "?", r"$\perp AB$"),
    )
)
ACCELERATION = TermTable(
    (
        read_term("", r"\boldsymbol{a}_{B}", "?", "along $Ox$"),
        read_term("=", r"\boldsymbol{a}_{A}^{\mathrm{t}}", r"$\alpha\cdot OA$", r"$\perp OA$"),
        read_term(
            "+", r"\boldsymbol{a}_{A}^{\mathrm{n}}", r"$\omega^{2}\cdot OA$", "from $A$ to $O$"
        ),
        read_term("+", r"\boldsymbol{a}_{BA}^{\mathrm{t}}", "?", r"$\perp AB$"),
        read_term(
            "+",
            r"\boldsymbol{a}_{BA}^{\mathrm{n}}",
            r"$\omega_{AB}^{2}\cdot AB$",
            "from $B$ to $A$",
        ),
    )
)
ENGLISH_BLOCKS: tuple[Block, ...] = (
    Heading("What moves how", 1),
    Prose(
        "The crank $OA$ turns about the fixed axis $O$; the rod $AB$ has plane motion; the "
        "slider $B$ is in translation along $Ox$."
    ),
    Heading("Velocities", 1),
    Heading("Step 1: the crank $OA$ turns about $O$", 2),
    read_display((r"v_A &= \omega\cdot OA = 2\cdot 0.3 = 0.6\,\mathrm{m/s}",)),
    Heading("Step 2: the rod $AB$, base point $A$", 2),
    Prose("The velocity of $B$ is that of the base point $A$ and that of the rotation about it:"),
    VELOCITY,
    Prose(
        r"Two magnitudes are unknown. Projected on $AB$, on which $\boldsymbol{v}_{BA}$ has no "
        r"part:"
    ),
    read_display(
        (
            r"v_B\cos 30^{\circ} &= v_A\cos 0^{\circ}",
            r"v_B &= \frac{v_A}{\cos 30^{\circ}} = \frac{0.6}{\sqrt{3}/2} = \frac{2\sqrt{3}}{5}"
            r" = 0.692820\,\mathrm{m/s}",
        )
    ),
    Prose(r"and on the normal of $AB$:"),
    read_display(
        (
            r"\omega_{AB} &= \frac{v_{BA}}{AB} = \frac{v_B\sin 30^{\circ}}{\sqrt{3}\cdot 0.3}"
            r" = \frac{2}{3}\,\mathrm{rad/s}",
        )
    ),
    Pictures(
        (
            Picture(mechanism_scene(), "Velocities of $A$ and $B$"),
            Picture(polygon_scene(), r"Velocity polygon, 1 m/s corresponds to 60 mm"),
        )
    ),
    Heading("Accelerations", 1),
    Heading("Step 3: the rod $AB$, base point $A$", 2),
    ACCELERATION,
    Prose("Projected on $AB$:"),
    read_display(
        (
            r"a_B\cos 30^{\circ} &= a_A^{\mathrm{n}}\cos 90^{\circ} + a_A^{\mathrm{t}}\cos "
            r"0^{\circ} + a_{BA}^{\mathrm{n}}",
            r"a_B &= \frac{\alpha\cdot OA + \omega_{AB}^2\cdot AB}{\cos 30^{\circ}} = \frac{4}{3}"
            r" = \boxed{1.33333\,\mathrm{m/s^2}}\quad\text{(to the right)}",
        )
    ),
    Pictures((Picture(polygon_scene(), "Acceleration polygon"),)),
)
ENGLISH_SOLUTION = SolutionSheet(
    language="en",
    course="Theoretical Mechanics",
    title="Midterm examination",
    date="14 November 2025",
    student="00123456",
    name="Đặng Thị Hồng",
    code="K7Q2-9FHM",
    questions=(
        WorkedQuestion(
            1,
            "q1",
            "Slider-crank: velocity and acceleration of the slider $B$",
            r"The crank $OA$ of length $r = 0.3\,\mathrm{m}$ turns clockwise about the fixed pin "
            r"$O$ with $\omega = 2\,\mathrm{rad/s}$ and $\alpha = 5\,\mathrm{rad/s^2}$. The rod "
            r"has the length $AB = \sqrt{3}\,OA$. Find the velocity and the acceleration of the "
            r"slider $B$ when $\varphi = 60^\circ$.",
            ENGLISH_BLOCKS,
        ),
    ),
)

CHINESE_BLOCKS: tuple[Block, ...] = (
    Heading("运动分析", 1),
    Prose("曲柄 $OA$ 绕定轴 $O$ 转动；连杆 $AB$ 作平面运动；滑块 $B$ 沿 $Ox$ 作直线平移。"),
    Heading("速度", 1),
    Heading("第 1 步：曲柄 $OA$ 绕 $O$ 轴转动", 2),
    read_display((r"v_A &= \omega\cdot OA = 2\cdot 0.3 = 0.6\,\mathrm{m/s}",)),
    Heading("第 2 步：连杆 $AB$，以 $A$ 为基点", 2),
    TermTable(
        (
            read_term("", r"\boldsymbol{v}_{B}", "?", "沿 $Ox$"),
            read_term("=", r"\boldsymbol{v}_{A}", r"$\omega\cdot OA$", r"$\perp OA$"),
            read_term("+", r"\boldsymbol{v}_{BA}", "?", r"$\perp AB$"),
        )
    ),
    Prose(r"大小中有两个未知量。向 $AB$ 方向投影，$\boldsymbol{v}_{BA}$ 在该方向上无投影："),
    read_display(
        (
            r"v_B\cos 30^{\circ} &= v_A\cos 0^{\circ}",
            r"v_B &= \frac{v_A}{\cos 30^{\circ}} = \frac{2\sqrt{3}}{5} = "
            r"0.692820\,\mathrm{m/s}\quad\text{（向右）}",
        )
    ),
    Pictures(
        (
            Picture(mechanism_scene(), "机构上 $A$、$B$ 两点的速度"),
            Picture(polygon_scene(), "速度多边形"),
        )
    ),
    Heading("加速度", 1),
    Heading("第 3 步：连杆 $AB$，以 $A$ 为基点", 2),
    TermTable(
        (
            read_term("", r"\boldsymbol{a}_{B}", "?", "沿 $Ox$"),
            read_term("=", r"\boldsymbol{a}_{A}^{\mathrm{t}}", r"$\alpha\cdot OA$", r"$\perp OA$"),
            read_term(
                "+", r"\boldsymbol{a}_{A}^{\mathrm{n}}", r"$\omega^{2}\cdot OA$", "由 $A$ 指向 $O$"
            ),
            read_term("+", r"\boldsymbol{a}_{BA}^{\mathrm{t}}", "?", r"$\perp AB$"),
            read_term(
                "+",
                r"\boldsymbol{a}_{BA}^{\mathrm{n}}",
                r"$\omega_{AB}^{2}\cdot AB$",
                "由 $B$ 指向 $A$",
            ),
        )
    ),
    Prose("向 $AB$ 方向投影："),
    read_display(
        (
            r"a_B\cos 30^{\circ} &= a_A^{\mathrm{t}} + a_{BA}^{\mathrm{n}}",
            r"a_B &= \frac{4}{3} = \boxed{1.33333\,\mathrm{m/s^2}}\quad\text{（向右）}",
        )
    ),
)
CHINESE_SOLUTION = SolutionSheet(
    language="zh",
    course="理论力学",
    title="期中考试",
    date="2025 年 11 月 14 日",
    student="00123456",
    name="欧阳修远",
    code="K7Q2-9FHM",
    questions=(
        WorkedQuestion(
            1,
            "q3",
            "曲柄滑块机构：滑块 $B$ 的速度与加速度",
            r"曲柄 $OA$ 长 $r = 0.3\,\mathrm{m}$，绕固定铰链 $O$ 顺时针转动，角速度为 $\omega = 2\,\mathrm{rad/s}$。"
            r"连杆长 $AB = \sqrt{3}\,OA$。求 $\varphi = 60^\circ$ 时滑块 $B$ 的速度与加速度。",
            CHINESE_BLOCKS,
        ),
    ),
)


def long_equation(terms: int) -> TermTable:
    """A vector equation of that many terms, with magnitudes and directions as long as they may
    become.
    """
    magnitudes = (
        "?",
        r"$2\omega_{\mathrm{e}} v_{\mathrm{r}}$",
        r"$\omega_{O_{1}B}^{2}\cdot O_{1}B$",
        r"$\frac{v_{\mathrm{r}}^{2}}{r + R}$",
        "$0$",
    )
    directions = (
        r"$\perp O_{1}B$",
        "along the guide, to the left",
        "from $B$ to $O_{1}$",
        "?",
        "tangent to the circular slot at $A$",
    )
    return TermTable(
        tuple(
            read_term(
                "" if index == 0 else "=" if index == 1 else "-" if index == 5 else "+",
                rf"\boldsymbol{{a}}_{{BA{'A' * (index % 3)}}}^{{\mathrm{{n}}}}",
                magnitudes[index % 5],
                directions[index % 5],
            )
            for index in range(terms)
        )
    )
