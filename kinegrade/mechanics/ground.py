"""The body that does not move, by its name."""

from __future__ import annotations

GROUND = "ground"
