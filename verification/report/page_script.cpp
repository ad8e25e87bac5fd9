// SPDX-License-Identifier: GPL-3.0-or-later
// The script of the page, as it stands in it.
#include "verification/report/page.hpp"

namespace ehd::report {

namespace {

constexpr const char* page_js = R"js(
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

  // What the index marks: the section at the top of the window.
  var links = figures.all(document, "nav a"), heads = links.map(function (link) {
    return document.getElementById(link.getAttribute("href").slice(1));
  });
  function mark_section() {
    var now = 0;
    heads.forEach(function (head, i) { if (head.getBoundingClientRect().top < window.innerHeight / 3) { now = i; } });
    links.forEach(function (link, i) {
      if (i === now) { link.setAttribute("aria-current", "true"); } else { link.removeAttribute("aria-current"); }
    });
  }
  window.addEventListener("scroll", mark_section, { passive: true });
  if (links.length) { mark_section(); }

  // A link to something closed opens it; to a filtered row, shows it.
  function open_target() {
    var target = document.getElementById(decodeURIComponent(window.location.hash.slice(1)));
    if (!target) { return; }
    for (var one = target; one; one = one.parentElement) {
      if (one.tagName === "DETAILS") { one.open = true; }
      one.hidden = false;
    }
    target.scrollIntoView();
  }
  window.addEventListener("hashchange", open_target);
  // A case's sparkline opens its figure, and closes it again.
  document.querySelectorAll("a.opens").forEach(function (link) {
    var fold = document.getElementById(link.getAttribute("href").slice(1)).closest("details");
    function tell() { link.setAttribute("aria-expanded", String(fold.open)); }
    link.setAttribute("role", "button");
    link.addEventListener("click", function (event) { event.preventDefault(); fold.open = !fold.open; });
    link.addEventListener("keydown", function (event) {
      if (event.key === " ") { event.preventDefault(); fold.open = !fold.open; }
    });
    fold.addEventListener("toggle", tell);
    tell();
  });

  // A click on a legend entry shows or hides its series in all panels of the picture.
  document.querySelectorAll("svg.plot .key").forEach(function (key) {
    var svg = key.closest("svg"), number = key.getAttribute("data-key");
    svg.setAttribute("role", "group");  // an image has no switches
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
  function plain(label) { return label.replace(/[_^]/g, ""); }
  function read(event) {
    var svg = event.currentTarget;
    var datum = event.target.closest ? event.target.closest("[data-hint]") : null;
    if (datum) { show(datum.getAttribute("data-hint"), event); return; }
    var at = figures.place_in(svg, event), frame = at && figures.frame_at(svg, at);
    if (!frame) { hide(); return; }
    var best = null, nearest = 28 * 28, box = figures.box_of(frame), x = figures.axis(frame, "x");
    figures.all(frame.parentNode, ".series:not(.off)").forEach(function (series) {
      var y = figures.axis(frame, figures.vertical(series));
      figures.points(series).forEach(function (point) {
        if (!point) { return; }
        var px = x.place(point[0]), py = y.place(point[1]), dx = px - at.x, dy = py - at.y, away = dx * dx + dy * dy;
        if (away >= nearest || !figures.inside(box, px, py, 0.5)) { return; }
        nearest = away;
        best = { series: series, point: point };
      });
    });
    if (!best) { hide(); return; }
    var label = frame.getAttribute(best.series.hasAttribute("data-right") ? "data-right" : "data-y");
    show((best.series.getAttribute("data-name") || "") + "\n" + plain(frame.getAttribute("data-x")) + ": " +
      best.point[0] + "\n" + plain(label) + ": " + best.point[1], event);
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
    // A number of the ladder leads to its claims.
    document.querySelectorAll("a[data-rung]").forEach(function (link) {
      link.addEventListener("click", function () {
        controls.querySelector("input").value = "";
        controls.querySelectorAll("select").forEach(function (select, i) {
          select.value = link.getAttribute(i === 0 ? "data-rung" : "data-verdict");
        });
        filter();
      });
    });
    // The key / leads to the words, as in many programs.
    document.addEventListener("keydown", function (event) {
      var typing = /INPUT|SELECT/.test(document.activeElement.tagName);
      if (event.key !== "/" || event.ctrlKey || event.metaKey || typing) { return; }
      event.preventDefault();
      controls.closest("details").open = true;
      controls.querySelector("input").focus();
    });
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
  open_target();
})();
)js";

}  // namespace

const char* page_script() { return page_js; }

}  // namespace ehd::report
