"""The elements of MathML that hold no others: letters, signs, texts, spaces and brackets."""

from __future__ import annotations

from dataclasses import dataclass, replace
from html import escape
from typing import assert_never

from kinegrade.language.math.letters import SIGNS
from kinegrade.language.math.spacing import SPACE_WIDTHS
from kinegrade.language.math.tree import AccentName, FractionName, SpaceName, Style

FRACTIONS: dict[FractionName, str] = {
    "frac": "",
    "dfrac": ' displaystyle="true"',
    "tfrac": ' displaystyle="false"',
}
ACCENTS: dict[AccentName, str] = {
    "vec": '<mo stretchy="false">→</mo>',
    "bar": '<mo stretchy="false">¯</mo>',
    "hat": '<mo stretchy="false">^</mo>',
    "widehat": '<mo stretchy="true">^</mo>',
    "tilde": '<mo stretchy="false">~</mo>',
    "dot": "<mo>˙</mo>",
    "ddot": "<mo>¨</mo>",
    "overline": '<mo stretchy="true">‾</mo>',
    "overrightarrow": '<mo stretchy="true">→</mo>',
    "underbrace": '<mo stretchy="true">⏟</mo>',
    "boxed": ' style="border: 1px solid; padding: 0.15em"',
}


@dataclass(frozen=True, slots=True)
class Face:
    """How letters stand."""

    upright: bool = False
    bold: bool = False

    def change(self, style: Style) -> Face:
        """The face inside a lettering."""
        match style:
            case "mathrm":
                return replace(self, upright=True)
            case "mathbf":
                return Face(upright=True, bold=True)
            case "mathit":
                return replace(self, upright=False)
            case "boldsymbol":
                return replace(self, bold=True)
            case _:
                assert_never(style)


def write_letters(letters: str, face: Face) -> str:
    """Letters as one identifier, in their face."""
    normal = ' mathvariant="normal"' if face.upright and len(letters) == 1 else ""
    return f"<mi{normal}{write_weight(face)}>{letters}</mi>"


def write_weight(face: Face) -> str:
    """The attribute of bold letters, else nothing."""
    return ' style="font-weight: bold"' if face.bold else ""


def write_space(name: SpaceName) -> str:
    """A space of that width."""
    return f'<mspace width="{SPACE_WIDTHS[name]:g}em"/>'


def write_sign(latex: str) -> str:
    """A sign by its LaTeX name, spaced as its kind is."""
    forms = SIGNS[latex]
    character = escape(forms.character)
    match forms.kind:
        case "ordinary":
            return f"<mi>{character}</mi>"
        case "opening" | "closing":
            return f'<mo stretchy="false">{character}</mo>'
        case "relation" | "binary" | "punctuation" | "large":
            return f"<mo>{character}</mo>"
        case _:
            assert_never(forms.kind)


def write_text(text: str) -> str:
    """Words, whose spaces are kept."""
    printable = "".join(character if character.isprintable() else " " for character in text)
    return f"<mtext>{escape(printable.replace(' ', chr(0xA0)))}</mtext>"


def write_fence(bracket: str) -> str:
    """A bracket as high as what it encloses; nothing for the LaTeX bracket "."."""
    if bracket == ".":
        return ""
    return f'<mo fence="true" stretchy="true">{SIGNS[bracket].character}</mo>'


def write_attached(base: str, below: str | None, above: str | None) -> str:
    """A base with what stands below it and above it."""
    match below, above:
        case None, None:
            return base
        case str(), None:
            return f"<msub>{base}{below}</msub>"
        case None, str():
            return f"<msup>{base}{above}</msup>"
        case _:
            return f"<msubsup>{base}{below}{above}</msubsup>"
