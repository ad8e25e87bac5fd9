// SPDX-License-Identifier: GPL-3.0-or-later
// Runs behind the report's own script and writes what it sees into the page (in a frame: into the page around it), a
// line each, "error: ..." where something is wrong.
"use strict";
(function () {
  var seen = window.seen;
  function attempt(name, look) {
    try { seen.push(name + ": " + look()); } catch (thrown) { seen.push("error: " + name + ": " + thrown); }
  }
  function complain(svg, what) { seen.push("error: " + svg.id + " " + what); }
  function verdict(works, otherwise) { return works ? "works" : "does not work: " + otherwise; }
  function pointer(svg, element, x, y) {
    element.dispatchEvent(new PointerEvent("pointermove", { clientX: x, clientY: y, bubbles: true }));
    var readout = document.querySelector(".readout"), text = readout.hidden ? "" : readout.textContent;
    svg.dispatchEvent(new PointerEvent("pointerleave"));
    return text;
  }

  function finish() {
    seen.push("done");
    if (window.parent !== window) { window.parent.postMessage(seen.join("\n"), "*"); return; }
    var result = document.createElement("pre");
    result.id = "probe";
    result.textContent = "\n" + seen.join("\n") + "\n";
    document.body.appendChild(result);
  }

  attempt("width", function () { return window.innerWidth; });
  attempt("overflow", function () { return Math.max(0, document.documentElement.scrollWidth - window.innerWidth); });
  attempt("paper", function () { return getComputedStyle(document.body).backgroundColor; });
  attempt("figures", function () {
    var pictures = document.querySelectorAll("svg.plot");
    pictures.forEach(function (svg) {
      var box = svg.getBoundingClientRect();
      if (!(box.width > 100 && box.height > 80)) { complain(svg, "is " + box.width + " x " + box.height); }
      // Data: a curve that has a length, marks, or coloured cells.
      var data = 0;
      svg.querySelectorAll(".series path.line").forEach(function (path) {
        data += path.getTotalLength() > 1 ? 1 : 0;
      });
      data += svg.querySelectorAll(".series .mark, rect.cell").length;
      if (data === 0) { complain(svg, "has no data"); }
      if (!svg.querySelector("title").textContent || !svg.querySelector("desc").textContent) {
        complain(svg, "has no title");
      }
      if (/NaN|undefined|Infinity/.test(svg.innerHTML)) { complain(svg, "has numbers that are none"); }
      // Numbers, names of axes and the legend must not touch: their boxes, in the page.
      var labels = svg.querySelectorAll(".frame text, .axis-label, .key text");
      var texts = Array.prototype.slice.call(labels).map(function (text) {
        return { box: text.getBoundingClientRect(), says: text.textContent };
      });
      texts.forEach(function (a, i) {
        texts.slice(i + 1).forEach(function (b) {
          var across = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
          var down = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
          if (across > 1 && down > 3) { complain(svg, ": \"" + a.says + "\" and \"" + b.says + "\" overlap"); }
        });
      });
      svg.querySelectorAll("text").forEach(function (text) {
        var t = text.getBoundingClientRect(), s = svg.getBoundingClientRect();
        if (t.left < s.left - 2 || t.right > s.right + 2 || t.bottom > s.bottom + 2) {
          complain(svg, ": \"" + text.textContent + "\" sticks out of the picture");
        }
      });
    });
    return pictures.length;
  });
  if (!document.documentElement.classList.contains("js")) {  // the page without its script: nothing more to try
    finish();
    return;
  }
  attempt("toggle", function () {
    var svg = document.getElementById("fig-case-made-20-10"), key = svg.querySelector(".key");
    var number = key.getAttribute("data-key");
    var series = svg.querySelector(".series[data-key=\"" + number + "\"]");
    key.dispatchEvent(new MouseEvent("click", { bubbles: true }));
    var hidden = getComputedStyle(series).display === "none" && key.getAttribute("aria-pressed") === "false";
    key.dispatchEvent(new MouseEvent("click", { bubbles: true }));
    return verdict(hidden && getComputedStyle(series).display !== "none", "hidden " + hidden);
  });
  attempt("read-out", function () {
    var svg = document.getElementById("fig-case-made-20-10");
    var box = svg.querySelector(".frame path.axis:last-of-type").getBoundingClientRect();
    // Half a circle on -2 ... 1.2 cut at what is shown: its top is at P = 1.
    var text = "", top = /P = p\/pH: (1|0\.9\d*)$/;
    [0.04, 0.2].forEach(function (down) {
      for (var i = 1; i < 40 && !top.test(text); ++i) {
        text = pointer(svg, svg, box.left + box.width * i / 40, box.top + box.height * down) || text;
      }
    });
    var at_top = /^P reference\nX = x\/b: -?[\d.e-]+\nP = p\/pH: (1|0\.9\d*)$/;
    return verdict(at_top.test(text) || /^P fast\n/.test(text), text.replace(/\n/g, " | "));
  });
  attempt("cell", function () {
    var svg = document.getElementById("fig-film-minimum-roelands"), cell = svg.querySelector("[data-hint] rect");
    var box = cell.getBoundingClientRect(), text = pointer(svg, cell, box.left + 3, box.top + 3);
    return verdict(/^M = .*H_Moes = [\d.]+/.test(text), text);
  });
  attempt("filter", function () {
    var controls = document.querySelector(".controls"), input = controls.querySelector("input");
    input.value = "twins";
    input.dispatchEvent(new Event("input", { bubbles: true }));
    var some = controls.querySelector("output").textContent;
    input.value = "";
    input.dispatchEvent(new Event("input", { bubbles: true }));
    return verdict(some === "1 of 4" && controls.querySelector("output").textContent === "4 of 4", some);
  });
  attempt("theme", function () {
    var button = document.querySelector("button.theme"), colours = [];
    var paper = function () { return getComputedStyle(document.body).backgroundColor; }, before = paper();
    for (var i = 0; i < 3; ++i) { button.click(); colours.push(paper()); }
    return verdict(colours.join(";") === "rgb(255, 255, 255);rgb(21, 24, 28);" + before, colours.join(" "));
  });
  finish();
})();
