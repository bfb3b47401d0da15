"""Square roots of exact numbers, in the smallest tower of roots that holds them."""

from __future__ import annotations

from math import gcd
from typing import Any

from flint import fmpq, fmpz

from kinegrade.numbers.surd import Real, Root, Surd, make_surd

_TRIAL_PRIMES = [p for p in range(2, 1000) if all(p % q for q in range(2, int(p**0.5) + 1))]


def square_root(number: Real, roots: tuple[Root, ...]) -> Real | None:
    """A square root of `number` within the tower of `roots`, or None when there is none.

    (u + v sqrt d)^2 = a + b sqrt d requires a^2 - b^2 d to be a square n^2 one level lower, and u^2
    = (a +- n)/2.
    """
    if not roots:
        return _rational_root(number)
    top, lower = roots[-1], roots[:-1]
    if not (isinstance(number, Surd) and number.root.level == top.level):
        plain = square_root(number, lower)
        if plain is not None:
            return plain
        multiple = square_root(number / top.radicand, lower)
        return None if multiple is None else make_surd(top, fmpq(0), multiple)
    norm = square_root(number.a * number.a - number.b * number.b * top.radicand, lower)
    if norm is None:
        return None
    for half in ((number.a + norm) / 2, (number.a - norm) / 2):
        part = square_root(half, lower) if half != 0 else None
        if part is not None:
            return Surd(top, part, number.b / (2 * part))
    return None


def denesting(number: Real, roots: tuple[Root, ...]) -> Real | None:
    """A number lower in the tower whose root gives the root of `number` too, or None: sqrt(5 - 2
    sqrt 6) needs sqrt 3.

    With a^2 - b^2 d = n^2, the root of a + b sqrt d is u + b sqrt d/(2 u) where u^2 = (a + n)/2.
    """
    if not isinstance(number, Surd):
        return None
    norm = square_root(
        number.a * number.a - number.b * number.b * number.root.radicand,
        roots[: number.root.level - 1],
    )
    return None if norm is None else (number.a + abs(norm)) / 2


def _rational_root(number: Any) -> Any | None:
    """The square root of a rational number if it is rational, else None."""
    if number < 0:
        return None
    above, below = fmpz(number.p).isqrt(), fmpz(number.q).isqrt()
    return fmpq(above, below) if above * above == number.p and below * below == number.q else None


def split_radicand(number: Real) -> tuple[Any, Real]:
    """(factor, radicand) with sqrt(number) = factor*sqrt(radicand): integer coefficients, no small
    square divisor.
    """
    coefficients = _list_coefficients(number)
    below = 1
    for coefficient in coefficients:
        below = below * int(coefficient.q) // gcd(below, int(coefficient.q))
    above = 0
    for coefficient in coefficients:
        above = gcd(above, int(coefficient.p) * (below // int(coefficient.q)))
    root, free = split_square(above * below)
    return fmpq(root, below), number * fmpq(below * free, above)


def _list_coefficients(number: Real) -> list[Any]:
    """The non-zero rational coefficients of a number over its tower."""
    if isinstance(number, Surd):
        return _list_coefficients(number.a) + _list_coefficients(number.b)
    return [number] if number != 0 else []


def split_square(number: int) -> tuple[int, int]:
    """(r, f) with number = r^2 * f and f free of the squares of small primes, and not itself a
    square.

    >>> split_square(72)
    (6, 2)
    """
    root = 1
    for prime in _TRIAL_PRIMES:
        while number % (prime * prime) == 0:
            number //= prime * prime
            root *= prime
        if prime * prime > number:
            break
    whole = int(fmpz(number).isqrt())
    return (root * whole, 1) if whole * whole == number else (root, number)
