"""`make bench`: the promised figures, each as a ratio against a peer in this run; status 1 if one
is broken.
"""

from __future__ import annotations

import sys

from benchmarks import marking, papers, solving, startup, templates


def main() -> int:
    """Print every figure; 1 when a promise is broken."""
    kept = True
    for module in (startup, solving, templates, marking, papers):
        for figure in module.figures():
            print(figure.line(), flush=True)
            kept &= figure.kept
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
