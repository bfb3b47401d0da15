// @ts-check
// Tells the score to a learning management system by SCORM 1.2, where the page stands inside one.

/**
 * @typedef {object} ScormApi
 * @property {(empty: "") => string} LMSInitialize
 * @property {(name: string) => string} LMSGetValue
 * @property {(name: string, value: string) => string} LMSSetValue
 * @property {(empty: "") => string} LMSCommit
 * @property {(empty: "") => string} LMSFinish
 */

/** @returns {ScormApi | null} that of a window around this one, or of the one that opened it */
function findScorm() {
  for (const start of [window, window.opener]) {
    let within = start;
    for (let depth = 0; within && depth < 10; depth += 1) {
      if (within.API) return within.API;
      if (within.parent === within) break;
      within = within.parent;
    }
  }
  return null;
}

const scorm = findScorm();
let reported = 0; // per cent, perhaps of an earlier visit
if (scorm) {
  scorm.LMSInitialize("");
  reported = Number(scorm.LMSGetValue("cmi.core.score.raw")) || 0;
  addEventListener("pagehide", () => scorm.LMSFinish(""), { once: true });
}

/** @param {number} earned @param {number} points */
function reportScore(earned, points) {
  const share = points ? earned / points : 0;
  const score = Math.round(100 * share);
  if (!scorm || score < reported) return;
  reported = score;
  scorm.LMSSetValue("cmi.core.score.min", "0");
  scorm.LMSSetValue("cmi.core.score.max", "100");
  scorm.LMSSetValue("cmi.core.score.raw", String(score));
  scorm.LMSSetValue("cmi.core.lesson_status", share === 1 ? "completed" : "incomplete");
  scorm.LMSCommit("");
}
