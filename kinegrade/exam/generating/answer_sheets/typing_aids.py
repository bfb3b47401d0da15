"""What makes an answer workbook quick to type into: a cell that finds a student's row by the code
of the paper or the id, and for each answer a word on its unit and a warning where no number is
typed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.sax.saxutils import escape, quoteattr

from kinegrade.exam.folder.asks import Ask
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message

HEADER_ROW = 2  # above it stands the finder
_FIRST = HEADER_ROW + 1  # row of a student
_ID, _CODE = "A", "C"  # columns that the finder looks into
_LAST = 20_000  # row in which a student may stand who was added later
_SOUGHT = "$B$1"
# What is typed there as a code without its hyphen, in capitals
_TYPED = f'SUBSTITUTE(SUBSTITUTE(UPPER(TRIM({_SOUGHT})),"-","")," ","")'


def name_column(number: int) -> str:
    """The letters of a column, counted from 1.

    >>> name_column(1), name_column(26), name_column(27), name_column(703)
    ('A', 'Z', 'AA', 'AAA')
    """
    letters = ""
    while number:
        number, letter = divmod(number - 1, 26)
        letters = chr(ord("A") + letter) + letters
    return letters


def find_row_formula(first_answer: str) -> str:
    """A link to the row of the student whose id, or whose paper's code, is typed beside it: codes
    with or without their hyphen, in small letters or capitals. `first_answer` is the column of the
    first answer.

    >>> find_row_formula("D")[:40]
    'IF(TRIM($B$1)="","",IFERROR(HYPERLINK("#'
    """
    sought = f"TRIM({_SOUGHT})"
    by_id = f"MATCH({sought},{_name_area(_ID)},0)"
    # Whole codes: by their ends alone, "B" would find one that begins and ends with it
    by_code = f'MATCH(REPLACE({_TYPED},5,0,"-"),{_name_area(_CODE)},0)'
    row = f"{HEADER_ROW}+IFERROR({by_id},{by_code})"
    link = f'HYPERLINK("#{first_answer}"&({row}),"→ "&({row}))'
    return f'IF({sought}="","",IFERROR({link},"?"))'


def _name_area(column: str) -> str:
    """A column below the header: the formula stands in one of them itself."""
    return f"${column}${_FIRST}:${column}${_LAST}"


def write_highlight(rows: int, width: int) -> str:
    """The row that was found stands out."""
    code = f'SUBSTITUTE(${_CODE}{_FIRST},"-","")'
    own = f"OR(${_ID}{_FIRST}=TRIM({_SOUGHT}),{code}={_TYPED})"
    formula = escape(f'AND(TRIM({_SOUGHT})<>"",{own})')
    area = f"A{_FIRST}:{name_column(width)}{max(HEADER_ROW + rows, _FIRST)}"
    return (
        f'<conditionalFormatting sqref="{area}"><cfRule type="expression" dxfId="0" '
        f'priority="1"><formula>{formula}</formula></cfRule></conditionalFormatting>'
    )


def write_validations(asks: Sequence[Ask], first: int, rows: int, words: Catalogue) -> str:
    """For each ask, from the column numbered `first` on, what is to be typed, and a warning where
    it has no digit.
    """
    each = "".join(_write_each(asks, first, rows, words))
    return f'<dataValidations count="{len(asks)}">{each}</dataValidations>'


def _write_each(asks: Sequence[Ask], first: int, rows: int, words: Catalogue) -> Iterator[str]:
    title = quoteattr(words.text("exam.no-number-typed"))
    warning = quoteattr(words.text("exam.number-expected"))
    for place, ask in enumerate(asks, first):
        column = name_column(place)
        area = f"{column}{_FIRST}:{column}{max(HEADER_ROW + rows, _FIRST)}"
        prompt = quoteattr(words.write(_describe(ask)))
        yield (
            '<dataValidation type="custom" errorStyle="warning" allowBlank="1" '
            f'showInputMessage="1" showErrorMessage="1" errorTitle={title} error={warning} '
            f'promptTitle={quoteattr(ask.column[:32])} prompt={prompt} sqref="{area}">'
            f"<formula1>{escape(_holds_digit(f'{column}{_FIRST}'))}</formula1></dataValidation>"
        )


def _describe(ask: Ask) -> Message:
    """What is to be typed for an ask."""
    if ask.unit == "1":
        return Message("exam.type-number")
    return Message("exam.type-number-in", unit=ask.unit)


def _holds_digit(cell: str) -> str:
    """A formula: whether a cell holds a digit, or only dashes as for a blank."""
    without = cell
    for digit in range(10):
        without = f'SUBSTITUTE({without},"{digit}","")'
    return f'OR(TRIM({cell})="-",LEN({without})<LEN({cell}))'
