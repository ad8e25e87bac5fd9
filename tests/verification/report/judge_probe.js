// SPDX-License-Identifier: GPL-3.0-or-later
// Runs on the page of ehd judge, as browser_probe.js does on the report, and writes what it sees into the page around.
"use strict";
(async function () {
  var seen = window.seen;
  function all(selector) { return Array.prototype.slice.call(document.querySelectorAll(selector)); }
  seen.push("overflow: " + Math.max(0, document.documentElement.scrollWidth - window.innerWidth));
  var box = document.querySelector("#first .scroll");
  seen.push("table: " + (box.scrollWidth <= box.clientWidth ? "fits" : box.scrollWidth + " of " + box.clientWidth));
  // A look in a legend: the outline of the mark, moved to the origin, its colour and whether it is filled.
  all("svg.plot").forEach(function (svg) {
    var looks = {}, large = [], count = 0;
    all("#" + svg.id + " .key").forEach(function (key) {
      var mark = key.querySelector(".mark"), name = key.textContent;
      if (!mark) { return; }
      var size = mark.getBBox(), style = getComputedStyle(mark), outline = mark.tagName;
      if (outline === "path") {
        outline = mark.getAttribute("d").replace(/(-?[\d.]+)[ ,](-?[\d.]+)/g, function (whole, x, y) {
          return Math.round(10 * (x - size.x)) + " " + Math.round(10 * (y - size.y));
        });
      }
      var look = [outline, style.fill, style.stroke].join(" ");
      if (looks[look]) { seen.push("error: " + svg.id + ": " + name + " looks like " + looks[look]); }
      looks[look] = name;
      if (size.width > 10) { large.push(name); }
      count += 1;
    });
    seen.push("looks: " + count + ", all differ, " + large.join(", ") + " alone is large");
  });
  if (window.axe) {
    var found = await window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"],
      resultTypes: ["violations"] });
    seen.push("axe: " + found.passes.length + " rules pass, " + found.violations.length + " do not");
    found.violations.forEach(function (one) {
      seen.push("error: axe: " + one.id + " (" + one.help + "): " + one.nodes[0].html.slice(0, 120).replace(/\n/g, " "));
    });
  }
  seen.push("done");
  window.parent.postMessage(seen.join("\n"), "*");
})().catch(function (thrown) { window.parent.postMessage("error: " + thrown, "*"); });
