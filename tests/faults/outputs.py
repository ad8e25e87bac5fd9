# SPDX-License-Identifier: GPL-3.0-or-later
"""Output files: modes, links, full devices, several files of one command."""

import os
import resource
import subprocess

TITLE = "output files: modes, links, together or not at all"
SOLVE = ["solve", "--M", "20", "--L", "10"]


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


def trap(room):
    """A link under the name that the program used to give its temporary file, for every process in reach."""
    room.write("victim", "untouched")
    waiting = ["sh", "-c", 'read line; exec "$@"', "sh", room.program.path, *SOLVE, "--json", "a.json"]
    process = subprocess.Popen(waiting, cwd=room.path, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
    (room.path / f"a.json.partial-{process.pid}").symlink_to("victim")
    process.communicate(b"go\n")
    return None if (room.path / "victim").read_text() == "untouched" else "wrote through a link"


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


def long_name(room):
    name = "n" * 255
    ended = room.run(*SOLVE, "--json", name)
    return None if ended.code == 0 and name in room.files() else f"ended with {ended.code}: {ended.err!r}"


def inputs():
    for mode in (0o600, 0o640, 0o664, 0o755):
        yield f"mode {mode:o}", keeps_mode(mode)
    yield "a link to a file", keeps_link
    yield "a link in place of the temporary file", trap
    yield "the second of two outputs is too large", too_large
    yield "a closed pipe", closed_pipe
    yield "a name of 255 characters", long_name
