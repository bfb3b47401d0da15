"""`kinegrade check`: templates proved in order, several at a time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from typing import assert_never

from kinegrade.errors import TemplateError
from kinegrade.exam.printing.printable import find_printing_faults
from kinegrade.language.message import Message
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template
from kinegrade.processes.executor import map_in_order
from kinegrade.proof.checking import check
from kinegrade.proof.reporting import write_findings, write_verdict


@dataclass(frozen=True)
class TemplateProof:
    """What `kinegrade check` prints of a template, and whether it is sound."""

    verdict: Message
    findings: tuple[Message, ...]
    sound: bool


def prove_templates(
    names: Iterable[str], sample: int, workers: Executor
) -> Iterator[TemplateProof]:
    """The proofs of the templates of these names (or paths that end in .toml), in order.

    Raises TemplateError for one that cannot be read, when its turn comes.
    """
    return map_in_order(workers, partial(_prove, sample), map(_read, names))


def prove_template(template: Template, sample: int) -> TemplateProof:
    """The proof of a template, by a sample of its draws."""
    report = check(template, sample)
    report.faults += find_printing_faults(report.template)
    findings = tuple(write_findings(report))
    return TemplateProof(write_verdict(report), findings, report.is_sound)


def _read(name: str) -> Template | TemplateError:
    """The template, or the fault of its file, which is raised when its turn comes."""
    try:
        return load_template(name)
    except TemplateError as fault:
        return fault


def _prove(sample: int, template: Template | TemplateError) -> TemplateProof:
    match template:
        case TemplateError():
            raise template
        case Template():
            return prove_template(template, sample)
        case _:
            assert_never(template)
