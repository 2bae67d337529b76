// What is asked of the solver, and what its reply means: the same by Node and in a page.

/// A scene that cannot be solved. `kind`: "refused" (the input is wrong), "not certified", "died", "failed".
export class ContactError extends Error {
  constructor({kind, message}) {
    super(message);
    this.name = "ContactError";
    this.kind = kind;
  }
}

/// solve()'s arguments as a message for solver.js.
export const questionOf = (scene, {changes = {}, files = {}, influence = {}, fields = false} = {}) => {
  if (typeof scene !== "string")
    throw new TypeError("The scene is no text (solve() takes TOML, not a file) Read the file, and give its text.");
  return {what: fields ? "fields" : "numbers", question: JSON.stringify({text: scene, changes, files}), influence};
};

/// The reply's bytes as a result. Throws ContactError.
export const resultOf = body => {
  const answer = JSON.parse(new TextDecoder().decode(body));
  if (answer.problem)
    throw new ContactError(answer.problem);
  return answer;
};
