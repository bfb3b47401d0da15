"""What stands on a gallery of templates, free of any typesetter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from kinegrade.figure.scene import Scene
from kinegrade.language import Language

if TYPE_CHECKING:
    pass  # a paper has none


@dataclass(frozen=True)
class GalleryFigure:
    """One draw of a template: its figure to scale and the values drawn."""

    figure: Scene
    givens: str  # prose


@dataclass(frozen=True)
class GalleryDemands:
    """How many combinations a template has, and what it takes: its difficulty from 1 to `most`,
    minutes; its tags, plain.
    """

    combinations: int
    difficulty: int
    most: int
    minutes: int
    tags: tuple[str, ...]


@dataclass(frozen=True)
class GalleryEntry:
    """One template as an instructor chooses it; `faults` says what cannot be shown of it."""

    family: str  # plain, as are name and faults; "" where nothing but these two can be shown
    name: str
    title: str  # prose
    demands: GalleryDemands | None  # None where it cannot be shown
    asks: tuple[str, ...]  # math: asked unless an exam chooses otherwise
    on_request: tuple[str, ...]  # math: asked only where an exam names them
    figures: tuple[GalleryFigure, ...]
    faults: tuple[str, ...] = ()


@dataclass(frozen=True)
class Gallery:
    """A contact sheet of templates, those of one family one after another."""

    language: Language
    entries: tuple[GalleryEntry, ...]
