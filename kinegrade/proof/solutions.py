"""Whether the worked solution of a template can be written, by every method and for every ask."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.errors import KinegradeError
from kinegrade.language import ENGLISH
from kinegrade.language.message import Fault, Message
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import list_statement_languages
from kinegrade.problem.template.template import METHODS
from kinegrade.proof.answerable import list_values, write_values
from kinegrade.proof.report import Report
from kinegrade.worked.solution import write_worked_solution


def prove_solutions(report: Report) -> Iterator[Fault]:
    """A fault for each method by which the first instance has no worked solution."""
    languages = sorted(list_statement_languages(report.template), key=ENGLISH.__ne__)
    for example in report.examples[:1] if languages else ():
        values = list_values(example)
        whole = solve_template(report.template, values, report.sound)
        for method in METHODS if report.template.scheme.has_mechanism else (None,):
            try:
                write_worked_solution(whole, report.sound, languages[0], method)
            except KinegradeError as error:
                shown, reason = write_values(values), error.faults[0]
                what = Message("template.no-solution", values=shown, reason=reason)
                yield Fault(method or report.template.name, what)
