# SPDX-License-Identifier: GPL-3.0-or-later
"""Options that are unknown, nearly right, out of range, no number, repeated or in conflict."""

TITLE = "options: unknown, near misses, out of range, conflicts"

NUMBERS = {  # command: its options, each with values that it refuses
    "solve --M 20 --L 10": {
        "--tolerance": ["abc", "", "nan", "inf", "0", "-1", "1.5", "1e400", "1e-400", "1e-3x"],
        "--nodes": ["abc", "", "15", "0", "-16", "16.5", "99999999999", "99999999999999999999"],
        "--max-iterations": ["abc", "0", "-1", "99999999999"],
        "--time-limit": ["abc", "0", "-1", "nan", "1e10", "1e400"],
        "--inlet": ["abc", "-1", "0", "nan", "-1e7", "-inf"],
        "--viscosity": ["abc", "", "Barus", "isoviscous", "roelands"],
        "--density": ["abc", "", "dowson-higginson"],
        "--alpha-per-Pa": ["abc", "0", "-1", "1", "nan"],
        "--z": ["abc", "0", "-1", "11"],
        "--p0-Pa": ["abc", "0", "-1", "1e16"],
        "--solver": ["abc", "", "Fast"],
        "--quantity": ["abc", "", "film"],
    },
    "bearing na4908": {"--law": ["abc", "", "Hertz"], "--max-iterations": ["0"], "--time-limit": ["0"]},
    "compare own-moes-20-10": {"--tolerance": ["abc", "0", "1.5", "nan"], "--solver": ["abc"]},
    "verify": {"--rung": ["abc", "-1", "12", "99999999999"], "--case": ["abc", ""], "--random-runs": ["0", "abc"]},
    "export films own-moes-20-10 --M 10:100 --L 3:12": {
        "--tolerance": ["abc", "0", "1.5", "nan"],
        "--threads": ["0", "abc"],
        "--max-solves": ["0", "abc", "1e3"],
        "--format": ["", "CSV", "xml"],
    },
    "export films own-moes-20-10 --L 3:12": {
        "--M": ["", ":", "10", "10:", "9:9", "9:1", "nan:9", "1:inf", "1:2:3", "0:1"]},
    "export films own-moes-20-10 --M 10:100": {"--L": ["", "-1:3", "3:101", "abc:9", "1,2"]},
    "atlas": {"--tolerance": ["1", "abc"], "--threads": ["0", "1025", "abc", "99999999999"], "--only": ["abc"]},
}

VERY_LONG = "9" * 100000  # for every option

WHOLE = [  # arguments, and what the refusal says
    (["solve", "--M", "20", "--L", "10", "--tolerence", "1e-3"], ["--tolerence", "did you mean --tolerance?"]),
    (["solve", "--M", "20", "--L", "10", "--tolerence=1e-3"], ["--tolerence", "did you mean --tolerance?"]),
    (["solve", "--M", "20", "--L", "10", "--nods", "64"], ["--nods", "did you mean --nodes?"]),
    (["solve", "--M", "20", "--L", "10", "--qqqqqqqq"], ["--qqqqqqqq", "ehd solve --help"]),
    (["solve", "own-moes-20-10", "--qqqqqqqq"], ["--qqqqqqqq", "ehd solve --help"]),
    (["bearing", "na4908", "--laws", "ehd"], ["--laws", "did you mean --law?"]),
    (["verify", "--quik"], ["--quik", "did you mean --quick?"]),
    (["solv", "own-moes-20-10"], ["solv", "did you mean solve?"]),
    (["frobnicate"], ["frobnicate", "ehd --help"]),
    (["frobnicate", "--help"], ["frobnicate", "ehd --help"]),
    (["--frobnicate"], ["--frobnicate", "ehd --help"]),
    (["solve", ""], ["a CASE has a name"]),
    (["solve"], ["missing"]),
    (["solve", "--M", "20"], ["--L"]),
    (["solve", "--L", "10"], ["--M"]),
    (["solve", "--M"], ["--M", "ehd solve --help"]),
    (["solve", "--M", "1e-400", "--L", "10"], ["--M"]),
    (["solve", "--M", "20", "--L", "1e-400"], ["--L"]),
    (["solve", "--M", "20", "--L", "10", "--L", "11"], ["--L"]),
    (["solve", "own-moes-20-10", "na4908"], ["na4908", "ehd solve --help"]),
    (["solve", "own-moes-20-10", "--M", "20"], ["exclude"]),
    (["solve", "na4908"], ["is no contact"]),
    (["solve", "own-moes-20-10", "--tolerance", "1e-3", "--nodes", "64"], ["exclude"]),
    (["solve", "own-moes-20-10", "--tolerance-central", "1e-3", "--nodes", "64"], ["exclude"]),
    (["solve", "own-moes-20-10", "--tolerance-minimum", "2"], ["--tolerance-minimum", "more than 0 to 1"]),
    (["solve", "own-moes-20-10", "--json", ""], ["the name is empty"]),
    (["solve", "own-moes-20-10", "--profile", "-"], ["--profile"]),
    (["compare"], ["required"]),
    (["compare", ""], ["a CASE has a name"]),
    (["bearing"], ["required"]),
    (["bearing", ""], ["a CASE has a name"]),
    (["bearing", "own-moes-20-10"], ["allowed is a bearing case"]),
    (["plan", ""], ["a CASE has a name"]),
    (["export"], ["WHAT"]),
    (["convert", "M=1e160", "L=1"], ["leaves the range"]),
    (["convert", "W=1e-160", "U_mean=1e300", "G=1"], ["leaves the range"]),
    (["export", "films", "", "--M", "10:100", "--L", "3:12"], ["a CASE has a name"]),
    (["export", "films", "own-moes-20-10"], ["--M is missing"]),
    (["judge"], ["a FILE is missing"]),
    (["judge", "nowhere.json"], ["there is no such file"]),
    (["judge", ""], ["there is no such file"]),
    (["compare", "own-barus-5-5", "--external", "mine"], ["--external", "has no name"]),
    (["cases", "own-barus-5-5", "--json", "--bibtex"], ["exclude"]),
    (["cases", "nowhere"], ["there is no such case"]),
    (["report"], ["required"]),
    (["report", "nowhere"], ["nowhere"]),
    (["sweep"], ["required"]),
    (["sweep", ""], ["allowed is a sweep file (TOML)"]),
    (["sweep", "nowhere.toml"], ["allowed is a sweep file (TOML)"]),
    (["verify", "--case", "na4908", "--rung", "1"], ["allowed here is --rung"]),
    (["verify", "--case", "own-moes-20-10", "--rung", "1"], ["allowed here is --rung"]),
]


def refusal(arguments, says):
    return lambda room: room.refused(*arguments, says=says)


def inputs():
    for command, options in NUMBERS.items():
        for option, values in options.items():
            for value in [*values, VERY_LONG]:
                named = [] if option == "--case" else [option]
                yield f"{command} {option} {value[:30]!r}", refusal([*command.split(), option, value], named)
    for arguments, says in WHOLE:
        yield " ".join(map(repr, arguments)), refusal(arguments, says)
