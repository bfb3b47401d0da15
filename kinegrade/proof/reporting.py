"""What `kinegrade check` prints of a template."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kinegrade.draws.deal import count_reasons
from kinegrade.language.message import Message, list_plainly
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import (
    find_languages,
    find_unstated_texts,
    is_language_named,
)
from kinegrade.proof.report import Report
from kinegrade.students.near_mistakes import Shares


def write_verdict(report: Report, name: str = "") -> Message:
    """Whether the template is sound, and proved by a published result, under its name or another;
    undecided where no draw was accepted.
    """
    name = name or report.template.name
    if report.faults:
        return Message("template.report-faulty", name=name)
    if not report.is_sound:
        return Message("template.report-undecided", name=name)
    if not report.template.published:
        return Message("template.report-unproved", name=name)
    return Message("template.report-sound", name=name)


def write_findings(report: Report) -> Iterator[Message]:
    """What was found, a line each."""
    yield _write_languages(report.template)
    yield Message("template.report-proved", number=report.proved - report.rounded)
    if report.rounded:
        yield Message("template.report-rounded", number=report.rounded)
    yield Message(
        "template.report-examined",
        combinations=report.template.combinations,
        examined=report.examined,
        accepted=report.instances,
        refused=count_reasons(dict(sorted(report.refused.items()))),
    )
    milliseconds = f"{report.seconds * 1e3:.1f}"
    yield Message("template.report-distinct", number=report.distinct, milliseconds=milliseconds)
    if report.demands is not None:
        yield report.demands
    yield from report.causes
    yield from _write_spreads(report)
    yield from report.assemblies
    yield from _write_near_mistakes(Message("template.report-refused"), report.near.refused)
    yield from _write_near_mistakes(Message("template.report-inseparable"), report.near.passing)
    if report.following:
        yield Message("template.report-following")
    for name, others in report.following.items():
        yield Message("template.report-follows", ask=f"  {name}", others=list_plainly(others))
    for remark in report.remarks:
        yield Message("template.report-remark", remark=remark)
    for fault in report.faults:
        yield Message("template.report-fault", fault=fault)


def _write_languages(template: Template) -> Message:
    if not is_language_named(template):
        return Message("template.report-one-language")
    unstated = find_unstated_texts(template)
    if unstated:
        return Message("template.unstated-language", names=list_plainly(unstated))
    languages = find_languages(template)
    complete = list_plainly(languages) if languages else Message("template.no-language")
    return Message("template.report-languages", languages=complete)


def _write_near_mistakes(heading: Message, found: Mapping[str, Shares]) -> Iterator[Message]:
    """The heading and a line for each ask of which there are any; nothing where there are none."""
    lines = [
        Message(
            "template.report-shares",
            ask=f"  {name}",
            mistakes=list_plainly([f"{mistake} {share:.1%}" for mistake, share in shares.items()]),
        )
        for name, shares in found.items()
        if shares
    ]
    yield from [heading, *lines] if lines else ()


def _write_spreads(report: Report) -> Iterator[Message]:
    for name, spread in report.spreads.items():
        unit = report.template.asks[name].unit.printed
        yield Message(
            "template.report-spread",
            ask=f"{name:<12} {min(spread.values):10.4g} .. {max(spread.values):<10.4g} {unit:<7}",
            negative=f"{spread.negative:4.0%}",
            different=len(set(spread.values)),
        )
