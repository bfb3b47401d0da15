"""What the sample of a check says of a template: too few instances, answers that need not be worked
out, draws easier than others, tolerances that are too narrow.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.draws.examining import Examined
from kinegrade.language.message import Message
from kinegrade.numbers.tolerance import ONE_PER_CENT, USUAL_CARRY
from kinegrade.proof.report import Report
from kinegrade.students.rounding.accuracy import USUALLY, WIDEST, find_usual_share

_FEWEST = 500  # distinct instances: fewer, and a large class finds out the pattern behind the draws
_FIRST_COUNTED = 200  # draws: fewer were asked for to have a quick look, and may not tell; from
# so many on as many more are counted as it takes
_MOST_COUNTED = 2000
_COUNTED_TOGETHER = 100
_SELDOM = 0.1  # of draws accepted: below it, exams take long to generate
_OFTEN = 0.1  # of the instances in which a sense is not marked
_FEW = 0.02  # a share of draws, or of all others, that chance may leave unlike the rest


def weigh_sample(report: Report) -> None:
    """Too few instances are a fault, and answers with points that need not be worked out."""
    _weigh_number(report)
    if 0 < report.instances < _SELDOM * report.examined:
        report.remarks.append(
            Message("template.seldom-accepted", accepted=report.instances, examined=report.examined)
        )
    complete = report.examined == report.template.combinations
    for name, spread in report.spreads.items():
        if spread.is_constant(vanishes=report.template.asks[name].vanishes, complete=complete):
            report.faults.append(Message("template.same-answer", ask=name))
        elif spread.copied is not None:
            report.faults.append(
                Message(f"template.equals-{spread.copied.kind}", ask=name, other=spread.copied.name)
            )
    report.faults += _find_unmarked_senses(report)
    report.remarks += _find_uneven_remarks(report)
    report.remarks += _find_rounding_remarks(report)


def count_on(report: Report, draw_filter: DrawFilter) -> None:
    """Count further draws until it is certain whether there are too few distinct instances, so that
    the verdict does not depend on which were drawn.
    """
    deck = draw_filter.deck
    most = min(deck.size, _MOST_COUNTED)
    while (
        _FIRST_COUNTED <= report.counted < most and report.bounds[0] < _FEWEST <= report.bounds[1]
    ):
        stop = min(report.counted + _COUNTED_TOGETHER, most)
        draws = [deck.combination(each) for each in range(report.counted, stop)]
        found = draw_filter.examine(draws)
        report.further.update(isinstance(each, Examined) for each in found)


def _weigh_number(report: Report) -> None:
    """Too few instances are a fault; a remark where too few draws were counted to tell."""
    fewest, most = report.bounds
    if fewest >= _FEWEST:
        return
    if most >= _FEWEST:
        numbers = {"accepted": report.accepted, "examined": report.counted, "least": _FEWEST}
        needed = (
            min(report.template.combinations, _FIRST_COUNTED)
            if report.counted < _FIRST_COUNTED
            else report.count_needed(_FEWEST)
        )
        report.remarks.append(Message("template.sample-too-small", needed=needed, **numbers))
    elif report.instances:
        report.faults.append(
            Message("template.too-few-instances", number=report.distinct, least=_FEWEST)
        )
    else:
        report.faults.append(Message("template.no-acceptable-instance"))


def _find_unmarked_senses(report: Report) -> Iterator[Message]:
    """The asks in which larger terms cancel, a share of which is allowed, so that zero and the
    other sense count as right.
    """
    for ask, spread in report.spreads.items():
        share = report.near.passing.get(ask, {}).get("sense-reversed", 0.0)
        told = sum(value != 0 for value in spread.values)
        marked = report.template.asks[ask].points > 0
        if marked and share >= _OFTEN and 2 * told > len(spread.values):
            yield Message("template.sense-not-marked", ask=ask, share=f"{share:.0%}")


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
