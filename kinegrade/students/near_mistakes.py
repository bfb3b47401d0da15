"""How often known mistakes land within tolerance of the right answer: in the draws that are refused
for it, and in those that are dealt.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from kinegrade.students.separation import Separation

Shares = Mapping[str, float]  # by mistake, largest first, all above zero


@dataclass(frozen=True)
class NearMistakes:
    """By ask, the mistakes that may be taken for right, each with its share of a question's draws.

    `refused` has those that draws keep apart: the share of the draws fit for other reasons that is
    refused. `passing` has those that nothing keeps apart: the share of the draws kept.
    """

    refused: Mapping[str, Shares] = field(default_factory=dict)
    passing: Mapping[str, Shares] = field(default_factory=dict)


def find_near_mistakes(separation: Separation) -> NearMistakes:
    """What the sample of a separation shows."""
    seen = separation.compare(separation.sample)
    dealt = seen.fit & ~separation.find_confused(seen)
    inseparable = separation.inseparable(seen)
    refused, passing = {}, {}
    for name, labels in seen.identifiers.items():
        near, kept = seen.near[name], separation.kept[name]
        refused[name] = _list_shares(labels, near[:, seen.fit], kept)
        passing[name] = _list_shares(labels, near[:, dealt], np.isin(labels, inseparable[name]))
    return NearMistakes(refused, passing)


def _list_shares(labels: tuple[str, ...], near: np.ndarray, chosen: np.ndarray) -> Shares:
    """The share of instances for each mistake that is chosen."""
    shares = near.mean(axis=1) if near.size else np.zeros(len(labels))
    found = zip(labels, np.where(chosen, shares, 0.0).tolist(), strict=True)
    return dict(sorted((each for each in found if each[1]), key=lambda each: -each[1]))
