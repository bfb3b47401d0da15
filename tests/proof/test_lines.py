"""`check` says where the statement has points and lines otherwise than the mechanism."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.claims.claims import find_false_claims
from tests.problem.turning_crank import CRANK
from tests.said import all_said


def find(said: str, phi: str = "60") -> list[str]:
    """What is contradicted of the crank OA of length r, with M in its middle, at an angle."""
    text = CRANK.replace('en = "{{ r }} ', f"en = '''{said}. {{{{ r }}}} ")
    text = text.replace('{{ omega }}", zh', "{{ omega }}''', zh", 1)
    template = read_template("crank", text)
    return all_said(find_false_claims(template, [solve_template(template, {"phi": phi}, ())]))


@pytest.mark.parametrize(
    ("said", "there", "elsewhere"),
    [
        ("$A$ lies above $O$", "60", "-60"),
        ("the pin $A$ lying above the horizontal through $O$", "60", "-60"),
        ("$A$ liegt oberhalb der Waagerechten durch $O$", "60", "-60"),
        ("$A$ 位于 $O$ 上方", "60", "-60"),
        ("$O$ is below $A$", "60", "-60"),
        ("$OA$ is vertical", "90", "60"),
        ("$OA$ is horizontal", "0", "60"),
        ("$OA$ steht senkrecht", "90", "60"),
        ("$OA$ 处于水平位置", "0", "60"),
        ("$OA$ makes the angle {{ phi }} with the horizontal", "60", ""),
        ("$OA$ makes an angle {{ phi }} with the vertical", "45", "60"),
        ("$OA$ bildet mit der Senkrechten den Winkel {{ phi }}", "45", "60"),
        ("$OA$ 与竖直方向的夹角为 {{ phi }}", "45", "60"),
        (r"The disc has the radius $OA=2\,OM$", "60", ""),
        ("where $OM = MA$", "60", ""),
        (r"where $OA=\sqrt3\,OM$", "", "60"),
        ("$A$ is its lowest point", "-90", "90"),
        ("$A$ ist ihr tiefster Punkt", "-90", "60"),
        ("最低点 $A$", "-90", "60"),
        ("$A$ is the rightmost point", "0", "60"),
        ("a line through $A$ lies above $O$", "-60", ""),
        ("$M$ lies on the line, and $A$ above the line $OM$", "60", ""),
        ("$A$ oberhalb der Geraden $OM$", "60", ""),
        ("the crank's end $A$, which lies level with the fixed pin $O$", "0", "60"),
        ("The slider $A$ slides on the horizontal line through $O$", "0", "60"),
        ("Der Kolben $A$ gleitet auf der Waagerechten durch $O$", "0", "60"),
        ("滑块 $A$ 沿过 $O$ 的水平线滑动", "0", "60"),
        ("The slider $A$ slides on the vertical line through $O$", "90", "60"),
        ("$A$ 与 $O$ 等高", "0", "60"),
        ("$OA$ is inclined by 30° to the right of the vertical", "60", "120"),
        ("the crank stands at the angle {{ phi }} to the horizontal", "60", ""),
        ("the crank stands at the angle {{ phi }} to the vertical", "45", "60"),
        ("die Kurbel ist unter {{ phi }} gegen die Senkrechte geneigt", "45", "60"),
        ("由竖直向上的方向逆时针转到曲柄的角为 {{ phi }}", "45", "60"),
        ("it stands at {{ phi }} below the line $MA$", "", "60"),
        (r"$OA$ of length $2\tfrac{r}{2}$", "60", ""),
        (r"$OA$ of length $\sqrt{2}\,r$", "", "60"),
        (r"$OA$ hat die Länge $3r/2$", "", "60"),
        (r"$OA$ 的长度为 $2r$", "", "60"),
        (r"$A$ lies at the distance $r$ from $O$", "60", ""),
        (r"$A$ liegt im Abstand $2r$ von $O$", "", "60"),
        (r"the pin $A$, at the distance $3r$ from a wall", "60", ""),
        (r"the pin $M$ lies between $O$ and $A$, above $A$", "-60", ""),
        (r"$O$ und $A$ haben den Abstand $2r$", "", "60"),
        (r"$O$ and $A$ have the distance $2 x$", "60", ""),  # no given
        ("$A$ is farther from $O$ than $M$", "60", ""),
        ("$A$ is nearer to the pin $O$ than $M$", "", "60"),
        ("$A$ liegt näher an $O$ als $M$", "", "60"),
        ("$A$ 比 $M$ 离 $O$ 更近", "", "60"),
        ("$A$ is the point of the rim farthest from $O$", "60", ""),
        ("$A$ ist der Punkt, der $O$ am nächsten liegt", "60", ""),
        ("$A$ is the point of the rim nearest to $O$", "", "60"),
        ("$A$ liegt am nächsten an $O$", "", "60"),
        ("$A$ is the topmost point of the disc", "90", "60"),
        ("$A$ ist der oberste Punkt der Scheibe", "90", "60"),
        ("$A$ 为轮缘上的最高点", "90", "60"),
    ],
)
def test_what_lies_otherwise_than_it_is_said_to_is_a_fault(
    said: str, there: str, elsewhere: str
) -> None:
    if there:
        assert find(said, there) == []
    if elsewhere:
        assert [
            each.count("the points of the mechanism lie otherwise")
            for each in find(said, elsewhere)
        ] == [1]


@pytest.mark.parametrize("said", ["$A$ lies below the line $OM$", "$O$ lies above $MA$"])
def test_a_point_on_a_line_is_on_either_side(said: str) -> None:
    assert find(said) == []


def test_the_fault_names_the_words() -> None:
    assert find("$OA$ is horizontal") == [
        'statement: it says "$OA$ is horizontal", and the points of the mechanism lie otherwise: '
        "correct the words, or the points"
    ]


@pytest.mark.parametrize(
    "said",
    [
        "The distance of $O$ and $A$ is {{ half }}",
        "$OA=$ {{ half }}",
        "$O$ 与 $A$ 间的距离为 {{ half }}",
    ],
)
def test_a_length_that_is_another_is_a_fault_in_other_words_too(said: str) -> None:
    named = said.replace("{{ half }}", "{{ s }}")
    text = CRANK.replace('en = "{{ r }} ', f'en = "{named} {{{{ r }}}} ')
    text = text.replace(
        "[parameters]",
        '[parameters]\ns = { unit = "m", draw = [7], means = { en = "a", zh = "b" } }',
    )
    template = read_template("crank", text)
    (fault,) = all_said(find_false_claims(template, [solve_template(template, {}, ())]))
    assert fault.startswith("statement: it says that OA is s, and OA is ")
