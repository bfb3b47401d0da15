"""What an author may write: the tables of a template's file, and the keys of their entries.

The entries `words.TABLE-KEY` of the catalogues say what each key is for; `problem.vocabulary` puts
them together.
"""

from __future__ import annotations

from collections.abc import Mapping

MAX_CHARACTERS = 100_000  # of a file; the longest that is shipped has 8,000

# Tables and keys of the file, by whether every template needs them
NEEDED = (
    "title",
    "family",
    "source",
    "parameters",
    "points",
    "bodies",
    "joints",
    "inputs",
    "asks",
    "statement",
)
OPTIONAL = (
    "lengths",
    "reasons",
    "conditions",
    "text",
    "published",
    "figure",
    "tags",
    "method",
)
SHARING = ("mechanism",)
STATED = ("language",)  # of a file whose texts are written once
KNOWN = (*NEEDED, *OPTIONAL, *SHARING, *STATED)
NAMES = ("parameters", "points", "bodies")  # without these nothing that names them can be checked

# What templates can share with others: tables, laid over by name, and lists, one after the other
SHARED_TABLES = ("parameters", "lengths", "reasons", "points", "bodies", "figure")
SHARED_LISTS = ("joints", "conditions")
SHARED = (*SHARED_TABLES, *SHARED_LISTS)

PARAMETER = (
    "unit",
    "draw",
    "published",
    "means",
    "symbol",
)
INPUT = (
    "motion",
    "velocity",
    "acceleration",
)
ASK = (
    "quantity",
    "unit",
    "means",
    "sign",
    "points",
    "vanishes",
    "cyclic",
    "symbol",
)
PUBLISHED = (
    "source",
    "given",
    "gives",
)

FIGURE = (
    "lengths",
    "angles",
    "radii",
    "circles",
    "arrows",
    "lines",
    "right_angles",
    "labels",
    "shapes",
    "supports",
    "frames",
    "axes",
)
FIGURE_EXAMPLES: Mapping[str, str] = {
    "lengths": 'lengths = [{ symbol = "l", from = "A", to = "B" }]',
    "angles": r"""angles = [{ symbol = '\theta', at = "O", from = "right", to = "A" }]""",
    "radii": 'radii = [{ symbol = "R", centre = "O" }]',
    "circles": 'circles = [{ body = "wheel", centre = "O", through = "A" }]',
    "arrows": r"""arrows = [{ symbol = '2\omega', turns = "OA" }]""",
    "lines": 'lines = [["O", "A"]]',
    "right_angles": 'right_angles = [["C", "D", "E"]]',
    "labels": 'labels = { O1 = "O_1" }',
    "shapes": 'shapes = { ABC = "bent" }',
    "supports": 'supports = { O1 = "up" }',
    "frames": 'frames = [{ x = "x_1", y = "y_1", at = "A", to = "B" }]',
    "axes": 'axes = "origin"',
}
LENGTH = (
    "symbol",
    "from",
    "to",
    "along",
)
ANGLE = (
    "symbol",
    "at",
    "from",
    "to",
    "sense",
)
RADIUS = (
    "symbol",
    "centre",
    "of",
    "through",
)
CIRCLE = (
    "body",
    "centre",
    "through",
)
FRAME = (
    "x",
    "y",
    "at",
    "from",
    "to",
    "along",
)
MOVING = (
    "symbol",
    "moves",
    "along",
    "rate",
)
TURNING = (
    "symbol",
    "turns",
    "sense",
    "rate",
)
