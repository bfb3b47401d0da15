"""What an author may write: the tables of a template's file, and the keys of their entries.

The comments that begin with `#:` say what each key is for; the reference of docs/ prints them.
"""

from __future__ import annotations

MAX_CHARACTERS = 100_000  # of a file; the longest that is shipped has 8,000

# Tables and keys of the file, by whether every template needs them
NEEDED = (
    #: The name of the problem, on papers and in lists.
    "title",
    #: The kind of mechanism, in small letters; banks draw by it and the gallery groups by it.
    "family",
    #: Where the problem was published.
    "source",
    #: The givens, by name.
    "parameters",
    #: The points in the order of construction, in metres: x to the right, y upwards.
    "points",
    #: The moving bodies, each with the points marked on it: `OA = "O A"`. A particle is written
    #: `"particle M"`.
    "bodies",
    #: How the bodies are joined, one sentence each; the fixed body is called `ground`.
    "joints",
    #: What is imposed: one motion for each degree of freedom. `[]` for a problem of positions
    #: alone.
    "inputs",
    #: What may be asked, by name.
    "asks",
    #: The whole problem in Markdown and `$LaTeX$`, complete without the figure. Every parameter
    #: stands in it as `{{ name }}`, which prints symbol, value and unit; `{{ name.value }}` prints
    #: the value with its unit, `{{ name.size }}` symbol and value without the sign. `{{ OA.turning
    #: }}` and `{{ B.moving }}` say how a driven body or point goes, with its givens.
    "statement",
)
OPTIONAL = (
    #: Lengths that follow from the givens, by name, as expressions.
    "lengths",
    #: What drawn values must fulfil: two expressions with `<`, `<=`, `>`, `>=` or `==` between
    #: them.
    "conditions",
    #: Wordings that depend on the values: for each name a list of texts with a condition under
    #: `if`; the last may have none. The statement uses them as `{{ name }}`. A text is left out
    #: where nothing that is asked needs any given in it.
    "text",
    #: The results that the source gives; `kinegrade check` proves them.
    "published",
    #: What is marked in the figure. The mechanism itself is drawn from bodies and joints.
    "figure",
    #: Further words by which banks find the template, such as `["two-drivers"]`.
    "tags",
    #: How the worked solution finds velocities where several methods serve.
    "method",
)
SHARING = (
    #: The name of a shared mechanism, `mechanisms/NAME.toml`, over which this template is laid.
    "mechanism",
)
KNOWN = (*NEEDED, *OPTIONAL, *SHARING)
NAMES = ("parameters", "points", "bodies")  # without these nothing that names them can be checked

# What templates can share with others: tables, laid over by name, and lists, one after the other
SHARED_TABLES = ("parameters", "lengths", "points", "bodies", "figure")
SHARED_LISTS = ("joints", "conditions")
SHARED = (*SHARED_TABLES, *SHARED_LISTS)

PARAMETER = (
    #: The unit in which it is given.
    "unit",
    #: The values that may be drawn: a list, `[15, 30, "sqrt(3)"]`, or a range, `"0.1 .. 0.5 step
    #: 0.05"`.
    "draw",
    #: The value in the source, where it has one.
    "published",
    #: What it is, in a few words.
    "means",
    #: The symbol in LaTeX math, where it does not follow from the name.
    "symbol",
)
INPUT = (
    #: What moves, as a sentence.
    "motion",
    #: The velocity or angular velocity, as an expression; counter-clockwise positive.
    "velocity",
    #: The acceleration or angular acceleration; zero where it is not stated.
    "acceleration",
)
ASK = (
    #: What is asked for, as an expression.
    "quantity",
    #: The unit of the answer.
    "unit",
    #: What it is, in a few words.
    "means",
    #: What a positive answer means: a keyword, or words of your own by language.
    "sign",
    #: Its points, and that it is asked unless a bank chooses otherwise; without them it is asked on
    #: request.
    "points",
    #: `true` where zero is a proper answer; other draws with the answer zero are refused.
    "vanishes",
    #: `true` for an angle that is right with any number of full turns more or less.
    "cyclic",
    #: The symbol in LaTeX math, where it does not follow from the name.
    "symbol",
)
PUBLISHED = (
    #: Which part of the source, or under which assumption.
    "source",
    #: The values of parameters for which the results hold; all values where it is not stated.
    "given",
    #: The results, by ask, as expressions of the parameters.
    "gives",
)

FIGURE = (
    #: Dimension lines.
    "lengths",
    #: Angles.
    "angles",
    #: Radii of circles.
    "radii",
    #: Circles of a body that no joint mentions, such as the flange of a wheel.
    "circles",
    #: Arrows of motions: straight with `moves`, curved with `turns`. An input whose rate is a
    #: parameter, or its negative, has its arrow without one; and always in the sense that it has.
    "arrows",
    #: Thin lines between two points: `[["O", "A"]]`.
    "lines",
    #: Right angles to mark, by three points with the corner in the middle: `[["C", "D", "E"]]`.
    "right_angles",
    #: Other text for a point, or text for a body: `{ O = "O_1" }`; `false` for no label.
    "labels",
    #: Other shapes of bodies: `{ OA = "bent" }`; `gear`, `cam`, `arc`, `rope`, `load`, `disc`,
    #: `geneva`, `bent`, `bar`, `bare`, `through`, `jaw`.
    "shapes",
    #: Frames fixed to bodies, as two arrows with their letters.
    "frames",
    #: Where the axes x and y stand: `"origin"`, or `"aside"` as a small frame. Where nothing is
    #: said, coordinates that are asked or given call for the first, components for the second.
    "axes",
)
LENGTH = (
    #: Its symbol in LaTeX math.
    "symbol",
    #: The point at one end.
    "from",
    #: The point at the other end.
    "to",
    #: `horizontal` or `vertical` for the projected distance.
    "along",
)
ANGLE = (
    #: Its symbol in LaTeX math.
    "symbol",
    #: The point at its vertex.
    "at",
    #: The first side: a point, or `right`, `up`, `left`, `down`.
    "from",
    #: The second side, in the same way.
    "to",
    #: `ccw` or `cw` from the first side to the second; the shorter way where it is not stated.
    "sense",
)
RADIUS = (
    #: Its symbol in LaTeX math.
    "symbol",
    #: The point at the centre.
    "centre",
    #: The body whose circle it is, where several have the centre.
    "of",
    #: A point on the circle, where several have the centre.
    "through",
)
CIRCLE = (
    #: The body that has the circle.
    "body",
    #: The point at its centre.
    "centre",
    #: A point on it.
    "through",
)
FRAME = (
    #: The letter of its x axis in LaTeX math.
    "x",
    #: The letter of its y axis.
    "y",
    #: The point at its origin.
    "at",
    #: The point from which the direction of an axis is taken; that at the origin where it is not
    #: stated.
    "from",
    #: The point to which that axis points, or `right`, `up`, `left`, `down`.
    "to",
    #: Which axis that is: `x`, or `y`; x where it is not stated.
    "along",
)
MOVING = (
    #: Its symbol in LaTeX math.
    "symbol",
    #: The point at which the arrow stands.
    "moves",
    #: The point or the side towards which it points, where no input moves the point.
    "along",
    #: `velocity`, or `acceleration` for an arrow with two heads; a velocity where it is not stated.
    "rate",
)
TURNING = (
    #: Its symbol in LaTeX math.
    "symbol",
    #: The body about whose pivot the arrow is curved.
    "turns",
    #: `ccw` or `cw`, where no input turns the body.
    "sense",
    #: `velocity`, or `acceleration` for an arrow with two heads; a velocity where it is not stated.
    "rate",
)
