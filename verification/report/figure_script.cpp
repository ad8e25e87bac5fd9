// SPDX-License-Identifier: GPL-3.0-or-later
// The script of the figures, as it stands in the page: zoom, and their data and pictures as files. Written here rather
// than taken from a plotting library: the figures are SVG already, in print and without a script, and two hundred lines
// redraw them, where uPlot (51 kB, canvas) would draw each a second time.
#include "verification/report/page.hpp"

namespace ehd::report {

namespace {

constexpr const char* figure_axes = R"js("use strict";
// A picture's panels: axes from values to places and back. `data-x-range` holds what is shown now.
var figures = (function () {
  function axis(frame, name) {
    var range = frame.getAttribute("data-" + name + "-range");
    if (!range) { return null; }
    var box = frame.getAttribute("data-box").split(",").map(Number), log = frame.hasAttribute("data-" + name + "-log");
    var from = name === "x" ? box[0] : box[3], to = name === "x" ? box[2] : box[1];
    function scaled(value) { return log ? (value > 0 ? Math.log(value) : NaN) : value; }
    var ends = range.split(",").map(Number), a = scaled(ends[0]), b = scaled(ends[1]);
    return {
      log: log, ends: ends,
      place: function (value) { return from + (scaled(value) - a) / (b - a) * (to - from); },
      value: function (place) {
        var at = a + (place - from) / (to - from) * (b - a);
        return log ? Math.exp(at) : at;
      }
    };
  }
  // [[x, y], ...]; null where the curve is broken.
  function points(series) {
    if (!series.points) {
      series.points = (series.getAttribute("data-values") || "").split(" ").map(function (one) {
        return one.indexOf(",") > 0 ? one.split(",").map(Number) : null;
      });
    }
    return series.points;
  }
  function vertical(series) { return series.hasAttribute("data-right") ? "right" : "y"; }
  function inside(box, x, y, edge) {
    return x >= box[0] - edge && x <= box[2] + edge && y >= box[1] - edge && y <= box[3] + edge;
  }
  function box_of(frame) { return frame.getAttribute("data-box").split(",").map(Number); }
  function place_in(svg, event) {
    var matrix = svg.getScreenCTM();
    return matrix ? new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse()) : null;
  }
  function frame_at(svg, at) {
    return Array.prototype.slice.call(svg.querySelectorAll(".frame[data-box]")).filter(function (one) {
      return inside(box_of(one), at.x, at.y, 0);
    })[0] || null;
  }
  function all(root, selector) { return Array.prototype.slice.call(root.querySelectorAll(selector)); }
  return { axis: axis, points: points, vertical: vertical, inside: inside, box_of: box_of, place_in: place_in,
    frame_at: frame_at, all: all };
})();
)js";

constexpr const char* figure_drawing = R"js(
// Ticks, grid, curves and marks of a panel for the ends that its axes have now.
figures.drawing = (function () {
  var all = figures.all, box_of = figures.box_of;
  function made(parent, name) { return document.createElementNS(parent.namespaceURI, name); }
  function ticks(axis) {
    var low = Math.min.apply(null, axis.ends), high = Math.max.apply(null, axis.ends), found = [];
    if (axis.log && high / low >= 10) {
      var first = Math.floor(Math.log10(low)), last = Math.ceil(Math.log10(high));
      var every = Math.ceil((last - first) / 8);
      for (var k = first; k <= last; ++k) {
        for (var digit = 1; digit < 10; ++digit) {
          var at = digit * Math.pow(10, k);
          if (at < low || at > high) { continue; }
          var text = Math.abs(k) <= 2 ? String(Number(at.toPrecision(1))) : null;
          found.push({ value: at, major: digit === 1 && k % every === 0, text: text, power: k });
        }
      }
      if (found.filter(function (tick) { return tick.major; }).length > 1) { return found; }
      found = [];
    }
    var step = Math.pow(10, Math.floor(Math.log10((high - low) / 6)));
    step *= [10, 5, 2, 1].filter(function (more) { return (high - low) / (step * more) >= 4; })[0] || 1;
    for (var i = Math.ceil(low / step); i * step <= high; ++i) {
      found.push({ value: i * step, major: true, text: String(Number((i * step).toPrecision(7))) });
    }
    return found;
  }
  function label(parent, x, y, anchor, tick) {
    var text = made(parent, "text");
    text.setAttribute("x", x);
    text.setAttribute("y", y);
    text.setAttribute("text-anchor", anchor);
    text.setAttribute("class", "small");
    text.textContent = (tick.text === null ? "10" : tick.text).replace("-", "\u2212");
    if (text.textContent.length > 6) { text.style.fontSize = "9px"; }  // beside the name of the axis
    if (tick.text === null) {
      var power = made(parent, "tspan");
      power.setAttribute("dy", "-.48em");
      power.setAttribute("font-size", "75%");
      power.textContent = String(tick.power).replace("-", "\u2212");
      text.appendChild(power);
    }
    parent.appendChild(text);
    return text;
  }
  // A label that touches the one before it is taken away.
  function thin(texts) {
    var last = null;
    texts.forEach(function (text) {
      var box = text.getBBox();
      var touches = last && box.x < last.x + last.width + 4 && last.x < box.x + box.width + 4 &&
        box.y < last.y + last.height - 2 && last.y < box.y + box.height - 2;
      if (touches) { text.remove(); } else { last = box; }
    });
  }
  function draw_frame(frame) {
    var box = box_of(frame), grid = "", marks = "", texts = frame.querySelector(".ticks-text");
    texts.textContent = "";
    ["x", "y", "right"].forEach(function (name) {
      var axis = figures.axis(frame, name), labels = [];
      if (!axis) { return; }
      ticks(axis).forEach(function (tick) {
        var at = axis.place(tick.value), length = tick.major ? 5 : 3, edge = name === "right" ? box[2] : box[0];
        if (name === "x") {
          marks += "M" + at + " " + box[3] + "v" + -length;
          if (!tick.major) { return; }
          grid += "M" + at + " " + box[1] + "V" + box[3];
          labels.push(label(texts, at, box[3] + 15, "middle", tick));
          return;
        }
        marks += "M" + edge + " " + at + "h" + (name === "right" ? -length : length);
        if (!tick.major) { return; }
        if (name === "y") { grid += "M" + box[0] + " " + at + "H" + box[2]; }
        labels.push(label(texts, edge + (name === "right" ? 6 : -6), at + 4, name === "right" ? "start" : "end", tick));
      });
      thin(labels);
    });
    frame.querySelector(".grid").setAttribute("d", grid);
    frame.querySelector(".ticks").setAttribute("d", marks);
  }
  // The original places of marks, and of rules, are those of the original axes.
  function draw_contents(panel, frame, home) {
    var box = box_of(frame), x = figures.axis(frame, "x"), x_home = figures.axis(home, "x");
    all(panel, ".series").forEach(function (series) {
      var name = figures.vertical(series), y = figures.axis(frame, name), y_home = figures.axis(home, name), d = "";
      var points = figures.points(series), pen = "M", line = series.querySelector("path.line");
      points.forEach(function (point) {
        var px = point ? x.place(point[0]) : NaN, py = point ? y.place(point[1]) : NaN;
        if (!isFinite(px + py)) { pen = "M"; return; }
        d += pen + px.toFixed(2) + " " + py.toFixed(2);
        pen = "L";
      });
      if (line) { line.setAttribute("d", d || "M0 0"); line.setAttribute("clip-path", clip(panel, box)); }
      var marked = series.getAttribute("data-marked");
      marked = marked === null ? points.map(function (point, i) { return i; }) : marked.split(" ").map(Number);
      all(series, ".mark").forEach(function (mark, k) {
        var point = points[marked[k]], px = x.place(point[0]), py = y.place(point[1]);
        mark.setAttribute("transform", "translate(" + (px - x_home.place(point[0])) + " " +
          (py - y_home.place(point[1])) + ")");
        mark.style.display = figures.inside(box, px, py, 0.5) ? "" : "none";
      });
    });
    all(panel, ".rule-at").forEach(function (rule) {
      var value = Number(rule.getAttribute("data-value")), at = figures.axis(frame, "y").place(value);
      rule.setAttribute("transform", "translate(0 " + (at - figures.axis(home, "y").place(value)) + ")");
      rule.style.display = at >= box[1] && at <= box[3] ? "" : "none";
    });
  }
  function clip(panel, box) {
    var svg = panel.ownerSVGElement, id = svg.id + "-clip-" + all(svg, ".panel").indexOf(panel);
    if (!document.getElementById(id)) {
      var path = made(svg, "clipPath"), rectangle = made(svg, "rect");
      path.setAttribute("id", id);
      [["x", box[0]], ["y", box[1]], ["width", box[2] - box[0]], ["height", box[3] - box[1]]].forEach(function (one) {
        rectangle.setAttribute(one[0], one[1]);
      });
      path.appendChild(rectangle);
      panel.appendChild(path);
    }
    return "url(#" + id + ")";
  }
  return { made: made, draw_frame: draw_frame, draw_contents: draw_contents };
})();
)js";

constexpr const char* figure_zoom = R"js(
// Zoom: drag a rectangle, or the buttons and keys. The axes get new ends, ticks and curves are drawn again. Panels that
// show the same x keep it in common.
figures.zoom = (function () {
  var all = figures.all, box_of = figures.box_of, made = figures.drawing.made;
  var draw_frame = figures.drawing.draw_frame, draw_contents = figures.drawing.draw_contents;
  // Ends of an axis for the part between two places of the frame.
  function part(frame, name, from, to) {
    var axis = figures.axis(frame, name);
    return axis ? axis.value(from) + "," + axis.value(to) : null;
  }
  function show(svg, frame, ranges) {
    var same = (frame.home || frame).getAttribute("data-x-range");
    all(svg, ".panel").forEach(function (panel) {
      var one = panel.querySelector(".frame");
      one.home = one.home || one.cloneNode(false);
      if (one === frame) {
        Object.keys(ranges).forEach(function (name) { one.setAttribute("data-" + name + "-range", ranges[name]); });
      } else if (one.home.getAttribute("data-x-range") === same) {
        one.setAttribute("data-x-range", ranges.x);
      } else { return; }
      draw_frame(one);
      draw_contents(panel, one, one.home);
    });
    svg.classList.add("zoomed");
  }
  // The part of the frame between two corners.
  function to_box(svg, frame, left, top, right, bottom) {
    var ranges = { x: part(frame, "x", left, right), y: part(frame, "y", bottom, top) };
    if (figures.axis(frame, "right")) { ranges.right = part(frame, "right", bottom, top); }
    show(svg, frame, ranges);
  }
  // Around the middle by a factor, moved by shares of the frame.
  function by(svg, factor, right, up) {
    all(svg, ".frame[data-box]").slice(0, 1).forEach(function (frame) {
      var box = box_of(frame), w = box[2] - box[0], h = box[3] - box[1];
      var x = (box[0] + box[2]) / 2 + right * w, y = (box[1] + box[3]) / 2 - up * h;
      to_box(svg, frame, x - w / 2 / factor, y - h / 2 / factor, x + w / 2 / factor, y + h / 2 / factor);
    });
  }
  function reset(svg) {
    all(svg, ".panel").forEach(function (panel) {
      var frame = panel.querySelector(".frame");
      if (!frame.home) { return; }
      ["x", "y", "right"].forEach(function (name) {
        var range = frame.home.getAttribute("data-" + name + "-range");
        if (range) { frame.setAttribute("data-" + name + "-range", range); }
      });
      draw_frame(frame);
      draw_contents(panel, frame, frame.home);
    });
    svg.classList.remove("zoomed");
  }
  function follow_pointer(svg) {
    var start = null, frame = null, rectangle = null;
    function end() { if (rectangle) { rectangle.remove(); } start = rectangle = null; }
    svg.addEventListener("pointerdown", function (event) {
      var at = event.pointerType === "touch" || event.button ? null : figures.place_in(svg, event);
      frame = at && figures.frame_at(svg, at);
      if (frame) { start = at; event.preventDefault(); }
    });
    svg.addEventListener("pointermove", function (event) {
      if (!start) { return; }
      var at = figures.place_in(svg, event), box = box_of(frame);
      if (!rectangle) {
        rectangle = made(svg, "rect");
        rectangle.setAttribute("class", "zoom-box");
        svg.appendChild(rectangle);
        if (svg.setPointerCapture && event.isTrusted) { svg.setPointerCapture(event.pointerId); }
      }
      at.x = Math.max(box[0], Math.min(box[2], at.x));
      at.y = Math.max(box[1], Math.min(box[3], at.y));
      rectangle.corners = [Math.min(start.x, at.x), Math.min(start.y, at.y),
        Math.max(start.x, at.x), Math.max(start.y, at.y)];
      ["x", "y"].forEach(function (name, i) { rectangle.setAttribute(name, rectangle.corners[i]); });
      rectangle.setAttribute("width", rectangle.corners[2] - rectangle.corners[0]);
      rectangle.setAttribute("height", rectangle.corners[3] - rectangle.corners[1]);
    });
    svg.addEventListener("pointerup", function () {
      var corners = rectangle && rectangle.corners;
      if (corners && corners[2] - corners[0] > 8 && corners[3] - corners[1] > 8) {
        to_box(svg, frame, corners[0], corners[1], corners[2], corners[3]);
      }
      end();
    });
    svg.addEventListener("pointercancel", end);
    svg.addEventListener("dblclick", function () { reset(svg); });
  }
  var keys = { "+": [1.5, 0, 0], "-": [1 / 1.5, 0, 0], ArrowLeft: [1, -0.2, 0], ArrowRight: [1, 0.2, 0],
    ArrowUp: [1, 0, 0.2], ArrowDown: [1, 0, -0.2] };
  function follow_keys(svg) {
    svg.setAttribute("tabindex", "0");
    svg.addEventListener("keydown", function (event) {
      if (event.target !== svg || event.ctrlKey || event.metaKey || event.altKey) { return; }
      if (keys[event.key]) { by.apply(null, [svg].concat(keys[event.key])); event.preventDefault(); }
      if (event.key === "0" || event.key === "Escape") { reset(svg); }
    });
  }
  return { by: by, reset: reset, follow: function (svg) {
    svg.classList.add("zoomable");
    follow_pointer(svg);
    follow_keys(svg);
  } };
})();
)js";

constexpr const char* figure_files = R"js(
// A figure's data as CSV, its picture as SVG, and its buttons.
(function () {
  var all = figures.all;
  function cell(text) { return /[",\n]/.test(text) ? "\"" + text.replace(/"/g, "\"\"") + "\"" : text; }
  function plain(label) { return label.replace(/[_^]/g, ""); }
  function csv(svg) {
    var rows = [], labels = (svg.getAttribute("data-axes") || "").split("|").map(plain);
    function add(cells) { rows.push(cells.map(cell).join(",")); }
    if (svg.querySelector(".frame[data-box]")) {
      add(["x-axis", "y-axis", "curve", "x", "y"]);
      all(svg, ".panel").forEach(function (panel) {
        var frame = panel.querySelector(".frame"), x = plain(frame.getAttribute("data-x")), seen = {};
        // A line through some of a curve's marks has its name, and no value of its own.
        all(panel, ".series").forEach(function (series) {
          var name = series.getAttribute("data-name"), right = series.hasAttribute("data-right");
          var y = plain(frame.getAttribute(right ? "data-right" : "data-y"));
          series.getAttribute("data-values").split(" ").forEach(function (point) {
            var row = name + "|" + y + "|" + point;
            if (point === "-" || point === "" || seen[row]) { return; }
            seen[row] = true;
            add([x, y, name].concat(point.split(",")));
          });
        });
      });
      return rows.join("\n") + "\n";
    }
    add((svg.querySelector(".series") ? ["curve"] : []).concat(labels));
    all(svg, "[data-row]").forEach(function (one) {
      var series = one.closest(".series");
      add((series ? [series.getAttribute("data-name")] : []).concat(one.getAttribute("data-row").split(",")));
    });
    return rows.join("\n") + "\n";
  }
  // A file of its own: white, with its style inside, colours as words.
  function picture(svg) {
    var sheet = document.getElementById("picture-style"), style = sheet.textContent, copy = svg.cloneNode(true);
    sheet.getAttribute("data-colours").split(";").forEach(function (one) {
      var pair = one.split(":");
      if (pair.length === 2) { style = style.split("var(" + pair[0].trim() + ")").join(pair[1].trim()); }
    });
    var view = svg.viewBox.baseVal, paper = document.createElementNS(svg.namespaceURI, "rect");
    [copy].concat(all(copy, "*")).forEach(function (one) {
      Array.prototype.slice.call(one.attributes).forEach(function (attribute) {
        if (/^data-|^tabindex$|^aria-pressed$/.test(attribute.name)) { one.removeAttribute(attribute.name); }
      });
    });
    copy.removeAttribute("style");
    copy.setAttribute("role", "img");
    copy.setAttribute("width", view.width);
    copy.setAttribute("height", view.height);
    paper.setAttribute("width", view.width);
    paper.setAttribute("height", view.height);
    paper.setAttribute("fill", "#ffffff");
    copy.insertBefore(paper, copy.firstChild);
    var inside = document.createElementNS(svg.namespaceURI, "style");
    inside.textContent = style + ".off{display:none}";
    copy.insertBefore(inside, copy.firstChild);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + new XMLSerializer().serializeToString(copy);
  }
  function save(name, type, text) {
    var link = document.createElement("a"), address = URL.createObjectURL(new Blob([text], { type: type }));
    link.href = address;
    link.download = name;
    link.click();
    window.setTimeout(function () { URL.revokeObjectURL(address); }, 1000);
  }
  all(document, "figure").forEach(function (figure) {
    var svg = figure.querySelector("svg.plot"), tools = document.createElement("div");
    if (!svg) { return; }
    var title = svg.querySelector("title").textContent, zoomable = figure.classList.contains("curves");
    function button(text, what, act) {
      var one = document.createElement("button");
      one.type = "button";
      one.textContent = text;
      one.setAttribute("aria-label", text + ": " + what + ", " + title);
      one.title = what;
      one.addEventListener("click", act);
      tools.appendChild(one);
    }
    tools.className = "tools";
    button("CSV", "save the data", function () { save(svg.id + ".csv", "text/csv", csv(svg)); });
    button("SVG", "save the picture", function () { save(svg.id + ".svg", "image/svg+xml", picture(svg)); });
    if (zoomable) {
      figures.zoom.follow(svg);
      button("+", "zoom in", function () { figures.zoom.by(svg, 1.5, 0, 0); });
      button("\u2212", "zoom out", function () { figures.zoom.by(svg, 1 / 1.5, 0, 0); });
      button("whole", "show the whole figure (also: double click)", function () { figures.zoom.reset(svg); });
    }
    figure.appendChild(tools);
  });
})();
)js";

}  // namespace

std::string figure_script() { return std::string(figure_axes) + figure_drawing + figure_zoom + figure_files; }

}  // namespace ehd::report
