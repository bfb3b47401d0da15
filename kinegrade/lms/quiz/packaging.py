"""Names in packages as learning management systems take them."""

from __future__ import annotations

import re
from hashlib import sha256

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_.-]{0,79}", re.ASCII)
_UNFIT = re.compile(r"[^A-Za-z0-9_-]+", re.ASCII)


def make_stable_name(identifier: str) -> str:
    """An identifier that XML, file systems and URLs accept: unchanged where it is one, otherwise
    always the same one made from it.

    >>> make_stable_name("exam1-q1.v_B"), make_stable_name("../a b")
    ('exam1-q1.v_B', 'i_a_b-2c2c791a06')
    """
    if _NAME.fullmatch(identifier) and ".." not in identifier:
        return identifier
    fingerprint = sha256(identifier.encode("utf-8", "backslashreplace")).hexdigest()[:10]
    written = _UNFIT.sub("_", identifier)[:60]
    return f"{'' if written[:1].isalpha() else 'i'}{written}-{fingerprint}"


def make_pool_name(exam: str) -> str:
    """The name of an exam's pool, which depends on the exam alone, not on its variants.

    >>> make_pool_name("4f0b")
    'pool-4f0b'
    """
    return make_stable_name(f"pool-{exam}")
