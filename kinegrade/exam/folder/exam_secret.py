"""What an exam's numbers are drawn from: a random secret that lives in the exam folder and that no
one needs to know.

`generate` makes one, or keeps that of the folder which it replaces; in folders of earlier versions
it was a word typed by the instructor.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from hmac import digest
from secrets import token_hex
from typing import Any, assert_never

_BYTES = 32  # of the secret: 256 bits, as many as HMAC-SHA256 returns
_LEAST = 32  # hexadecimal digits of the shortest secret accepted: 128 bits
_EARLIER = "seed"  # the key under which earlier versions kept the words


@dataclass(frozen=True)
class RandomSecret:
    """Two random secrets in hexadecimal, `draws` for numbers and `codes` for the codes printed on
    papers.

    They are independent, so the codes of a whole class reveal nothing about the numbers. `label` is
    typed by the instructor; it is mixed into the numbers and need not be secret.
    """

    draws: str = field(repr=False)
    codes: str = field(repr=False)
    label: str = ""

    @property
    def guessable(self) -> bool:
        """Whether it could be found by trying words."""
        return False

    @property
    def drawing(self) -> str:
        """The key under which numbers, templates, versions and the order of questions are drawn."""
        return digest(bytes.fromhex(self.draws), self.label.encode(), "sha256").hex()

    @property
    def coding(self) -> str:
        """The key under which the codes of papers are made."""
        return self.codes

    def record(self) -> dict[str, str]:
        """What exam.json holds of it."""
        return {"secret": self.draws, "label": self.label, "codes": self.codes}


@dataclass(frozen=True)
class FromWords:
    """Words from which the whole exam can be derived anywhere: anyone who guesses them has every
    key.

    For tests and demonstrations, and for folders of earlier versions.
    """

    words: str = field(repr=False)

    @property
    def guessable(self) -> bool:
        """Whether it could be found by trying words."""
        return True

    @property
    def drawing(self) -> str:
        """The key under which numbers, templates, versions and the order of questions are drawn."""
        return self.words

    @property
    def coding(self) -> str:
        """The key under which the codes of papers are made."""
        return self.words

    def record(self) -> dict[str, str]:
        """What exam.json holds of it."""
        return {"reproducible": self.words}


ExamSecret = RandomSecret | FromWords


@dataclass(frozen=True)
class SecretWish:
    """What the instructor asks for: a label to be mixed in, or words to derive everything from;
    with `new`, fresh numbers instead of those of the folder that is replaced.
    """

    label: str | None = None
    words: str | None = None
    new: bool = False

    def secret(self, kept: ExamSecret | None) -> ExamSecret:
        """The secret of the exam to be written; `kept` is that of the folder that it replaces, if
        there is one.
        """
        if self.words is not None:
            return FromWords(self.words)
        if kept is None or self.new:
            return draw_secret(self.label or "")
        return kept if self.label is None else _relabel(kept, self.label)


def draw_secret(label: str = "") -> RandomSecret:
    """A new secret, 256 random bits for the numbers and as many for the codes of papers."""
    return RandomSecret(token_hex(_BYTES), token_hex(_BYTES), label)


def _relabel(secret: ExamSecret, label: str) -> ExamSecret:
    """The secret with another label; words have no label, so unless it is the same words, the
    result is a new random secret.
    """
    match secret:
        case RandomSecret():
            return replace(secret, label=label)
        case FromWords():
            return secret if secret.words == label else draw_secret(label)
        case _:
            assert_never(secret)


def find_secret(head: Mapping[str, Any]) -> ExamSecret | None:
    """The secret that exam.json states; None if it states no complete one."""
    words = head.get("reproducible", head.get(_EARLIER))
    if isinstance(words, str):
        return FromWords(words)
    draws, codes, label = (head.get(name) for name in ("secret", "codes", "label"))
    if _is_hexadecimal(draws) and _is_hexadecimal(codes) and isinstance(label, str):
        return RandomSecret(str(draws), str(codes), label)
    return None


def _is_hexadecimal(text: object) -> bool:
    """Whether this is a text of whole bytes in hexadecimal, 128 bits or more."""
    if not isinstance(text, str) or len(text) < _LEAST:
        return False
    try:
        return len(bytes.fromhex(text)) * 2 == len(text)
    except ValueError:
        return False
