"""One press: a sheet is one value, and Typst, LaTeX, Word and HTML are layouts of it."""
