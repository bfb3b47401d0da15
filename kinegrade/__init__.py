"""kinegrade: exams in planar kinematics, drawn per student, solved exactly, typeset and marked.

>>> import kinegrade
>>> kinegrade.template("slider-crank").solve(r="1/5", phi=60)["v_B"].exact
'2*sqrt(3)/15'

The names below are all that is meant for programs and notebooks; the commands of the same names are
made of them. Each is loaded when it is first used. What they refuse raises KinegradeError, whose
text is what the terminal says.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kinegrade.errors import KinegradeError
    from kinegrade.exam.generating.options import GenerateOptions
    from kinegrade.exam.roster.roster import Roster
    from kinegrade.lms.grades.dialect import ExportOptions
    from kinegrade.public.assigning import ExchangeOptions, assign, exchange
    from kinegrade.public.bank import Bank
    from kinegrade.public.class_page import report
    from kinegrade.public.entries import compare_entries
    from kinegrade.public.exporting import export
    from kinegrade.public.generating import add_students, generate
    from kinegrade.public.marking import GradeOptions, grade
    from kinegrade.public.opening import open_exam, open_marks
    from kinegrade.public.problem import template
    from kinegrade.public.quizzes import QuizOptions, quiz
    from kinegrade.public.sheets import FeedbackOptions, feedback

__version__ = "0.2.0"
__all__ = [
    "Bank",
    "ExchangeOptions",
    "ExportOptions",
    "FeedbackOptions",
    "GenerateOptions",
    "GradeOptions",
    "KinegradeError",
    "QuizOptions",
    "Roster",
    "__version__",
    "add_students",
    "assign",
    "compare_entries",
    "exchange",
    "export",
    "feedback",
    "generate",
    "grade",
    "open_exam",
    "open_marks",
    "quiz",
    "report",
    "template",
]
_HOMES = {
    "Bank": "public.bank",
    "ExchangeOptions": "public.assigning",
    "ExportOptions": "lms.grades.dialect",
    "FeedbackOptions": "public.sheets",
    "GenerateOptions": "exam.generating.options",
    "GradeOptions": "public.marking",
    "KinegradeError": "errors",
    "QuizOptions": "public.quizzes",
    "Roster": "exam.roster.roster",
    "add_students": "public.generating",
    "assign": "public.assigning",
    "compare_entries": "public.entries",
    "exchange": "public.assigning",
    "export": "public.exporting",
    "feedback": "public.sheets",
    "generate": "public.generating",
    "grade": "public.marking",
    "open_exam": "public.opening",
    "open_marks": "public.opening",
    "quiz": "public.quizzes",
    "report": "public.class_page",
    "template": "public.problem",
}


def __getattr__(name: str) -> object:
    """A public name, loaded when it is first used. Raises AttributeError for another one."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return __all__
