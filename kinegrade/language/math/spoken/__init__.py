"""Formulas in words: `speaking` tidies what `nodes` says of a tree, `units` says units."""
