"""What an author may write: the tables of a template's file, and the keys of their entries."""

from __future__ import annotations

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
OPTIONAL = ("lengths", "conditions", "text", "published", "figure", "tags", "method")
KNOWN = (*NEEDED, *OPTIONAL, "mechanism")
NAMES = ("parameters", "points", "bodies")  # without these nothing that names them can be checked

# What templates can share with others: tables, laid over by name, and lists, one after the other
SHARED_TABLES = ("parameters", "lengths", "points", "bodies", "figure")
SHARED_LISTS = ("joints", "conditions")
SHARED = (*SHARED_TABLES, *SHARED_LISTS)

PARAMETER = ("unit", "draw", "published", "means", "symbol")
INPUT = ("motion", "velocity", "acceleration")
ASK = ("quantity", "unit", "means", "sign", "points", "vanishes", "cyclic", "symbol")
PUBLISHED = ("source", "given", "gives")

FIGURE = (
    "lengths",
    "angles",
    "radii",
    "circles",
    "arrows",
    "lines",
    "labels",
    "shapes",
    "axes",
)
LENGTH = ("symbol", "from", "to", "along")
ANGLE = ("symbol", "at", "from", "to", "sense")
RADIUS = ("symbol", "centre", "of", "through")
CIRCLE = ("body", "centre", "through")
MOVING = ("symbol", "moves", "along")
TURNING = ("symbol", "turns", "sense")
