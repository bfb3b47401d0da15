// @ts-check
// Shows one drawing of a mechanism after the other.

{
  const box = /** @type {Element} */ (document.getElementById(ID));
  const stage = /** @type {Element} */ (box.querySelector("g.moving"));
  const shown = /** @type {Element} */ (box.querySelector("output"));
  const { drawings, moved, first, closed } = DATA;
  const player = new Player(box, DATA, (place) => {
    const number = Math.round(place) % drawings.length;
    stage.innerHTML = drawings[number];
    shown.textContent = moved[number];
  });
  player.load({ last: drawings.length - (closed ? 0 : 1), closed, first, sense: 1 });
}
