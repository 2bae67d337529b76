// solve() by Node.
import {ContactError, questionOf, resultOf, solvedAs} from "./ask.mjs";
import {replyTo} from "./solver.mjs";

export const solve = async (scene, options) => resultOf(await replyTo(questionOf(solvedAs(options), scene, options)));
export {ContactError};
