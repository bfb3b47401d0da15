"""The promised figures, each as a ratio against a peer in this run; `make bench` prints them all.

    python -m benchmarks [startup | one_paper | solving | templates | marking | papers | cycles ...]

The status is 1 if a promise is broken, or if a peer is missing: a promise that is not measured is
not kept.
"""

from __future__ import annotations

import argparse
import sys
from importlib import import_module
from importlib.util import find_spec

from tests.tools import complaint, missing_tools

BENCHMARKS = (
    "startup",
    "one_paper",
    "solving",
    "templates",
    "marking",
    "papers",
    "workers",
    "typesetting",
    "tags",
    "class_commands",
    "cycles",
    "preview",
)


def missing_peer() -> str:
    """One line about what the figures are measured against and is not on this machine, or ""."""
    tools = missing_tools()
    if find_spec("sympy") is not None and tools:
        return complaint(tools)
    for peer in ("sympy", "pylinkage"):
        if find_spec(peer) is None:
            return f"{peer}: not installed; expected the group dev; run pip install --group dev"
    return ""


def main() -> int:
    """Print every figure; 1 when a promise is broken or cannot be measured."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks")
    parser.add_argument("benchmarks", nargs="*", default=BENCHMARKS, metavar="BENCHMARK")
    lacking = missing_peer()
    if lacking:
        print(lacking, file=sys.stderr)
        return 1
    kept = True
    for name in parser.parse_args().benchmarks:
        # loaded here, as a peer that is missing would end the program before it is named
        for figure in import_module(f"benchmarks.{name}").figures():
            print(figure.line(), flush=True)
            kept &= figure.kept
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
