"""What a person wants at each step of a term, from choosing problems to next year's exam.

`test_rows.py` holds that each row is asserted by a test named for it, `test_row_NUMBER_...`, or is
still to come.
"""

from __future__ import annotations

from collections.abc import Mapping

#: By the number of the step, what is wanted.
ROWS: Mapping[int, str] = {
    1: "choosing: filters, difficulty, minutes, tags shown and listed",
    2: "an own bank: a starter with every key",
    3: "the header: university, logo, duration, aids, instructions",
    4: "some values, fixed values, the same numbers for all, two templates in one slot: possible,"
    " and said what it costs",
    5: "a theory question beside the others, and one with numbers of its own",
    6: "working space by the bank; any language with a catalogue",
    7: "rosters as registrars and systems send them: read, and said how",
    8: "room, seat, group, language and extra time in the roster: used",
    9: "booklets for rooms, equal page counts, spare papers, one paper again, a typo, a late student,"
    " a proof: each a command",
    10: "a midterm in 25 seconds, worked solutions when asked for",
    11: "generating again by mistake never loses the key of printed papers",
    12: "homework: a practice sheet that takes answers",
    13: "answers that two assistants typed: merged, compared",
    14: "a workbook to type into; ids that a spreadsheet changed are repaired, and said",
    15: "decimal commas: said once, or read without a word",
    16: "marks by hand beside marks by machine",
    17: "grading, fixing, voiding, accepting, widening, comparing, in people's names for things",
    18: "feedback, report and sharing, by group, on paper",
    19: "grades into Canvas, Moodle and the workbook of an examination office",
    20: "absent is told apart from zero",
    21: "a scale of grades",
    22: "a pool quiz, marked right or refused",
    23: "next year nobody gets last year's numbers",
    24: "an assistant reads messages in their own language",
    25: "plain words for misspelt names, swapped folders, curly quotes and files of Windows",
}
#: Rows that no test asserts yet, by what is missing.
TO_COME: Mapping[int, str] = {}
