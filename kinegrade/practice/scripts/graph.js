// @ts-check
// Small graphs of what is asked, over the cycle, with the place that is shown.

const GRAPH_WIDTH = 300;
const GRAPH_HEIGHT = 84;
const BESIDE = 4; // positions that shape a curve between them: more would swing where it is cut off

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
    this.values = values.length === 1 ? [0.5] : values;
    this.poses = poses;
    this.whole = poses.shareAt(poses.last);
    const [low, high] = [least, greatest].map((value) => words.writeNumber(value, 3));
    box.innerHTML = `<figcaption>${ask.label}: ${low} … ${high} ${ask.shown}</figcaption>`;
    const graph = makeShape("svg", { viewBox: `0 0 ${GRAPH_WIDTH} ${GRAPH_HEIGHT}`, class: "graph", "aria-hidden": "true" });
    const corners = poses.fine.map((place) => this.corner(place));
    graph.append(makeShape("polyline", { class: "curve", points: writeCorners(corners) }));
    this.mark = makeShape("circle", { class: "mark", r: 4 });
    graph.append(this.mark);
    box.append(graph);
    place.append(box);
  }

  /** @param {number} place @returns {[number, number]} the corner of the curve there */
  corner(place) {
    const { poses, values } = this;
    const value = clamp(poses.combine(values, poses.near(place, BESIDE), 0), 0, 1);
    const across = 4 + ((GRAPH_WIDTH - 8) * poses.shareAt(place)) / this.whole;
    return [across, GRAPH_HEIGHT - 8 - (GRAPH_HEIGHT - 16) * value];
  }

  /** @param {number} place */
  show(place) {
    moveCircle(this.mark, this.corner(place));
  }
}
