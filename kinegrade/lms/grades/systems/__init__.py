"""The systems that grades are written for, by the names that `export --to` reads: a table each.

The command line offers these names and no others. The tables know nothing but `dialect`, so that
help answers at once.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.lms.grades.dialect import Dialect
from kinegrade.lms.grades.systems.blackboard import BLACKBOARD
from kinegrade.lms.grades.systems.brightspace import BRIGHTSPACE
from kinegrade.lms.grades.systems.canvas import CANVAS
from kinegrade.lms.grades.systems.edx import EDX
from kinegrade.lms.grades.systems.generic import GENERIC
from kinegrade.lms.grades.systems.moodle import MOODLE
from kinegrade.lms.grades.systems.sakai import SAKAI

SYSTEMS: Mapping[str, Dialect] = {
    "moodle": MOODLE,
    "canvas": CANVAS,
    "blackboard": BLACKBOARD,
    "brightspace": BRIGHTSPACE,
    "sakai": SAKAI,
    "edx": EDX,
    "generic": GENERIC,
}
WORKBOOK = "xlsx"  # no system's file: everything in one spreadsheet
GRADE_FILES = (*SYSTEMS, WORKBOOK)
