"""CHANGELOG.md: what is new stands under Unreleased, and what is released is history."""

from __future__ import annotations

import re
from hashlib import sha256
from pathlib import Path

CHANGELOG = (Path(__file__).parent.parent / "CHANGELOG.md").read_text(encoding="utf-8")
VERSIONS = re.split(r"^## ", CHANGELOG, flags=re.MULTILINE)[1:]
# Of all that follows the heading of the last release; only a release may change it.
RELEASED = "c53d4549a7ae8b72"


def test_each_version_has_its_kinds_of_change_once_and_in_order() -> None:
    for version in VERSIONS:
        kinds = re.findall(r"^### (.*)$", version, re.MULTILINE)
        assert kinds == sorted(set(kinds)), version.splitlines()[0]
        assert set(kinds) <= {"Added", "Changed", "Fixed", "Removed"}, version.splitlines()[0]


def test_a_change_made_now_is_not_told_of_a_released_version() -> None:
    released = CHANGELOG.partition("\n## 0.2.0")[2]
    assert sha256(released.encode()).hexdigest()[:16] == RELEASED
