"""The layout of a marks folder: the names of its files and columns, in one place for writing and
reading.

Columns are found by name, so columns added by a later version do no harm. The
comments that begin with `#:` say what files and columns hold; the reference of docs/ prints them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, Literal, NamedTuple


class TableFile(NamedTuple):
    """A file of the folder that is a table: its columns in the order in which they are written, and
    those that may be missing.
    """

    name: str
    columns: tuple[str, ...]
    optional: tuple[str, ...] = ()


ANSWER_COLUMNS = (
    #: The student's id.
    "student",
    #: The question, `q1`, as in the bank.
    "question",
    #: The ask, `v_B`.
    "ask",
    #: What was typed; an apostrophe stands before what a spreadsheet would run as a formula.
    "response",
    #: The number that was read, in the unit of the ask.
    "read_as",
    #: The unit of the ask.
    "unit",
    #: `right`, `blank`, `mistake` and so on.
    "verdict",
    #: The points earned.
    "points",
    #: The points that could be earned.
    "out_of",
    #: Why, in a sentence.
    "reason",
    #: The identifiers of the known mistakes that lead to this answer.
    "mistakes",
    #: `policy` where the answer was compared by a tolerance of the policy; empty where one that is
    #: accepted, or other points, decided.
    "rule",
)
# grades.csv has a column for each question between these
BEFORE_QUESTIONS = (
    #: The student's id.
    "student",
    #: The student's name.
    "name",
)
AFTER_QUESTIONS = (
    #: The sum of the points.
    "total",
    #: The points that could be earned.
    "out_of",
    #: The share of the points, in per cent.
    "percent",
    #: `marked`, or `absent` for anyone who answered nothing at all.
    "status",
)
#: Columns of grades.csv that stand at its end only where they are needed.
WHERE_NEEDED = (
    #: The points subtracted for being late and for trying again; only where a policy says what that
    #: costs.
    "subtracted",
    #: The grade by the scale of policy or bank; only where one of them has a scale.
    "grade",
)
SUBTRACTED_POINTS, SCALE_GRADE = WHERE_NEEDED
_KEPT_AMOUNTS = ("before", "before_out_of", "by_this_marking", "out_of", "stands")

# Earlier versions named the mistakes and the policy in the reason alone
#: Every answer with its verdict and reason.
ANSWERS: Final = TableFile("marks.csv", ANSWER_COLUMNS, optional=("mistakes", "rule"))
MISTAKE: Final = "mistake"  # the verdict on an answer that known mistakes lead to
NAMES_BETWEEN: Final = " "  # identifiers of mistakes contain no blank
BY_POLICY: Final = "policy"  # the rule of an answer that was not compared by the paper's
# Earlier versions wrote no status
#: The points of each student, question by question, and the total.
GRADES: Final = TableFile(
    "grades.csv",
    (*BEFORE_QUESTIONS, *AFTER_QUESTIONS, *WHERE_NEEDED),
    optional=("percent", "status", *WHERE_NEEDED),
)
#: What a person should look at: where it stands, what is wrong, what was done about it.
COMPLAINTS: Final = TableFile(
    "complaints.csv", ("file", "line", "column", "content", "problem", "done")
)
#: Students who keep an earlier total; only with `--never-lower`.
KEPT: Final = TableFile("kept.csv", ("student", "name", *_KEPT_AMOUNTS, "reason"))
#: Whose line of the key each answer was marked by; only where questions came from a pool.
PUT: Final = TableFile("variants.csv", ("student", "question", "ask", "key_of"))
#: The questions of each paper in their order; only where they differ from the bank's.
PRINTED: Final = TableFile("printed.csv", ("student", "questions"))
# Earlier versions wrote one line a question, with what it is worth as its points
#: Who still lacks a mark by hand for which question: points to be filled in, for `--manual`, which
#: takes them for this exam alone; with the code of the paper where the answers were typed by that,
#: so that the mark follows the paper as they do; only where there are some.
OPEN: Final = TableFile(
    "open.csv",
    ("student", "name", "paper", "question", "out_of", "points", "comment", "exam"),
    optional=("student", "name", "paper", "out_of", "comment", "exam"),
)
# Earlier versions did not say which marks were given by codes
#: Marks by hand, with what the machine gave in the same place, empty where only hands mark, and the
#: code of the paper where the mark was given by that alone, which it follows; only where there are
#: some.
MANUAL: Final = TableFile(
    "manual.csv",
    ("student", "question", "points", "out_of", "machine", "comment", "paper"),
    optional=("paper",),
)
#: Marks by hand for what the policy drops, or for questions that the student's paper holds no
#: longer: they do not count, and do again as soon as that is no longer so; only where there are
#: some.
LEFT_OUT: Final = TableFile("left-out.csv", MANUAL.columns, optional=MANUAL.optional)
#: Questions whose points, as the papers state them, come on top of the maximum; only where there
#: are some.
BONUS: Final = TableFile("bonus.csv", ("question", "points"))
#: What was subtracted from whose total, and why; only where a policy says what being late or trying
#: again costs.
SUBTRACTED: Final = TableFile(
    "subtracted.csv",
    (
        *("student", "name", "submitted", "due", "late_by", "late_percent"),
        *("tries_before", "tries_percent", "points", "reason"),
    ),
)
#: The scale by which grades were given: each grade with the percentage from which on it is given,
#: and whether it passes; only where there is one.
SCALE: Final = TableFile("scale.csv", ("grade", "from", "result"))
#: How often the key had changed before the class was marked, as it was corrected or papers changed
#: hands; only where it had.
CORRECTIONS: Final = TableFile("corrections.csv", ("corrections",))
#: Ids that students had before those of this folder; only where somebody's was changed.
FORMER_IDS: Final = TableFile("former-ids.csv", ("student", "formerly"))
#: By what the exam is known by which the class was marked: commands refuse marks of another one. It
#: tells nothing of the secret.
EXAM: Final = TableFile("exam.csv", ("exam",))
#: Students whose marks come from another exam, such as a make-up exam, with the folder of marks
#: that had them; only where folders were merged.
MERGED: Final = TableFile("merged.csv", ("student", "marks"))
#: What changed in the marks after they were known, totals and answers, when and why; later markings
#: keep it and add to it. Only where a reason was given.
CHANGES: Final = TableFile(
    "changes.csv",
    (
        *("date", "student", "name", "what", "before", "after"),
        *("out_of_before", "out_of_after", "reason"),
    ),
)
QUESTIONS_BETWEEN: Final = " "  # question identifiers contain no blank
#: A copy of the policy; where there was none, a line that says so.
POLICY: Final = "policy.toml"
TABLES: Final = (
    ANSWERS,
    GRADES,
    COMPLAINTS,
    KEPT,
    PUT,
    PRINTED,
    OPEN,
    MANUAL,
    LEFT_OUT,
    BONUS,
    SCALE,
    SUBTRACTED,
    CORRECTIONS,
    FORMER_IDS,
    EXAM,
    MERGED,
    CHANGES,
)
FILES: Final = (*(file.name for file in TABLES), POLICY)
FILLED_IN: Final = (OPEN.name, MANUAL.name)  # which people edit, and `grade` reads again
MARKER: Final = COMPLAINTS.name  # the file by which kinegrade recognises a marks folder

Status = Literal["marked", "absent"]  # absent: answered nothing at all
STATUSES: Final[tuple[Status, ...]] = ("marked", "absent")
FOR_PEOPLE: Final = (GRADES, ANSWERS, COMPLAINTS)
# Besides the questions
_OF_NUMBERS = {"points", "subtracted", "total", "out_of", "percent", "line", "machine"}
TEXT_COLUMNS: Final = (
    frozenset(name for file in (*FOR_PEOPLE, MANUAL) for name in file.columns) - _OF_NUMBERS
)


def make_grades_header(questions: tuple[str, ...], needed: Sequence[str] = ()) -> tuple[str, ...]:
    """The columns of grades.csv for these questions, and those of `WHERE_NEEDED` that are."""
    return (*BEFORE_QUESTIONS, *questions, *AFTER_QUESTIONS, *needed)
