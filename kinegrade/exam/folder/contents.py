"""What an exam folder holds: the names of its files and folders."""

from __future__ import annotations

from kinegrade.language.known import known_languages
from kinegrade.problem.template.translation_names import name_beside

HEAD = "exam.json"
KEY = "key.jsonl"
KEY_BOOK = "key.pdf"
POOL = "variants.jsonl"  # the lines of the key that a pool was made of
BANK = "bank.toml"
TEMPLATES = "templates"
NOTICE = "INSTRUCTOR-ONLY.txt"
PAPERS, SOLUTIONS, SOURCES = "papers", "solutions", "tex"
ANSWERS, ANSWER_WORKBOOK = "answers.csv", "answers.xlsx"
FOR_STUDENTS = (PAPERS, f"{PAPERS}.pdf")
CONTENTS = (
    HEAD,
    NOTICE,
    KEY,
    KEY_BOOK,
    BANK,
    *(name_beside(BANK, language) for language in known_languages()),
    TEMPLATES,
    *FOR_STUDENTS,
    ANSWERS,
    ANSWER_WORKBOOK,
    SOLUTIONS,
    f"{SOLUTIONS}.pdf",
    SOURCES,
    POOL,
)
