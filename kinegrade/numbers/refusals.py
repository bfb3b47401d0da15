"""What no arithmetic has a value for."""

from __future__ import annotations


class NegativeRoot(ValueError):
    """The square root of a negative number."""


class NoDirection(ValueError):
    """The direction of a zero vector."""


class Inexact(Exception):
    """A value lies in no small exact field and has to be worked out with balls instead."""
