"""Chance: how often rare events that do not depend on each other come together."""

from __future__ import annotations

from math import exp, lgamma, log

#: Questions, at least, that must fit another paper: a number misread gives all answers of one
#: question as they are right on each paper that has that number
QUESTIONS_THAT_TELL = 2


def find_tail(count: int, mean: float) -> float:
    """The probability that a Poisson variable with that mean is at least `count`; a mean of zero
    allows nothing.

    >>> round(find_tail(2, 0.1), 6), find_tail(0, 0.1), find_tail(1, 0.0)
    (0.004679, 1.0, 0.0)
    """
    if count <= mean or not count:
        return 1.0
    if not mean:
        return 0.0
    term = chance = exp(count * log(mean) - mean - lgamma(count + 1))
    while term > 1e-12 * chance:
        count += 1
        term *= mean / count
        chance += term
    return chance
