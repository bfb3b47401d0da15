"""The entry point of the process: `python -m kinegrade` is `kinegrade`."""

from __future__ import annotations

import gc
import sys
from typing import NoReturn

from kinegrade.processes.garbage_collection import NEW_OBJECTS

#: Interrupted by Ctrl-C.
INTERRUPTED = 130  # 128 and the number of SIGINT, as shells count


def start() -> NoReturn:
    """Run the command line and exit with its status; Ctrl-C works even while it is being loaded."""
    # What is loaded holds no cycles; to look for them takes a tenth of the time of a short run
    gc.set_threshold(NEW_OBJECTS)
    try:
        from kinegrade.cli import main
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    main()


if __name__ == "__main__":
    start()
