# SPDX-License-Identifier: GPL-3.0-or-later
"""What else runs in the process: other threads, Ctrl-C, other ways to find the library."""

import concurrent.futures
import multiprocessing
import os
import shutil
import signal
import subprocess
import sys
import threading
import time

import ehd
import numpy as np
import pytest

def long_solve():
    return [ehd.solve(M=2000, L=25, solver="reference", tolerance=1e-10).status]


def long_films():
    return ehd.films(np.geomspace(2, 2000, 20000), 10, tolerance=1e-5).status


@pytest.fixture
def interrupted_soon():
    """Both calls take ten seconds and more."""
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    yield
    timer.join()


@pytest.mark.usefixtures("interrupted_soon")
@pytest.mark.parametrize("work", [long_solve, long_films])
def test_ctrl_c_ends_a_call(work):
    usual = signal.getsignal(signal.SIGINT)
    with pytest.raises(KeyboardInterrupt):
        work()
    assert signal.getsignal(signal.SIGINT) is usual
    assert ehd.solve(M=20, L=10).status == "converged"  # the next call is not cancelled


@pytest.mark.parametrize("work", [long_solve, long_films])
def test_a_handler_of_the_user_decides_what_ctrl_c_means(work, request):
    """Here it notes the signal: then the call returns, and its status says that it was cancelled."""
    seen = []
    usual = signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
    try:
        request.getfixturevalue("interrupted_soon")
        status = work()
    finally:
        signal.signal(signal.SIGINT, usual)
    assert seen == [signal.SIGINT] and "limit-reached" in status


def test_other_threads_run_meanwhile():
    """While the main thread is inside the library, another one counts."""
    counted, ready = [0], threading.Event()

    def count():
        while not ready.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    ehd.films(np.geomspace(2, 200, 150), 10, tolerance=1e-4, threads=1)
    during = counted[0] - before
    ready.set()
    thread.join()
    assert during >= 10  # with the interpreter locked it would be 0 or 1


def test_threads_of_python_get_the_same_numbers():
    cases = [(M, L) for M in (5.0, 20.0, 80.0) for L in (5.0, 10.0)]

    def film(group):
        return ehd.solve(M=group[0], L=group[1]).film.minimum.hertz

    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        assert list(pool.map(film, cases)) == [film(group) for group in cases]


def test_processes_get_the_same_bits():
    with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        there = pool.submit(ehd.solve, "own-steel-20-10")
        law = pool.submit(ehd.bearing, "na4908", "hertz").result().law("inner")
    here = ehd.solve("own-steel-20-10")
    assert there.result().film == here.film and there.result().P.tobytes() == here.P.tobytes()
    assert law.force(2e-6) == ehd.bearing("na4908", "hertz").law("inner").force(2e-6)


def test_results_are_freed():
    """Kept, 300 results are 12 MB."""
    def resident_kB():
        with open("/proc/self/status", encoding="utf-8") as file:
            return next(int(line.split()[1]) for line in file if line.startswith("VmRSS"))

    def work():
        for _ in range(300):
            ehd.solve(M=20, L=10)
            with pytest.raises(ehd.InputError):
                ehd.solve(M=20, L=200)

    work()
    before = resident_kB()
    work()
    assert resident_kB() - before < 5000


def run_python(code, **environment):
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False,
                          env={**os.environ, **environment})


def test_the_library_that_the_environment_names_is_the_only_one():
    done = run_python("import ehd; ehd.solve(M=20, L=10)", EHD_LIBRARY="/nowhere/libehd.so.0")
    assert done.returncode == 1
    assert "ImportError" in done.stderr and "/nowhere/libehd.so.0" in done.stderr and "EHD_LIBRARY" in done.stderr
    assert "ignored" not in done.stderr  # nothing is said of the result that could not be made


def test_importing_needs_neither_the_library_nor_matplotlib():
    done = run_python("import sys, ehd; assert 'matplotlib' not in sys.modules", EHD_LIBRARY="/nowhere/libehd.so.0")
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("packages, libraries, cases", [
    ("lib/python3/dist-packages", "lib", "share/ehd/cases"),  # installed under a prefix
    ("bindings/python", "build", "cases"),  # a source tree
    ("lib/python3/dist-packages", "lib/python3/dist-packages/ehd", "share/ehd/cases"),  # in the package itself
])
def test_the_library_and_the_cases_are_found_beside_the_package(tmp_path, packages, libraries, cases):
    shutil.copytree(os.path.dirname(ehd.__file__), tmp_path / packages / "ehd",
                    ignore=shutil.ignore_patterns("__pycache__"))
    for folder in (libraries, os.path.dirname(cases)):
        (tmp_path / folder).mkdir(parents=True, exist_ok=True)
    (tmp_path / libraries / "libehd.so.0").symlink_to(os.environ["EHD_LIBRARY"])
    (tmp_path / cases).symlink_to(os.environ["EHD_CASES"])
    code = ("import os; del os.environ['EHD_LIBRARY'], os.environ['EHD_CASES']; import ehd; "
            "print(ehd.__file__, ehd.solve('own-moes-20-10').status)")
    done = run_python(code, PYTHONPATH=str(tmp_path / packages))
    assert done.stdout.split() == [str(tmp_path / packages / "ehd" / "__init__.py"), "converged"], done.stderr
