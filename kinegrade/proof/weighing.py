"""What the sample of a check says of a template: too few instances, answers that need not be worked
out, draws easier than others, tolerances that are too narrow.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.message import Message
from kinegrade.numbers.tolerance import ONE_PER_CENT, USUAL_CARRY
from kinegrade.proof.report import Report
from kinegrade.students.rounding.accuracy import USUALLY, WIDEST, find_usual_share

_FEWEST = 500  # distinct instances: fewer, and a large class finds out the pattern behind the draws
_SELDOM = 0.1  # of draws accepted: below it, exams take long to generate
_FEW = 0.02  # a share of draws, or of all others, that chance may leave unlike the rest


def weigh_sample(report: Report) -> None:
    """Too few instances are a fault, and answers with points that need not be worked out."""
    _weigh_number(report)
    if 0 < report.instances < _SELDOM * report.examined:
        report.remarks.append(
            Message("template.seldom-accepted", accepted=report.instances, examined=report.examined)
        )
    for name, spread in report.spreads.items():
        if spread.is_constant(vanishes=report.template.asks[name].vanishes):
            report.faults.append(Message("template.same-answer", ask=name))
        elif spread.copied is not None:
            report.faults.append(
                Message(f"template.equals-{spread.copied.kind}", ask=name, other=spread.copied.name)
            )
    report.remarks += _find_uneven_remarks(report)
    report.remarks += _find_rounding_remarks(report)


def _weigh_number(report: Report) -> None:
    """Too few instances are a fault; a remark where the sample is too small to tell."""
    if report.distinct >= _FEWEST:
        return
    if report.possible >= _FEWEST:
        numbers = {"accepted": report.instances, "examined": report.examined, "least": _FEWEST}
        needed = report.count_needed(_FEWEST)
        report.remarks.append(Message("template.sample-too-small", needed=needed, **numbers))
    elif report.instances:
        report.faults.append(
            Message("template.too-few-instances", number=report.distinct, least=_FEWEST)
        )
    else:
        report.faults.append(Message("template.no-acceptable-instance"))


def _find_uneven_remarks(report: Report) -> Iterator[Message]:
    """The givens that make some draws easier than others."""
    for name, count in report.special.items():
        share = count / report.instances
        if _FEW <= share <= 1 - _FEW:
            yield Message("template.easier-in-some", given=name, share=f"{share:.0%}")


def _find_rounding_remarks(report: Report) -> Iterator[Message]:
    """The asks for which 1 % is often not enough, with the tolerance that is."""
    for ask, shares in report.shares.items():
        kept = sum(share <= ONE_PER_CENT.relative for share in shares)
        if kept > USUALLY * len(shares):
            continue
        enough = find_usual_share(shares)
        advice = (
            Message("template.tolerance-enough", share=enough * 100)
            if enough <= WIDEST
            else Message("template.no-tolerance-enough")
        )
        yield Message(
            "template.often-astray",
            ask=ask,
            figures=USUAL_CARRY,
            number=kept,
            examined=len(shares),
            advice=advice,
        )
