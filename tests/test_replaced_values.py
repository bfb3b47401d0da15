"""The type checker tells which `replace` a value takes, and which of its fields there are."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from tests import replaced_values

CODE = """
import dataclasses

import msgspec
from msgspec import structs


class Arm(msgspec.Struct, frozen=True):
    length: float


@dataclasses.dataclass(frozen=True)
class Wheel:
    radius: float


def change(arm: Arm, wheel: Wheel) -> None:
    structs.replace(arm, length=2.0)
    dataclasses.replace(wheel, radius=2.0)
    dataclasses.replace(arm, length=2.0)
    structs.replace(arm, radius=2.0)


def change_either(part: Arm | Wheel) -> None:
    dataclasses.replace(part)
"""
EXPECTED = [
    "changes.py:20: error: Arm is a struct:"
    " msgspec.structs.replace changes it, not dataclasses.replace",
    "changes.py:21: error: Arm has no field radius to change",
    "changes.py:25: error: Arm is a struct:"
    " msgspec.structs.replace changes it, not dataclasses.replace",
]


def test_a_struct_is_changed_by_its_own_replace_and_by_its_fields(tmp_path: Path) -> None:
    (tmp_path / "changes.py").write_text(CODE, encoding="utf-8")
    settings = f"[mypy]\nplugins = {replaced_values.__file__}\n"
    (tmp_path / "mypy.ini").write_text(settings, encoding="utf-8")
    arguments = [sys.executable, "-m", "mypy", "--no-error-summary", "changes.py"]
    result = subprocess.run(arguments, cwd=tmp_path, capture_output=True, text=True, check=False)
    told = [line.split("  [")[0] for line in result.stdout.splitlines()]
    assert told == EXPECTED, result.stderr
