"""The author's proof of a template: its published results hold exactly, and what is drawn is fit
for students.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import islice
from time import perf_counter
from typing import assert_never

from kinegrade.draws.deck import Combination, Deck, make_deck
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.draws.examining import Examined, Reason, Refused
from kinegrade.errors import MechanismError, TemplateError
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.problem.holding import choose_wording, condition_holds
from kinegrade.problem.needs import find_idle_givens
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.statement_faults import find_statement_faults
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import find_unfinished_translations
from kinegrade.proof.answerable import find_answerable, write_values
from kinegrade.proof.assemblies import note_assemblies
from kinegrade.proof.causes import find_causes, write_causes
from kinegrade.proof.claims.circles import note_radii_of_bars
from kinegrade.proof.claims.claims import find_false_claims
from kinegrade.proof.claims.givens import note_angles_in_radians
from kinegrade.proof.claims.kinds import note_kinds_said, note_other_kinds
from kinegrade.proof.claims.swaps import note_printed_answers
from kinegrade.proof.clauses.clauses import find_false_clauses
from kinegrade.proof.contacts import note_lost_contacts
from kinegrade.proof.demanding import describe_demands
from kinegrade.proof.ends import note_points_beyond_ends
from kinegrade.proof.letters import note_letters, note_points_without_letter
from kinegrade.proof.marked_values import find_wrong_marks
from kinegrade.proof.published import prove_published
from kinegrade.proof.reach import find_condition
from kinegrade.proof.report import SECRET, Report
from kinegrade.proof.searching import find_breaking_values
from kinegrade.proof.solutions import prove_solutions
from kinegrade.proof.spread import Copied, Spread
from kinegrade.proof.weighing import count_on, weigh_sample
from kinegrade.students.following.connections import find_connections
from kinegrade.students.near_mistakes import find_near_mistakes
from kinegrade.students.rounding.accuracy import WIDEST

_TEXTS_TRIED = 1000  # draws at which the texts that depend on values are tried
_SEARCHED = 300  # instances that the search for breaking values tries
_RIGHT_ANGLE = 90
_UNLIKE: frozenset[Reason] = frozenset({"condition", "mechanism", "degenerate"})
_EXAMPLES = 10  # instances that are put together in other ways, some milliseconds each
_BEYOND = 2 * WIDEST  # stands for more than any tolerance may give


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
    report.remarks += _list_remarks(template)
    _weigh_texts(report, sample)
    report.faults += asks.faults()
    if asks.stuck and not asks.solved:
        report.faults.append(Message("template.no-drawn-solved", reason=asks.stuck))
        return report
    for published in template.published:
        prove_published(report, published)
    try:
        _draw(report, draws)
    except TemplateError as error:  # its figure marks what is not there
        report.faults += error.faults
        return report
    weigh_sample(report)
    note_assemblies(report)
    report.faults += find_wrong_marks(template, report.examples)
    report.faults += find_false_claims(template, report.examples)
    report.faults += find_false_clauses(template, report.examples)
    report.remarks += note_points_beyond_ends(template, report.examples)
    report.remarks += note_lost_contacts(template, report.examples)
    report.remarks += note_printed_answers(template, report.sound)
    report.remarks += note_radii_of_bars(template, report.examples)
    report.remarks += note_points_without_letter(template, report.examples[:1])
    report.faults += prove_solutions(report)
    _search(report, min(sample, _SEARCHED))
    describe_demands(report)
    report.following = find_connections(template, _select_asked(report))
    return report


def _list_remarks(template: Template) -> Iterator[Message]:
    """What is to be weighed in the file itself."""
    yield from note_letters(template)
    yield from note_other_kinds(template)
    yield from note_kinds_said(template)
    yield from note_angles_in_radians(template)
    for name in find_idle_givens(template):
        yield Message("template.idle-given", given=name)
    if not template.published:
        yield Message("template.no-published")
        return
    given = {name for published in template.published for name in published.gives}
    unproved = [name for name in template.asked() if name not in given]
    if unproved:
        yield Message("template.unproved-asks", asks=list_plainly(unproved))


def _search(report: Report, examples: int) -> None:
    """Look for values that break the template, drawable ones and their neighbours."""
    broken = find_breaking_values(report.template, _select_asked(report), examples, report.secret)
    if broken is not None:
        values, condition = write_values(broken[0]), find_condition(report.template, broken[0])
        kind = "breaks-without" if condition else "breaks-at"
        parts = {"condition": condition} if condition else {}
        report.faults.append(Message(f"template.{kind}", values=values, reason=broken[1], **parts))
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
    """Examine the sample: what is refused and why, how the answers spread, which mistakes cannot be
    distinguished from the truth, how long an instance takes.
    """
    template, asked = report.template, _select_asked(report)
    draw_filter = DrawFilter(template, asked, _check_deck(template, report.secret), {})
    if draw_filter.separation is not None:
        report.near = find_near_mistakes(draw_filter.separation)
    start = perf_counter()
    verdicts = draw_filter.examine(draws)
    report.causes += write_causes(template, find_causes(draws, verdicts), draws)
    for found in verdicts:
        match found:
            case Refused(reason=reason, ask=ask):
                report.refused[reason] += 1
                if reason == "rounding":
                    report.shares.setdefault(ask, []).append(_BEYOND)
            case Examined():
                _note(report, found.solution)
                for name, tolerance in found.tolerances.items():
                    report.shares.setdefault(name, []).append(tolerance.relative)
            case _:
                assert_never(found)
    report.seconds = (perf_counter() - start) / max(report.instances, 1)
    if not report.examples:
        report.examples += islice(_solve_refused(draw_filter, draws, verdicts), _EXAMPLES)
    count_on(report, draw_filter)


def _solve_refused(
    draw_filter: DrawFilter, draws: Sequence[Combination], verdicts: Sequence[Examined | Refused]
) -> Iterator[Solution]:
    """Instances that no paper will have though they move: what the statement says has to hold for
    them, too.
    """
    for values, verdict in zip(draws, verdicts, strict=True):
        if isinstance(verdict, Refused) and verdict.reason not in _UNLIKE:
            with suppress(MechanismError):
                yield draw_filter.dealt.solved(values)


def choose_drawable(template: Template, sample: int, secret: str = SECRET) -> list[Combination]:
    """Values of `sample` different combinations; all of them if there are no more."""
    return _check_deck(template, secret).first(sample)


def _check_deck(template: Template, secret: str) -> Deck:
    """The deck from which a check takes its sample, the first combinations."""
    return make_deck(template, secret, template.name)


def _note(report: Report, solution: Solution) -> None:
    """Count an accepted instance and the spread of its answers."""
    report.instances += 1
    if len(report.examples) < _EXAMPLES:
        report.examples.append(solution)
    known = {Copied("given", name): given for name, given in solution.parameters.items()}
    for name, answer in solution.answers.items():
        report.spreads.setdefault(name, Spread()).note(answer, known)
        known[Copied("ask", name)] = answer
    report.special.update(
        name for name, given in solution.parameters.items() if _makes_easier(given)
    )


def _makes_easier(given: Quantity) -> bool:
    """Whether a given is zero, or an angle whose sine or cosine is."""
    return given.is_zero or (given.unit == "deg" and given.value % _RIGHT_ANGLE == 0)
