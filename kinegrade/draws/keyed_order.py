"""What a secret decides: a number at every address, and an order of the numbers 0, 1, ... n-1.

Both are addressed, never consumed: what stands at one place does not depend on what was looked up
before, so that it is the same on any machine in ten years.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from hashlib import sha256
from hmac import digest
from math import isqrt
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hashlib import _Hash

_BLOCK = 64  # bytes that SHA-256 takes at a time
_ROUNDS = 10  # of the network: as many as NIST SP 800-38G has in FF1, for domains as small as ours


@dataclass(frozen=True)
class KeyedOrder:
    """A permutation of 0, 1, ... `size`-1 that `secret` and `name` decide.

    A balanced Feistel network (M. Luby, C. Rackoff, 1988) with HMAC-SHA256 as its round function,
    on pairs of digits to the least base whose square is no less than `size`, which are added modulo
    that base; a number beyond `size` is sent through again until one below comes out (cycle
    walking). Both are from J. Black, P. Rogaway, Ciphers with Arbitrary Finite Domains, 2002.

    >>> order = KeyedOrder("spring", "q1", 5)
    >>> sorted(order.at(place) for place in range(5))
    [0, 1, 2, 3, 4]
    """

    secret: str
    name: str
    size: int

    def at(self, place: int) -> int:
        """The number at a place of the order. Raises IndexError beyond its end."""
        if not 0 <= place < self.size:
            raise IndexError(f"place {place} of an order of {self.size}")
        base = isqrt(self.size - 1) + 1
        number = self._enciphered(place, base)
        while number >= self.size:
            number = self._enciphered(number, base)
        return number

    def _enciphered(self, number: int, base: int) -> int:
        """A number below the square of `base`, sent through the network."""
        begun, closing = _begin(self.secret, _frame("order of draws") + _frame(self.name))
        left, right = divmod(number, base)
        for turn in range(_ROUNDS):
            inner, outer = begun.copy(), closing.copy()
            inner.update(turn.to_bytes() + str(right).encode())
            outer.update(inner.digest())
            left, right = right, (left + int.from_bytes(outer.digest())) % base
        return left * base + right


def address(secret: str, *parts: str | int) -> int:
    """The number at an address: HMAC-SHA256 of the parts under the secret, as an integer of 256
    bits.
    """
    message = b"".join(map(_frame, parts))
    return int.from_bytes(digest(secret.encode(), message, "sha256"))


@lru_cache(maxsize=64)
def _begin(secret: str, name: bytes) -> tuple[_Hash, _Hash]:
    """HMAC-SHA256 of messages that begin with a name, as far as it is the same for all of them: the
    inner hash and the outer one (RFC 2104). To begin anew takes ten times as long as the rest.
    """
    key = secret.encode()
    block = (key if len(key) <= _BLOCK else sha256(key).digest()).ljust(_BLOCK, b"\0")
    inner, outer = (sha256(bytes(byte ^ pad for byte in block)) for pad in (0x36, 0x5C))
    inner.update(name)
    return inner, outer


@lru_cache(maxsize=4096)
def _frame(part: str | int) -> bytes:
    """A part of an address with its length in front."""
    text = str(part).encode()
    return len(text).to_bytes(4, "big") + text
