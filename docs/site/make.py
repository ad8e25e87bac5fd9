#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make.py FOLDER: the pages of this repository as a site, FOLDER/html (make site).

The pages keep their places, so that a link works in the tree and on the site alike: FOLDER/pages has every *.md of the
tree and every file that one links to. Then mkdocs, which fails where a link leads nowhere or the navigation forgets a
page of docs/. Nothing is loaded from elsewhere; a page that would is a fault. Exit code 0, or that of mkdocs."""
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests" / "docs"))
import names  # noqa: E402, which files are pages, and what a link is

KATEX = pathlib.Path("/usr/share/javascript/katex")  # of libjs-katex
REPORT = ROOT / "out" / "verify" / "report.html"  # of make report; without it the site has none
ABOUT_REPORT = "      - The report: docs/report.md\n"
RESULTS = sorted((ROOT / "docs" / "results").glob("*.md"))
SHOWN = re.compile(r"!\[[^\]]*\]\(([^)]+)\)|src=\"([^\"]+)\"")


def sources():
    """Every file of the site, from the root."""
    found = {page for page, _ in names.pages()} | set(RESULTS)
    for page in list(found):
        text = page.read_text()
        targets = [place for place, _ in names.LINK.findall(text)] + [a or b for a, b in SHOWN.findall(text)]
        found |= {file for file in ((page.parent / place).resolve() for place in targets if place) if file.is_file()}
    return sorted(file.relative_to(ROOT) for file in found)


def forgotten():
    """Pages of docs/ that the navigation does not name."""
    navigation = (HERE / "mkdocs.yml").read_text()
    return [page for page in sorted((ROOT / "docs").glob("*.md")) if f"docs/{page.name}\n" not in navigation]


def foreign(html):
    """What a page would load from elsewhere."""
    elements = r"(?:script|img|iframe|link rel=\"?(?:stylesheet|preconnect)\"?)"
    load = re.compile(rf"<{elements}[^>]*(?:src|href)=\"?(?:https?:)?//[^>]*>")
    return [f"{page.relative_to(html)}: {found}"
            for page in html.rglob("*.html") for found in load.findall(page.read_text())]


def unset(html):
    """Pages of which KaTeX did not set every formula; nothing is known without Chromium."""
    chromium = shutil.which("chromium")
    for page in html.rglob("*.html") if chromium else ():
        if formulas := page.read_text().count('class="arithmatex"'):
            command = [chromium, "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=5000",
                       "--dump-dom"]
            shown = subprocess.run([*command, page.as_uri()], capture_output=True, text=True).stdout
            if shown.count('class="katex-display"') != formulas:
                yield f"{page.relative_to(html)}: {formulas} formulas, of which {shown.count('katex-display')} are set"


def main(folder):
    shutil.rmtree(folder, ignore_errors=True)
    for file in sources():
        (folder / "pages" / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / file, folder / "pages" / file)
    for name in ("site.css", "site.js"):
        shutil.copyfile(HERE / name, folder / "pages" / name)
    (folder / "pages" / "katex").mkdir()
    for name in ("katex.min.js", "katex.min.css", "fonts"):
        copy = shutil.copytree if (KATEX / name).is_dir() else shutil.copy
        copy(KATEX / name, folder / "pages" / "katex" / name)
    settings = (HERE / "mkdocs.yml").read_text()
    if REPORT.exists():
        shutil.copyfile(REPORT, folder / "pages" / "report.html")
        settings = settings.replace(ABOUT_REPORT, ABOUT_REPORT + "      - The report itself: report.html\n")
    (folder / "mkdocs.yml").write_text(settings)
    built = subprocess.run(["mkdocs", "build", "--quiet", "--strict", "--config-file", folder / "mkdocs.yml",
                            "--site-dir", folder / "html"])
    faults = [f"{page.name}: docs/site/mkdocs.yml does not name it" for page in forgotten()] + foreign(folder / "html")
    faults += unset(folder / "html")
    print(*faults, sep="\n", end="\n" if faults else "")
    if built.returncode == 0 and not faults:
        print(f"{folder / 'html' / 'index.html'}; with its search: python3 -m http.server -d {folder / 'html'}")
    return built.returncode or bool(faults)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
