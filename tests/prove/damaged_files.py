"""A damaged file is refused, or read with everyone in it: no crash, no hang, nobody lost."""

from __future__ import annotations

from pathlib import Path

from tests.fuzz.case import fault_of_case
from tests.fuzz.doors import write_material


def hold(seed: int, folder: Path) -> None:
    """Send the damaged file of a seed through its door; the folder keeps the undamaged ones."""
    material = folder / "material"
    if not material.exists():
        material.mkdir()
        write_material(material)
    fault = fault_of_case(seed, material, folder / "case")
    assert not fault, fault
