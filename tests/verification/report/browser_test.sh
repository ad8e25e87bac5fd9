#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# browser_test.sh EHD MADE_REPORT [AXE]: the report of made results in headless Chromium: no console message, every
# figure with its data, light and dark, a phone's width without sideways scrolling, its height, headings and links,
# the script's switches, zoom, saved files; with AXE, the file axe.min.js, also its rules of WCAG 2.1 A and AA. Exit
# code: 0 all is well, 1 something is not (a line each), 77 no browser is installed.
set -eu
ehd=$1
made_report=$2
axe=${3:-}
here=$(cd "$(dirname "$0")" && pwd)

browser=
for name in chromium chromium-browser google-chrome google-chrome-stable; do
  if command -v "$name" > /dev/null 2>&1; then browser=$name; break; fi
done
if [ -z "$browser" ]; then
  echo "report in the browser: skipped: no Chromium is installed (apt-get install chromium)"
  exit 77
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$made_report" "$folder"
"$ehd" report "$folder" > /dev/null
mkdir "$folder/long"  # as many rows as a real page has
"$made_report" "$folder/long" long
"$ehd" report "$folder/long" > /dev/null

# with_probe PAGE PROBE: the page with a script in front that catches errors, and one behind that looks and writes down
# what it saw.
with_probe() {
  sed '/<meta charset/q' "$1"
  echo '<script>window.seen = [];'
  echo 'window.addEventListener("error", function (e) { window.seen.push("error: " + e.message); });</script>'
  sed '1,/<meta charset/d; /<\/body>/d' "$1"
  if [ -n "$axe" ]; then
    echo '<script>'
    cat "$axe"
    echo '</script>'
  fi
  echo '<script>'
  cat "$here/$2"
  echo '</script></body></html>'
}
sed '/^<script>$/,/^<\/script>$/d' "$folder/report.html" > "$folder/plain.html"
grep -q '<script' "$folder/plain.html" && { echo "the page's script was not taken out"; exit 1; }
with_probe "$folder/report.html" browser_probe.js > "$folder/probe.html"
with_probe "$folder/plain.html" browser_probe.js > "$folder/plain-probe.html"
# The page of ehd judge: a submission of the reader beside the kept ones.
cat > "$folder/mine.csv" << END
case,version,quantity,value,scaling,stated_error
own-moes-20-10,1,film.minimum,0.0742,hertz,1e-3
own-moes-5-5,1,film.minimum,0.2341,hertz,1e-3
END
"$ehd" judge "$folder/mine.csv" --output "$folder" > /dev/null
with_probe "$folder/judge.html" judge_probe.js > "$folder/judge-probe.html"
# framed WIDTH HEIGHT PAGE: the page in a frame. A window is never narrower than 500 pixels, a frame in it may be.
framed() {
  cat << END
<!DOCTYPE html><html><head><title>frame</title></head><body>
<iframe src="$3" width="$1" height="$2" style="border:0"></iframe>
<script>window.addEventListener("message", function (e) {
  var result = document.createElement("pre");
  result.id = "probe";
  result.textContent = "\\n" + e.data + "\\n";
  document.body.appendChild(result);
});</script></body></html>
END
}
framed 390 844 probe.html > "$folder/phone.html"
framed 390 844 judge-probe.html > "$folder/judge-phone.html"
framed 1400 900 judge-probe.html > "$folder/judge-wide.html"
# Of the long page only the height is of interest.
{
  sed '/<\/body>/d' "$folder/long/report.html"
  cat << END
<script>window.parent.postMessage(
  "width: " + window.innerWidth + "\\nheight: " + document.documentElement.scrollHeight + "\\ndone", "*");</script>
</body></html>
END
} > "$folder/long-probe.html"
framed 1400 900 long-probe.html > "$folder/wide.html"

failed=0
complain() {
  echo "$1"
  failed=1
}

# look NAME PAGE SCHEME: the page as the browser has it in the end, and what it said. SCHEME: 0 dark, 1 light.
look() {
  name=$1
  timeout 120 "$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir="$folder/profile" \
    --enable-logging=stderr --v=0 --virtual-time-budget=10000 --window-size=1200,900 \
    --blink-settings=preferredColorScheme="$3" --dump-dom "file://$folder/$2" \
    > "$folder/$name.dom.html" 2> "$folder/$name.log" || complain "$name: the browser ended with exit code $?"
  if grep "CONSOLE" "$folder/$name.log"; then complain "$name: the page wrote to the console"; fi
  sed -n '/<pre id="probe">$/,/^<\/pre>/p' "$folder/$name.dom.html" | sed '/pre/d' > "$folder/$name.txt"
  grep -q '^done$' "$folder/$name.txt" || complain "$name: the probe did not come to its end"
  while IFS= read -r line; do
    case $line in
      error:*) complain "$name: $line" ;;
    esac
  done < "$folder/$name.txt"
}

# says NAME LINE: the probe of that run has seen it.
says() {
  grep -qx -- "$2" "$folder/$1.txt" || complain "$1: expected \"$2\", seen: $(tr '\n' ';' < "$folder/$1.txt")"
}

look light probe.html 1
look dark probe.html 0
look phone phone.html 1
look plain plain-probe.html 1
look wide wide.html 1
look judge-wide judge-wide.html 1
look judge-phone judge-phone.html 0

figures=$(grep -c '<svg class="plot"' "$folder/report.html")
[ "$figures" -gt 40 ] || complain "the page has only $figures figures"
for run in light dark phone plain; do
  says "$run" "figures: $figures"
  says "$run" "overflow: 0"
  says "$run" "overflow, all open: 0"
  says "$run" "shown: 3"  # margins, the first bearing: the others open on demand
  says "$run" "pictures: works"
  says "$run" "contours: works"
  says "$run" "headings: works"
  says "$run" "links: works"
  says "$run" "anchors: works"
done
says light "paper: rgb(255, 255, 255)"
says dark "paper: rgb(21, 24, 28)"
says phone "width: 390"
says phone "tables: works"
says wide "width: 1400"
most_height=10333  # a third of the 31,000 pixels of the page that had nothing folded
height=$(sed -n 's/^height: //p' "$folder/wide.txt")
[ "${height:-$((most_height + 1))}" -le "$most_height" ] || complain "the closed page is ${height:-?} pixels high"
for seen in toggle read-out cell filter "filter links" "filter key" index case zoom "zoomed ticks" theme CSV \
    "CSV of a map" SVG targets; do
  for run in light dark phone; do says "$run" "$seen: works"; done
done
for run in judge-wide judge-phone; do
  says "$run" "overflow: 0"
  says "$run" "table: fits"
  says "$run" "looks: \([89]\|[1-9][0-9]\+\), all differ, mine alone is large"  # eight or more
done
if [ -n "$axe" ]; then
  for run in light dark phone judge-wide judge-phone; do says "$run" "axe: .* rules pass, 0 do not"; done
fi

timeout 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" \
  --print-to-pdf="$folder/report.pdf" "file://$folder/report.html" > /dev/null 2>&1 || complain "print: exit code $?"
[ -s "$folder/report.pdf" ] || complain "print: nothing came out"

[ "$failed" -eq 0 ] \
  && echo "$figures figures: light, dark, on a phone, without the script, in print${axe:+; axe-core has no objection}"
exit "$failed"
