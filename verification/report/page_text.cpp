// SPDX-License-Identifier: GPL-3.0-or-later
// The style sheet and the script of the page, as they stand in it.
#include "verification/report/page.hpp"

namespace ehd::report {

namespace {

constexpr const char* style = R"css(
:root{--pass:#1d7a3a;--fail:#b3261e;--warn:#8a5a00;--panel:#f5f6f8}
@media screen and (prefers-color-scheme:dark){
:root:not([data-theme=light]){--pass:#6fd08c;--fail:#ff8a80;--warn:#f0c060;--panel:#1e2329;color-scheme:dark}
}
@media screen{:root[data-theme=dark]{--pass:#6fd08c;--fail:#ff8a80;--warn:#f0c060;--panel:#1e2329;color-scheme:dark}}
:root[data-theme=light]{color-scheme:light}
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%}
body{margin:0;background:var(--paper);color:var(--ink);
font:16px/1.5 system-ui,-apple-system,"Segoe UI",Helvetica,Arial,sans-serif}
header,main{max-width:1180px;margin:0 auto;padding:0 20px}
header{padding-top:18px}
h1{font-size:1.7rem;line-height:1.2;margin:0 0 8px}
h2{font-size:1.35rem;margin:40px 0 10px;padding-top:10px;border-top:2px solid var(--grid)}
h3{font-size:1.08rem;margin:26px 0 8px}
p{max-width:80ch;margin:8px 0}
a{color:var(--s1)}
nav{display:flex;flex-wrap:wrap;gap:4px 16px;align-items:center}
code{font:0.9em ui-monospace,Menlo,Consolas,monospace;overflow-wrap:break-word}
pre{white-space:pre-wrap;overflow-wrap:anywhere;background:var(--panel);padding:10px 12px;
font:0.85rem ui-monospace,Menlo,Consolas,monospace}
button,input,select{font:inherit;color:var(--ink);background:var(--panel);border:1px solid var(--soft);
border-radius:4px;padding:3px 10px}
input{min-width:0;max-width:100%}
.verdict{font-size:1.1rem;border-left:6px solid var(--pass);padding:8px 14px;background:var(--panel);max-width:none}
.verdict.fail{border-color:var(--fail)}
.absent{color:var(--soft);font-style:italic}
.scroll{overflow-x:auto;max-width:100%;margin:10px 0}
table{border-collapse:collapse;font-size:0.88rem;line-height:1.35}
caption{text-align:left;font-weight:600;padding:4px 0;caption-side:top}
th,td{padding:3px 12px 3px 0;text-align:left;vertical-align:top;border-bottom:1px solid var(--grid)}
th[scope=row]{font-weight:500}
thead th{border-bottom:2px solid var(--soft);}
.number{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.name{white-space:nowrap}
thead .number{white-space:normal}
.wide{min-width:16em}
td.wide code,th code{display:inline-block}
.claims th[scope=row]{min-width:14em;max-width:22em;overflow-wrap:anywhere}
td.pass,td.converged{color:var(--pass)}
td.fail,td.diverged{color:var(--fail);font-weight:700}
td.inconclusive,td.tolerance-not-met,td.limit-reached,td.under-resolved{color:var(--warn);font-weight:700}
.claim{border-left:4px solid var(--fail);padding:4px 14px;margin:12px 0;background:var(--panel)}
.claim.inconclusive{border-color:var(--warn)}
.claim p{margin:4px 0;overflow-wrap:anywhere}
.figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,440px),1fr));
gap:22px 26px;align-items:start}
.figures.wide-figure{grid-template-columns:1fr}
.figures.maps{grid-template-columns:repeat(auto-fill,minmax(min(100%,540px),1fr))}
.figures.polars{grid-template-columns:repeat(auto-fill,minmax(min(100%,340px),1fr))}
figure{margin:0;min-width:0}
.picture{overflow-x:auto}
svg.plot{display:block;width:100%;height:auto}
figcaption{font-size:0.86rem;color:var(--soft);margin-top:2px;overflow-wrap:anywhere}
figcaption b{color:var(--ink)}
details{margin:10px 0}
summary{cursor:pointer;font-weight:600}
.controls{display:none;flex-wrap:wrap;gap:8px;margin:8px 0}
.js .controls{display:flex}
.theme{display:none}
.js .theme{display:inline-block;margin-left:auto}
.js .key{cursor:pointer}
.key.off{opacity:.35}
.series.off{display:none}
.readout{position:fixed;z-index:5;pointer-events:none;background:var(--paper);color:var(--ink);
border:1px solid var(--soft);border-radius:4px;padding:3px 8px;font-size:0.82rem;line-height:1.35;
max-width:min(90vw,340px);white-space:pre-line}
dl{display:grid;grid-template-columns:max-content 1fr;gap:2px 16px;margin:8px 0}
dt{color:var(--soft)}
dd{margin:0;overflow-wrap:anywhere;min-width:0}
@media (max-width:600px){
header,main{padding-left:12px;padding-right:12px}
dl{grid-template-columns:1fr}
dt{margin-top:6px}
figure.map .picture svg.plot{min-width:560px}
.wide-figure .picture svg.plot{min-width:700px}
}
@media print{
body{font-size:10pt}
header,main{max-width:none;padding:0}
nav,.controls,.readout{display:none!important}
figure,.claim{break-inside:avoid}
h2,h3{break-after:avoid}
.scroll,.picture{overflow:visible}
.figures{grid-template-columns:1fr 1fr}
.figures.wide-figure{grid-template-columns:1fr}
.figures.maps{grid-template-columns:1fr}
.figures.maps svg.plot{margin:0 auto}
details::details-content{content-visibility:visible;block-size:auto}
thead{display:table-header-group}
tr{break-inside:avoid}
*{print-color-adjust:exact;-webkit-print-color-adjust:exact}
}
)css";

constexpr const char* script = R"js("use strict";
(function () {
  var root = document.documentElement;
  root.classList.add("js");

  // The theme: light, dark, or that of the system.
  var theme = document.createElement("button");
  var themes = ["auto", "light", "dark"], chosen = 0;
  theme.type = "button";
  theme.className = "theme";
  function name() { theme.textContent = "Theme: " + themes[chosen]; }
  theme.addEventListener("click", function () {
    chosen = (chosen + 1) % themes.length;
    if (chosen === 0) { root.removeAttribute("data-theme"); } else { root.setAttribute("data-theme", themes[chosen]); }
    name();
  });
  name();
  document.querySelector("nav").appendChild(theme);

  // A click on a legend entry shows or hides its series in all panels of the picture.
  document.querySelectorAll("svg.plot .key").forEach(function (key) {
    var svg = key.closest("svg"), number = key.getAttribute("data-key");
    key.setAttribute("role", "button");
    key.setAttribute("tabindex", "0");
    key.setAttribute("aria-pressed", "true");
    function toggle() {
      var off = !key.classList.contains("off");
      svg.querySelectorAll("[data-key=\"" + number + "\"]").forEach(function (one) {
        one.classList.toggle("off", off);
      });
      key.setAttribute("aria-pressed", String(!off));
    }
    key.addEventListener("click", toggle);
    key.addEventListener("keydown", function (event) {
      if (event.key === "Enter" || event.key === " ") { event.preventDefault(); toggle(); }
    });
  });

  // The read-out: the nearest point of the visible curves, or the text of a cell.
  var readout = document.createElement("div");
  readout.className = "readout";
  readout.setAttribute("role", "status");
  readout.hidden = true;
  document.body.appendChild(readout);
  function show(text, event) {
    readout.textContent = text;
    readout.hidden = false;
    var width = readout.offsetWidth, height = readout.offsetHeight;
    readout.style.left = Math.max(4, Math.min(event.clientX + 14, window.innerWidth - width - 6)) + "px";
    var below = event.clientY + 18, above = event.clientY - height - 12;
    readout.style.top = (below + height > window.innerHeight ? above : below) + "px";
  }
  function hide() { readout.hidden = true; }
  function points(series) {
    if (!series.points) {
      series.points = (series.getAttribute("data-values") || "").split(" ").filter(Boolean).map(function (one) {
        return one.split(",");
      });
    }
    return series.points;
  }
  function plain(label) { return label.replace(/[_^]/g, ""); }
  function read(event) {
    var svg = event.currentTarget;
    var datum = event.target.closest ? event.target.closest("[data-hint]") : null;
    if (datum) { show(datum.getAttribute("data-hint"), event); return; }
    var matrix = svg.getScreenCTM();
    if (!matrix) { hide(); return; }
    var at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    var best = null, nearest = 28 * 28, frame = null;
    svg.querySelectorAll(".frame").forEach(function (one) {
      var box = (one.getAttribute("data-box") || "").split(",").map(Number);
      if (at.x >= box[0] && at.x <= box[2] && at.y >= box[1] && at.y <= box[3]) { frame = one; }
    });
    if (!frame) { hide(); return; }
    svg.querySelectorAll(".series:not(.off)").forEach(function (series) {
      points(series).forEach(function (point) {
        var dx = point[0] - at.x, dy = point[1] - at.y, away = dx * dx + dy * dy;
        if (away < nearest) { nearest = away; best = { series: series, point: point }; }
      });
    });
    if (!best) { hide(); return; }
    var label = frame.getAttribute(best.series.hasAttribute("data-right") ? "data-right" : "data-y");
    show((best.series.getAttribute("data-name") || "") + "\n" + plain(frame.getAttribute("data-x")) + ": " +
      best.point[2] + "\n" + plain(label) + ": " + best.point[3], event);
  }
  document.querySelectorAll("svg.plot").forEach(function (svg) {
    svg.addEventListener("pointermove", read);
    svg.addEventListener("pointerdown", read);
    svg.addEventListener("pointerleave", hide);
  });
  window.addEventListener("scroll", hide, { passive: true });

  // Filters of the table of all claims: words in the row, rung, verdict.
  document.querySelectorAll(".controls").forEach(function (controls) {
    var table = document.getElementById(controls.getAttribute("data-for"));
    var rows = Array.prototype.slice.call(table.querySelectorAll("tbody tr"));
    var shown = controls.querySelector("output");
    function filter() {
      var words = controls.querySelector("input").value.toLowerCase().split(/\s+/).filter(Boolean);
      var selects = Array.prototype.slice.call(controls.querySelectorAll("select")), count = 0;
      rows.forEach(function (row) {
        var text = row.textContent.toLowerCase();
        var keep = words.every(function (word) { return text.indexOf(word) >= 0; }) && selects.every(function (select) {
          return !select.value || row.cells[Number(select.getAttribute("data-column"))].textContent === select.value;
        });
        row.hidden = !keep;
        count += keep ? 1 : 0;
      });
      shown.textContent = count + " of " + rows.length;
    }
    controls.addEventListener("input", filter);
    filter();
  });

  // Some browsers print closed details closed: all are opened for printing.
  window.addEventListener("beforeprint", function () {
    document.querySelectorAll("details").forEach(function (one) {
      if (!one.open) { one.open = true; one.setAttribute("data-closed", ""); }
    });
  });
  window.addEventListener("afterprint", function () {
    document.querySelectorAll("details[data-closed]").forEach(function (one) {
      one.open = false;
      one.removeAttribute("data-closed");
    });
  });
})();
)js";

}  // namespace

const char* page_style() { return style; }
const char* page_script() { return script; }

}  // namespace ehd::report
