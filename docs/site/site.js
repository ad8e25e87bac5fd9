// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the formulas of a page by KaTeX: the TeX of a ```math block stands in \[ ... \]. Read from a folder, without a
// server, a browser does not let the search read its index: the search is not shown there.
document.addEventListener("DOMContentLoaded", () => {
  for (const block of document.querySelectorAll(".arithmatex"))
    katex.render(block.textContent.trim().replace(/^\\\[|\\\]$/g, ""), block, {displayMode: true});
  if (location.protocol === "file:")
    for (const part of document.querySelectorAll(".md-search, label[for=__search]")) part.remove();
});
