"""Seeds that once found a fault, each with what it was; they are run with every test."""

from __future__ import annotations

FAILED: dict[int, str] = {
    156: "report: read_as of marks.csv was no number",
    250: "quiz: a tolerance in the key without its parts",
}
