"""Moodle's gradebook download in any language: columns are found by what they hold, and no feedback
is lost in silence.
"""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest
from click.testing import Result

from tests.lms.marked_folder import write_exam, write_marks
from tests.small_class import kinegrade

# First and last name, id number, institution, department, address; title; points, per cent,
# feedback; time of export.
HEADERS = {
    "en": "First name|Last name|ID number|Institution|Department|Email address"
    "|Quiz: Kinematics|Real|Percentage|Feedback|Last downloaded from this course",
    "de": "Vorname|Nachname|ID-Nummer|Institution|Abteilung|E-Mail-Adresse"
    "|Test: Kinematik|Punkte|Prozentsatz|Rückmeldung|Zuletzt aus diesem Kurs geladen",
    "es": "Nombre|Apellido(s)|Número de ID|Institución|Departamento|Dirección de correo"
    "|Examen: Cinemática|Real|Porcentaje|Retroalimentación|Última descarga de este curso",
    "fr": "Prénom|Nom de famille|Numéro d’identification|Institution|Département|Adresse de "
    "courriel"
    "|Test : Cinématique|Brut|Pourcentage|Feedback|Dernier téléchargement depuis ce cours",
    "it": "Nome|Cognome|Codice identificativo|Istituzione|Dipartimento|Indirizzo email"
    "|Quiz: Cinematica|Punteggio|Percentuale|Commento|Ultimo scaricamento da questo corso",
    "ja": "名|姓|IDナンバ|所属組織|部署|メールアドレス"
    "|小テスト: 運動学|実データ|パーセンテージ|フィードバック|このコースからの最終ダウンロード",
    "nl": "Voornaam|Achternaam|ID-nummer|Instelling|Afdeling|E-mailadres"
    "|Test: Kinematica|Echt|Percentage|Feedback|Laatst gedownload van deze cursus",
    "pt": "Nome|Apelido|Número de identificação|Instituição|Departamento|Endereço de e-mail"
    "|Teste: Cinemática|Real|Percentagem|Comentários|Última transferência desta disciplina",
    "ru": "Имя|Фамилия|Индивидуальный номер|Учреждение|Отдел|Адрес электронной почты"
    "|Тест: Кинематика|Значение|Проценты|Отзыв|Последнее скачивание с этого курса",
    "zh_cn": "名|姓|学号|机构|系别|电子邮件地址|测验：运动学|分数|百分比|反馈|上次下载",
    "invented": "Vorpal|Snicker|Slithy 7|Gimble|Wabe|Mome rath|Tove: "
    "Jabberwock|Outgrabe|Mimsy|Borogove|Frumious",
}
PEOPLE = {  # in the order of Moodle, not of the class
    "0012347": "w3@example.invalid",
    "0012346": "w2@example.invalid",
    "0012348": "w4@example.invalid",
    "0012345": "w1@example.invalid",
}
GRADED = ("8.25", "4", "9.6667")  # 0012345, 0012346, 0012348
COMMENTS = ("1: 7/7; 2: 1.25/3", "1: 4/7; 2: 0/3", "1: 6.6667/7; 2: 3/3")
Cells = tuple[str, ...]


def header(language: str, words: Cells = ("Real", "Percentage", "Feedback")) -> list[str]:
    """The header in a language; `words` says which of the three columns of the item are there."""
    *people, title, points, share, comment, time = HEADERS[language].split("|")
    shown = dict(zip(("Real", "Percentage", "Feedback"), (points, share, comment), strict=True))
    return [*people, *(f"{title} ({shown[word]})" for word in words), time]


def download(folder: Path, head: list[str], cells: dict[str, Cells]) -> Path:
    """A gradebook with these cells of the item for each student."""
    rows = [
        ["Ann", "Other", student, "", "", email, *cells[student], "1795226878"]
        for student, email in PEOPLE.items()
    ]
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([head, *rows])
    path = folder / "download.csv"
    path.write_text(stream.getvalue(), encoding="utf-8", newline="")
    return path


def alike(cells: Cells) -> dict[str, Cells]:
    return dict.fromkeys(PEOPLE, cells)


def some_graded() -> dict[str, Cells]:
    return alike(("-", "-", "")) | {"0012346": ("2.94", "29.41 %", "")}


def exported(folder: Path, path: Path, *options: str) -> Result:
    marks, exam = write_marks(folder / "MARKS"), write_exam(folder / "EXAM")
    where = "--to", "moodle", "--into", path, "-o", folder / "out.csv", "--force"
    return kinegrade("export", marks, *where, "--exam", exam, *options)


def columns(folder: Path, *headers: str) -> list[Cells]:
    """What stands below these headers, for the students in the order of the class."""
    with (folder / "out.csv").open(encoding="utf-8", newline="") as stream:
        rows = {row[2]: row for row in csv.reader(stream)}
    head = next(iter(rows.values()))
    places = [head.index(name) for name in headers]
    return [tuple(rows[student][place] for place in places) for student in sorted(PEOPLE)]


@pytest.mark.parametrize("language", HEADERS)
def test_grades_and_feedback_go_into_a_gradebook_of_any_language(
    tmp_path: Path, language: str
) -> None:
    head = header(language)
    result = exported(tmp_path, download(tmp_path, head, some_graded()))
    assert (result.exit_code, result.stdout) == (0, ""), result.stderr
    points, share, comment = head[6:9]
    assert columns(tmp_path, points, share, comment) == [
        (GRADED[0], "-", COMMENTS[0]),
        (GRADED[1], "29.41 %", COMMENTS[1]),
        ("-", "-", ""),  # handed in nothing
        (GRADED[2], "-", COMMENTS[2]),
    ]
    assert f'grades into "{points}", feedback into "{comment}"' in result.stderr


@pytest.mark.parametrize("language", HEADERS)
def test_a_gradebook_without_any_grade_yet_is_filled_by_the_order_of_its_columns(
    tmp_path: Path, language: str
) -> None:
    head = header(language)
    assert exported(tmp_path, download(tmp_path, head, alike(("-", "-", "")))).exit_code == 0
    assert columns(tmp_path, *head[6:9])[1] == (GRADED[1], "-", COMMENTS[1])


@pytest.mark.parametrize("language", HEADERS)
def test_feedback_that_has_no_column_is_not_dropped_without_a_word(
    tmp_path: Path, language: str
) -> None:
    head = header(language, ("Real",))
    result = exported(tmp_path, download(tmp_path, head, alike(("2.94",))))
    assert result.exit_code == 0
    assert columns(tmp_path, head[6])[1] == (GRADED[1],)
    assert (
        "download.csv: has no column for feedback on the total, so the points by question are "
        "left out - download the file with feedback to fill them in, or add --no-feedback\n"
    ) in result.stderr
    silent = exported(tmp_path, download(tmp_path, head, alike(("2.94",))), "--no-feedback")
    assert "left out" not in silent.stderr


@pytest.mark.parametrize("language", HEADERS)
def test_old_feedback_is_replaced_and_not_taken_for_grades(tmp_path: Path, language: str) -> None:
    head = header(language, ("Real", "Feedback"))
    cells = alike(("2.94", "")) | {"0012346": ("3.00", "7"), "0012348": ("-", "see me")}
    assert exported(tmp_path, download(tmp_path, head, cells)).exit_code == 0
    assert columns(tmp_path, *head[6:8])[1] == (GRADED[1], COMMENTS[1])


@pytest.mark.parametrize("missing", ["-", "Ungenügend"])
def test_words_of_a_scale_behind_the_points_are_no_feedback(tmp_path: Path, missing: str) -> None:
    head = header("invented", ("Real", "Feedback"))
    cells = alike(("2.94", "Befriedigend")) | {"0012348": ("-", missing)}
    result = exported(tmp_path, download(tmp_path, head, cells))
    assert "has no column for feedback on the total" in result.stderr
    assert columns(tmp_path, *head[6:8])[1] == (GRADED[1], "Befriedigend")


def test_feedback_that_was_filled_in_for_everybody_is_filled_in_again(tmp_path: Path) -> None:
    head = header("invented", ("Real", "Feedback"))
    path = download(tmp_path, head, alike(("10.00", "1: 7/7; 2: 3/3")))
    assert exported(tmp_path, path).exit_code == 0
    assert columns(tmp_path, *head[6:8])[1] == (GRADED[1], COMMENTS[1])


def test_people_are_found_by_address_where_the_file_has_no_ids(tmp_path: Path) -> None:
    path = download(tmp_path, header("fr"), some_graded())
    text = path.read_text(encoding="utf-8")
    for student in PEOPLE:
        text = text.replace(student, "")
    path.write_text(text, encoding="utf-8", newline="")
    result = exported(tmp_path, path)
    assert 'students are found by "Adresse de courriel"' in result.stderr
    assert "8.25" in (tmp_path / "out.csv").read_text(encoding="utf-8")
    marks = tmp_path / "MARKS"
    refused = kinegrade(
        "export", marks, "--to", "moodle", "--into", path, "-o", tmp_path / "other.csv"
    )
    assert refused.exit_code == 2
    assert "or the exam that knows the addresses (--exam)" in refused.stderr


def test_a_maximum_that_points_beside_per_cent_show_is_seen_in_any_language(tmp_path: Path) -> None:
    cells = alike(("-", "-", "")) | {"0012346": ("2.94", "14.71 %", "")}
    result = exported(tmp_path, download(tmp_path, header("invented"), cells))
    assert result.exit_code == 2
    assert '"Tove: Jabberwock (Outgrabe)": counts 20 there, 10 in the exam' in result.stderr


def test_of_several_items_one_has_to_be_named_and_gets_its_own_feedback(tmp_path: Path) -> None:
    head = header("ru")
    title = "Задание: Ещё одно"
    words = ("Значение", "Проценты", "Отзыв")
    both = [*head[:9], *(f"{title} ({word})" for word in words), head[9]]
    cells = {student: (*found, "-", "-", "") for student, found in some_graded().items()}
    path = download(tmp_path, both, cells)
    refused = exported(tmp_path, path)
    assert refused.exit_code == 2
    assert (
        "2 grade columns to fill in - expected one - name it with --column HEADER (grade columns "
        f'here: "{head[6]}", '
        f'"{title} (Значение)")'
    ) in refused.stderr
    assert exported(tmp_path, path, "--column", f"{title} (Значение)").exit_code == 0
    assert columns(tmp_path, *both[6:12])[1] == ("2.94", "29.41 %", "", GRADED[1], "-", COMMENTS[1])


@pytest.mark.parametrize("language", ["fr", "ru", "zh_cn"])
def test_an_item_is_found_by_its_title_whatever_the_activity_is_called_there(
    tmp_path: Path, language: str
) -> None:
    head = header(language)
    path = download(tmp_path, head, some_graded())
    title = HEADERS[language].split("|")[6].replace("：", ":").split(":")[1].strip()
    assert exported(tmp_path, path, "--title", title).exit_code == 0
    assert columns(tmp_path, head[6])[1] == (GRADED[1],)


@pytest.mark.parametrize("place", [0, 1, 2, 5, 7, 8])
def test_points_are_not_written_over_names_ids_per_cent_or_feedback(
    tmp_path: Path, place: int
) -> None:
    head = header("pt")
    path = download(tmp_path, head, some_graded())
    result = exported(tmp_path, path, "--column", head[place])
    assert result.exit_code == 2
    assert "is no column from which Moodle takes grades" in result.stderr


def test_small_ids_are_not_looked_for_among_grades(tmp_path: Path) -> None:
    students = dict(zip(sorted(PEOPLE), "1234", strict=True))
    marks = write_marks(tmp_path / "MARKS", students=students)
    path = tmp_path / "download.csv"
    path.write_text("Prénom,Test (Brut)\nA,1\nB,2\nC,3\nD,4\n", encoding="utf-8")
    result = kinegrade("export", marks, "--to", "moodle", "--into", path, "-o", tmp_path / "o.csv")
    assert result.exit_code == 2
    assert "no column by which Moodle identifies students" in result.stderr


def test_an_empty_column_of_dates_in_a_worksheet_is_not_taken_for_grades(tmp_path: Path) -> None:
    path = tmp_path / "download.csv"
    path.write_text(
        "Identifiant,Adresse de courriel,Note,Note maximale,Dernière modification (note)\n"
        "Participant 12,w1@example.invalid,,10.00,-\nParticipant 13,w2@example.invalid,,10.00,-\n",
        encoding="utf-8",
    )
    result = exported(tmp_path, path)
    assert result.exit_code == 2
    assert (
        "no grade columns to fill in - expected one - name it with --column HEADER" in result.stderr
    )
    exported(tmp_path, path, "--column", "Note")
    assert ",8.25,10.00,-\n" in (tmp_path / "out.csv").read_text(encoding="utf-8")
