"""How far a proof is, said every minute while it runs: what a run that is cut short had found stays
on the screen.
"""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from tests.prove.outcome import Outcome
from tests.prove.proof import Proof

EVERY = 60.0  # seconds


class Tally:
    """The outcomes of a proof so far, which several threads may add to."""

    def __init__(self, proof: Proof, cases: int) -> None:
        self._proof, self._cases = proof, cases
        self._begin = time.monotonic()
        self._lock = threading.Lock()
        self._done, self._failed, self._compared = 0, 0, 0

    def add(self, outcome: Outcome) -> None:
        """Count an outcome; a failure is shown at once."""
        with self._lock:
            self._done += 1
            self._failed += bool(outcome.fault)
            self._compared += outcome.compared
        if outcome.fault:
            _show(write_failure(self._proof, outcome))

    def show(self) -> None:
        """Say how many cases are done and how many of them failed."""
        seconds = time.monotonic() - self._begin
        counts = {"failed": self._failed, "compared": self._compared}
        counted = "".join(f"{count} {what}, " for what, count in counts.items() if count)
        _show(f"{self._proof.name}: {self._done} of {self._cases} done, {counted}{seconds:.0f} s")


@contextmanager
def tallied(proof: Proof, cases: int) -> Iterator[Callable[[Outcome], None]]:
    """What counts the outcomes of a proof, and says on stderr every minute how far it is."""
    tally, ended = Tally(proof, cases), threading.Event()

    def show_now_and_then() -> None:
        while not ended.wait(EVERY):
            tally.show()

    thread = threading.Thread(target=show_now_and_then, daemon=True)
    thread.start()
    try:
        yield tally.add
    finally:
        ended.set()
        thread.join()


def write_failure(proof: Proof, outcome: Outcome) -> str:
    """An entry of the list of failed seeds."""
    return f"    ({proof.name!r}, {outcome.seed}): {outcome.fault!r},"


def _show(line: str) -> None:
    print(line, file=sys.stderr, flush=True)
