"""Seeds that once found a fault, each with what it was; they are run with every test."""

from __future__ import annotations

FAILED = {
    156: "report: a crash where read_as in marks.csv is no number",
    33124: "report: a crash where read_as in marks.csv is no number",
    250: "quiz: a crash where the tolerance of an ask is missing in the key",
    100279: "report: endless work on points of 1e9999999999 in marks.csv",
    200641372: "quiz: endless work on a tolerance of nothing in the key",
    200636443: "a workbook: a crash where the packed bytes of a part are damaged",
    200636542: "a workbook: a crash where the packed bytes of a part are damaged",
    159443907: "feedback: a crash where the exact answer of the key is a number of JSON",
    700576: "quiz: a crash where the tolerance of an ask is missing in the key",
}
