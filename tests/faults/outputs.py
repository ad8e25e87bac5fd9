# SPDX-License-Identifier: GPL-3.0-or-later
"""Output files: modes, links, full devices, closed streams, several files of one command."""

import json
import os
import resource
import subprocess

from room import Skipped, preloaded

TITLE = "output files: modes, links, together or not at all"
SOLVE = ["solve", "--M", "20", "--L", "10"]
SWEEP = 'case = "na4908"\nlaws = ["hertz"]\ncombine = "zip"\n[keys]\n"operation.radial_load_N" = [1e3, 2e3]\n'


def keeps_mode(mode):
    def attack(room):
        room.write("a.json", "old")
        (room.path / "a.json").chmod(mode)
        ended = room.run(*SOLVE, "--json", "a.json")
        now = (room.path / "a.json").stat().st_mode & 0o7777
        return None if ended.code == 0 and now == mode else f"mode {mode:o} became {now:o}: {ended.err!r}"
    return attack


def keeps_link(room):
    room.write("real.json", "old")
    (room.path / "a.json").symlink_to("real.json")
    room.run(*SOLVE, "--json", "a.json")
    if not (room.path / "a.json").is_symlink():
        return "the link became a file"
    return None if "converged" in (room.path / "real.json").read_text() else "the file behind the link is old"


def keeps_link_to_nothing(room):
    """As a shell's > does, and as where the file is there."""
    (room.path / "below").mkdir()
    (room.path / "below" / "b.json").symlink_to("real.json")
    (room.path / "a.json").symlink_to("below/b.json")
    room.run(*SOLVE, "--json", "a.json")
    if not (room.path / "a.json").is_symlink() or not (room.path / "below" / "b.json").is_symlink():
        return "a link became a file"
    made = room.path / "below" / "real.json"
    return None if made.exists() and "converged" in made.read_text() else "the file behind the links is not made"


def calls(room, *arguments):
    """What the program opened to write, synced and renamed, in order: (what, path in the room)."""
    log = room.path / "calls"
    ended = room.run(*arguments, environment={"LD_PRELOAD": preloaded("calls.c"), "EHD_CALLS": str(log)})
    if not log.exists():
        raise Skipped("the program does not run under LD_PRELOAD (a sanitizer does not)")
    if ended.code != 0:
        return [("ended", str(ended.code))]
    seen = [line.split(" ", 1) for line in log.read_text().splitlines()]
    return [(what, os.path.relpath(room.path / path, room.path)) for what, path in seen]


def whole_on_disk(room):
    """Each temporary file is new and no link, on disk before it gets its name, and its name is on disk after that."""
    seen = calls(room, *SOLVE, "--json", "a.json", "--profile", "a.csv")
    temporary = [path for what, path in seen if what == "made" and ".partial-" in path]
    wrong = [f"{path} is made without O_EXCL and O_NOFOLLOW" for what, path in seen if what == "made-carelessly"]
    if len({path.split(".partial-")[0] for path in temporary}) != 2:
        return f"two temporary files were expected: {seen}"
    for path in temporary:
        if ("renamed", path) not in seen:
            wrong.append(f"{path} is not renamed")
            continue
        renamed = seen.index(("renamed", path))
        if ("synced", path) not in seen[:renamed]:
            wrong.append(f"{path} is not on disk before it is renamed")
        if ("synced", ".") not in seen[renamed:]:
            wrong.append(f"the folder is not on disk after {path} is renamed")
    return "; ".join(wrong) or None


def journal_on_disk(room):
    room.write("s.toml", SWEEP)
    synced = [path for what, path in calls(room, "sweep", "s.toml", "--output", "out") if what == "synced"]
    return None if "out/rows/journal" in synced else f"the journal is not on disk at the end: {synced}"


def too_large(room):
    """ulimit -f: the limit on the size of a file is met by the second output; the first must not appear."""
    room.write("a.csv", "old")
    room.write("a.json", "old")
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))
    ended = subprocess.run([room.program.path, *SOLVE, "--json", "a.json", "--profile", "a.csv"], cwd=room.path,
                           capture_output=True, preexec_fn=limit, check=False)
    if ended.returncode != 2 or ended.stderr.count(b"\n") != 1:
        return f"ended with {ended.returncode}: {ended.stderr!r}"
    texts = {(room.path / name).read_text() for name in ("a.csv", "a.json")}
    if texts != {"old"}:
        return "one of two outputs appeared"
    left = [file for file in room.files() if ".partial-" in file]
    return f"leaves {left}" if left else None


def closed_pipe(room):
    """`ehd solve --json - --profile a.csv | true`"""
    reader, writer = os.pipe()
    os.close(reader)
    subprocess.run([room.program.path, *SOLVE, "--json", "-", "--profile", "a.csv"], cwd=room.path, stdout=writer,
                   stderr=subprocess.DEVNULL, check=False, restore_signals=True)
    os.close(writer)
    left = [file for file in room.files() if ".partial-" in file]
    return f"leaves {left}" if left else None


# Commands that write into a file, with what they print beside it or before it.
BESIDE = {
    "compare": ["compare", "own-moes-5-5", "--solver", "fast", "--tolerance", "1e-1", "--json", "a.json"],
    "compare, not converged": ["compare", "own-moes-5-5", "--solver", "fast", "--tolerance", "1e-6",
                               "--max-iterations", "1", "--json", "a.json"],
    "judge": ["judge", "mine.csv", "--json", "a.json"],
    "solve": [*SOLVE, "--json", "a.json"],
    "bearing": ["bearing", "na4908", "--law", "hertz", "--json", "a.json"],
    "response": ["response", "own-moes-5-5", "--json", "a.json"],
    "convert": ["convert", "M=20", "L=10", "--json", "a.json"],
}


def closed_stream(arguments, streams):
    """`ehd ... >&-`: the file gets the JSON alone, or nothing."""
    def attack(room):
        room.write("mine.csv", "case,version,quantity,value,scaling\nown-barus-5-5,1,film.minimum,0.2,hertz\n")
        ended = subprocess.run([room.program.path, *arguments], cwd=room.path, stdin=subprocess.DEVNULL,
                               capture_output=True, preexec_fn=lambda: [os.close(one) for one in streams], check=False)
        if ended.returncode not in (0, 1, 2):
            return f"ended with {ended.returncode}: {ended.stderr!r}"
        if 1 in streams and ended.returncode == 0:
            return "success, though standard output is closed"
        left = [file for file in room.files() if file not in ("a.json", "mine.csv")]
        try:
            json.loads((room.path / "a.json").read_text())
        except FileNotFoundError:
            pass
        except ValueError:
            return f"the file is no JSON: {(room.path / 'a.json').read_text()[:200]!r}"
        return f"leaves {left}" if left else None
    return attack


def long_name(room):
    name = "n" * 255
    ended = room.run(*SOLVE, "--json", name)
    return None if ended.code == 0 and name in room.files() else f"ended with {ended.code}: {ended.err!r}"


def inputs():
    for mode in (0o600, 0o640, 0o664, 0o755):
        yield f"mode {mode:o}", keeps_mode(mode)
    yield "a link to a file", keeps_link
    yield "a link to a link to no file", keeps_link_to_nothing
    yield "temporary files: O_EXCL, O_NOFOLLOW, fsync of file and folder", whole_on_disk
    yield "the journal of a sweep: fsync", journal_on_disk
    yield "the second of two outputs is too large", too_large
    yield "a closed pipe", closed_pipe
    for name, arguments in BESIDE.items():
        for streams in ((0,), (1,), (2,), (0, 1, 2)):
            yield f"{name}: closed {streams}", closed_stream(arguments, streams)
    yield "a name of 255 characters", long_name
