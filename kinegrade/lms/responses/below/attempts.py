"""The attempts of a student in a table of answers one below the other: what was handed in at one
time is one attempt, and so is all of it where no ask is answered at two times.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from kinegrade.deadlines.moment import parse_moment
from kinegrade.files.cell_text import is_answered, trim
from kinegrade.files.rows.row import Row
from kinegrade.lms.responses.times import read_times


@dataclass
class LongAttempt:
    """What was gathered of a student at one time: the first row, and for each ask the row of its
    answer; `time` is "" where the rows have none. `others` are the attempts that were found to
    belong to it although they have other times.
    """

    first: Row
    time: str
    answers: dict[str, Row] = field(default_factory=dict)
    others: tuple[LongAttempt, ...] = ()


def settle_attempts(attempts: Sequence[LongAttempt], answer: int) -> Sequence[LongAttempt]:
    """The attempts as they count, of which `answer` is the column of the answers: one, at the last
    of the times, where no ask is answered in two of them. Where it is not certain which time is
    the last, they stay apart.
    """
    if len(attempts) == 1 or _overlap(attempts, answer):
        return attempts
    last = _find_last([attempt for attempt in attempts if attempt.time])
    return attempts if last is None else [_unite(attempts, last, answer)]


def _overlap(attempts: Iterable[LongAttempt], answer: int) -> bool:
    """Whether an ask is answered in two of the attempts."""
    answered = [
        ask
        for attempt in attempts
        for ask, row in attempt.answers.items()
        if is_answered(trim(row.cell(answer)))
    ]
    return len({*answered}) < len(answered)


def _find_last(timed: Sequence[LongAttempt]) -> LongAttempt | None:
    """The attempt with the last time; None where that is not certain."""
    texts, _ = read_times(attempt.time for attempt in timed)
    moments = [parse_moment(text) for text in texts]
    known = [moment for moment in moments if moment is not None]
    if len(known) < len(timed) or len({moment.tzinfo is None for moment in known}) > 1:
        return timed[0] if len(timed) == 1 else None
    return timed[known.index(max(known))]


def _unite(attempts: Sequence[LongAttempt], last: LongAttempt, answer: int) -> LongAttempt:
    """One attempt of several, at the time of the last."""
    answers: dict[str, Row] = {}
    for attempt in attempts:
        for ask, row in attempt.answers.items():
            if ask not in answers or is_answered(trim(row.cell(answer))):
                answers[ask] = row
    others = tuple(each for each in attempts if each.time and each is not last)
    return LongAttempt(attempts[0].first, last.time, answers, others)
