"""Claims that fail in each way a claim can, for the tests of the program that runs proofs."""

from __future__ import annotations

import os
import signal
from pathlib import Path


def hold(seed: int, folder: Path) -> int:
    """Every seed ends in 1 fails, in 2 raises, in 3 dies, in 4 takes much memory, in 5 too
    long; the others compare two things.
    """
    match seed % 10:
        case 1:
            assert seed % 10 != 1, f"{seed} ends\nin 1"
        case 2:
            raise ValueError("no such thing")
        case 3:
            os._exit(7)
        case 4:
            len(bytearray(1_100 << 20))
        case 5:
            signal.raise_signal(signal.SIGXCPU)
        case _:
            (folder / "case").write_text(str(seed), encoding="utf-8")
    return 2
