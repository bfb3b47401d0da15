"""What an author chooses by a word: tags by which banks find a template, the method of its worked
solution.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from kinegrade.problem.template import METHODS, Method

TAG = re.compile(r"[a-z][a-z0-9-]{0,29}", re.ASCII)
Fault = Callable[[str, str], None]  # takes the key and what was expected


def read_tags(words: list[Any], fault: Fault) -> tuple[str, ...]:
    """The author's own tags."""
    if all(isinstance(word, str) and TAG.fullmatch(word) for word in words):
        return tuple(words)
    fault("tags", 'expected short words of small letters, digits and hyphens, like ["two-drivers"]')
    return ()


def read_method(word: Any, fault: Fault) -> Method | None:
    """The method by which velocities are worked out where several serve; None leaves the choice to
    the engine.
    """
    chosen = next((method for method in METHODS if method == word), None)
    if word is not None and chosen is None:
        fault("method", f"expected one of {', '.join(METHODS)}")
    return chosen
