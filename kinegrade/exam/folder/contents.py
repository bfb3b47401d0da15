"""What an exam folder holds: the names of its files and folders.

The comments that begin with `#:` say what each holds; the reference of docs/ prints them.
"""

from __future__ import annotations

from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.problem.template.translation_names import name_beside

#: The exam: title, questions, asks with their units and points, students, the secret.
HEAD = "exam.json"
#: The right answers, one line for each student, with the values drawn and the known mistakes.
KEY = "key.jsonl"
#: The same numbers as arrays, by which a large class is marked faster; not where papers hold
#: different questions. While they are not those of `key.jsonl`, that alone is read.
KEY_COLUMNS = "key.npz"
#: The same for spare papers that are not assigned.
SPARES = "spares.jsonl"
#: The right answers for people.
KEY_BOOK = "key.pdf"
#: The same for spare papers, with the names of those who got one.
SPARE_KEY_BOOK = "spare-key.pdf"
#: The lines of the key that a pool of quiz questions was made of; written by `kinegrade quiz`.
POOL = "variants.jsonl"
#: The bank as it was.
BANK = "bank.toml"
#: The logo of the papers, where the bank has one.
LOGO = "logo.svg"
#: The formula sheet behind the papers, where the bank has one that is a PDF.
FORMULA_PAGES = "formula-sheet.pdf"
#: The same where it is a text.
FORMULA_TEXT = "formula-sheet.md"
#: The templates as they were.
TEMPLATES = "templates"
#: Says who may see what.
NOTICE = "INSTRUCTOR-ONLY.txt"
#: One PDF for each student, in numbered folders where they are more than a thousand; for students.
PAPERS = "papers"
#: The same papers in a booklet for each room, and one of spare papers, where the roster names
#: rooms; for invigilators.
ROOMS = "rooms"
#: Worked solutions, one PDF for each student, in the same folders; for students after the exam.
SOLUTIONS = "solutions"
#: Sources of papers typeset by LaTeX, for editing.
SOURCES = "tex"
#: The blank sheet for the class's answers.
ANSWERS = "answers.csv"
#: The same sheet as a workbook, which keeps ids as text.
ANSWER_WORKBOOK = "answers.xlsx"
#: How far an exam is that is being written, and its secret; gone when the exam is whole.
UNFINISHED = "unfinished"
FINDER = Message("exam.find-row")  # begins the line above the header of the workbook
FOR_STUDENTS = (PAPERS, f"{PAPERS}.pdf", ROOMS)
CONTENTS = (
    HEAD,
    NOTICE,
    KEY,
    KEY_COLUMNS,
    SPARES,
    KEY_BOOK,
    SPARE_KEY_BOOK,
    BANK,
    *(name_beside(BANK, language) for language in known_languages()),
    LOGO,
    FORMULA_PAGES,
    FORMULA_TEXT,
    TEMPLATES,
    *FOR_STUDENTS,
    ANSWERS,
    ANSWER_WORKBOOK,
    SOLUTIONS,
    f"{SOLUTIONS}.pdf",
    SOURCES,
    POOL,
)
