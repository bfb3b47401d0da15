"""kinegrade: exams in planar kinematics, drawn per student, solved exactly, typeset and marked.

>>> import kinegrade
>>> kinegrade.template("slider-crank").solve(r="1/5", phi=60)["v_B"].exact
'2*sqrt(3)/15'
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kinegrade.problem.problem import Problem

__version__ = "0.1.0"
__all__ = ["__version__", "template"]


def template(name: str) -> Problem:
    """The problem with that name (see `kinegrade list`), or from that path of a template file.
    Raises TemplateError.
    """
    from kinegrade.problem.problem import Problem

    return Problem.load(name)
