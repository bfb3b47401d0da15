// @ts-check
// The velocity pole of a body, and its centrodes: the curve of poles in the plane and in the body.

const ROUNDED = 0.5 / FINE; // mm: what coordinates may be off
const PRECISE = 0.2; // mm: where rounding could move a pole further, it is not shown
const FEWER = 6; // neighbours, from which the pole is found again
const STEADY = 0.5; // mm: where it is then further away, positions are too few to tell
const REACH = 70; // mm beside the mechanism's frame that poles are shown in
const LEAP = 12; // mm between neighbours of a curve that are not joined

/**
 * @typedef {object} Pole
 * @property {[number, number]} at in the drawing, mm
 * @property {[number, number]} inside in the body, mm from its first point along to its second, and across
 */

/**
 * The velocity pole of the body with these two points; null where it is not known to a pixel.
 * @param {Poses} poses
 * @param {[number, number]} points
 * @param {number} place
 * @returns {Pole | null}
 */
function findPole(poses, points, place) {
  const [{ pole, doubt }, coarse] = [NEIGHBOURS, FEWER].map((count) =>
    workOutPole(poses, points, poses.near(place, count)),
  );
  if (!poses.motion.poles) return null;
  const change = Math.hypot(pole.at[0] - coarse.pole.at[0], pole.at[1] - coarse.pole.at[1]);
  return doubt <= PRECISE && change <= STEADY ? pole : null;
}

/**
 * @param {Poses} poses
 * @param {[number, number]} points
 * @param {Near} near
 * @returns {{pole: Pole, doubt: number}} the pole, and how far rounding alone could have moved it
 */
function workOutPole(poses, points, near) {
  const [first, second] = points.map((point) => poses.follow(point, near));
  const [along, down] = [second.x - first.x, second.y - first.y];
  const length = Math.hypot(along, down);
  const rate = (along * (second.down - first.down) - down * (second.across - first.across)) / length ** 2;
  const [x, y] = [-first.down / rate, first.across / rate];
  const noise = ROUNDED * near.weights[1].reduce((sum, weight) => sum + Math.abs(weight), 0);
  return {
    pole: {
      at: [first.x + x, first.y + y],
      inside: [(x * along + y * down) / length, (y * along - x * down) / length],
    },
    doubt: (noise / Math.abs(rate)) * (1 + (2 * Math.hypot(x, y)) / length),
  };
}

/** Draws the pole of a body, the lines to it, its centrodes. */
class PoleDrawing {
  /** @param {SVGElement} stage @param {Skeleton["poles"][0]} body @param {Poses} poses */
  constructor(stage, { letter, points, lines }, poses) {
    const add = (/** @type {string} */ name, /** @type {Record<string, string | number>} */ attributes) =>
      stage.appendChild(makeShape(name, attributes));
    this.points = points;
    this.ends = lines;
    this.poses = poses;
    const found = poses.fine.map((place) => this.find(place));
    this.seen = found.flatMap((pole) => (pole ? [pole.at] : []));
    this.fixed = add("path", { class: "fixed-centrode", d: writeCurve(found.map((pole) => pole && pole.at)) });
    this.moving = add("path", { class: "moving-centrode", d: writeCurve(found.map((pole) => pole && pole.inside)) });
    this.lines = add("path", { class: "ray" });
    this.mark = add("circle", { class: "pole", r: 1.1 });
    this.letter = add("text", { class: "letter pole" });
    this.letter.innerHTML = letter;
  }

  /** @param {number} place @returns {Pole | null} null also where it is not in the picture */
  find(place) {
    const { width, height } = this.poses.motion;
    const pole = findPole(this.poses, this.points, place);
    const [x, y] = pole?.at ?? [Infinity, Infinity];
    const isNear = x > -REACH && x < width + REACH && y > -REACH && y < height + REACH;
    return isNear ? pole : null;
  }

  /** @param {number} place @param {Wanted} wanted */
  show(place, wanted) {
    const pole = this.find(place);
    this.fixed.toggleAttribute("hidden", !wanted.centrodes);
    this.moving.toggleAttribute("hidden", !wanted.centrodes);
    for (const each of [this.lines, this.mark, this.letter]) {
      each.toggleAttribute("hidden", !pole || !wanted.poles);
    }
    const points = this.poses.at(place);
    const [first, second] = this.points.map((point) => points[point]);
    const turn = (findTurn([first, second]) * 180) / Math.PI;
    this.moving.setAttribute("transform", `translate(${first[0]} ${first[1]}) rotate(${turn})`);
    if (!pole) return;
    const lines = this.ends.map((end) => writeCurve([pole.at, points[end]], Infinity));
    this.lines.setAttribute("d", lines.join(""));
    moveCircle(this.mark, pole.at);
    moveLetter(this.letter, pole.at, UP_RIGHT);
  }
}

/**
 * @param {([number, number] | null)[]} corners
 * @param {number} [leap] mm between corners that are not joined
 * @returns {string} a path, broken where it is unknown
 */
function writeCurve(corners, leap = LEAP) {
  /** @type {[number, number] | null} */
  let before = null;
  return corners
    .map((corner) => {
      const joined = corner && before && Math.hypot(corner[0] - before[0], corner[1] - before[1]) < leap;
      before = corner;
      return corner ? `${joined ? "L" : "M"}${corner[0].toFixed(2)} ${corner[1].toFixed(2)}` : "";
    })
    .join("");
}
