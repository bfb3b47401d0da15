// @ts-check
// The baked positions of a mechanism, and those between them.

/**
 * @typedef {object} Motion
 * @property {boolean} closed
 * @property {boolean} poles
 * @property {number} width
 * @property {number} height
 * @property {number} low
 * @property {number} high
 * @property {string} moved
 * @property {number} speed
 * @property {number} acceleration
 * @property {number[]} radii
 * @property {string[]} coordinates
 * @property {[least: number, greatest: number, steps: string, gaps: number[]][]} curves
 */

const ORDER = 4; // of the differences by which positions are written
const FINE = 4000; // steps of a millimetre
const MOVED_STEPS = 200000; // of the whole way of the input
const CURVE_STEPS = 1000;
const NEIGHBOURS = 8; // positions of which one between them is made
const TOGETHER = "="; // before how a place goes with two others, which are written themselves
const HALVINGS = 30;
const PLACES = 4; // of a curve for each position

/** @typedef {{first: number, weights: number[][]}} Near positions about a place, and their weights */

/** @param {string} text @returns {number[]} the values behind their differences of the last order */
function sumUp(text) {
  const numbers = text.split(" ").map(Number);
  const order = Math.min(ORDER, numbers.length - 1);
  let values = numbers.slice(order);
  for (const first of numbers.slice(0, order).reverse()) {
    let sum = first;
    values = [first, ...values.map((rise) => (sum += rise))];
  }
  return values;
}

/** @param {string[]} coordinates @returns {number[][]} x and y of each place in mm */
function readRows(coordinates) {
  const rows = coordinates.map((text) =>
    text.startsWith(TOGETHER) ? [] : sumUp(text).map((value) => value / FINE),
  );
  for (let row = 0; row < rows.length; row += 2) {
    if (rows[row].length) continue;
    const [first, second, along, across] = coordinates[row].slice(1).split(" ").map(Number);
    const others = [2 * first, 2 * first + 1, 2 * second, 2 * second + 1].map((each) => rows[each]);
    const count = Math.max(...others.map((other) => other.length));
    for (let place = 0; place < count; place += 1) {
      const [x, y, toX, toY] = others.map((other) => other[other.length === 1 ? 0 : place]);
      rows[row].push(x + along * (toX - x) - across * (toY - y));
      rows[row + 1].push(y + along * (toY - y) + across * (toX - x));
    }
  }
  return rows;
}

/** Positions by how many of them have been passed, a number that need not be whole. */
class Poses {
  /** @param {Motion} motion */
  constructor(motion) {
    this.motion = motion;
    this.rows = readRows(motion.coordinates);
    this.moved = sumUp(motion.moved).map((value) => value / MOVED_STEPS);
    this.count = this.moved.length;
  }

  /** @returns {number} the last place */
  get last() {
    return this.motion.closed ? this.count : this.count - 1;
  }

  /** @returns {number[]} places close enough for curves */
  get fine() {
    return Array.from({ length: PLACES * this.last + 1 }, (_, number) => number / PLACES);
  }

  /** @returns {number} the place of the instant: where the input has not moved */
  get instant() {
    const { low, high } = this.motion;
    const share = -low / (high - low);
    const after = this.moved.findIndex((each) => each >= share - 1e-9);
    if (after <= 0) return 0;
    let [below, above] = [after - 1, after];
    for (let round = 0; round < HALVINGS; round += 1) {
      const middle = (below + above) / 2;
      if (this.shareAt(middle) < share) below = middle;
      else above = middle;
    }
    return above;
  }

  /** @param {number} place @returns {number} how far the input has moved since the instant */
  inputAt(place) {
    const { low, high } = this.motion;
    return low + (high - low) * this.shareAt(place);
  }

  /** @param {number} place @returns {number} the same as a part of the way from `low` to `high` */
  shareAt(place) {
    return this.combine(this.moved, this.near(place), 0, true);
  }

  /** @param {number} place @returns {[number, number][]} where the points are, in mm */
  at(place) {
    const near = this.near(place);
    return pair(this.rows.map((row) => this.combine(row, near, 0)));
  }

  /**
   * Where a point is, in mm, and how far it goes from a place to the next one.
   * @param {number} point
   * @param {Near} near
   * @returns {{x: number, y: number, across: number, down: number}}
   */
  follow(point, near) {
    const [left, top] = [this.rows[2 * point], this.rows[2 * point + 1]];
    return {
      x: this.combine(left, near, 0),
      y: this.combine(top, near, 0),
      across: this.combine(left, near, 1),
      down: this.combine(top, near, 1),
    };
  }

  /** @param {number} place @param {number} [wanted] how many positions @returns {Near} */
  near(place, wanted = NEIGHBOURS) {
    const count = Math.min(wanted, this.count);
    const before = Math.floor(place) - Math.floor((count - 1) / 2);
    const first = this.motion.closed ? before : clamp(before, 0, this.count - count);
    return { first, weights: weigh(place - first, count) };
  }

  /**
   * What becomes of a row at a place: its value there, or its first or second derivative.
   * @param {number[]} row
   * @param {Near} near
   * @param {number} order of the derivative
   * @param {boolean} [turns] whether it grows by 1 from turn to turn
   * @returns {number}
   */
  combine(row, { first, weights }, order, turns = false) {
    if (row.length === 1) return order ? 0 : row[0];
    return weights[order].reduce(
      (sum, weight, number) => sum + weight * this.entry(row, first + number, turns),
      0,
    );
  }

  /**
   * A row's value at a whole place, in closed cycles also before and after it.
   * @param {number[]} row
   * @param {number} whole
   * @param {boolean} turns whether it grows by 1 from turn to turn
   * @returns {number}
   */
  entry(row, whole, turns) {
    if (!this.motion.closed) return row[clamp(whole, 0, this.count - 1)];
    const wrapped = modulo(whole, this.count);
    return row[wrapped] + (turns ? (whole - wrapped) / this.count : 0);
  }

  /** @param {number[]} places @returns {number[]} those of the turns before and after as well */
  repeat(places) {
    if (!this.motion.closed) return places;
    return places.flatMap((place) => [place - this.count, place, place + this.count]);
  }

  /**
   * Velocities and accelerations of the points in mm, the given ones of the input being at work.
   * @param {number} place
   * @returns {{velocities: [number, number][], accelerations: [number, number][]}}
   */
  rates(place) {
    const { closed, low, high, speed, acceleration } = this.motion;
    const near = this.near(closed ? place : clamp(place, 2, this.last - 2));
    const [slope, bend] = [1, 2].map(
      (order) => (high - low) * this.combine(this.moved, near, order, true),
    );
    const found = this.rows.map((row) => {
      const rise = this.combine(row, near, 1) / slope;
      const bent = (this.combine(row, near, 2) - rise * bend) / slope ** 2;
      return { velocity: rise * speed, acceleration: bent * speed ** 2 + rise * acceleration };
    });
    return {
      velocities: pair(found.map((each) => each.velocity)),
      accelerations: pair(found.map((each) => each.acceleration)),
    };
  }
}

/**
 * The weights with which values at 0, 1, 2 ... give that at a place between them, and its first and
 * second derivative: Fornberg, Mathematics of Computation 51 (1988) 699.
 * @param {number} place
 * @param {number} count
 * @returns {number[][]}
 */
function weigh(place, count) {
  const weights = [0, 1, 2].map(() => new Array(count).fill(0));
  weights[0][0] = 1;
  let product = 1;
  for (let last = 1; last < count; last += 1) {
    const [before, here] = [last - 1 - place, last - place];
    let next = 1;
    for (let number = 0; number < last; number += 1) {
      next *= last - number;
      for (let order = 2; order >= 0; order -= 1) {
        const lower = (/** @type {number} */ each) => (order ? order * weights[order - 1][each] : 0);
        const row = weights[order];
        if (number === last - 1) {
          row[last] = (product * (lower(number) - before * row[number])) / next;
        }
        row[number] = (here * row[number] - lower(number)) / (last - number);
      }
    }
    product = next;
  }
  return weights;
}

/** @param {number[]} numbers @returns {[number, number][]} */
function pair(numbers) {
  /** @type {[number, number][]} */
  const pairs = [];
  for (let row = 0; row < numbers.length; row += 2) pairs.push([numbers[row], numbers[row + 1]]);
  return pairs;
}
