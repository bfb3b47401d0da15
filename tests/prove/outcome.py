"""What came of one case, as a line of JSON from the process that ran it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Outcome:
    """The seed of a case, and what was wrong there; "" where the claim holds."""

    seed: int
    fault: str
