"""What an instructor may write in a policy's file: its keys, and those of its tables.

The comments that begin with `#:` say what each key is for; the reference of docs/ prints them.
"""

from __future__ import annotations

POLICY = (
    #: Which of a student's rows counts: `last` (as without a policy), `first` or `best`.
    "attempts",
    #: How far an answer may be off; what is not stated stays as on the paper.
    "tolerance",
    #: Shares of the points for answers that are not right.
    "credit",
    #: Which grades totals earn: a table `[scale]`, in place of the bank's.
    "scale",
    #: What being late costs: a table `[late]`.
    "late",
    #: What each submission after the first costs: a table `[tries]`.
    "tries",
    #: Rules for single questions: tables `[questions.q1]`.
    "questions",
)
QUESTION = (
    #: How far an answer to this question may be off.
    "tolerance",
    #: Shares of the points in this question.
    "credit",
    #: `drop` takes the question's points out of everyone's total; `full` gives them to everyone who
    #: handed in answers.
    "void",
    #: Rules for single asks: tables `[questions.q1.asks.v_B]`.
    "asks",
)
QUESTION_BY_HAND = (
    #: `drop` leaves a question that only hands mark out of the marking; its points are given in a
    #: file of marks.
    "void",
)
ASK = (
    #: How far this answer may be off.
    "tolerance",
    #: Shares of the points of this ask.
    "credit",
    #: `drop` or `full`, as for a question.
    "void",
    #: Points in place of those on the paper.
    "points",
    #: Further answers that count, each a table.
    "accept",
)
ACCEPTED = (
    #: The answer: a number, or an expression of this paper's parameters and right answers, in SI
    #: units.
    "value",
    #: The unit of a number; that of the ask where it is not stated, or where the value has givens.
    "unit",
    #: Its share of the points; all of them where it is not stated.
    "credit",
    #: Whether later answers that follow from it count as following: `true`, as where it is not
    #: stated, or `false`.
    "leads",
    #: The id of the student for whom it counts, or a list of ids; everyone where it is not stated.
    "student",
)
