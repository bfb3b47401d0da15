"""Every shipped template is sound by `check`, whatever instances it looks at."""

from __future__ import annotations

from pathlib import Path

from kinegrade.proof.checking import check
from tests.prove.draws import seeded_template

INSTANCES = 200


def hold(seed: int, _: Path) -> None:
    """Check the template of a seed at instances of that seed."""
    report = check(seeded_template(seed), INSTANCES, secret=f"prove {seed}")
    assert report.faults == [], f"{report.template.name}: {report.faults}"
