// The program answers. reply_of_worker.js stands here where a solver inside the page does; nothing else on the page
// knows which.
export const NOTE = "";
export const SILENT =
    "The program does not answer (it was ended, or this machine has lost it) Start bem_contact explore again.";

/// What is answered to a question, as a Response; throws where nobody answers. `what`: a name of all_asked
/// (answers.hpp).
export const replyTo = (what, question) =>
    fetch(what, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(question)});
