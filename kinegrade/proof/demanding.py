"""What a template takes to solve, as the check says it, and the tags that follow from it."""

from __future__ import annotations

from kinegrade.choosing.demands import LEVELS, find_demands, suggest_tags
from kinegrade.errors import MechanismError
from kinegrade.language.message import Message, Quoted, list_plainly
from kinegrade.problem.template.tags import Tag, find_misspelt_tags
from kinegrade.proof.report import Report


def describe_demands(report: Report) -> None:
    """What solving takes, and the tags by which banks would find it."""
    if not report.template.scheme.has_mechanism:
        return
    try:
        demands = find_demands(report.template)
    except MechanismError as error:
        reason = error.faults[0]
        report.remarks.append(Message("template.no-default-solved", reason=reason))
        return
    difficulty, minutes = demands.difficulty, demands.minutes
    report.demands = Message(
        "choosing.shown-difficulty", difficulty=difficulty, most=LEVELS, count=minutes
    )
    family = report.template.about.family
    if family != family.lower():
        names = {"family": Quoted(family), "small": Quoted(family.lower())}
        report.remarks.append(Message("template.family-capitals", **names))
    report.remarks += map(_describe_misspelt, find_misspelt_tags(report.template))
    tags = suggest_tags(report.template, demands)
    if tags:
        report.remarks.append(Message("template.tags-lacking", tags=list_plainly(tags)))


def _describe_misspelt(tags: tuple[str, Tag]) -> Message:
    own, known = map(Quoted, tags)
    return Message("template.tag-misspelt", own=own, known=known)
