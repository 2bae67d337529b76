// What is asked of the solver, and what its reply means: the same by Node and in a page.

/// A scene that cannot be solved. `kind`: "refused" (the input is wrong), "not certified", "died", "failed".
export class ContactError extends Error {
  constructor({kind, message}) {
    super(message);
    this.name = "ContactError";
    this.kind = kind;
  }
}

/// What is asked when solve() has these options.
export const solvedAs = ({fields = false} = {}) => fields ? "fields" : "numbers";

/// A question as a message for solver.js. `what`: a name of all_asked (explore/answers.hpp); the rest are solve()'s arguments.
export const questionOf = (what, scene, {changes = {}, files = {}, influence = {}} = {}) => {
  if (typeof scene !== "string")
    throw new TypeError("The scene is no text (solve() takes TOML, not a file) Read the file, and give its text.");
  return {what, question: JSON.stringify({text: scene, changes, files}), influence};
};

/// The reply's bytes as a result. Throws ContactError.
export const resultOf = body => {
  const answer = JSON.parse(new TextDecoder().decode(body));
  if (answer.problem)
    throw new ContactError(answer.problem);
  return answer;
};
