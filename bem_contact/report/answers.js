// Which contacts an answer has, and how it ended. `data` and `report`: what the page shows.
import {models} from "../record/words.json";
import {contactOf} from "./contact_figures.js";

const TITLES = {...Object.fromEntries(Object.entries(models).map(([name, {title}]) => [name, title])),
                right: "Right wheel", left: "Left wheel"}; // in that order; of wheelsets the last two
// A model that is not here has its name in scenes, and stands behind the others.
export const titleOf = name => TITLES[name] ?? name, shortOf = name => models[name]?.short ?? name;
export const namesIn =
    group => [...new Set([...Object.keys(TITLES), ...Object.keys(group ?? {})])].filter(name => group?.[name]);
export const SETS = {at_equal_forces: "At equal forces", at_equal_position: "At equal position and vertical force"};

/// The contacts of a group: itself, or one of each model or wheel.
export const contactsOf = group => {
  if (group?.p_n)
    return [contactOf(group.attributes.model, group)];
  const inside = name => group?.[name]?.result ?? group?.[name];
  return namesIn(group).filter(name => inside(name)?.p_n)
    .map(name => contactOf(name, inside(name)));
};
export const certifiedOf = group => group.attributes.certified === 1;
/// How an answer ended, by its number in files (record/outcome.hpp), and how many cases are it.
export const OUTCOMES = ["missing", "certified", "not certified", "refused", "died", "failed"];
const COUNTED = {
  certified: "are certified",
  "not certified": "are not",
  refused: "were refused",
  died: "died",
  failed: "failed",
  missing: "are missing"
};
export const countsText = countOf => Object.entries(COUNTED)
                                  .map(([outcome, text]) => [countOf(outcome), text])
                                  .filter(([count], k) => count > 0 || k === 0)
                                  .map(([count, text]) => `${count} ${text}`)
                                  .join(", ");
