"""A feedback sheet as Markdown (GitHub's tables, `$...$` math), for systems that take text."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from urllib.parse import quote

from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.sheet import FeedbackQuestion, FeedbackRow, FeedbackSheet

_SPECIAL = re.compile(
    r"([\\`*_\[\]<>#|$&~^@]|(?<=[A-Za-z]):(?=//)|(?<=www)\.|!(?=\[)|^[-+=])", re.IGNORECASE
)
_NUMBERED = re.compile(r"^([0-9]+)([.)])(?=\s|$)")
_COLUMNS = ("asked", "yours", "right", "verdict", "points")
_CONTROLS = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]+")


def write_feedback_markdown(sheet: FeedbackSheet) -> str:
    """The sheet as text; nothing a student typed is interpreted as Markdown or HTML."""
    words = open_catalogue(sheet.language).raw("feedback", "sheet.")
    fields = (
        (words["name"], sheet.name),
        (words["student"], sheet.student),
        (words["paper"], sheet.code),
    )
    course = f"{sheet.course} · {sheet.date}" if sheet.date else sheet.course
    lines = [
        f"# {_write_plain(sheet.title)}: {words['feedback']}",
        "",
        _write_plain(course),
        "",
        " · ".join(f"{label}: **{_write_plain(value)}**" for label, value in fields),
        "",
        " · ".join(_write_result(sheet, words)),
        "",
    ]
    for question in sheet.questions:
        lines += _write_question(question, words)
    if sheet.subtracted:
        lines += [_write_plain(sheet.subtracted), ""]
    if sheet.kept:
        lines += [words["kept"], ""]
    if sheet.guesses:
        lines += [words["about-hints"], ""]
    if sheet.solution:
        lines += [f"[{words['solution']}]({quote(sheet.solution)})", ""]
    return "\n".join(lines)


def _write_result(sheet: FeedbackSheet, words: Mapping[str, str]) -> Iterator[str]:
    """The total, and the grade where there is one."""
    yield f"**{words['total']}: {sheet.total}**"
    if sheet.grade:
        yield f"**{words['grade']}: {_write_plain(sheet.grade)}**"


def _write_plain(text: str) -> str:
    r"""Text that Markdown prints as it is, on one line.

    >>> print(_write_plain("<b>|_x_$"))
    \<b\>\|\_x\_\$
    """
    line = _SPECIAL.sub(r"\\\1", _CONTROLS.sub(" ", text).strip())
    return _NUMBERED.sub(r"\1\\\2", line)


def _write_question(question: FeedbackQuestion, words: Mapping[str, str]) -> Iterator[str]:
    title = f" · {question.title}" if question.title else ""
    yield f"## {_write_plain(question.heading)}{title} ({question.points})"
    yield ""
    if question.note:
        yield _write_plain(question.note)
        yield ""
    if question.givens:
        yield f"{words['givens']}: {question.givens}"
        yield ""
    if question.rows:
        yield _write_cells([words[column] for column in _COLUMNS])
        yield "|---|---|---|---|---:|"
        yield from (_write_cells(_write_row(row, words["none"])) for row in question.rows)
        yield ""


def _write_row(row: FeedbackRow, none: str) -> Sequence[str]:
    typed = _write_plain(row.typed) or f"*{none}*"
    read = f" ({_write_plain(row.read_as)})" if row.read_as else ""
    remarks = [row.remark.replace("|", r"\|"), _write_plain(row.reason)]
    verdict = (
        ". ".join((f"**{_write_plain(row.verdict)}**", " ".join(filter(None, remarks))))
        if any(remarks)
        else (f"**{_write_plain(row.verdict)}**")
    )
    return (
        " · ".join(filter(None, (f"${row.symbol}$ {row.meaning}".rstrip(), row.sign))),
        f"{typed}{read}",
        _write_right(row),
        f"{row.mark} {verdict}",
        row.points,
    )


def _write_right(row: FeedbackRow) -> str:
    exact = f"${row.exact}$" if row.exact else ""
    allowed = f"({row.allowed})" if row.allowed else ""
    return " ".join(filter(None, (exact, _write_plain(row.right), allowed)))


def _write_cells(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
