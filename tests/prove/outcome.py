"""What came of one case, as a line of JSON from the process that ran it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Outcome:
    """The seed of a case, what was wrong there ("" where the claim holds), and how many things were
    `compared` there, of proofs that promise a number of them.
    """

    seed: int
    fault: str
    compared: int = 0
