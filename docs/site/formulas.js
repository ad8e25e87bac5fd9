// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the formulas of a page by KaTeX: the TeX of a ```math block stands in \[ ... \].
document.addEventListener("DOMContentLoaded", () => {
  for (const block of document.querySelectorAll(".arithmatex"))
    katex.render(block.textContent.trim().replace(/^\\\[|\\\]$/g, ""), block, {displayMode: true});
});
