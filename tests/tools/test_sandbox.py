"""The sandbox as its user meets it: pictures without a window, a window that ends by itself, faults in one line."""
import os
import subprocess
import sys
import tempfile
import unittest

SANDBOX, SOURCE = sys.argv.pop(1), sys.argv.pop(1)


def run(*arguments, **environment):
    return subprocess.run([SANDBOX, *arguments], capture_output=True, text=True, timeout=100, cwd=SOURCE,
                          env={**os.environ, **environment})


class Sandbox(unittest.TestCase):
    def test_writes_the_picture_of_a_tick(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = os.path.join(folder, "panes.png")
            result = run("panes", "--ticks", "8", "--size", "640x360", "--picture", picture)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("tick 8", result.stdout)
            self.assertIn("playing: 100 %\n", result.stderr)
            with open(picture, "rb") as file:
                head = file.read(24)
            self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
            self.assertEqual(head[16:24], (640).to_bytes(4, "big") + (360).to_bytes(4, "big"))

    def test_opens_a_window_on_a_scene_and_on_a_replay(self):
        for what in (["stack"], ["--replay", "assets/replays/demo.brt"]):
            result = run(*what, "--size", "320x180", "--frames", "5", SDL_VIDEODRIVER="offscreen")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertRegex(result.stdout, r"^\d+ ticks\n$")

    def test_says_what_is_wrong_in_one_line(self):
        for arguments, expected in (
                (["nosuch"], "expected panes, "),
                (["panes", "--variant", "64"], "0 to 63"),
                (["panes", "--accuracy", "best"], "expected phone, "),
                (["panes", "--size", "0x0"], "--size 0x0"),
                (["panes", "--ticks", "100000000", "--picture", "never.png"], "--ticks"),
                (["panes", "--ticks", "-1"], "--ticks"),
                (["panes", "--tick", "1"], "--tick"),
                (["--replay", "LICENSE"], "not a Brittle replay"),
                (["panes", "--picture", "/no/such/folder/a.png"], "cannot be written")):
            result = run(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn(expected, result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
            self.assertTrue(result.stderr.startswith("sandbox: "), result.stderr)


if __name__ == "__main__":
    unittest.main()
