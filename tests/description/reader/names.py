"""Names printed in formulas: `O_{1}` is O1, `\\varphi_1` is phi1."""

from __future__ import annotations

import re

ATOM = re.compile(
    r"(?:\\(?P<greek>[A-Za-z]+)|(?P<letter>[A-Za-z]))"
    r"(?P<primes>'*)"
    r"(?P<below>_(?:\{(?:[^{}]|\{[^{}]*\})*\}|[A-Za-z0-9]))?"
    r"(?P<above>\^(?:\{\\(?:mathrm|text)\{[A-Za-z]+\}\}|\\(?:mathrm|text)\{[A-Za-z]+\}|\{\*\}|\*"
    r"|\{\\prime+\}))?"
)
GREEK = {
    *("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa"),
    *("lambda", "mu", "nu", "xi", "rho", "pi", "sigma", "tau", "upsilon", "phi", "chi"),
    *("psi", "omega"),
}
CAPITAL = {name.capitalize() for name in GREEK}


def plain(printed: str) -> str:
    """The name without the marks of printing."""
    words = re.sub(r"\\(?:mathrm|text|prime)", "", printed)
    words = re.sub(r"\\var(?=[a-z])", r"\\", words)
    words = words.replace("'", "p")
    return re.sub(r"[\\{}_^,$\s]", "", words)


def atom_at(text: str, place: int) -> re.Match[str] | None:
    """A letter with its indices at that place of the text."""
    found = ATOM.match(text, place)
    if found and found["greek"] and not is_greek(found["greek"]):
        return None
    return found


def is_greek(command: str) -> bool:
    """Whether the command is a Greek letter."""
    return command.removeprefix("var") in GREEK or command in CAPITAL


def atoms(text: str) -> list[str]:
    """The letters of a text that is nothing but names side by side: `O_{1}T` is O1, T."""
    found: list[str] = []
    place = 0
    while place < len(text):
        if text[place].isspace():
            place += 1
            continue
        atom = atom_at(text, place)
        if atom is None:
            raise ValueError(f"not a name: {text}")
        found.append(plain(atom[0]))
        place = atom.end()
    return found


def point_name(text: str) -> str:
    """The name of the one point that the text names."""
    found = atoms(text)
    if len(found) != 1:
        raise ValueError(f"not the name of a point: {text}")
    return found[0]


def pair_of_points(text: str) -> tuple[str, str]:
    """The names of the two points that the text names."""
    found = atoms(text)
    if len(found) != 2:
        raise ValueError(f"not the names of two points: {text}")
    return found[0], found[1]
