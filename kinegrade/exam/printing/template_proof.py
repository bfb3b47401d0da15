"""`kinegrade check`: templates proved in order, several at a time."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import assert_never

from kinegrade.errors import TemplateError
from kinegrade.exam.printing.printable import find_printing_faults
from kinegrade.language.message import Message
from kinegrade.problem.template.library.library import find_template_names, load_template
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
    names = tuple(names)
    return map_in_order(
        workers, partial(_prove, sample), zip(_tell_apart(names), map(_read, names), strict=True)
    )


def prove_template(template: Template, sample: int, name: str = "") -> TemplateProof:
    """The proof of a template, by a sample of its draws, under its own name or another."""
    report = check(template, sample)
    report.faults += find_printing_faults(report.template)
    report.remarks += _note_shipped_name(template)
    findings = tuple(write_findings(report))
    return TemplateProof(write_verdict(report, name), findings, report.is_sound)


def _tell_apart(names: Sequence[str]) -> Iterator[str]:
    """The names of templates; the paths of different files that share one."""
    times = Counter(Path(name).stem for name in set(names))
    return (Path(name).stem if times[Path(name).stem] == 1 else name for name in names)


def _note_shipped_name(template: Template) -> Iterator[Message]:
    """A remark where a template has the name of a shipped one, and another text."""
    name = template.name
    if name in find_template_names() and load_template(name).file.text != template.file.text:
        yield Message("template.shadows-shipped", name=name)


def _read(name: str) -> Template | TemplateError:
    """The template, or the fault of its file, which is raised when its turn comes."""
    try:
        return load_template(name)
    except TemplateError as fault:
        return fault


def _prove(sample: int, named: tuple[str, Template | TemplateError]) -> TemplateProof:
    name, template = named
    match template:
        case TemplateError():
            raise template
        case Template():
            return prove_template(template, sample, name)
        case _:
            assert_never(template)
