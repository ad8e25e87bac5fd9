# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals in the middle of the work of every command that takes a while."""

import json
import os
import select
import signal
import subprocess
import time

TITLE = "SIGINT and SIGTERM: what is kept; leftovers of SIGKILL"
KEEPING_S = 60  # until the first part of a command is finished, beside other attacks
PATIENCE_S = 10  # until the temporary files are there, and until the program has ended

# Commands that take some seconds, with an output each.
SWEEP = 'case = "own-moes-20-10"\nsolver = "reference"\ncombine = "product"\n[keys]\n' \
        '"moes.M" = { from = 5.0, to = 60.0, points = 200, spacing = "linear" }\n'
MINE = "case,version,quantity,value,scaling,stated_error\nown-moes-20-10,1,film.minimum,0.0742,hertz,1e-3\n"
# Not here: cases, convert, new, plan and report end within a tenth of a second.
COMMANDS = {
    "solve": ["solve", "--M", "20", "--L", "10", "--solver", "reference.uniform", "--nodes", "3000",
              "--json", "a.json", "--profile", "a.csv"],
    "compare": ["compare", "own-moes-100-10", "--solver", "reference.uniform", "--tolerance", "1e-6",
                "--json", "a.json"],
    "bearing": ["bearing", "na4908", "--solver", "reference", "--json", "a.json", "--csv", "a.csv"],
    "verify": ["verify", "--output", "out"],
    "bench": ["bench", "--output", "out"],
    "stress": ["stress", "--part", "a", "--output", "out"],
    "statements": ["statements", "--json", "a.json"],
    "sweep": ["sweep", "s.toml", "--output", "out", "--threads", "1"],
    "atlas": ["atlas", "--output", "out", "--threads", "1", "--only", "roelands-m5000-l30"],
    "atlas --motion": ["atlas", "--motion", "--output", "out", "--threads", "1", "--only", "roelands-m200-l15"],
    "response": ["response", "own-moes-100-10", "--solver", "reference", "--tolerance", "1e-12", "--json", "a.json",
                 *(word for Omega in range(1, 100) for word in ("--omega", str(Omega)))],
    "bearing --dynamic": ["bearing", "na4908", "--solver", "reference", "--law", "ehd", "--dynamic",
                          "--json", "a.json"],
    "export law": ["export", "law", "na4908", "--raceway", "inner", "--knots", "10000", "--output", "law.csv"],
    "judge": ["judge", *["mine.csv"] * 600, "--output", "out"],
    "maps": ["maps", "--table"],
    "export films": ["export", "films", "own-moes-20-10", "--M", "2:1000", "--L", "2.5:20", "--tolerance", "1e-6",
                     "--output", "films.c"],
}


class TooEarly(Exception):
    """The command ended before the signal: the test has to give it more to do."""


def hear_signals():
    """A shell starts its background jobs with SIGINT ignored, and the program leaves an ignored signal ignored."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_DFL)


def started(room, arguments, ready, **environment):
    room.write("s.toml", SWEEP)
    room.write("mine.csv", MINE)
    process = subprocess.Popen([room.program.path, *arguments], cwd=room.path, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, preexec_fn=hear_signals, env={**os.environ, **environment})
    end = time.monotonic() + PATIENCE_S
    while not ready() and process.poll() is None and time.monotonic() < end:
        time.sleep(0.01)
    time.sleep(0.1)
    if process.poll() is not None:
        raise TooEarly(process.communicate()[1].decode(errors="replace"))
    return process


def partial(room):
    return [file for file in room.files() if ".partial-" in file]


def interrupted(command, number):
    def attack(room):
        begun = {"sweep": "out/rows/journal", "atlas": "out/.progress/films/journal",
                 "atlas --motion": "out/.progress/motion/journal"}.get(command)
        def at_work():
            if command == "maps":  # nothing shows from outside that it has begun
                return True
            return begun in room.files() if begun else partial(room)
        try:
            process = started(room, COMMANDS[command], at_work)
        except TooEarly as early:
            return f"the command ended before the signal: {early}"
        process.send_signal(number)
        try:
            _, err = process.communicate(timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return "did not end in time"
        text = err.decode(errors="replace")
        last = text.strip().split("\n")[-1]
        if process.returncode != -number:
            return f"did not end by signal {number}, but with {process.returncode}: {text!r}"
        if "interrupted" not in last or text.count("interrupted") != 1:
            return f"not one line says that it was interrupted: {text!r}"
        if partial(room):
            return f"leaves {partial(room)}"
        if command == "sweep" and "out/rows/journal" not in room.files():
            return "the finished rows are not kept"
        return None
    return attack


# Commands whose finished parts are kept: what they print where the first is finished, on a terminal where nothing else
# says so, and what the file then has to say.
KEEPING = {
    "verify": (["verify", "--quick", "--rung", "6", "--output", "out"], b"verify 1/", "results.json",
               lambda file: file["summary"]["stopped"] and file["summary"]["not_run"] > 0 and file["topics"]
               and not file["summary"]["success"] and "figures" not in file),
    "stress": (["stress", "--quick", "--part", "e", "--part", "a", "--output", "out"], b"pass in", "stress.json",
               lambda file: [part["verdict"] for part in file["parts"]] == ["pass", "inconclusive"]
               and not file["success"]),
    "bench": (["bench", "--part", "convolution", "--part", "work-precision", "--output", "out"], b"c = ", "bench.json",
              lambda file: file["settings"]["left_out"] == ["work-precision"] and "convolution" in file),
}


def at_first_part(room, arguments, mark):
    """The process, where its output has the mark: both streams are one terminal. And that terminal."""
    terminal, end = os.openpty()
    process = subprocess.Popen([room.program.path, *arguments], cwd=room.path, stdout=end, stderr=end,
                               preexec_fn=hear_signals)
    os.close(end)
    seen, late = b"", time.monotonic() + KEEPING_S
    while mark not in seen and time.monotonic() < late and process.poll() is None:
        if select.select([terminal], [], [], 0.1)[0]:
            seen += os.read(terminal, 4096)
    if mark not in seen:
        process.kill()
        process.communicate()
        os.close(terminal)
        raise TooEarly(f"no part was finished: {seen[-300:]!r}")
    return process, terminal


def rest_of(terminal):
    text = b""
    try:
        while more := os.read(terminal, 4096):
            text += more
    except OSError:  # the other end is closed
        pass
    os.close(terminal)
    return text


def keeps_finished(command, number):
    def attack(room):
        arguments, mark, name, is_kept = KEEPING[command]
        try:
            process, terminal = at_first_part(room, arguments, mark)
        except TooEarly as early:
            return str(early)
        process.send_signal(number)
        try:
            process.wait(timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            return "did not end in time"
        text = rest_of(terminal)
        if process.returncode != -number or text.count(b"interrupted; out/") != 1:
            return f"ended with {process.returncode}: {text!r}"
        if partial(room):
            return f"leaves {partial(room)}"
        if f"out/{name}" not in room.files():
            return "the finished parts are not kept"
        file = json.loads((room.path / "out" / name).read_text())
        if not is_kept(file):
            return f"out/{name} does not say what is left out: {json.dumps(file)[:300]}"
        return None
    return attack


def prints_finished_cases(number):
    """Two bearings, the first one dry and so quick: its table stands on standard output when the second is cut."""
    def attack(room):
        arguments = ["bearing", "harris-209", "na4908", "--solver", "reference"]
        process = subprocess.Popen([room.program.path, *arguments], cwd=room.path, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, preexec_fn=hear_signals)
        select.select([process.stdout], [], [], PATIENCE_S)
        if process.poll() is not None:
            return f"the command ended before the signal: {process.communicate()[1]!r}"
        process.send_signal(number)
        out, err = process.communicate(timeout=PATIENCE_S)
        if process.returncode != -number or err.count(b"interrupted") != 1:
            return f"ended with {process.returncode}: {err!r}"
        alone = room.run("bearing", "harris-209").out
        return None if out.decode() == alone else f"printed {out!r} and not the table of the finished case"
    return attack


def ended_twice(room):
    """The second signal does not wait until what is finished has been written."""
    process = started(room, COMMANDS["verify"], lambda: partial(room))
    process.send_signal(signal.SIGINT)
    process.send_signal(signal.SIGTERM)
    try:
        _, err = process.communicate(timeout=PATIENCE_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return "did not end in time"
    if process.returncode not in (-signal.SIGINT, -signal.SIGTERM) or err.count(b"interrupted") != 1:
        return f"ended with {process.returncode}: {err!r}"
    return f"leaves {partial(room)}" if partial(room) else None


def killed(room):
    arguments = COMMANDS["solve"]
    process = started(room, arguments, lambda: partial(room))
    process.kill()
    process.communicate()
    left = partial(room)
    if not left:
        return "the test is wrong: SIGKILL left nothing"
    short = ["--M", "20", "--L", "10", "--json", "a.json", "--profile", "a.csv"]
    ended = room.run("solve", *short)
    if ended.code != 0 or partial(room):
        return f"the next run ended with {ended.code} and left {partial(room)}: {ended.err!r}"
    return None


def two_at_once(room):
    """The files of a run that is still at work are no leftovers."""
    process = started(room, COMMANDS["solve"], lambda: partial(room))
    before = partial(room)
    room.run("solve", "--M", "20", "--L", "10", "--json", "a.json")
    lost = [file for file in before if file not in room.files()]
    process.kill()
    process.communicate()
    return f"removed {lost} of a living run" if lost else None


def ignored(room):
    """nohup: a signal that the caller ignores stays ignored."""
    arguments = ["solve", "--M", "20", "--L", "10", "--solver", "reference.uniform", "--nodes", "500",
                 "--json", "a.json"]
    process = subprocess.Popen([room.program.path, *arguments], cwd=room.path, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    time.sleep(0.1)
    process.send_signal(signal.SIGHUP)
    process.communicate(timeout=PATIENCE_S)
    return None if process.returncode in (0, 1) else f"ended with {process.returncode}"


def with_child(number):
    """The solver that `compare --external` runs ends with the program, and so does the folder between them."""
    def attack(room):
        child = "touch started; sleep 60 # {case} {out}"
        arguments = ["compare", "own-moes-20-10", "--solver", "fast", "--tolerance", "1e-2", "--external",
                     f"mine=cd {room.path}; {child}", "--json", "a.json"]
        folder = room.path / "exchange"
        folder.mkdir()
        process = started(room, arguments, lambda: "started" in room.files(), TMPDIR=str(folder))
        process.send_signal(number)
        process.communicate(timeout=PATIENCE_S)
        if process.returncode != -number:
            return f"did not end by signal {number}, but with {process.returncode}"
        def living():
            return [pid for pid in os.listdir("/proc") if pid.isdigit() and cwd_of(pid) == str(room.path)]
        end = time.monotonic() + PATIENCE_S
        while living() and time.monotonic() < end:
            time.sleep(0.01)
        alive = living()
        if alive:
            for pid in alive:
                os.kill(int(pid), signal.SIGKILL)
            return "the external solver lives on"
        return f"leaves {list(folder.iterdir())}" if list(folder.iterdir()) else None
    return attack


def cwd_of(pid):
    try:
        return os.readlink(f"/proc/{pid}/cwd")
    except OSError:
        return None


def inputs():
    for number in (signal.SIGINT, signal.SIGTERM):
        yield f"compare --external, {number.name}", with_child(number)
    for command in COMMANDS:
        for number in (signal.SIGINT, signal.SIGTERM):
            yield f"{command}, {number.name}", interrupted(command, number)
    for command in KEEPING:
        for number in (signal.SIGINT, signal.SIGTERM):
            yield f"{command}, {number.name} after a part", keeps_finished(command, number)
    for number in (signal.SIGINT, signal.SIGTERM):
        yield f"bearing, {number.name} after a case", prints_finished_cases(number)
    yield "verify, two signals", ended_twice
    yield "solve, SIGKILL and again", killed
    yield "two runs at once", two_at_once
    yield "SIGHUP ignored by the caller", ignored
