"""The mechanisms all figure tests draw."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))  # mechanisms.py and more_mechanisms.py are data, not tests
