"""Math: LaTeX is read once into a tree (`tree`, `reading`), and each writer writes the tree.

Nothing a formula holds reaches Typst, TeX or HTML as code: writers emit what is in the tables of
`letters` and what they make themselves, and escape the rest.
"""
