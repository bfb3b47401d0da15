"""Every proof in full, at seeds that are new every time; `make prove` runs it.

    python -m tests.prove [--minutes 55] [--scale 0.01] [--seed 1] [--only PROOF]

Prints a table of the proofs, each with its first seed and how many cases were run of those that the
proof in full has; below a proof its failures, each as the line that belongs into
`tests/prove/failed_seeds.py`. The status is 1 if there is any. Each proof has as many shares of the
minutes that are left when it begins as its weight says, so that a dear one leaves those after it
their turn; none of its batches begins later: a table with fewer cases than it should have says so by its numbers. A
proof that promises to compare so many things has their number in its row. Every minute stderr has a
line that says how far the proof is, and each failure as soon as it is known.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Sequence
from secrets import randbelow

from tests.prove.outcome import Outcome
from tests.prove.processes import outcomes
from tests.prove.progress import tallied, write_failure
from tests.prove.proof import Proof
from tests.prove.proofs import PROOFS

TITLES = f"{'proof':24}{'seed':>12}{'cases':>8}{'of':>8}{'seconds':>9}{'failures':>10}"
HEADER = f"{TITLES}{'compared':>10}"
SEEDS = 10**9


def main(arguments: Sequence[str] | None = None, proofs: Sequence[Proof] = PROOFS) -> int:
    """Run the proofs, print what came of them; 1 where one failed."""
    wanted = _parser(proofs).parse_args(arguments)
    end = time.monotonic() + 60 * wanted.minutes
    chosen = _chosen(proofs, wanted.only)
    failed = False
    print(HEADER, flush=True)
    for place, proof in enumerate(chosen):
        cases = max(1, round(wanted.scale * proof.cases))
        first = randbelow(SEEDS) if wanted.seed is None else wanted.seed
        begin = time.monotonic()
        shares = sum(each.weight for each in chosen[place:])
        until = begin + (end - begin) * proof.weight / shares
        with tallied(proof, cases) as note:
            seeds = range(first, first + cases)
            found = list(outcomes(proof, seeds, wanted.jobs, until, note))
        lines = [write_failure(proof, each) for each in found if each.fault]
        print(_row(proof, first, found, time.monotonic() - begin), *lines, sep="\n", flush=True)
        failed = failed or bool(lines)
    return 1 if failed else 0


def _chosen(proofs: Sequence[Proof], only: Sequence[str] | None) -> list[Proof]:
    """The proofs named, or all."""
    return [proof for proof in proofs if only is None or proof.name in only]


def _parser(proofs: Sequence[Proof]) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m tests.prove")
    parser.add_argument("--minutes", type=float, default=55.0)
    parser.add_argument("--scale", type=float, default=1.0, help="share of the cases to run")
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    names = [proof.name for proof in proofs]
    parser.add_argument("--only", action="append", choices=names, help="this proof; repeatable")
    return parser


def _row(proof: Proof, first: int, found: Sequence[Outcome], seconds: float) -> str:
    """The row of a proof in the table."""
    failures = sum(bool(each.fault) for each in found)
    compared = sum(each.compared for each in found)
    run = f"{first:12}{len(found):8}{proof.cases:8}{seconds:9.0f}{failures:10}"
    return f"{proof.name:24}{run}{compared or '':>10}".rstrip()


if __name__ == "__main__":
    sys.exit(main())
