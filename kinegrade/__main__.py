"""The entry point of the process: `python -m kinegrade` is `kinegrade`."""

from __future__ import annotations

import sys
from typing import NoReturn

#: Interrupted by Ctrl-C.
INTERRUPTED = 130  # 128 and the number of SIGINT, as shells count


def start() -> NoReturn:
    """Run the command line and exit with its status; Ctrl-C works even while it is being loaded."""
    try:
        from kinegrade.cli import main
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    main()


if __name__ == "__main__":
    start()
