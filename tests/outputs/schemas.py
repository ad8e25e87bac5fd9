#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every JSON of the program against the schemas of docs/schema, and the kept submissions against theirs. A schema that
a source names has to be there, on the list of docs/schema/README.md, and held against a document here.

  schemas.py EHD          exit code 0: all valid; 1: one is not; 77: there is no jsonschema
"""
import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SKIPPED = 77
try:
    import jsonschema
except ImportError:
    system = "/usr/bin/python3"
    if sys.executable != system and not subprocess.run([system, "-c", "import jsonschema"],
                                                       capture_output=True).returncode:
        sys.exit(subprocess.run([system, *sys.argv]).returncode)
    print("schemas: not run: there is no jsonschema (apt-get install python3-jsonschema)")
    sys.exit(SKIPPED)

TOP = pathlib.Path(__file__).resolve().parents[2]
SCHEMAS = {file.stem: json.loads(file.read_text()) for file in sorted((TOP / "docs" / "schema").glob("*.json"))}


ROOMS = ("contact", "fast", "reference", "bearing", "workflow", "io", "verification", "cli", "bindings")
OWN_NOTES = {"ehd-journal-3"}  # the head of a journal, which nobody else reads


def require_files():
    """Each schema that a source names has a file, and a line in the list."""
    text = "".join(file.read_text() for room in ROOMS for file in (TOP / room).rglob("*.[ch]pp"))
    named = set(re.findall(r'"(ehd-[a-z-]+-\d+)"', text)) - OWN_NOTES
    listed = set(re.findall(r"\]\((ehd-[a-z-]+-\d+)\.json\)", (TOP / "docs" / "schema" / "README.md").read_text()))
    for what, names in (("in the sources", named), ("in docs/schema/README.md", listed)):
        if names != set(SCHEMAS):
            differ = ", ".join(sorted(names ^ set(SCHEMAS)))
            sys.exit(f"schemas: {differ}: either a file of docs/schema or a name {what} is missing")


def validator(name):
    store = {f"{stem}.json": schema for stem, schema in SCHEMAS.items()}
    resolver = jsonschema.RefResolver("", SCHEMAS[name], store=store)
    return jsonschema.Draft202012Validator(SCHEMAS[name], resolver=resolver)


def require_valid(document, what):
    name = document["schema"]
    for error in validator(name).iter_errors(document):
        sys.exit(f"schemas: {what} is no {name}: {error.json_path}: {error.message}")
    # A schema that lets everything through would prove nothing: without any one of its keys it has to object.
    for key in document:
        if key in SCHEMAS[name]["required"]:
            less = copy.deepcopy(document)
            del less[key]
            if validator(name).is_valid(less):
                sys.exit(f"schemas: {name} does not miss {key}")
    if SCHEMAS[name]["additionalProperties"] is not True and validator(name).is_valid(document | {"unheard": "of"}):
        sys.exit(f"schemas: {name} accepts an unknown key")


def files_of(ehd, folder):
    """The JSON files that commands leave in a folder."""
    runs = {
        "verify": ("verify", "--quick", "--case", "harris-209"),
        "verify a rung": ("verify", "--quick", "--rung", "2"),
        "bench": ("bench", "--quick", "--part", "convolution", "--part", "first", "--part", "batch"),
        "stress": ("stress", "--quick", "--part", "d"),
        "sweep": ("sweep", TOP / "examples" / "sweeps" / "contact-moes.toml"),
        "sweep of a bearing": ("sweep", TOP / "tests" / "outputs" / "inputs" / "bearings.toml"),
    }
    for what, command in runs.items():
        out = pathlib.Path(folder) / what.replace(" ", "-")
        subprocess.run([ehd, *map(str, command), "--output", out], capture_output=True, check=True)
        for file in sorted(out.glob("*.json")):
            yield f"{file.name} of ehd {what}", json.loads(file.read_text())


def main(ehd):
    require_files()

    def said(*arguments):
        ended = subprocess.run([ehd, *map(str, arguments)], capture_output=True, text=True, check=True)
        return json.loads(ended.stdout)

    kept = sorted((TOP / "cases" / "submissions").glob("*.json"))
    documents = [(file.name, json.loads(file.read_text())) for file in kept]
    documents += [(f"ehd judge {file.name}", said("judge", file, "--json", "-")) for file in kept[:1]]
    documents.append(("ehd cases", said("cases", "own-moes-20-10", "own-barus-3-4-flooded", "own-steel-20-10",
                                        "dry-steel", "na4908", "venner1991-waiting", "--json")))
    documents.append(("a problem", documents[-1][1]["cases"][0]["problem"]))
    for case in ("own-moes-20-10", "own-barus-3-4-flooded", "own-steel-20-10", "dry-steel"):
        documents.append((f"ehd solve {case}", said("solve", case, "--json", "-")))
    documents.append(("ehd convert", said("convert", "M=20", "L=10", "--json", "-")))
    documents.append(("ehd plan", said("plan", "own-moes-20-10", "--set", "moes.M=30", "--json", "-")))
    documents.append(("ehd plan of a bearing", said("plan", "na4908", "--json", "-")))
    for law in ("hertz", "ehd-linear"):
        documents.append((f"ehd bearing by {law}", said("bearing", "na4908", "--law", law, "--json", "-")))
    documents.append(("ehd bearing --dynamic", said("bearing", "na4908", "--law", "ehd", "--dynamic",
                                                    "--frequency", 100, "--json", "-")))
    documents.append(("ehd response", said("response", "own-moes-5-5", "--omega", 1, "--wavelength", 2, "--tolerance",
                                           1e-3, "--json", "-")))
    answer = f"mine=cp {TOP / 'cases' / 'submissions' / 'ehd-fast-1e-3.json'} {{out}}; test {{case}}"
    documents.append(("ehd compare", said("compare", "own-moes-20-10", "--tolerance", 1e-2, "--external", answer,
                                          "--json", "-")[0]))
    documents.append(("ehd export law", said("export", "law", "na4908", "--raceway", "inner", "--knots", 8, "--format",
                                             "json", "--set", "bearing.clearance_m=1e-6")))
    documents.append(("ehd export films", said("export", "films", "own-moes-20-10", "--M", "10:40", "--L", "5:12",
                                               "--tolerance", 1e-2, "--format", "json")))
    documents.append(("ehd statements", said("statements", "--json", "-")))
    with tempfile.TemporaryDirectory() as folder:
        documents += files_of(ehd, folder)
    for what, document in documents:
        require_valid(document, what)
    seen = {document["schema"] for _, document in documents}
    if unused := set(SCHEMAS) - seen:
        sys.exit(f"schemas: nothing was held against {', '.join(sorted(unused))}")
    print(f"{len(documents)} documents, {len(seen)} schemas")


if __name__ == "__main__":
    main(sys.argv[1])
