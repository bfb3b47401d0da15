"""Statements and figures that contradict the mechanism at the numbers that were dealt: a paper with
such a statement has a wrong key, or none.

`kinegrade check` finds them when a template is written; here they are looked for again where nobody
need have done so: in templates of the instructor's own, and in shipped ones to which the bank gives
values that they do not list.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice

from kinegrade.exam.bank.blueprint import BankQuestion
from kinegrade.exam.setting.dealing import ClassDeal
from kinegrade.files.fields.document import read_text
from kinegrade.language.message import Fault, Message
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.library.library import find_shipped
from kinegrade.problem.template.sections.opening import TEMPLATE
from kinegrade.problem.template.template import Template

_TRIED = 10  # papers, as many as `check` looks at


def list_contradictions(dealt: ClassDeal) -> Iterator[Fault]:
    """A complaint for each thing that the statement or the figure of a question says and that is
    not so on some papers.
    """
    for question in dealt.bank.questions:
        if question.template.scheme.has_mechanism and not _is_proved(question):
            where = f"{question.identifier} ({question.template.name})"
            for fault in _find_contradictions(question.template, _solve(dealt, question)):
                said = replace(fault, do=fault.do or Message("exam.correct-statement"))
                yield Fault(where, said)


def _is_proved(question: BankQuestion) -> bool:
    """Whether the template is a shipped one, at values that it lists itself."""
    template = question.template
    path = find_shipped("templates") / f"{template.name}.toml"
    listed = all(
        set(values) <= set(template.parameters[name].choices)
        for name, values in question.domains.items()
    )
    return listed and path.exists() and read_text(path, TEMPLATE) == template.file.text


def _solve(dealt: ClassDeal, question: BankQuestion) -> list[Solution]:
    """The instances of a few papers."""
    name = question.identifier
    draws = {(*each.values(),): each for each in dealt.values[name].values()}
    return [dealt.exam.filters[name].dealt.solved(each) for each in islice(draws.values(), _TRIED)]


def _find_contradictions(template: Template, examples: list[Solution]) -> Iterator[Fault]:
    """What `check` says of them."""
    # Their patterns take a second to be made, and most banks have shipped templates alone
    from kinegrade.proof.claims.claims import find_false_claims  # noqa: PLC0415
    from kinegrade.proof.clauses.clauses import find_false_clauses  # noqa: PLC0415
    from kinegrade.proof.marked_values import find_wrong_marks  # noqa: PLC0415

    yield from find_wrong_marks(template, examples)
    yield from find_false_claims(template, examples)
    yield from find_false_clauses(template, examples)
