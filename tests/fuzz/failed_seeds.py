"""Seeds that once found a fault, each with what it was; they are run with every test."""

from __future__ import annotations

FAILED: dict[int, str] = {}
