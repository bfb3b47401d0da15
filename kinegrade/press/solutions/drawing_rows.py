"""Rows of drawings in a worked solution, and the text that stands beside them: how much of the page
they take.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.figure.scene import Scene
from kinegrade.press.solutions.settings import USUAL, Setting, Spread, add_heights

GAP = 6.0  # millimetres between a drawing and what stands beside it
# Millimetres that a caption has at least, of three lines where it is narrow, and takes below a
# drawing with its distance
_CAPTION_WIDTH, _NARROW_WIDTH = 42.0, 28.0
_CAPTION, _HIGHER = 9.5, 4.0
_AROUND = 4.0  # millimetres above and below a row with drawings


@dataclass(frozen=True, eq=False)  # one is itself alone: quick to look up
class Drawing:
    """A picture with its caption, or the question's figure, which has none; `narrow` where the
    caption leaves text more room beside it.
    """

    scene: Scene
    caption: str | None
    title: str  # prose: what it shows, for those who do not see it
    narrow: bool = False

    @property
    def width(self) -> float:
        """Millimetres that the drawing takes with its caption."""
        caption = _NARROW_WIDTH if self.narrow else _CAPTION_WIDTH
        return self.scene.width if self.caption is None else max(self.scene.width, caption)

    @property
    def height(self) -> float:
        """Millimetres that the drawing takes with its caption."""
        caption = _CAPTION + _HIGHER * (self.scene.width < _CAPTION_WIDTH and self.narrow)
        return self.scene.height + (0.0 if self.caption is None else caption)


@dataclass(frozen=True)
class DrawingRow:
    """Drawings side by side at the right edge with text to their left, or alone in the middle;
    `whole` where no page may end within the text.
    """

    drawings: tuple[Drawing, ...]
    beside: tuple[Setting, ...]
    spread: Spread = USUAL
    whole: bool = False

    @property
    def width(self) -> float:
        """Millimetres that the drawings take."""
        return sum(one.width for one in self.drawings) + GAP * (len(self.drawings) - 1)

    @property
    def height(self) -> float:
        """Millimetres that the row takes of the page."""
        drawn = max(one.height for one in self.drawings)
        return max(drawn, add_heights(self.beside)) + _AROUND * self.spread.blocks
