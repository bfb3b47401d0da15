"""The report on answers that fit other papers: a table, and a few sentences on what it means and
does not mean.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.csv_writing import encode_for_people, neutralise, write_csv_text
from kinegrade.grading.sharing import MOST, QUESTIONS, Pair, Sharing

HEADER = (
    "student", "name", "other", "other_name", "wrong_answers", "fit_the_other_paper",
    "expected_by_chance",
    "right_there", "right_there_expected", "chance_in_the_class", "answers", "note",
)  # fmt: skip
NOTE = "worth a look; not evidence of anything by itself"


def write_sharing_csv(sharing: Sharing) -> bytes:
    """A CSV file with a line for each pair; cells that a spreadsheet might run are made harmless,
    ids stay unchanged.
    """
    return encode_for_people(write_csv_text(HEADER, map(_write_row, sharing.reported)))


def _write_row(pair: Pair) -> tuple[str, ...]:
    right = sum(answer.as_key for answer in pair.answers)
    return (
        pair.student.student, neutralise(pair.student.name),
        pair.other.student, neutralise(pair.other.name),
        str(pair.wrong), str(len(pair.answers)), f"{pair.expected:.2g}",
        str(right), f"{pair.as_key_expected:.2g}",
        f"{pair.chance:.1e}", neutralise("; ".join(_write_answers(pair))), NOTE,
    )  # fmt: skip


def _write_answers(pair: Pair) -> Iterator[str]:
    for answer in pair.answers:
        yield (
            f"{answer.column} {answer.typed.strip()} "
            f"({'right' if answer.as_key else 'a known mistake'} there)"
        )


def write_sharing_text(sharing: Sharing) -> str:
    """The same for a person, without names: how much was found, and how it may and may not be
    read.
    """
    return "\n".join(_write_sentences(sharing))


def _write_sentences(sharing: Sharing) -> Iterator[str]:
    count, level = sharing.found, f"{100 * sharing.level:g} %"
    if count:
        pairs = "1 pair is" if count == 1 else f"{count:,} pairs are"
        yield (
            f"{pairs} worth a look, of {sharing.pairs:,}: more of a student's wrong answers fit "
            "the other's paper than chance explains. Of 100 classes without any sharing, about "
            f"{100 * sharing.level:g} would show a pair too."
        )
        yield (
            "This is a hint, not evidence of anything by itself: it does not say who gave and "
            "who took, or that any student did. Look at the scripts and hear the students before "
            "you conclude anything."
        )
    else:
        yield (
            f"No pair of students stands out, of {sharing.pairs:,}, at the level of {level} for "
            "the whole class."
        )
    if count > MOST:
        yield f"The file has the {MOST:,} most striking ones."
    yield from _write_limits(sharing)


def _write_limits(sharing: Sharing) -> Iterator[str]:
    """What this exam cannot show."""
    if sharing.questions < QUESTIONS:
        yield (
            "An exam of one question shows nothing here: misreading one number gives all "
            "the answers of a paper that has that number."
        )
    if sharing.papers < sharing.students:
        yield (
            f"{sharing.students:,} students had {sharing.papers:,} different papers: answers "
            "passed on between identical papers leave no trace, and where few papers differ, "
            "hardly anything stands out."
        )
