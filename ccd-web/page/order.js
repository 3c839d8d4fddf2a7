// Which of two files is the start of the step, by their names.

/** Words of a name that say so. */
const START = /(^|[^a-z])(before|start|old|first)([^a-z]|$)/i;

/** The start, then the end: by numbers of otherwise equal names, by words, else as they came. */
export function inOrder([p, q]) {
  const rest = ({ name }) => name.replace(/\d+/g, "");
  // Digits after a point are not a number of their own.
  const isNumbered = rest(p) === rest(q) && !/\d\.\d/.test(p.name + q.name);
  const swap = isNumbered
    ? p.name.localeCompare(q.name, "en", { numeric: true }) > 0
    : START.test(q.name) && !START.test(p.name);
  return swap ? [q, p] : [p, q];
}
