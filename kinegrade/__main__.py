"""`python -m kinegrade` is `kinegrade`."""

from kinegrade.cli import main

main()
