#!/usr/bin/env python3
"""What accuracy buys, by a quick run of tools/accuracy: the directions of its curves, on errors alone, which are the same bits on every
machine; of times only that they are there.

usage: test_accuracy.py PROGRAM
"""
import csv
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1])
ROUNDS = ["1", "2", "3", "5", "unbounded"]
DEFAULT = "3 to 8"  # rounds, more than three only where something is fast
SEEN = 1.1  # an error that grows by less than this factor has not grown: shards differ from break to break
PLOTS = ["budget", "front", "headline", "knobs", "lag", "map", "phases", "rounds", "splitters", "threshold"]


def accuracy(*arguments, **options):
    return subprocess.run([str(PROGRAM), *map(str, arguments)], capture_output=True, text=True, timeout=300, **options)


class Quick(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        result = accuracy("--quick", "--instructions", "--out", cls.folder)
        assert result.returncode == 0, result.stdout + result.stderr

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def rows(self, table):
        with open(self.folder / f"{table}.csv", newline="") as file:
            return list(csv.DictReader(file))

    def panes(self, how, panes, speed, column="exit_speed_error_percent", table="panes", substeps=1):
        found = [row for row in self.rows(table) if row["how"] == how and int(row["panes"]) == panes
                 and float(row["speed"]) == speed and int(row["substeps"]) == substeps]
        self.assertEqual(len(found), 1, (how, panes, speed))
        return float(found[0][column])

    def error(self, knob, value, scene, figure):
        found = [row for row in self.rows("figures")
                 if (row["knob"], row["value"], row["scene"], row["figure"]) == (knob, value, scene, figure)]
        self.assertEqual(len(found), 1, (knob, value, scene, figure))
        return float(found[0]["error"])

    def test_the_default_keeps_its_exit_speeds(self):
        claimed = [row for row in self.rows("panes") if row["how"] == "default"]
        self.assertEqual({row["speed"] for row in claimed}, {"10", "20", "50", "100", "200"})
        for row in claimed:
            self.assertLess(float(row["exit_speed_error_percent"]), 2.0, row)

    def test_more_rounds_never_worsen_the_exit_speed(self):
        for panes in (1, 6):
            for speed in (20, 100):
                errors = [self.panes(rounds, panes, speed) for rounds in ROUNDS]
                for fewer, more in zip(errors, errors[1:]):
                    # A tenth of a percent of the speed is what the shards in the way weigh.
                    self.assertLess(more, max(SEEN * fewer, 0.2), (panes, speed, errors))

    def test_more_rounds_never_come_later(self):
        for speed in (20, 100):
            late = [self.panes(rounds, 6, speed, "late_ms") for rounds in ROUNDS]
            for fewer, more in zip(late, late[1:]):
                self.assertLessEqual(more, SEEN * fewer, (speed, late))
            self.assertLess(late[-1], 1.0, "unbounded rounds leave no lag")
            self.assertGreater(late[0], 15.0, "one round for six panes costs ticks")
            self.assertLess(10 * self.panes(DEFAULT, 6, speed, "late_ms"), self.panes("3", 6, speed, "late_ms"))

    def test_breaking_inside_the_step_beats_blending_beats_breaking_after_it(self):
        for speed in (20, 100):
            after, blended = self.panes("after", 1, speed), self.panes("blended", 1, speed)
            # One round is the least that breaking inside the step can take: no faster way is as good.
            inside = self.panes("1", 1, speed)
            self.assertLess(10 * inside, blended)
            self.assertLess(1.5 * blended, after)
            for way in ("after", "blended", "restored"):
                self.assertLess(10 * self.panes("1", 6, speed), self.panes(way, 6, speed), way)

    def test_iterations_and_substeps_bring_stacks_and_pendulums_nearer_to_what_is_exact(self):
        for value in ("2", "10", "32"):  # what stands is held, whatever the sweeps leave
            self.assertLess(self.error("iterations", value, "stack", "displacement"), 0.1, value)
        packed = [self.error("iterations", value, "packed", "displacement") for value in ("2", "10", "32")]
        self.assertEqual(packed, sorted(packed, reverse=True))
        self.assertLess(packed[2], 0.2 * packed[0])
        for scene, figure, part in [("stack", "displacement", 0.2), ("swing", "angle", 0.3), ("packed", "displacement", 0.2)]:
            errors = [self.error("substeps", value, scene, figure) for value in ("1", "2", "4")]
            self.assertEqual(errors, sorted(errors, reverse=True), scene)
            self.assertLess(errors[2], part * errors[0], scene)

    def test_nothing_is_gained_or_lost_inside_the_step(self):
        for value in ROUNDS[:2] + [DEFAULT]:
            self.assertLess(self.error("fracture", value, "shatter", "momentum lost"), 1e-5)
            self.assertLess(self.error("fracture", value, "shatter", "energy gained"), 1e-6)
            self.assertEqual(self.error("fracture", value, "grazes", "missed or ghost breaks"), 0.0)

    def test_more_substeps_at_the_same_rounds_come_earlier(self):
        for rounds in ("1", "2"):
            late = [self.panes(rounds, 6, 100, "late_ms", "map", substeps) for substeps in (1, 2)]
            self.assertLess(late[1], late[0])

    def test_only_splitters_without_repair_fail(self):
        failures = {}
        for row in self.rows("splitters"):
            failures[row["splitter"]] = failures.get(row["splitter"], 0) + float(row["failures"])
            self.assertGreater(float(row["splits"]), 0, row)
        for ours in ("ours float", "ours double", "exact rationals"):
            self.assertEqual(failures[ours], 0, ours)
        for naive in ("naive float", "naive double"):
            self.assertGreater(failures[naive], 0, naive)

    def test_the_strength_is_an_edge_inside_the_step_and_none_after_it(self):
        rows = self.rows("threshold")
        self.assertEqual({row["beside"] for row in rows}, {"1", "0.1", "1e-06"})
        for row in rows:
            wrong = float(row["false_breaks_per_1e4"]), float(row["missed_breaks_per_1e4"])
            self.assertEqual(wrong[0], 0.0, row)
            if row["how"] in ("after", "after capped", "blended", "restored"):
                self.assertGreater(wrong[1], 1000.0, row)
            else:
                self.assertEqual(wrong[1], 0.0, row)

    def test_floats_cost_less_than_a_thousandth_of_a_percent(self):
        rows = self.rows("float")
        self.assertEqual(len(rows), 5)
        for row in rows:
            self.assertLess(float(row["worst_relative_error"]), 1e-5, row)

    def test_instructions_were_counted_setting_by_setting(self):
        counted = {(row["knob"], row["value"]): float(row["instructions_per_s"]) for row in self.rows("settings")}
        for setting, count in counted.items():
            self.assertGreater(count, 1e7, setting)
        self.assertEqual(counted[("iterations", "10")], counted[("preset", "balanced")], "the same settings")
        self.assertGreater(counted[("iterations", "32")], 1.5 * counted[("iterations", "2")])

    def test_better_presets_are_better(self):
        presets = [row["value"] for row in self.rows("settings") if row["knob"] == "preset"]
        self.assertEqual(presets, ["phone", "balanced", "accurate", "reference"])
        for scene, figure in [("stack", "displacement"), ("swing", "angle")]:
            errors = [self.error("preset", preset, scene, figure) for preset in presets]
            for cheaper, better in zip(errors, errors[1:]):
                self.assertLess(better, 1.01 * cheaper, (scene, errors))
            self.assertLess(errors[-1], 0.2 * errors[0], scene)

    def test_everything_was_timed(self):
        for table in ("settings", "panes", "map"):
            for row in self.rows(table):
                self.assertGreater(float(row["ms_per_s"]), 0.0, row)
        for row in self.rows("phases"):
            self.assertGreater(sum(float(row[phase]) for phase in row if phase not in ("rounds", "ticks")), 0.0, row)

    def test_the_report_shows_the_plots(self):
        report = (self.folder / "report.md").read_text()
        for name in PLOTS:
            self.assertIn(f"({name}.svg)", report)
            self.assertTrue((self.folder / f"{name}.svg").read_text().rstrip().endswith("</svg>"), name)
            self.assertEqual((self.folder / f"{name}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n", name)


class Refusals(unittest.TestCase):
    def refused(self, *arguments, says, **options):
        result = accuracy(*arguments, **options)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertIn(says, result.stderr)

    def test_a_missing_plotting_program_is_named_before_the_work(self):
        with tempfile.TemporaryDirectory() as folder:
            self.refused("--quick", "--out", folder, says="gnuplot is missing: apt-get install gnuplot-nox",
                         env=dict(os.environ, PATH=folder))
            self.assertEqual(os.listdir(folder), [])

    def test_a_folder_that_cannot_be_made(self):
        with tempfile.NamedTemporaryFile() as file:
            self.refused("--quick", "--no-plots", "--out", file.name + "/out", says="cannot be made")

    def test_scenes_and_presets_that_are_none(self):
        self.refused("--scene", "sea", says="--scene sea: expected one of panes grazes stack")
        self.refused("--scene", "panes", "--accuracy", "fast", says="--accuracy fast: expected one of phone balanced")
        self.refused("--scene", "panes", "--accuracy", "iterations 17", says="or a knob and its value, as 'iterations 16'")

    def test_a_setting_by_its_row_in_the_tables(self):
        result = accuracy("--scene", "swing", "--accuracy", "iterations 16")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(result.stdout.startswith("swing, iterations 16: 240 ticks"), result.stdout)

    def test_a_missing_valgrind_is_named_before_the_work(self):
        with tempfile.TemporaryDirectory() as folder:
            os.symlink("/bin/sh", folder + "/sh")
            self.refused("--quick", "--no-plots", "--instructions", "--out", folder + "/out",
                         says="valgrind is missing: apt-get install valgrind", env=dict(os.environ, PATH=folder))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
