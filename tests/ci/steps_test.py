#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The logic of .ci/steps.py, on lists of steps that take no time: what turns a run red, and what its last lines say."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = TOP / ".ci" / "steps.py"


def step(name, command, level="must", more=""):
    return f"[[step]]\nname = '{name}'\nlevel = '{level}'\ncommand = '''{command}'''\n{more}\n"


def run(which, *steps, options=(), setup="true"):
    """(exit code, output) of a run of these steps."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "steps.toml"
        file.write_text("".join(steps))
        ended = subprocess.run([sys.executable, PROGRAM, which, "--steps", file, "--setup", setup, *options],
                               capture_output=True, text=True, timeout=60, check=False)
    return ended.returncode, ended.stdout + ended.stderr


PASSES = step("first", "echo works")


class WhatTurnsARunRed(unittest.TestCase):
    def red(self, name, why, *steps, **how):
        code, said = run("run", *steps, **how)
        self.assertEqual(code, 1, said)
        self.assertIn(f"RED: {name}: {why}", said)
        self.assertTrue(said.endswith("red\n"), said)
        return said

    def test_a_run_whose_steps_pass_is_green_and_names_times(self):
        code, said = run("run", PASSES)
        self.assertEqual(code, 0, said)
        self.assertIn("| first | must | 0 | 0 | passed |", said)
        self.assertIn("did NOT run: nothing, every step ran\ngreen\n", said)

    def test_a_must_that_fails(self):
        said = self.red("sanitizers", "failed (exit code 3)", step("sanitizers", "exit 3"),
                        step("next", "echo reached"))
        self.assertIn("\nreached\n", said)  # one fault does not hide another

    def test_a_must_that_skips_a_test(self):
        self.red("browser", "skipped a test: Test #3: report ....***Skipped",
                 step("browser", "echo 'Test #3: report ....***Skipped 0.01'"))
        self.red("faults", "skipped a test: memory: a: skipped: why", step("faults", "echo 'memory: a: skipped: why'"))

    def test_a_must_whose_packages_cannot_be_installed(self):
        more = "packages = ['chromium']"
        self.red("browser", "cannot be installed: one of chromium", step("browser", "true", more=more), setup="false")

    def test_a_must_that_the_time_cuts(self):
        self.red("slow", "cut after", step("slow", "sleep 50"), options=["--stop-after", "0.3"])

    def test_a_must_that_the_time_does_not_reach(self):
        said = self.red("later", "not begun", step("slow", "sleep 0.6"), step("later", "echo reached"),
                        options=["--stop-after", "0.3"])
        self.assertNotIn("\nreached\n", said)

    def test_another_step_that_fails(self):
        self.red("mutants", "failed (exit code 1)", PASSES, step("mutants", "exit 1", "more"))

    def test_what_a_step_leaves_behind_does_not_hold_the_run_up(self):
        code, said = run("run", step("daemon", "sleep 30 & echo left"))
        self.assertEqual(code, 0, said)


class WhatDidNotRun(unittest.TestCase):
    def test_the_rest_is_begun_only_while_there_is_time(self):
        code, said = run("run", step("must", "sleep 0.5"), step("rest", "echo reached", "more"),
                         options=["--begin-for", "0.2"])
        self.assertEqual(code, 0, said)
        self.assertIn("did NOT run: rest (not begun)\ngreen", said)

    def test_the_rest_is_cut_and_named(self):
        code, said = run("run", PASSES, step("rest", "sleep 50", "more"), options=["--stop-after", "0.3"])
        self.assertEqual(code, 0, said)
        self.assertIn("did NOT run: rest (cut after", said)

    def test_the_rest_is_not_begun_after_a_red_must(self):
        _, said = run("run", step("must", "exit 1"), step("rest", "echo reached", "more"))
        self.assertIn("did NOT run: rest (not begun)", said)

    def test_steps_of_check_all_are_named(self):
        code, said = run("run", PASSES, step("everything", "echo reached", "all"))
        self.assertEqual(code, 0, said)
        self.assertIn("did NOT run: everything (make check-all)", said)


class CheckAll(unittest.TestCase):
    def test_runs_every_level_in_its_own_form_and_without_a_limit(self):
        code, said = run("all", step("must", "echo one"), step("rest", "echo two", "more", "check_all = 'echo 2'"),
                         step("last", "echo three", "all"), options=["--begin-for", "0", "--stop-after", "0"])
        self.assertEqual(code, 0, said)
        self.assertRegex(said, "(?s)\none\n.*\n2\n.*\nthree\n")

    def test_every_step_counts(self):
        code, said = run("all", step("rest", "echo 'a ***Skipped'", "more"))
        self.assertEqual(code, 1, said)

    def test_a_later_run_of_one_step_keeps_the_rows_of_the_others(self):
        steps = (step("first", "true"), step("second", "exit 3"), step("third", "true"))
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "checks.md"
            for part in ("first", "second", "first"):
                run("all", *steps, options=["--only", part, "--page", str(page)])
            rows = page.read_text().split("|---|\n")[1].splitlines()
        self.assertRegex(rows[0], r"^\| first \| must \| 0 \| 0 \| passed \| \w+")
        self.assertRegex(rows[1], r"^\| second \| must \| 0 \| 0 \| failed \(exit code 3\) \| \w+")
        self.assertEqual(rows[2:], ["| third | must | | | has not run | |"])


class TheList(unittest.TestCase):
    def test_the_list_in_use_can_be_read_and_begins_with_make_test(self):
        ended = subprocess.run([sys.executable, PROGRAM, "list"], capture_output=True, text=True, check=True)
        lines = ended.stdout.splitlines()
        self.assertTrue(lines[0].startswith("must") and lines[0].endswith(": make test"), lines[0])
        targets = set((TOP / "Makefile").read_text().split("\n"))
        for line in lines:
            for word in line.split(": ", 1)[1].split("make ")[1:]:
                target = word.split()[0]
                self.assertTrue(any(text.startswith(target + ":") for text in targets), f"no make target {target}")

    def test_a_list_with_an_unknown_key_or_level_is_refused(self):
        for wrong in (step("a", "true", "often"), step("a", "true", more="needs = []"), PASSES + PASSES):
            code, said = run("run", wrong)
            self.assertEqual(code, 1, said)
            self.assertNotIn("green", said)


if __name__ == "__main__":
    unittest.main()
