"""A plain sheet for systems whose format is not established: 学号, 姓名, 成绩, 评语, in UTF-8 with a byte-order mark.

The mark lets spreadsheets show Chinese names. Columns are mapped, or copied, by hand.
"""

from __future__ import annotations

from kinegrade.lms.dialect import Column, Dialect, NewFile

GENERIC = Dialect(
    name="the generic sheet",
    places=4,
    new_file=NewFile(
        columns=(
            Column("学号", "id"),
            Column("邮箱", "email"),
            Column("姓名", "name"),
            Column("{title}", "grade"),
            Column("评语", "feedback"),
        ),
        key="id",
        title="成绩",
        mark=True,
    ),
)
