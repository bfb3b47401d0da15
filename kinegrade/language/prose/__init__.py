"""Prose: Markdown with `$...$` LaTeX math, read in one place and written for every target."""
