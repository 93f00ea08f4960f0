#!/usr/bin/env python3
"""The table of hard cases as its reader meets it: JSON that is JSON, a row per case, names that do not exist refused.

usage: test_hard_cases.py HARD_CASES
"""
import json
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop(1)
FIELDS = ["id", "case", "criterion", "figure", "pass", "seconds"]


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=120)


class Table(unittest.TestCase):
    def test_json_is_a_list_of_rows_in_order(self):
        result = run("--json", "B24", "B18")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = json.loads(result.stdout)
        self.assertEqual([row["id"] for row in rows], ["B18", "B24"])
        for row in rows:
            self.assertEqual(list(row), FIELDS)
            self.assertIs(row["pass"], True)
            self.assertGreater(row["seconds"], 0.0)

    def test_markdown_has_two_cases_to_a_line(self):
        result = run("--markdown", "B16", "B18")
        self.assertRegex(result.stdout, r"(?m)^\| B16 \|.*\| B18 \| a block cut .*\|$")

    def test_what_is_wrong_is_said_in_one_line(self):
        for arguments, says in [(["B18", "B99"], "no case B99"), (["--ful"], "--ful"), (["--json", "--markdown"], "--markdown")]:
            result = run(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertRegex(result.stderr, r"\Ahard_cases: .*\n\Z")
            self.assertIn(says, result.stderr)

    def test_help_has_examples(self):
        self.assertIn("hard_cases --full B1 B21", run("--help").stdout)


if __name__ == "__main__":
    unittest.main()
