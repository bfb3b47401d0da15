"""The names of velocity poles: the letters that a question gives them, else letters that no point
has.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from kinegrade.expressions.tree import Call, Name
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Letter, Node, Number, Row, Scripts
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.template.template import Ask, Template

_LETTERS = "PSQZ"


def name_poles(bodies: Sequence[str], template: Template) -> Mapping[str, str]:
    """The name of each body's pole, as points are named in templates ("C1"): by an ask about it,
    else a letter, numbered where several need one. Raises TypesetError for a symbol that is none.
    """
    asked = {body: name_asked_pole(body, template) for body in bodies}
    letter = choose_pole_letter(template)
    others = [body for body in bodies if not asked[body]]
    numbered = {
        body: f"{letter}{number}" if len(others) > 1 else letter
        for number, body in enumerate(others, 1)
    }
    return {body: asked[body] or numbered[body] for body in bodies}


def choose_pole_letter(template: Template) -> str:
    """P, or a letter that no point has."""
    points = template.scheme.points
    return next((letter for letter in _LETTERS if letter not in points), _LETTERS[0])


def name_asked_pole(body: str, template: Template) -> str:
    """The letter by which an ask names the pole of a body, "" where none does. Raises TypesetError
    for a symbol that is none.
    """
    pole = Call("pole", (Name(body),))
    for ask in template.asks.values():
        if pole in find_motion_calls(ask.quantity):
            named = _find_letter(ask) or _find_end(ask, pole)
            if named:
                return named
    return ""


def find_poles(asked: Iterable[Ask]) -> frozenset[str]:
    """The bodies about whose poles answers are."""
    calls = (call for ask in asked for call in find_motion_calls(ask.quantity))
    return frozenset(
        call.arguments[0].name
        for call in calls
        if call.function == "pole" and isinstance(call.arguments[0], Name)
    )


def _find_letter(ask: Ask) -> str:
    """The point whose coordinate an ask's symbol names, "" for any other symbol."""
    match read_math(ask.symbol, ask.name):
        case (Scripts(Letter("x" | "y"), (Letter(point),), 0, None),) if point.isupper():
            return point
        case _:
            return ""


def _find_end(ask: Ask, pole: Call) -> str:
    """The pole in the symbol of its distance from a point, as C1 in EC_1; "" for any other."""
    match ask.quantity:
        case Call("distance", (Name(point), other)) | Call("distance", (other, Name(point))):
            ends = _list_letters(read_math(ask.symbol, ask.name)) if other == pole else ()
            others = [end for end in ends if end != point]
            return others[0] if len(ends) == 2 and len(others) == 1 else ""
        case _:
            return ""


def _list_letters(row: Row) -> Sequence[str]:
    """The points that a symbol such as AC_1 or l_{AP} consists of; none for any other."""
    match row:
        case (Scripts(Letter(), lower, 0, None),) if lower is not None:
            return _list_letters(lower)
        case _:
            names = [_read_point(node) for node in row]
            return names if all(names) else ()


def _read_point(node: Node) -> str:
    """The name of a point as it is written: C1 for C_1; "" for what is none."""
    match node:
        case Letter(letter) if letter.isupper():
            return letter
        case Scripts(Letter(letter), (Number(digits),), 0, None) if letter.isupper():
            return letter + digits
        case _:
            return ""
