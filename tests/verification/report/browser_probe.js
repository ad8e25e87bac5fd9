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
  // No two of these elements may touch: their boxes, in the page.
  function expect_apart(svg, what, elements) {
    var shown = Array.prototype.slice.call(elements).map(function (element) {
      return { box: element.getBoundingClientRect(), says: element.textContent };
    });
    shown.forEach(function (a, i) {
      shown.slice(i + 1).forEach(function (b) {
        var across = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
        var down = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
        if (across > 1 && down > 3) {
          complain(svg, ": " + what + "\"" + a.says + "\" and \"" + b.says + "\" overlap");
        }
      });
    });
  }
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

  var closed = document.querySelectorAll("details:not([open])");
  function all(selector) { return Array.prototype.slice.call(document.querySelectorAll(selector)); }
  function scrolls_sideways() { return Math.max(0, document.documentElement.scrollWidth - window.innerWidth); }
  attempt("width", function () { return window.innerWidth; });
  attempt("overflow", scrolls_sideways);
  attempt("shown", function () {
    return all("svg.plot").filter(function (svg) { return !svg.closest("details:not([open])"); }).length;
  });
  closed.forEach(function (one) { one.open = true; });
  attempt("overflow, all open", scrolls_sideways);
  attempt("tables", function () {
    var wide = all("table").filter(function (table) { return table.parentNode.scrollWidth > table.parentNode.clientWidth; });
    return verdict(window.innerWidth > 600 || wide.length === 0, wide.length + " scroll sideways, the first is that of " +
      wide.slice(0, 1).map(function (table) { return table.tHead.textContent; }));
  });
  // Figures fit into the page, and their texts can be read, on a phone too.
  attempt("pictures", function () {
    var wide = all(".picture").filter(function (one) { return one.scrollWidth > one.clientWidth; });
    var small = 99, whose = "";
    all("svg.plot").forEach(function (svg) {
      var scale = svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
      svg.querySelectorAll("text").forEach(function (text) {
        var size = scale * parseFloat(getComputedStyle(text).fontSize);
        if (size < small) { small = size; whose = svg.id + ": " + text.textContent; }
      });
    });
    return verdict(wide.length === 0 && small >= 8, wide.length + " scroll sideways; smallest text " +
      small.toFixed(1) + " pixels, " + whose);
  });
  // A contour line that runs through a number would hide it.
  attempt("contours", function () {
    var crossed = [], lines = 0;
    all("figure.map svg").forEach(function (svg) {
      var numbers = all("#" + svg.id + " .cell-text").map(function (text) { return text.getBBox(); });
      all("#" + svg.id + " path.contour").forEach(function (path) {
        lines += 1;
        for (var at = 0, length = path.getTotalLength(); at <= length; at += 1) {
          var point = path.getPointAtLength(at);
          if (numbers.some(function (box) {
            // The box of a text is higher than its digits.
            return point.x > box.x && point.x < box.x + box.width &&
              point.y > box.y + 0.25 * box.height && point.y < box.y + 0.75 * box.height;
          })) { crossed.push(svg.id); return; }
        }
      });
    });
    return verdict(lines > 20 && crossed.length === 0, crossed.length + " of " + lines + " lines, " + crossed[0]);
  });
  attempt("headings", function () {
    var level = 0, wrong = all("h1,h2,h3,h4,h5,h6").filter(function (head) {
      var own = Number(head.tagName[1]), skips = own > level + 1;
      level = own;
      return skips;
    });
    return verdict(document.querySelectorAll("h1").length === 1 && wrong.length === 0, wrong.length + " skip a level");
  });
  attempt("links", function () {
    var lost = all("a[href^='#']").filter(function (link) {
      return !document.getElementById(decodeURIComponent(link.getAttribute("href").slice(1)));
    });
    return verdict(lost.length === 0, lost.map(function (link) { return link.getAttribute("href"); }).join(" "));
  });
  attempt("anchors", function () {
    var bare = all("figure").filter(function (figure) {
      return !figure.querySelector("a[href='#" + figure.querySelector("svg").id + "']");
    });
    var claims = all("#all-claims tbody tr").filter(function (row) { return !row.querySelector("a[href='#" + row.id + "']"); });
    return verdict(bare.length + claims.length === 0, bare.length + " figures, " + claims.length + " claims");
  });
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
      // Numbers, names of axes and the legend.
      expect_apart(svg, "", svg.querySelectorAll(".frame text, .axis-label, .key text"));
      expect_apart(svg, "the keys of ", svg.querySelectorAll(".key"));
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
  attempt("filter links", function () {
    var output = document.querySelector(".controls output");
    document.querySelector("a[data-rung='7'][data-verdict='pass']").click();
    var some = output.textContent, select = document.querySelectorAll(".controls select");
    select.forEach(function (one) { one.value = ""; });
    select[0].dispatchEvent(new Event("input", { bubbles: true }));
    return verdict(some === "1 of 4" && output.textContent === "4 of 4", some);
  });
  attempt("filter key", function () {
    document.getElementById("claims").open = false;
    document.dispatchEvent(new KeyboardEvent("keydown", { key: "/", bubbles: true }));
    var there = document.activeElement === document.querySelector(".controls input");
    return verdict(there && document.getElementById("claims").open, document.activeElement.tagName);
  });
  attempt("index", function () {
    window.scrollTo(0, document.getElementById("maps").offsetTop + 50);
    window.dispatchEvent(new Event("scroll"));
    var nav = document.querySelector("nav"), marked = nav.querySelector("[aria-current]");
    var works = Math.abs(nav.getBoundingClientRect().top) < 1 && marked.getAttribute("href") === "#maps";
    return verdict(works, nav.getBoundingClientRect().top + " " + marked.getAttribute("href"));
  });
  attempt("case", function () {
    var link = document.querySelector("a.opens[href='#figure-of-made-light']");
    var fold = document.getElementById("figure-of-made-light"), seen_open = [];
    function shown() { return fold.open && fold.querySelector("svg").getBoundingClientRect().height > 100; }
    fold.open = false;
    for (var i = 0; i < 2; ++i) { link.click(); seen_open.push(shown()); }
    fold.open = true;
    return verdict(seen_open.join() === "true,false", seen_open.join());
  });
  attempt("zoom", function () {
    var svg = document.getElementById("fig-case-made-20-10"), frames = svg.querySelectorAll(".frame");
    var box = frames[0].querySelector("path.axis:last-of-type").getBoundingClientRect(), ranges = [], texts = [];
    function look() {
      ranges.push(frames[0].getAttribute("data-x-range") + ";" + frames[1].getAttribute("data-x-range"));
      texts.push(frames[0].textContent);
    }
    function point(name, x, y) {
      svg.dispatchEvent(new PointerEvent(name, { clientX: box.left + x * box.width, clientY: box.top + y * box.height,
        bubbles: true, pointerType: "mouse" }));
    }
    look();
    point("pointerdown", 0.5, 0.1); point("pointermove", 0.75, 0.9); point("pointerup", 0.75, 0.9);
    look();
    var ends = ranges[1].split(";")[0].split(",").map(Number), line = svg.querySelector(".series path.line");
    var clipped = /^url/.test(line.getAttribute("clip-path"));
    svg.dispatchEvent(new KeyboardEvent("keydown", { key: "+" }));
    look();
    svg.closest("figure").querySelector(".tools button:last-of-type").click();
    look();
    var home = ranges[0].split(";")[0].split(",").map(Number), wide = home[1] - home[0];
    var works = Math.abs(ends[0] - home[0] - 0.5 * wide) < 0.02 * wide && Math.abs(ends[1] - ends[0] - 0.25 * wide) < 0.02 * wide;
    return verdict(works && clipped && ranges[1].split(";")[0] === ranges[1].split(";")[1] && ranges[2] !== ranges[1] &&
      ranges[3] === ranges[0] && texts[1] !== texts[0], ranges.join(" | "));
  });
  attempt("zoomed ticks", function () {
    var svg = document.getElementById("fig-work-made-20-10-film-minimum"), touching = 0, labels = 0;
    var buttons = svg.closest("figure").querySelectorAll(".tools button");
    function press_and_look(text) {
      buttons.forEach(function (one) { if (one.textContent === text) { one.click(); } });
      var boxes = all("#" + svg.id + " .ticks-text text").map(function (one) { return one.getBoundingClientRect(); });
      labels += boxes.length;
      boxes.forEach(function (a, i) {
        boxes.slice(i + 1).forEach(function (b) {
          touching += Math.min(a.right, b.right) - Math.max(a.left, b.left) > 0 &&
            Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 3 ? 1 : 0;
        });
      });
    }
    // Into the figure and far out of it.
    ["+", "+", "+", "+", "\u2212", "\u2212", "\u2212", "\u2212", "\u2212", "\u2212", "whole"].forEach(press_and_look);
    return verdict(touching === 0 && labels > 40, touching + " pairs of " + labels + " labels touch");
  });
  attempt("theme", function () {
    var button = document.querySelector("button.theme"), colours = [];
    var paper = function () { return getComputedStyle(document.body).backgroundColor; }, before = paper();
    for (var i = 0; i < 3; ++i) { button.click(); colours.push(paper()); }
    return verdict(colours.join(";") === "rgb(255, 255, 255);rgb(21, 24, 28);" + before, colours.join(" "));
  });

  // What is saved: the files that the buttons hand to the browser.
  var saved = [], usual = window.Blob;
  window.Blob = function (parts, options) { saved.push(parts.join("")); return new usual(parts, options); };
  HTMLAnchorElement.prototype.click = function () {};
  function press(id, what) {
    var button = Array.prototype.slice.call(document.getElementById(id).closest("figure").querySelectorAll("button"));
    button.filter(function (one) { return one.textContent === what; })[0].click();
    return saved[saved.length - 1];
  }
  async function look_at_files() {
    var csv = press("fig-case-made-20-10", "CSV"), lines = csv.trim().split("\n");
    // 81 nodes: P and H of two solvers, two differences.
    seen.push("CSV: " + verdict(lines[0] === "x-axis,y-axis,curve,x,y" && lines.length === 1 + 6 * 81 &&
      lines[1] === "X = x/b,P = p/pH,P reference,-2,0", lines.length + " lines, " + lines[1]));
    var map = press("fig-film-minimum-roelands", "CSV").trim().split("\n");
    seen.push("CSV of a map: " + verdict(map[0] === "load group M,lubricant group L,\"Minimum film HMoes, Roelands, compressible\"" &&
      map[1] === "0.1,0,5.98578694", map.slice(0, 2).join(" | ")));
    var svg = press("fig-case-made-light", "SVG");
    var read = new DOMParser().parseFromString(svg, "image/svg+xml");
    seen.push("SVG: " + verdict(read.documentElement.namespaceURI === document.querySelector("svg").namespaceURI &&
      !read.querySelector("parsererror") && svg.indexOf("var(--") < 0 && svg.indexOf("data-values") < 0 &&
      read.querySelectorAll(".series path.line").length === 6, svg.slice(0, 200)));
    // A link to a figure that is closed, and to a claim that the filter hides.
    var fold = document.getElementById("fig-film-minimum-roelands").closest("details");
    var row = document.getElementById("claim-twins-agree");
    fold.open = false;
    row.hidden = true;
    window.location.hash = "#fig-film-minimum-roelands";
    await new Promise(function (next) { window.setTimeout(next, 50); });
    window.location.hash = "#claim-twins-agree";
    await new Promise(function (next) { window.setTimeout(next, 50); });
    // The first table leads to the paper's statements, which are closed.
    var statements = document.getElementById("statements");
    statements.open = false;
    window.location.hash = document.querySelector(".overview a[href='#statements']").getAttribute("href");
    await new Promise(function (next) { window.setTimeout(next, 50); });
    seen.push("targets: " + verdict(fold.open && !row.hidden && statements.open,
      fold.open + " " + row.hidden + " " + statements.open));
    if (window.axe) {
      var found = await window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"],
        resultTypes: ["violations"] });
      seen.push("axe: " + found.passes.length + " rules pass, " + found.violations.length + " do not");
      found.violations.forEach(function (one) {
        seen.push("error: axe: " + one.id + " (" + one.help + "), " + one.nodes.length + " times: " +
          one.nodes.slice(0, 3).map(function (node) { return node.target.join(" ") + " " + node.html.slice(0, 120); }).join(" ; ").replace(/\n/g, " "));
      });
    }
  }
  look_at_files().catch(function (thrown) { seen.push("error: files: " + thrown); }).then(finish);
})();
