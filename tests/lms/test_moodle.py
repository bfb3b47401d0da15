"""moodle.csv from a folder of marks: exact ids, dot decimals, nothing that Moodle would refuse."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.lms.moodle import export

GRADES = '''student,name,q1,q2,total,out_of,percent
0012345,王伟,4,3,7,10,70
=9,"O'Neil, ""Zoë""",0,0.3333,0.3333,10,3.33
'''
MARKS = """student,question,ask,response,read_as,unit,verdict,points,out_of,reason
0012345,q1,v_B,1,1,m/s,right,4,4,"two
lines"
0012345,q1,omega_AB,,,rad/s,blank,0,3,
0012345,q2,a_B,1,1,m/s^2,right,3,3,
=9,q1,v_B,,,m/s,blank,0,4,
=9,q1,omega_AB,,,rad/s,blank,0,3,
=9,q2,a_B,1,1,m/s^2,right,0.3333,3,
"""


def folder(tmp_path: Path, grades: str = GRADES, marks: str = MARKS) -> Path:
    (tmp_path / "grades.csv").write_text(grades, encoding="utf-8")
    (tmp_path / "marks.csv").write_text(marks, encoding="utf-8")
    return tmp_path


def test_the_file_is_what_moodle_imports(tmp_path: Path) -> None:
    assert export(folder(tmp_path)) == (
        "ID number,Full name,Grade,Feedback\n"
        "0012345,王伟,7,q1: 4/7; q2: 3/3\n"
        '=9,"O\'Neil, ""Zoë""",0.3333,q1: 0/7; q2: 0.3333/3\n'
    )


def test_feedback_holds_no_html(tmp_path: Path) -> None:
    changed = folder(tmp_path, GRADES.replace("q1", "<b>"), MARKS.replace("q1", "<b>"))
    assert "&lt;b&gt;: 4/7" in export(changed)


def test_a_damaged_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(TableError, match="grades.csv: cannot be read"):
        export(tmp_path)
    with pytest.raises(TableError, match="grades.csv: no column total - expected the file as kinegrade"):
        export(folder(tmp_path, grades=GRADES.replace("total", "sum")))
    with pytest.raises(TableError, match="grades.csv: .*the line has 1 cells, the header 7"):
        export(folder(tmp_path, grades=GRADES + "7\n"))
    with pytest.raises(TableError, match='marks.csv:6: out_of is "x" - expected a number - grade again'):
        export(folder(tmp_path, marks=MARKS.replace("0,4,", "0,x,")))
