// What makes a page hard to read: words on words, words that are cut off, and what is wider than the sheet; one line for each.
(() => {
  const found = [], box = element => element.getBoundingClientRect();
  const shown = element => element.textContent.trim() && box(element).width > 0 && getComputedStyle(element).visibility !== "hidden" &&
                           !element.closest(".modebar-container, .hoverlayer");
  for (const figure of document.querySelectorAll(".figure")) {
    const frame = box(figure), words = [...figure.querySelectorAll("svg text")].filter(shown);
    words.forEach((word, k) => {
      const a = box(word);
      if (a.left < frame.left - 1 || a.right > frame.right + 1 || a.top < frame.top - 1 || a.bottom > frame.bottom + 1)
        found.push(`${figure.id}: '${word.textContent}' is cut off`);
      for (const other of words.slice(k + 1)) {
        const b = box(other), wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (wide > 2 && high > 3) // px: the empty borders of two boxes may touch
          found.push(`${figure.id}: '${word.textContent}' lies on '${other.textContent}'`);
      }
    });
  }
  const edge = box(document.body).right + 1;
  for (const element of document.querySelectorAll("table, pre, .figure"))
    if (box(element).right > edge && !element.closest("details:not([open])")) // what is folded is not shown
      found.push(`${element.id || element.tagName} is wider than the page`);
  return found.join("\n");
})()
