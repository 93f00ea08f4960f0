#!/usr/bin/env python3
"""What effects cost, as its reader meets it: JSON that is JSON, a row per effect, names that do not exist refused.

usage: test_effects_cost.py EFFECTS_COST [--long]
With --long every module is left out once: a build each.
"""
import json
import subprocess
import sys
import unittest

LONG = "--long" in sys.argv
if LONG:
    sys.argv.remove("--long")
PROGRAM = sys.argv.pop(1)
FIELDS = ["effect", "unused_overhead_percent", "bytes_per_body", "code_bytes", "used_ms"]


def run(*arguments, timeout=300):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=timeout)


class Costs(unittest.TestCase):
    def test_json_is_a_list_of_rows(self):
        result = run("--used", "--rounds", "1", "--json", "mirror", "joints")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = json.loads(result.stdout)
        self.assertEqual([row["effect"] for row in rows], ["mirror", "joints"])
        for row in rows:
            self.assertEqual(list(row), FIELDS)
            self.assertIsNone(row["unused_overhead_percent"])

    def test_what_is_no_module_is_refused(self):
        for arguments, says in [(["--used", "lightning"], "lightning: expected an effect with a module"),
                                (["--rounds", "0"], "--rounds"), (["--usd"], "--usd")]:
            result = run(*arguments)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, r"\Aeffects_cost: .*\n\Z")
            self.assertIn(says, result.stderr)

    @unittest.skipUnless(LONG, "a build per effect")
    def test_what_nobody_demands_costs_nothing(self):
        result = run("--json", "--rounds", "1", timeout=5400)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = json.loads(result.stdout)
        self.assertGreaterEqual(len(rows), 12)
        for row in rows:
            with self.subTest(row["effect"]):
                self.assertLessEqual(abs(row["unused_overhead_percent"]), 1.0)
                self.assertLessEqual(abs(row["bytes_per_body"]), 32)  # the heap rounds; a body has 17 kB


if __name__ == "__main__":
    unittest.main()
