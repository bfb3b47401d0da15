"""The sentences under which distances, components and angles are worked out, one table per
language.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kinegrade.language import Language

Signs = tuple[int, int]  # of the cosine and of the sine


@dataclass(frozen=True)
class PoseWords:
    """Sentences that introduce quantities of a pose; vectors are inserted as phrases."""

    component: str
    axis_component: str
    angle: str
    angle_from_axis: str
    between: str
    x_axis: str
    y_axis: str
    vector: str
    turned: str
    called: str
    quadrants: Mapping[Signs, str]


_ENGLISH = PoseWords(
    component="The component of {vector} in the direction of {direction} is their scalar product "
    "over the length of the latter:",
    axis_component="The ${axis}$ component of the unit vector in the direction of {direction}:",
    angle="The angle is counted counter-clockwise from {first} to {second}. Its cosine and its "
    "sine are proportional to the scalar product and the vector product of the two:",
    angle_from_axis="The angle is counted counter-clockwise from {first} to {second}. Its cosine "
    "and its sine are proportional to the coordinates of this vector:",
    between="The angle between {first} and {second} follows from their scalar product:",
    x_axis="the $x$ axis",
    y_axis="the $y$ axis",
    vector="${vector}$",
    turned="{vector} turned through $90^\\circ$ counter-clockwise",
    called="{vector} (called $\\boldsymbol{{{letter}}}$)",
    quadrants={
        (1, 1): "Cosine and sine are positive: the angle lies between $0^\\circ$ and $90^\\circ$.",
        (
            -1,
            1,
        ): "The cosine is negative, the sine positive: the angle lies between $90^\\circ$ and "
        "$180^\\circ$.",
        (
            -1,
            -1,
        ): "Cosine and sine are negative: the angle lies between $-180^\\circ$ and $-90^\\circ$.",
        (
            1,
            -1,
        ): "The cosine is positive, the sine negative: the angle lies between $-90^\\circ$ and "
        "$0^\\circ$.",
        (1, 0): "The sine is zero, the cosine positive: the angle is zero.",
        (-1, 0): "The sine is zero, the cosine negative: the angle is $180^\\circ$.",
        (0, 1): "The cosine is zero, the sine positive: the angle is $90^\\circ$.",
        (0, -1): "The cosine is zero, the sine negative: the angle is $-90^\\circ$.",
    },
)
_CHINESE = PoseWords(
    component="{vector}在{direction}方向上的分量等于两者的标量积除以后者的长度：",
    axis_component="沿{direction}方向的单位矢量在 ${axis}$ 轴上的投影：",
    angle="该角由{first}逆时针转到{second}。其余弦、正弦分别与两矢量的标量积、矢量积成正比：",
    angle_from_axis="该角由{first}逆时针转到{second}。其余弦、正弦与该矢量的坐标成正比：",
    between="{first}与{second}的夹角由标量积求得：",
    x_axis=" $x$ 轴",
    y_axis=" $y$ 轴",
    vector=" ${vector}$ ",
    turned="{vector}逆时针转过 $90^\\circ$ 所得的矢量",
    called="{vector}（记作 $\\boldsymbol{{{letter}}}$）",
    quadrants={
        (1, 1): "余弦、正弦均为正，该角在 $0^\\circ$ 与 $90^\\circ$ 之间。",
        (-1, 1): "余弦为负，正弦为正，该角在 $90^\\circ$ 与 $180^\\circ$ 之间。",
        (-1, -1): "余弦、正弦均为负，该角在 $-180^\\circ$ 与 $-90^\\circ$ 之间。",
        (1, -1): "余弦为正，正弦为负，该角在 $-90^\\circ$ 与 $0^\\circ$ 之间。",
        (1, 0): "正弦为零，余弦为正，该角为零。",
        (-1, 0): "正弦为零，余弦为负，该角为 $180^\\circ$。",
        (0, 1): "余弦为零，正弦为正，该角为 $90^\\circ$。",
        (0, -1): "余弦为零，正弦为负，该角为 $-90^\\circ$。",
    },
)


_WORDS: Mapping[str, PoseWords] = {"en": _ENGLISH, "zh": _CHINESE}


def load_pose_words(language: Language) -> PoseWords:
    """The sentences in one language.

    >>> load_pose_words("zh").quadrants[1, 0]
    '正弦为零，余弦为正，该角为零。'
    """
    return _WORDS[language]
