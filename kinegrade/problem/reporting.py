"""What `kinegrade check` prints of a template."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.problem.checking import Report


def report_lines(report: Report) -> Iterator[str]:
    """The report of one template, a line for each finding."""
    template = report.template
    verdict = "FAULTY" if report.faults else "sound"
    yield f"{template.name}: {verdict}"
    yield f"  published results proved exactly: {report.proved}"
    refused = ", ".join(f"{reason} {count}" for reason, count in sorted(report.refused.items())) or "none"
    yield (f"  drawable combinations: {template.combinations}; examined: "
           f"{report.instances + sum(report.refused.values())}, accepted: {report.instances}, refused: {refused}")
    for name, smallest in report.smallest.items():
        yield f"  {name}: {smallest:.4g} .. {report.largest[name]:.4g} {template.asks[name].unit.printed}"
    for fault in report.faults:
        yield f"  fault: {fault}"
