"""A folder copied whole, which stops at the first file that cannot be written, as on a disk that is
full.
"""

from __future__ import annotations

import shutil
from pathlib import Path


def copy_tree(source: Path, target: Path) -> None:
    """What stands in a folder, into one that may exist; links stay links. Raises the OSError of the
    first file, with its name: shutil has a list of them without any number.
    """
    failed: list[OSError] = []

    def copy(here: str, there: str) -> str:
        if failed:
            return there
        try:
            return shutil.copy2(here, there)
        except OSError as fault:
            failed.append(fault)
            return there

    shutil.copytree(source, target, symlinks=True, dirs_exist_ok=True, copy_function=copy)
    if failed:
        raise failed[0]
