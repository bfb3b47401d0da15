"""What `kinegrade check` prints of a template."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.problem.checking import Report
from kinegrade.problem.template_texts import find_languages


def write_report(report: Report) -> Iterator[str]:
    """The report of one template, a line for each finding."""
    template = report.template
    verdict = "FAULTY" if report.faults else "sound"
    yield f"{template.name}: {verdict}"
    yield f"  complete in: {', '.join(find_languages(template)) or 'no language'}"
    yield f"  published results proved exactly: {report.proved}"
    refused = (
        ", ".join(f"{reason} {count}" for reason, count in sorted(report.refused.items())) or "none"
    )
    yield (
        f"  drawable combinations: {template.combinations}; examined: "
        f"{report.instances + sum(report.refused.values())}, accepted: {report.instances}, "
        f"refused: {refused}"
    )
    yield f"  distinct instances: about {report.distinct}; {report.seconds * 1e3:.1f} ms each"
    for name, spread in report.spreads.items():
        yield (
            f"  {name:<12} {min(spread.values):10.4g} .. {max(spread.values):<10.4g} "
            f"{template.asks[name].unit.printed:<7} negative {spread.negative:4.0%}, "
            f"different {len(set(spread.values))}"
        )
    for name, mistakes in report.inseparable.items():
        if mistakes:
            yield f"  {name}: cannot be distinguished from the right answer: {', '.join(mistakes)}"
    for remark in report.remarks:
        yield f"  remark: {remark}"
    for fault in report.faults:
        yield f"  fault: {fault}"
