"""The page of a mechanism's cycle, whatever prints it."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.language import Language


@dataclass(frozen=True)
class CyclePage:
    """What is shown of a cycle: `figure` and each of the `graphs` an SVG document, each of the
    `facts` a line of prose.
    """

    language: Language
    title: str
    figure: str
    facts: tuple[str, ...]
    graphs: tuple[str, ...]
