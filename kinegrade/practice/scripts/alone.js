// @ts-check
// The score stays in the page.

/** @param {number} _earned @param {number} _points */
function reportScore(_earned, _points) {}
