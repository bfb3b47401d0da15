"""The sentences of the chapter on positions, one table per language; `{}` fields take LaTeX math or
other phrases.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kinegrade.language import Language


@dataclass(frozen=True)
class PositionWords:
    """Sentences that describe constructions; `point` is the one constructed."""

    origin: str
    lengths: str
    coordinates: str
    coordinates_of_several: str
    listing: str
    coincides: str
    polar: str
    polar_against: str
    beside: Mapping[int, str]  # by quarter turns from the x axis
    midpoint: str
    displaced: str
    turned: str
    toward: str
    along: str
    foot: str
    foot_reached: str
    lines_meet: str
    along_first: str
    quadratic: str
    line_meets_circle: str
    circles_meet: str
    sides: Mapping[str, str]
    on_the_left: str
    on_the_right: str
    level_line: str
    upright_line: str
    slanting_line: str
    line_between: str
    x_axis: str
    y_axis: str
    circle: str
    triangle: str
    reached_along: str


_ENGLISH = PositionWords(
    origin="${point}$ is the origin of the coordinates.",
    lengths="Lengths that follow from the givens:",
    coordinates="Coordinates of {points}:",
    coordinates_of_several="Coordinates of {points}:",
    listing=", ",
    coincides="${point}$ coincides with ${other}$:",
    polar="${point}$ lies at the distance ${radius}$ from ${centre}$ in the direction ${angle}$, "
    "counted counter-clockwise from the $x$ axis:",
    polar_against="${point}$ lies at the distance ${radius}$ from ${centre}$, opposite to the "
    "direction ${angle}$, which is counted counter-clockwise from the $x$ axis:",
    beside={
        0: "${point}$ lies at the distance ${radius}$ from ${centre}$ in the direction of $x$:",
        1: "${point}$ lies at the distance ${radius}$ from ${centre}$ in the direction of $y$:",
        2: "${point}$ lies at the distance ${radius}$ from ${centre}$ in the direction of $-x$:",
        3: "${point}$ lies at the distance ${radius}$ from ${centre}$ in the direction of $-y$:",
    },
    midpoint="${point}$ is the midpoint of ${first}{second}$:",
    displaced="From ${base}$ to ${point}$ leads the vector {vector}:",
    turned="{vector} turned through $90^\\circ$ counter-clockwise",
    toward="${point}$ lies on the ray from ${start}$ through ${end}$, at the distance ${distance}$ "
    "from ${start}$:",
    along="${point}$ lies at the distance ${distance}$ from ${start}$ in the direction of the "
    "vector {vector}:",
    foot="${point}$ is the foot of the perpendicular from ${from_}$ to {line}.",
    foot_reached="Its distance ${share}$ from ${start}$, negative against this direction, is the "
    "projection of {vector} on the line:",
    lines_meet="${point}$ is the point in which {first} and {second} meet:",
    along_first="its distance from ${start}$ along the first of them is ${share}$, negative "
    "against its direction:",
    quadratic="with ${share}$ for its distance from ${start}$ along the line, negative against the "
    "line's direction, the equation of the circle becomes a quadratic one:",
    line_meets_circle="${point}$ is the {side} of the points in which {line} meets {circle}:",
    circles_meet="${point}$ lies on {first} and on {second}, {side}.",
    sides={"right": "right one", "left": "left one", "upper": "upper one", "lower": "lower one"},
    on_the_left="on the left of the line from ${first}$ to ${second}$",
    on_the_right="on the right of the line from ${first}$ to ${second}$",
    level_line="the line through ${point}$ parallel to the $x$ axis",
    upright_line="the line through ${point}$ parallel to the $y$ axis",
    slanting_line="the line through ${point}$ in the direction ${angle}$",
    line_between="the line ${first}{second}$",
    x_axis="the $x$ axis",
    y_axis="the $y$ axis",
    circle="the circle about ${centre}$ of radius ${radius}$",
    triangle="In the triangle ${first}{second}{point}$ all sides are known; the law of cosines "
    "gives its angle at ${first}$:",
    reached_along="From ${first}$ the point ${point}$ is seen in the direction of "
    "${first}{second}$ turned through this angle {sense}:",
)
_CHINESE = PositionWords(
    origin="取 ${point}$ 为坐标原点。",
    lengths="由已知条件得下列长度：",
    coordinates="点 {points} 的坐标：",
    coordinates_of_several="{points} 各点的坐标：",
    listing="、",
    coincides="点 ${point}$ 与点 ${other}$ 重合：",
    polar="点 ${point}$ 到 ${centre}$ 的距离为 ${radius}$，由 $x$ 轴正向逆时针转到 ${centre}{point}$ 的角为 "
    "${angle}$：",
    polar_against="点 ${point}$ 到 ${centre}$ 的距离为 ${radius}$，由 $x$ 轴正向逆时针转到 ${point}{centre}$ 的角为 "
    "${angle}$：",
    beside={
        0: "点 ${point}$ 由 ${centre}$ 沿 $x$ 轴正向量取 ${radius}$ 得到：",
        1: "点 ${point}$ 由 ${centre}$ 沿 $y$ 轴正向量取 ${radius}$ 得到：",
        2: "点 ${point}$ 由 ${centre}$ 沿 $x$ 轴负向量取 ${radius}$ 得到：",
        3: "点 ${point}$ 由 ${centre}$ 沿 $y$ 轴负向量取 ${radius}$ 得到：",
    },
    midpoint="点 ${point}$ 为 ${first}{second}$ 的中点：",
    displaced="由 ${base}$ 到 ${point}$ 的矢量为 {vector}：",
    turned="{vector} 逆时针转过 $90^\\circ$ 所得的矢量",
    toward="点 ${point}$ 在由 ${start}$ 过 ${end}$ 的射线上，到 ${start}$ 的距离为 ${distance}$：",
    along="点 ${point}$ 到 ${start}$ 的距离为 ${distance}$，方向沿 {vector}：",
    foot="点 ${point}$ 为由 ${from_}$ 向{line}所作垂线的垂足。",
    foot_reached="由 ${start}$ 沿该方向到垂足的距离 ${share}$（反向为负）等于 {vector} 在该直线上的投影：",
    lines_meet="点 ${point}$ 为{first}与{second}的交点：",
    along_first="由 ${start}$ 沿第一条直线到该点的距离记为 ${share}$（反向为负）：",
    quadratic="由 ${start}$ 沿该直线到该点的距离记为 ${share}$（反向为负），代入圆的方程得二次方程：",
    line_meets_circle="点 ${point}$ 为{line}与{circle}的两交点中{side}：",
    circles_meet="点 ${point}$ 既在{first}上，又在{second}上，且{side}。",
    sides={
        "right": "靠右的一个",
        "left": "靠左的一个",
        "upper": "靠上的一个",
        "lower": "靠下的一个",
    },
    on_the_left="位于由 ${first}$ 指向 ${second}$ 的直线的左侧",
    on_the_right="位于由 ${first}$ 指向 ${second}$ 的直线的右侧",
    level_line="过 ${point}$ 且平行于 $x$ 轴的直线",
    upright_line="过 ${point}$ 且平行于 $y$ 轴的直线",
    slanting_line="过 ${point}$、方向角为 ${angle}$ 的直线",
    line_between="直线 ${first}{second}$ ",
    x_axis=" $x$ 轴",
    y_axis=" $y$ 轴",
    circle="以 ${centre}$ 为圆心、${radius}$ 为半径的圆",
    triangle="三角形 ${first}{second}{point}$ 的三边已知，由余弦定理求 ${first}$ 处的角：",
    reached_along="将 ${first}{second}$ 的方向{sense}转过该角，即为由 ${first}$ 到 ${point}$ 的方向：",
)
_SENSES: Mapping[str, tuple[str, str]] = {
    "en": ("counter-clockwise", "clockwise"),
    "zh": ("逆时针", "顺时针"),
}


_WORDS: Mapping[str, PositionWords] = {"en": _ENGLISH, "zh": _CHINESE}


def load_position_words(language: Language) -> PositionWords:
    """The sentences in one language.

    >>> load_position_words("zh").midpoint.format(point="C", first="A", second="B")
    '点 $C$ 为 $AB$ 的中点：'
    """
    return _WORDS[language]


def write_sense(language: Language, counter_clockwise: bool) -> str:
    """The word for a sense of rotation."""
    return _SENSES[language][0 if counter_clockwise else 1]
