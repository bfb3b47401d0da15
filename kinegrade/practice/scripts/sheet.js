// @ts-check
// Starts the page.

/** @param {Baked} baked */
function startSheet({ sheet, vocabulary, wording }) {
  const words = new Words(wording);
  const said = find(document, "#score");
  const score = new Score(sheet.questions, (earned, points) => {
    said.textContent = words.say("score", { earned, points });
    reportScore(earned, points);
  });
  const setting = { words, mistakes: sheet.mistakes, reader: new AnswerReader(vocabulary), score };
  sheet.questions.forEach((question, place) => {
    const box = copyTemplate("question");
    find(document, "main").append(box);
    new QuestionView(question, place, box, setting);
  });
  score.report(score.earned, score.total);
}

unpack(find(document, "#baked").textContent ?? "").then(startSheet);
