"""The maximum of an item in the system and in the exam: the same, or grades are scaled on request.

A grade above the item's maximum is refused by some systems and cut by others, and one such line
stops a whole import; so none is written.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction

from kinegrade.errors import Problem
from kinegrade.language.message import Fault, Message, Quoted, Text
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.grades import TOTAL, StudentGrade
from kinegrade.numbers.amounts import write_amount


def target_maximum(stated: Fraction | None, options: ExportOptions) -> Fraction | None:
    """The maximum to which grades are scaled: the one given or, with `scale`, the one that the file
    states; otherwise None.
    """
    if options.maximum is not None:
        return Fraction(options.maximum)
    return stated if options.scale else None


def find_most(maxima: Iterable[Fraction]) -> Fraction | None:
    """The largest maximum where not all students could get the same points, else None.

    >>> find_most([Fraction(9), Fraction(9)]), find_most([Fraction(3), Fraction(9), Fraction(0)])
    (None, Fraction(9, 1))
    """
    # By identity first, as hashing a fraction takes longer than the rest
    different = set({id(each): each for each in maxima}.values()) - {0}
    return max(different) if len(different) > 1 else None


def scaled(grade: StudentGrade, item: str, target: Fraction | None) -> Fraction:
    """The points of an item, scaled where there is a target."""
    points, out_of = grade.points[item], grade.out_of[item]
    return points if target is None or not out_of else points * target / out_of


def maximum_faults(
    where: Text,
    item: str,
    students: Iterable[StudentGrade],
    stated: Fraction | None,
    options: ExportOptions,
) -> list[Problem]:
    """Why the grades of an item cannot be written as they are, one line for each reason."""
    graded = tuple(students)
    known = {each.out_of[item] for each in graded}
    several = len(known - {0}) > 1
    scale = _explain_scale(stated, sorted(known - {stated}), several, options)
    unscaled = several and target_maximum(stated, options) is None and stated is None
    return [
        *(Fault(where, fault) for fault in scale),
        *([Fault(where, Message("grades.several-maxima"))] if unscaled else []),
        *_find_above(graded, item),
    ]


def _explain_scale(
    stated: Fraction | None, others: Sequence[Fraction], several: bool, options: ExportOptions
) -> Iterator[Message]:
    """Why grades cannot be scaled, or must be: `others` are maxima that the file does not state,
    `several` says whether students have different ones.
    """
    target = target_maximum(stated, options)
    maximum = None if options.maximum is None else Fraction(options.maximum)
    if maximum is not None and stated not in (None, maximum):
        yield Message("grades.other-maximum", stated=_show(stated), maximum=_show(maximum))
    elif options.scale and target is None:
        yield Message("grades.no-maximum")
    if stated is None or target is not None or not others:
        return
    if several:
        yield Message("grades.scale-several", stated=_show(stated))
    else:
        yield Message("grades.add-scale", stated=_show(stated), exam=_show(others[0]))


def _find_above(students: Sequence[StudentGrade], item: str) -> Iterator[Message]:
    """The students with more points than the item has, unless a bonus may have brought them there:
    then a total that was kept may be as high, too, where the bonus has been dropped since.
    """
    for each in students:
        is_raised = bool(each.bonus) if item == TOTAL else item in each.bonus
        if each.points[item] > each.out_of[item] and not is_raised:
            yield Message(
                "grades.above-maximum",
                student=Quoted(each.student),
                points=_show(each.points[item]),
                maximum=_show(each.out_of[item]),
            )


def _show(amount: Fraction | None) -> str:
    return write_amount(amount or Fraction(0))
