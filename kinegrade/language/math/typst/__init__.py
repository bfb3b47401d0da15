"""Formulas as Typst math, and as Typst code with the words that stand in for them."""
