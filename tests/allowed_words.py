"""Texts of the program that look like words of a language and are none, with the reasons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

NAMES = {  # identifiers that modules share, and files of ours hold
    "another ask",
    "another paper",
    "by hand",
    "degrees for radians",
    "feedback format",
    "name and id",
    "power of ten",
    "radians for degrees",
    "revolutions per minute",
    "revolutions per second",
    "wrong unit",
}
# By the reason why they are no words of the program: the files and the texts in them
ALLOWED: Mapping[str, Mapping[str, Sequence[str]]] = {
    "a report for the program's authors": {
        "cli/running/crash.py": [
            "command: {}",
            "kinegrade {}, Python {}, {}",
        ],
    },
    "what Python says of a name that a module does not have": {
        "__init__.py": [
            "module {} has no attribute {}",
        ],
    },
    "part of what an order is computed from": {
        "exam/setting/dealing.py": [
            "version {}",
        ],
    },
    "what earlier versions wrote into files": {
        "exam/folder/earlier_signs.py": [
            "-x|positive in the direction of \\$-x\\$",
            "-y|positive in the direction of \\$-y\\$",
            "\\+x|positive in the direction of \\$\\+x\\$",
            "\\+y|positive in the direction of \\$\\+y\\$",
            "with its sign",
        ],
        "marks_folder/earlier.py": [
            " by the policy",
        ],
    },
    "what Python's reader of TOML says": {
        "files/fields/toml_text.py": [
            "Cannot overwrite a value",
        ],
    },
    "what a server tells browsers, and how options are named": {
        "preview/application.py": [
            "data: changed\n\n",
            "; connect-src 'self'; frame-src 'self'; img-src data:",
        ],
    },
    "names of fonts": {
        "figure/back_ends/svg.py": [
            "Libertinus Serif, STIX Two Text, Times New Roman, Times, Liberation Serif, serif",
        ],
        "cycles/graphs.py": ["{}, Noto Serif CJK SC, Songti SC, SimSun"],
    },
    "Typst code": {
        "figure/back_ends/typst.py": [
            '(thickness: {}, cap: "round", join: "round"{})',
            "stroke: {}, fill: {}",
            "width: {}, height: {}",
            "{}, box({}, align(center + horizon, box({}))))",
            "{}, circle(radius: {}, {}))",
        ],
        "language/math/typst/formula.py": [
            "{} degree",
        ],
        "language/prose/typst.py": [
            "enum(start: {}, {});",
        ],
    },
    "signs for a product": {
        "grading/typed/keyboard.py": [
            "·⋅•∙・",
        ],
    },
    "a unit in symbols": {
        "grading/typed/unit_spelling.py": [
            "m^{} s^{} rad^{}",
        ],
    },
    "the letters that a font has": {
        "language/math/latex_text.py": [
            "[ -~\n¡-§©-¬®-·»-ĥĨ-ķĹ-ľŁ-ňŊ-ťŨ-žȘșȚț–—‘’‚“”„…‰‹›€™•]*",
            "[ẠạẢảẤ-ỹƠơƯưΑ-ΡΣ-Ωα-ωА-яЁё\u3000-。一-龥]",
        ],
    },
    "names of functions in formulas": {
        "language/math/letters.py": [
            "sin cos tan cot arcsin arccos arctan sinh cosh tanh exp ln log min max",
        ],
    },
    "the name of a standard, as its packages state it": {
        "lms/scorm.py": [
            "ADL SCORM",
        ],
    },
    "what another system calls its columns": {
        "lms/grades/systems/blackboard.py": [
            "Feedback Format",
            "Feedback to Learner",
            "Student ID",
        ],
        "lms/grades/systems/brightspace.py": [
            "End-of-Line Indicator",
            "{title} Points Grade <Numeric MaxPoints:{maximum}>",
        ],
        "lms/grades/systems/canvas.py": [
            "SIS Login ID",
            "SIS User ID",
        ],
        "lms/grades/systems/edx.py": [
            "New Points",
            "Open edX",
            "Previous Points",
        ],
        "lms/grades/systems/moodle.py": [
            "Email address",
            "Email地址",
            "Feedback comments",
            "Full name",
            "Grade can be changed",
            "ID number",
            "Last modified (grade)",
            "Maximum grade",
            "Rückmeldung",
            "分数",
            "反馈",
            "学号",
            "実データ",
            "百分比",
        ],
        "lms/responses/canvas.py": [
            "Student, Test",
            "Test Student",
        ],
        "lms/responses/forms/google_forms.py": [
            "email address",
        ],
        "lms/responses/moodle_columns.py": [
            "respuesta correcta",
            "richtige antwort",
            "right answer",
            "réponse correcte",
            "問題",
            "标准答案",
            "正解",
            "题目",
        ],
        "lms/responses/forms/ms_forms.py": [
            "completion time",
            "last modified time",
            "quiz feedback",
            "start time",
            "total points",
        ],
        "lms/responses/forms/wjx.py": [
            "序号",
            "(空)",
            "（空）",
            "(跳过)",
            "（跳过）",
        ],
        "lms/grades/systems/sakai.py": [
            "Student ID",
            "Student Name",
        ],
    },
    "an option of the command line": {
        "lms/grades/from_scratch.py": [
            "--column HEADER",
            "--column {}=HEADER",
        ],
        "lms/grades/item_columns.py": [
            "--column HEADER",
            "--column {}=HEADER",
        ],
    },
    "addresses of XML schemas": {
        "lms/quiz/qti12/manifest.py": [
            '<?xml version="1.0" encoding="UTF-8"?>\n<manifest identifier="kinegrade" xmlns="http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1">\n<metadata><schema>IMS Content</schema><schemaversion>1.1.3</schemaversion></metadata>\n<organizations/>\n<resources>\n',
            "{} https://canvas.instructure.com/xsd/cccv1p0.xsd",
        ],
        "lms/quiz/qti21/item.py": [
            "{} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd",
        ],
    },
    "what TeX writes into its log": {
        "press/latex/xetex.py": [
            "Missing character: There is no (.)",
            "Undefined control sequence",
        ],
    },
    "a style of the Word document": {
        "press/word/paper.py": [
            "Answer box",
        ],
    },
    "part of what a draw is computed from": {
        "draws/keyed_order.py": [
            "order of draws",
        ],
    },
    "an example in the language of templates": {
        "problem/template/sections/scheme.py": [
            '{ motion = "OA turns", velocity = "omega" }',
        ],
    },
    "sentences and examples in the language of templates": {
        "expressions/tree.py": [
            "left of",
            "right of",
        ],
        "mechanics/branches.py": [
            "left of A->B",
            "right of A->B",
        ],
        "mechanics/drivers/circulation.py": [
            "POINT of BODY circles POINT",
        ],
        "mechanics/drivers/component.py": [
            "B of AB moves along +x",
            "POINT of BODY moves along +x|-x|+y|-y|ANGLE [relative to BODY]",
            "M of M moves along direction(O, A) relative to AE",
        ],
        "mechanics/drivers/rotation.py": [
            "AB turns relative to OA",
            "OA turns",
            "BODY turns [relative to BODY]",
        ],
        "mechanics/geometry.py": [
            "left of",
            "right of",
        ],
        "mechanics/joints/arc.py": [
            "POINT of BODY stays on CIRCLE [of BODY]",
            "M of AB stays on circle(O1, R) of ring",
        ],
        "mechanics/joints/belt.py": [
            "open|crossed belt: CIRCLE of BODY, CIRCLE of BODY on BODY",
            "open belt: circle(A, r1) of I, circle(B, r2) of II on ground",
        ],
        "mechanics/joints/contact.py": [
            "CIRCLE [of curvature] of BODY touches LINE|CIRCLE [of BODY] [inside]",
            "circle(C, R) of cam touches line(A, 0) of BC",
            "circle(K, rho) of curvature of cam touches line(A, 0) of BC",
        ],
        "mechanics/joints/mesh.py": [
            "CIRCLE of BODY meshes with CIRCLE of BODY on BODY [inside]",
            "circle(A, r1) of I meshes with circle(B, r2) of II on arm",
        ],
        "mechanics/joints/parallel.py": [
            "BODY translates|turns with BODY",
            "BC translates",
            "rod turns with arm",
        ],
        "mechanics/joints/pin.py": [
            "pin A: OA AB",
            "pin POINT: BODY BODY ...",
            "pin O: ground OA",
        ],
        "mechanics/joints/roll.py": [
            "{} rolls on {}{}{}",
            "CIRCLE of BODY rolls on LINE|CIRCLE [of BODY] [inside]",
            "circle(A, r) of wheel rolls on line(O, 0)",
            "circle(A, r2) of II rolls on circle(O, r1) inside",
        ],
        "mechanics/joints/sleeve.py": [
            "BODY slides through BODY along LINE",
            "AB slides through sleeve along line(O, A)",
        ],
        "mechanics/joints/slide.py": [
            "B of AB slides on line(O, 0)",
            "POINT of BODY slides on LINE [of BODY]",
            "A of AB slides on line(O, A) of OC",
        ],
        "problem/kinds/signatures.py": [
            "meet(circle(A, l), circle(D, m), left of A->D)",
            "meet(circle(A, l), circle(D, m), right of A->D)",
            "left of",
            "right of",
        ],
        "problem/quantities/measures.py": [
            "radius(circle_of_poles(AB, phi))",
            "centre(circle_of_poles(AB, phi))",
        ],
        "problem/quantities/motion_functions.py": [
            "alpha(AB, OA)",
            "relative_velocity(A, OA, CB)",
            "relative_acceleration(A, OA, CB)",
            "coriolis(A, OA, CB)",
            "circle_of_poles(AB, phi)",
        ],
        "problem/vocabulary.py": [
            "turns with",
            "relative to",
        ],
        "problem/template/sections/key_examples.py": [
            'motion = "OA turns"',
        ],
    },
    "a command as it is typed": {
        "errors.py": [
            "kinegrade words",
        ],
    },
    "a place in a template's file": {
        "problem/statement.py": [
            "{}.toml: statement.{}",
            "{}.toml: text.{}",
        ],
        "problem/statement_faults.py": [
            "{}.toml: {}",
        ],
    },
    "a mark that no cell can hold": {
        "files/csv_reading.py": [
            "\x00end of table",
        ],
    },
    "titles of columns as other systems and other languages have them": {
        "exam/roster/known_columns.py": [
            "sis user id",
            "sis login id",
            "numéro d’identification",
            "numéro d'identification",
            "número de id",
            "idナンバ",
            "prénom",
            "nom de famille",
            "adresse de courriel",
            "dirección de correo",
            "メールアドレス",
            "グループ",
        ],
    },
    "how a time is written in a file of ours": {
        "exam/roster/cell_values.py": [
            "{} min",
        ],
    },
    "an option as it is typed": {
        "exam/roster/columns.py": [
            "--column {}=HEADER",
        ],
    },
    "what Unicode calls a character": {
        "exam/roster/reading.py": [
            "CJK UNIFIED",
        ],
    },
}
