"""Sets up a planar mechanism from its description in words alone, and solves it in plain floats.

It stands for a student who cannot see the figure. It was written from printed descriptions of
twenty mechanisms and the list of the words that templates use, and shares nothing with the program
that writes descriptions: it imports nothing of it.
"""

from __future__ import annotations

from tests.description.reader.solving import solve

__all__ = ["solve"]
