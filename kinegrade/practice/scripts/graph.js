// @ts-check
// Small graphs of what is asked, over the cycle, with the place that is shown.

const GRAPH_WIDTH = 300;
const GRAPH_HEIGHT = 84;

/** Draws the curve of an ask. */
class Graph {
  /**
   * @param {Element} place
   * @param {Ask} ask
   * @param {[number, number, string]} curve
   * @param {Poses} poses
   * @param {Words} words
   */
  constructor(place, ask, [least, greatest, steps], poses, words) {
    const box = document.createElement("figure");
    const values = sumUp(steps).map((value) => value / CURVE_STEPS);
    this.values = values.length === 1 ? poses.moved.map(() => 0.5) : values;
    this.poses = poses;
    this.whole = poses.motion.closed ? poses.entry(poses.moved, poses.count, 1) : 1;
    const [low, high] = [least, greatest].map((value) => words.writeNumber(value, 3));
    box.innerHTML = `<figcaption>${ask.label}: ${low} … ${high} ${ask.shown}</figcaption>`;
    const graph = makeShape("svg", { viewBox: `0 0 ${GRAPH_WIDTH} ${GRAPH_HEIGHT}`, class: "graph", "aria-hidden": "true" });
    const corners = poses.moved.map((moved, row) => this.corner(moved, this.values[row]));
    if (poses.motion.closed) corners.push(this.corner(this.whole, this.values[0]));
    graph.append(makeShape("polyline", { class: "curve", points: writeCorners(corners) }));
    this.mark = makeShape("circle", { class: "mark", r: 4 });
    graph.append(this.mark);
    box.append(graph);
    place.append(box);
  }

  /** @param {number} moved @param {number} value @returns {[number, number]} */
  corner(moved, value) {
    const across = 4 + ((GRAPH_WIDTH - 8) * moved) / this.whole;
    return [across, GRAPH_HEIGHT - 8 - (GRAPH_HEIGHT - 16) * value];
  }

  /** @param {number} place */
  show(place) {
    const { poses, values } = this;
    const row = Math.min(Math.floor(place), poses.last - 1);
    const between = (/** @type {number} */ first, /** @type {number} */ second) =>
      first + (second - first) * (place - row);
    const value = between(values[row], values[(row + 1) % poses.count]);
    const moved = between(poses.entry(poses.moved, row, 1), poses.entry(poses.moved, row + 1, 1));
    moveCircle(this.mark, this.corner(moved, value));
  }
}
