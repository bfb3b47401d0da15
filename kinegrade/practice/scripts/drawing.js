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
 * @property {string} input
 * @property {string} unit
 */

const LONGEST_ARROW = 18; // mm
const NEXT_TO_NOTHING = 0.03;
const SEEN = 0.6; // mm: shorter arrows are not drawn
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
    const { width, height, radii } = poses.motion;
    stage.replaceChildren();
    stage.setAttribute("viewBox", `0 0 ${width} ${height}`);
    stage.style.width = `${width * PIXELS}px`;
    this.skeleton = skeleton;
    this.poses = poses;
    const add = (/** @type {string} */ name, /** @type {Record<string, string | number>} */ attributes) =>
      stage.appendChild(makeShape(name, attributes));
    this.traces = this.listMoving().map((row) => add("polyline", { class: "trace", points: this.trace(row) }));
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

  /** @param {number} row @returns {string} the way of a point */
  trace(row) {
    const { poses } = this;
    const fine = Array.from({ length: 4 * poses.last + 1 }, (_, step) => poses.at(step / 4)[row]);
    return writeCorners(fine);
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

  /** @param {number} place @param {{velocities: boolean, accelerations: boolean}} wanted */
  show(place, wanted) {
    const points = this.poses.at(place);
    const { labels, bars, circles, pivots } = this.skeleton;
    circles.forEach((centre, number) => moveCircle(this.circles[number], points[centre]));
    pivots.forEach((pivot, number) => this.pivots[number].setAttribute("d", writePivot(points[pivot])));
    bars.forEach((corners, number) =>
      this.bars[number].setAttribute("points", writeCorners(corners.map((corner) => points[corner]))),
    );
    this.showGuides(points, labels.length);
    labels.forEach((_, row) => {
      moveCircle(this.joints[row], points[row]);
      this.letters[row].setAttribute("x", String(points[row][0] + 1.6));
      this.letters[row].setAttribute("y", String(points[row][1] - 1.6));
    });
    this.showArrows(place, points, wanted);
  }

  /** @param {[number, number][]} points @param {number} first the place of the guides' ends */
  showGuides(points, first) {
    this.skeleton.riders.forEach((rider, number) => {
      const ends = points.slice(first + 2 * number, first + 2 * number + 2);
      this.guides[number].setAttribute("points", writeCorners(ends));
      const turn = Math.atan2(ends[1][1] - ends[0][1], ends[1][0] - ends[0][0]);
      const [x, y] = points[rider];
      const angle = (turn * 180) / Math.PI;
      this.sliders[number].setAttribute("transform", `translate(${x} ${y}) rotate(${angle})`);
    });
  }

  /**
   * @param {number} place
   * @param {[number, number][]} points
   * @param {{velocities: boolean, accelerations: boolean}} wanted
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
