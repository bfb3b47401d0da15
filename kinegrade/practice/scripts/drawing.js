// @ts-check
// The moving drawing of a mechanism: bars, circles, pivots, guides, letters, arrows.

/**
 * @typedef {object} Skeleton
 * @property {string[]} labels
 * @property {number[][]} bars
 * @property {number[]} circles
 * @property {number[]} pivots
 * @property {number[]} riders
 * @property {boolean[]} blocks
 * @property {{letter: string, points: [number, number], lines: number[]}[]} poles
 * @property {string} input
 * @property {string} unit
 */

const LONGEST_ARROW = 18; // mm
const NEXT_TO_NOTHING = 0.03;
const SEEN = 0.6; // mm: shorter arrows are not drawn
const LETTER_AWAY = 3.4; // mm from a point to the middle of its letter
const BESIDE_BLOCK = 4.5; // the same, past the block at the point
/** @type {[number, number]} */
const UP_RIGHT = [0.7, -0.7];
const ROOM = 6; // mm between what is seen and the edge

/** @typedef {{velocities: boolean, accelerations: boolean, paths: boolean, poles: boolean, centrodes: boolean}} Wanted */

const SVG = "http://www.w3.org/2000/svg";

/**
 * An element of a drawing.
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @returns {SVGElement}
 */
function makeShape(name, attributes) {
  const shape = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) shape.setAttribute(key, String(value));
  return shape;
}

/** @param {[number, number][]} points @returns {string} */
function writeCorners(points) {
  return points.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(" ");
}

/** Draws the positions of a mechanism into an SVG element. */
class Drawing {
  /** @param {SVGElement} stage @param {Skeleton} skeleton @param {Poses} poses */
  constructor(stage, skeleton, poses) {
    const { radii } = poses.motion;
    stage.replaceChildren();
    this.stage = stage;
    this.skeleton = skeleton;
    this.poses = poses;
    const add = (/** @type {string} */ name, /** @type {Record<string, string | number>} */ attributes) =>
      stage.appendChild(makeShape(name, attributes));
    const ways = poses.fine.map((place) => poses.at(place));
    this.traces = this.listMoving().map((row) =>
      add("polyline", { class: "trace", points: writeCorners(ways.map((points) => points[row])) }),
    );
    this.poles = skeleton.poles.map((pole) => new PoleDrawing(stage, pole, poses));
    this.circles = skeleton.circles.map((_, number) => add("circle", { class: "rim", r: radii[number] }));
    this.guides = skeleton.riders.map(() => add("polyline", { class: "guide" }));
    this.pivots = skeleton.pivots.map(() => add("path", { class: "pivot" }));
    this.bars = skeleton.bars.map((corners) =>
      add(corners.length > 2 ? "polygon" : "polyline", { class: "bar" }),
    );
    this.sliders = skeleton.blocks.map((drawn) =>
      add("rect", { class: drawn ? "slider" : "bare", width: 6, height: 4, x: -3, y: -2 }),
    );
    this.joints = skeleton.labels.map((label) => add("circle", { class: label ? "joint" : "bare", r: 0.9 }));
    this.letters = skeleton.labels.map((label) => {
      const letter = add("text", { class: "letter" });
      letter.innerHTML = label;
      return letter;
    });
    this.velocities = skeleton.labels.map(() => add("path", { class: "velocity" }));
    this.accelerations = skeleton.labels.map(() => add("path", { class: "acceleration" }));
    this.scales = this.findScales();
  }

  /** @returns {number[]} the points with letters that move */
  listMoving() {
    return this.skeleton.labels.flatMap((label, place) => {
      const { rows } = this.poses;
      const moves = rows[2 * place].length > 1 || rows[2 * place + 1].length > 1;
      return label && moves ? [place] : [];
    });
  }

  /** Millimetres of arrows for those of the rates, by what is usual over the cycle. */
  findScales() {
    const places = Array.from({ length: this.poses.count }, (_, place) => this.poses.rates(place));
    const usual = (/** @type {"velocities" | "accelerations"} */ name) => {
      const sizes = places.map((each) =>
        Math.max(...this.listMoving().map((row) => Math.hypot(...each[name][row])), 0),
      );
      return sizes.sort((one, other) => one - other)[Math.floor(sizes.length * 0.9)];
    };
    const [velocity, acceleration] = [usual("velocities"), usual("accelerations")];
    // What is far below v^2 / r of any path in the drawing is what rounding left of nothing
    const nothing = (NEXT_TO_NOTHING * velocity ** 2) / this.poses.motion.width;
    return {
      velocities: velocity > 0 ? LONGEST_ARROW / velocity : 0,
      accelerations: acceleration > nothing ? LONGEST_ARROW / acceleration : 0,
    };
  }

  /** @param {number} place @param {Wanted} wanted */
  show(place, wanted) {
    this.widen(wanted.poles || wanted.centrodes);
    const points = this.poses.at(place);
    const { labels, bars, circles, pivots } = this.skeleton;
    circles.forEach((centre, number) => moveCircle(this.circles[number], points[centre]));
    pivots.forEach((pivot, number) => this.pivots[number].setAttribute("d", writePivot(points[pivot])));
    bars.forEach((corners, number) =>
      this.bars[number].setAttribute("points", writeCorners(corners.map((corner) => points[corner]))),
    );
    this.showGuides(points);
    labels.forEach((_, row) => {
      moveCircle(this.joints[row], points[row]);
      const turn = this.findBlock(row, points);
      if (turn === null) moveLetter(this.letters[row], points[row], this.findFree(row, points));
      else moveLetter(this.letters[row], points[row], findBesideBlock(turn), BESIDE_BLOCK);
    });
    for (const trace of this.traces) trace.toggleAttribute("hidden", !wanted.paths);
    for (const pole of this.poles) pole.show(place, wanted);
    this.showArrows(place, points, wanted);
  }

  /** @param {boolean} wide whether what lies beside the mechanism is seen as well */
  widen(wide) {
    const { width, height } = this.poses.motion;
    const seen = wide ? this.poles.flatMap((pole) => pole.seen) : [];
    const [left, right] = stretch(width, seen.map(([x]) => x));
    const [top, bottom] = stretch(height, seen.map(([, y]) => y));
    this.stage.setAttribute("viewBox", `${left} ${top} ${right - left} ${bottom - top}`);
    this.stage.style.width = `${(right - left) * PIXELS}px`;
  }

  /**
   * @param {number} row
   * @param {[number, number][]} points
   * @returns {number | null} the angle of the guide whose block is drawn at a point
   */
  findBlock(row, points) {
    const number = this.skeleton.riders.findIndex((rider, each) => rider === row && this.skeleton.blocks[each]);
    return number < 0 ? null : findTurn(this.findEnds(points, number));
  }

  /**
   * The direction of a point's letter: amid the widest angle between the bars there and the support
   * under a pivot.
   * @param {number} row
   * @param {[number, number][]} points
   * @returns {[number, number]}
   */
  findFree(row, points) {
    const { bars, pivots } = this.skeleton;
    const ends = bars.filter((each) => each.includes(row)).flat().map((corner) => points[corner]);
    const apart = ends.filter(([x, y]) => Math.hypot(x - points[row][0], y - points[row][1]) > SEEN);
    const angles = apart.map((end) => findTurn([points[row], end]));
    if (pivots.includes(row)) angles.push(Math.PI / 3, (2 * Math.PI) / 3);
    if (!angles.length) return UP_RIGHT;
    angles.sort((one, other) => one - other);
    const next = [...angles.slice(1), angles[0] + 2 * Math.PI];
    const widths = angles.map((angle, number) => next[number] - angle);
    const widest = widths.indexOf(Math.max(...widths));
    const middle = angles[widest] + widths[widest] / 2;
    return [Math.cos(middle), Math.sin(middle)];
  }

  /** @param {[number, number][]} points @param {number} number @returns {[number, number][]} of a guide */
  findEnds(points, number) {
    const first = this.skeleton.labels.length + 2 * number;
    return points.slice(first, first + 2);
  }

  /** @param {[number, number][]} points */
  showGuides(points) {
    this.skeleton.riders.forEach((rider, number) => {
      const ends = this.findEnds(points, number);
      this.guides[number].setAttribute("points", writeCorners(ends));
      const [x, y] = points[rider];
      const angle = (findTurn(ends) * 180) / Math.PI;
      this.sliders[number].setAttribute("transform", `translate(${x} ${y}) rotate(${angle})`);
    });
  }

  /**
   * @param {number} place
   * @param {[number, number][]} points
   * @param {Wanted} wanted
   */
  showArrows(place, points, wanted) {
    const rates = this.poses.rates(place);
    for (const name of /** @type {const} */ (["velocities", "accelerations"])) {
      this[name].forEach((arrow, row) => {
        const [x, y] = rates[name][row].map((part) => part * this.scales[name]);
        const drawn = wanted[name] && this.skeleton.labels[row];
        arrow.setAttribute("d", drawn ? writeArrow(points[row], x, y) : "");
      });
    }
  }
}

/** @param {SVGElement} circle @param {[number, number]} centre */
function moveCircle(circle, [x, y]) {
  circle.setAttribute("cx", x.toFixed(2));
  circle.setAttribute("cy", y.toFixed(2));
}

/** @param {[number, number][]} ends @returns {number} the angle of a line, rad */
function findTurn([[left, top], [right, bottom]]) {
  return Math.atan2(bottom - top, right - left);
}

/** @param {number} turn @returns {[number, number]} across a block along a line of this angle */
function findBesideBlock(turn) {
  const side = Math.cos(turn) < 0 ? -1 : 1;
  return [side * Math.sin(turn), -side * Math.cos(turn)];
}

/**
 * Moves a letter beside its point.
 * @param {SVGElement} letter
 * @param {[number, number]} point
 * @param {[number, number]} direction
 * @param {number} [far] mm
 */
function moveLetter(letter, [x, y], [across, down], far = LETTER_AWAY) {
  letter.setAttribute("x", String(x + far * across));
  letter.setAttribute("y", String(y + far * down + 1.1));
  letter.setAttribute("text-anchor", "middle");
}

/** @param {number} size @param {number[]} seen @returns {[number, number]} ends that hold all of it */
function stretch(size, seen) {
  return [Math.min(0, ...seen.map((each) => each - ROOM)), Math.max(size, ...seen.map((each) => each + ROOM))];
}

/** @param {[number, number]} point @returns {string} the support under a fixed pivot */
function writePivot([x, y]) {
  return `M${x} ${y}l-2.6 4.6h5.2zM${x - 4} ${y + 4.6}h8`;
}

/** @param {[number, number]} start @param {number} x @param {number} y @returns {string} */
function writeArrow([left, top], x, y) {
  const length = Math.hypot(x, y);
  if (!(length > SEEN) || length > 4 * LONGEST_ARROW) return "";
  const [across, down] = [x / length, y / length];
  const [tipX, tipY] = [left + x, top + y];
  const barb = (/** @type {number} */ side) =>
    `L${tipX - 2.2 * across - side * 0.8 * down} ${tipY - 2.2 * down + side * 0.8 * across}`;
  return `M${left} ${top}L${tipX} ${tipY}${barb(1)}M${tipX} ${tipY}${barb(-1)}`;
}
