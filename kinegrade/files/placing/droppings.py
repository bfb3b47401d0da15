"""Files that desktops put into folders, which are nobody's work."""

from __future__ import annotations

DESKTOP_DROPPINGS = {".DS_Store", "Thumbs.db", "desktop.ini"}
