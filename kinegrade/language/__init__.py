"""The languages in which exams are set and marked, and in which the terminal is spoken to.

A language is a folder of `catalogues`: gettext's files (.po), one for each part of the program.
Code holds keys, never words: `message` names an entry and what fills its places, `catalogue` writes
it in a language, `known` tells which languages there are.
"""

from __future__ import annotations

from typing import NewType

Language = NewType("Language", str)  # the name of its folder: "en", "zh"
ENGLISH = Language("en")  # the source of all translations
