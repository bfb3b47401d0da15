// @ts-check
// Verdicts in sentences.

/** @typedef {{words: Words, mistakes: Record<string, string>}} Sayings */

/**
 * What is said of an answer.
 * @param {Verdict} verdict
 * @param {Key} key
 * @param {Ask} ask
 * @param {Sayings} sayings
 * @returns {string}
 */
function explainVerdict(verdict, key, ask, { words, mistakes }) {
  switch (verdict.kind) {
    case "blank":
      return words.say("blank");
    case "unreadable":
      return words.say("unreadable", { reason: verdict.reason });
    case "wrong unit":
      return words.say("wrong-unit", { reason: verdict.reason });
    case "right":
      return joinSentences(words.say("right"), tellReading(verdict, ask, words));
    case "follow-through":
      return joinSentences(words.say("follow-through"), tellReading(verdict, ask, words));
    case "mistake": {
      const sentences = verdict.mistakes.map((name) => mistakes[name] ?? name);
      const either = sentences.reduce((first, second) => words.say("either-mistake", { first, second }));
      return joinSentences(words.say("wrong"), either, tellReading(verdict, ask, words));
    }
    default: {
      const guess = guessSlip(verdict.value, key, ask.unit);
      const said = guess ? tellGuess(guess, words) : "";
      return joinSentences(words.say("wrong"), said, tellReading(verdict, ask, words));
    }
  }
}

/** @param {...string} sentences */
function joinSentences(...sentences) {
  return sentences.filter((each) => each).join(" ");
}

/** @param {Verdict} verdict @param {Ask} ask @param {Words} words how the number was read */
function tellReading({ value }, ask, words) {
  return words.say("read-as", { value, unit: ask.unit === "1" ? "" : ask.unit });
}

/** @param {Guess} guess @param {Words} words */
function tellGuess({ kind, reversed, power }, words) {
  const hint = words.say(kind, { factor: String(10 ** Math.abs(power)) });
  return reversed ? words.say("turned-as-well", { hint }) : hint;
}
