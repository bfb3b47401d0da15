"""One promised figure: how much faster the product is than a peer, measured in the same run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from statistics import median
from time import perf_counter


@dataclass(frozen=True)
class Figure:
    """Cost per unit of work, ours and the peer's; `promise` is the least ratio peer/ours, None if
    none is made; `sought` is the ratio that was aimed at, where no way to it is known.

    Costs are seconds, shown as milliseconds, or megabytes where `unit` is "MB".
    """

    name: str
    ours: float
    peer: float
    promise: float | None
    unit: str = "ms"
    sought: float | None = None

    @property
    def ratio(self) -> float:
        """How many times cheaper ours is."""
        return self.peer / self.ours

    @property
    def kept(self) -> bool:
        """Whether the promise is kept."""
        return self.promise is None or self.ratio >= self.promise

    def line(self) -> str:
        """The figure as a line of the report."""
        promise = (
            ""
            if self.promise is None
            else f"  promised: {self.promise:g}  {'kept' if self.kept else 'BROKEN'}"
        )
        sought = "" if self.sought is None else f", sought: {self.sought:g}"
        scale = 1e3 if self.unit == "ms" else 1.0
        costs = (
            f"ours {self.ours * scale:9.3f} {self.unit}  peer {self.peer * scale:9.3f} {self.unit}"
        )
        return f"{self.name:<58} {costs}  ratio {self.ratio:7.2f}{promise}{sought}"


def seconds(work: Callable[[], object], repeats: int) -> float:
    """The median time of one call, after one call to warm up."""
    work()
    times = []
    for _ in range(repeats):
        start = perf_counter()
        work()
        times.append(perf_counter() - start)
    return median(times)
