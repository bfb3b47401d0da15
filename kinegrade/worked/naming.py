"""The names of bodies, points and rates in a worked solution: the paper's symbols where it has
them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import assert_never

from kinegrade.expression import Call, Name
from kinegrade.language import LANGUAGES, Language
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.notation import write_point_symbol
from kinegrade.problem.template import Template

_BODIES = {  # the words that templates use for bodies
    "crank": ("the crank", "曲柄"),
    "rocker": ("the rocker", "摇杆"),
    "rod": ("the rod", "杆"),
    "bar": ("the bar", "杆"),
    "wheel": ("the wheel", "轮"),
    "gear": ("the gear", "齿轮"),
    "rack": ("the rack", "齿条"),
    "disc": ("the disc", "圆盘"),
    "disk": ("the disc", "圆盘"),
    "sleeve": ("the sleeve", "套筒"),
    "cam": ("the cam", "凸轮"),
    "arm": ("the carrier", "系杆"),
    "plate": ("the plate", "平板"),
    "planet": ("the planet gear", "行星轮"),
    "tappet": ("the follower", "从动件"),
    "follower": ("the follower", "从动件"),
    "jaw": ("the jaw", "颚板"),
    "strut": ("the strut", "撑杆"),
    "coupler": ("the coupler", "连杆"),
    "slider": ("the slider", "滑块"),
    "table": ("the table", "台面"),
    "ring": ("the ring", "圆环"),
    "sun": ("the sun gear", "太阳轮"),
    "roller": ("the roller", "滚子"),
}
# Named by their end points
_LINKS = frozenset({"crank", "rocker", "rod", "bar", "arm", "strut", "jaw", "coupler"})


@dataclass(frozen=True)
class Naming:
    """What a template's bodies and rates are called in one language."""

    template: Template
    language: Language

    def point(self, name: str) -> str:
        """A point in LaTeX math."""
        return write_point_symbol(name)

    def body(self, name: str) -> str:
        """A body in prose: the paper's letters, or the word for it."""
        if not name.islower():
            head, _, letters = name.partition("_")
            if letters and head.islower():
                return f"{self._word(head)} ${letters}$"
            return self._wheel(name) if self._is_round(name) else f"${write_point_symbol(name)}$"
        kind = name.rstrip("0123456789")
        ends = "".join(map(write_point_symbol, self._points(name)[:2]))
        if kind in _LINKS and len(self._points(name)) > 1:
            return f"{self._word(kind)} ${ends}$"
        return f"{self._bare(kind)} {name[len(kind) :]}" if kind != name else self._word(kind)

    def letters(self, name: str) -> str:
        """A body in a subscript, in LaTeX math: its letters, else the word for it."""
        words = self.body(name)
        return words.split("$")[1] if "$" in words else rf"\text{{{words.removeprefix('the ')}}}"

    def _is_round(self, body: str) -> bool:
        """Whether a body has a circle with which it rolls, meshes or touches."""
        return len(body) < 3 and any(
            joint.circle and joint.body == body for joint in self.template.scheme.joints
        )

    def _wheel(self, body: str) -> str:
        """The wheel, or the gear; with its letter where there are several, or where the letter is a
        Roman numeral.
        """
        kind = "gear" if "gear" in self.template.about.family else "wheel"
        several = sum(self._is_round(other.name) for other in self.template.scheme.bodies) > 1
        roman = set(body) <= set("IV")
        return (
            f"{self._bare(kind)} {body if roman else f'${write_point_symbol(body)}$'}"
            if several or roman
            else self._word(kind)
        )

    def _bare(self, name: str) -> str:
        """The word for a body without its article."""
        return self._word(name).removeprefix("the ")

    def _points(self, body: str) -> tuple[str, ...]:
        return next(
            (other.points for other in self.template.scheme.bodies if other.name == body), ()
        )

    def _word(self, name: str) -> str:
        words = _BODIES.get(name)
        return words[LANGUAGES.index(self.language)] if words else name

    def omega(self, body: str) -> str:
        """The symbol of a body's angular velocity."""
        return self._turning[body][0]

    def alpha(self, body: str) -> str:
        """The symbol of a body's angular acceleration."""
        return self._turning[body][1]

    def turning(self, body: str, level: Level) -> str:
        """The symbol of a body's angular velocity or acceleration."""
        match level:
            case "velocity":
                return self.omega(body)
            case "acceleration":
                return self.alpha(body)
            case _:
                assert_never(level)

    @cached_property
    def _turning(self) -> dict[str, tuple[str, str]]:
        """For each body the symbols that the asks give to its rotation, else those of its
        points.
        """
        asked = {(call, body): symbol for call, body, symbol in self._asked_rotations()}
        taken = set(asked.values())
        found: dict[str, tuple[str, str]] = {}
        for body in self.template.scheme.bodies:
            omega, alpha = asked.get(("omega", body.name)), asked.get(("alpha", body.name))
            if omega is None:
                omega = (
                    alpha.replace("alpha", "omega", 1)
                    if alpha
                    else self._own(body.name, body.points, taken)
                )
            found[body.name] = (omega, alpha or omega.replace("omega", "alpha", 1))
            taken.add(omega)
        return found

    def _own(self, body: str, points: tuple[str, ...], taken: set[str]) -> str:
        letters = (
            write_point_symbol(body)
            if not body.islower()
            else "".join(map(write_point_symbol, points[:2]))
        )
        symbol = rf"\omega_{{{letters}}}"
        return (
            symbol
            if symbol not in taken and "_" not in body
            else rf"\omega_{{\text{{{self._bare(body)}}}}}"
        )

    def _asked_rotations(self) -> Iterator[tuple[str, str, str]]:
        for ask in self.template.asks.values():
            tree = ask.quantity
            if (
                isinstance(tree, Call)
                and tree.function in ("omega", "alpha")
                and len(tree.arguments) == 1
            ):
                body = tree.arguments[0]
                if isinstance(body, Name) and ask.symbol.startswith("\\" + tree.function):
                    yield tree.function, body.name, ask.symbol
