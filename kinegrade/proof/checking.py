"""The author's proof of a template: its published results hold exactly, and what is drawn is fit
for students.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from statistics import median
from time import perf_counter

from kinegrade.draws.deck import Combination, Deck, make_deck
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.draws.examining import Refused, examine
from kinegrade.language.message import Fault, Message
from kinegrade.problem.holding import choose_wording, condition_holds
from kinegrade.problem.solution import Solution
from kinegrade.problem.statement import find_statement_faults
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import find_unfinished_translations
from kinegrade.proof.answerable import find_answerable, write_values
from kinegrade.proof.published import prove_published
from kinegrade.proof.report import SECRET, Report
from kinegrade.proof.searching import find_breaking_values
from kinegrade.proof.spread import Spread

_FEWEST = 500  # distinct instances: fewer, and a large class finds out the pattern behind the draws
_TEXTS_TRIED = 1000  # draws at which the texts that depend on values are tried
_SEARCHED = 300  # instances that the search for breaking values tries
_OFTEN_ASTRAY = 0.1  # a share of refused draws that is reported to the author


def check(template: Template, sample: int = 200, secret: str = SECRET) -> Report:
    """Check published results exactly, and `sample` drawn instances (all, where there are no more).

    Another `secret` draws other instances. An ask that cannot be worked out is one fault; what
    follows from it is not reported again.
    """
    draws = choose_drawable(template, sample, secret)
    asks = find_answerable(template, draws)
    report = Report(template, secret, asks.sound)
    report.faults += find_statement_faults(template)
    report.faults += find_unfinished_translations(template)
    _weigh_texts(report, sample)
    if not template.published:
        report.faults.append(Message("template.no-published"))
    report.faults += asks.faults()
    if asks.stuck and not asks.solved:
        report.faults.append(Message("template.no-drawn-solved", reason=asks.stuck))
        return report
    for published in template.published:
        prove_published(report, published)
    _draw(report, draws)
    _weigh(report)
    _search(report, min(sample, _SEARCHED))
    return report


def _search(report: Report, examples: int) -> None:
    """Look for values that break the template, drawable ones and their neighbours."""
    broken = find_breaking_values(report.template, _select_asked(report), examples, report.secret)
    if broken is not None:
        values = write_values(broken[0])
        report.faults.append(Message("template.breaks-at", values=values, reason=broken[1]))
    elif report.refused["mechanism"]:
        report.remarks.append(Message("template.some-cannot-be-solved"))


def _select_asked(report: Report) -> tuple[str, ...]:
    """What an exam asks by default: those asks with points that can be worked out."""
    return tuple(name for name in report.template.asked() if name in report.sound)


def _weigh_texts(report: Report, sample: int) -> None:
    """A fault for the first text that has no wording at drawable values; a remark for each wording
    that never applies.
    """
    template = report.template
    idle = {name: set(range(len(wordings))) for name, wordings in template.words.texts.items()}
    if not template.words.texts:
        return
    for values in choose_drawable(template, max(sample, _TEXTS_TRIED), report.secret):
        if not all(
            condition_holds(template, condition, values) for condition in template.scheme.conditions
        ):
            continue
        for name, wordings in template.words.texts.items():
            found = choose_wording(template, name, values)
            if found is None:
                what = Message("template.no-wording-applies", values=write_values(values))
                report.faults.append(Fault(f"text.{name}", what))
                return
            idle[name].discard(wordings.index(found))
    report.remarks += [
        Message("template.applies-nowhere", wording=f"text.{name}[{index}]")
        for name, indices in idle.items()
        for index in sorted(indices)
    ]


def _draw(report: Report, draws: Sequence[Combination]) -> None:
    """Examine the sample: what is refused and why, how the answers spread, how long an instance
    takes.
    """
    times, plan = [], None
    for values, confused in zip(draws, _look_for_mistakes(report, draws), strict=True):
        if confused:
            report.refused["mistake"] += 1
            continue
        start = perf_counter()
        try:
            solution = examine(report.template, values, _select_asked(report), plan)
        except Refused as refusal:
            report.refused[refusal.reason] += 1
            report.blamed[refusal.reason, refusal.ask] += 1
            continue
        times.append(perf_counter() - start)
        plan = solution.motion.plan
        _note(report, solution)
    report.seconds = median(times) if times else 0.0


def _look_for_mistakes(report: Report, draws: Sequence[Combination]) -> list[bool]:
    """For each draw, whether a known mistake is taken for the truth; the report gets the mistakes
    that cannot be distinguished from it.
    """
    template = report.template
    draw_filter = DrawFilter(
        template, _select_asked(report), _check_deck(template, report.secret), {}
    )
    if draw_filter.separation is not None:
        report.inseparable = draw_filter.separation.inseparable()
    return draw_filter.confused(draws)


def _weigh(report: Report) -> None:
    """Too few instances and constant answers are faults; other answers that are easily guessed are
    remarks.
    """
    if not report.instances:
        report.faults.append(Message("template.no-acceptable-instance"))
    elif report.distinct < _FEWEST:
        report.faults.append(
            Message("template.too-few-instances", number=report.distinct, least=_FEWEST)
        )
    for name, spread in report.spreads.items():
        copied = spread.copied()
        if spread.constant:
            report.faults.append(Message("template.same-answer", ask=name))
        elif copied is not None:
            report.remarks.append(Message("template.equals-given", ask=name, given=copied))
    report.remarks += _find_rounding_remarks(report)


def _find_rounding_remarks(report: Report) -> Iterator[Message]:
    """The asks in which honest rounding often leaves the tolerance."""
    examined = report.instances + sum(report.refused.values())
    for (reason, ask), count in report.blamed.items():
        if reason == "rounding" and count >= _OFTEN_ASTRAY * examined:
            yield Message("template.often-astray", ask=ask, number=count, examined=examined)


def choose_drawable(template: Template, sample: int, secret: str = SECRET) -> list[Combination]:
    """Values of `sample` different combinations; all of them if there are no more."""
    return _check_deck(template, secret).first(sample)


def _check_deck(template: Template, secret: str) -> Deck:
    """The deck from which a check takes its sample, the first combinations."""
    return make_deck(template, secret, template.name)


def _note(report: Report, solution: Solution) -> None:
    """Count an accepted instance and the spread of its answers."""
    report.instances += 1
    for name, answer in solution.answers.items():
        report.spreads.setdefault(name, Spread()).note(answer, solution.parameters)
