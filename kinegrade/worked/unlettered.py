"""Points without a letter on the paper: what stands for a point of a body in translation that
neither the statement nor the figure letters.
"""

from __future__ import annotations

from kinegrade.worked.case import Case


def find_translating_body(point: str, case: Case) -> str | None:
    """The body whose motion is told instead of that of a point: it translates, and the paper has no
    letter for the point; None where the point is told.
    """
    if is_lettered(point, case):
        return None
    bodies = case.motion.frames.mechanism.bodies
    held = (body.name for body in bodies if point in body.points)
    return next((body for body in held if body in case.translating), None)


def is_lettered(point: str, case: Case) -> bool:
    """Whether the figure shows the letter of a point, or the statement has it in a formula."""
    if case.template.figure.labels.get(point, point) is not None:
        return True
    letter = case.naming.point(point)
    texts = case.template.words.statement.texts
    return any(letter in formula for text in texts for formula in text.split("$")[1::2])
