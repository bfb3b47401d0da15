"""What one process gave away is known to the others, in order, however late it is written."""

from __future__ import annotations

import threading
from pathlib import Path

from kinegrade.exam.ledger import Ledger


def test_what_stands_on_the_pages_before_a_part_is_taken(tmp_path: Path) -> None:
    writer, reader = Ledger(tmp_path), Ledger(tmp_path)
    writer.write(0, [{"q1": ("1", "2"), "q2": ("3",)}, {"q1": ("4", "5"), "q2": ("6",)}])
    writer.write(1, [])
    writer.write(2, [{"q1": ("7", "8")}])
    reader.read_before(2)
    assert reader.taken == {"q1": {("1", "2"), ("4", "5")}, "q2": {("3",), ("6",)}}
    reader.read_before(3)
    assert ("7", "8") in reader.taken["q1"]
    assert sorted(page.name for page in tmp_path.iterdir()) == ["0", "1", "2"]


def test_a_page_that_is_not_written_yet_is_waited_for(tmp_path: Path) -> None:
    reader = Ledger(tmp_path)
    later = threading.Timer(0.05, lambda: Ledger(tmp_path).write(0, [{"q": ("1",)}]))
    later.start()
    reader.read_before(1)
    later.join()
    assert reader.taken == {"q": {("1",)}}
