#!/usr/bin/env python3
"""Videos from outside: what ffprobe finds in one, that its pictures are the ones rendered alone, and that none is left half-written.

usage: test_movie.py PROGRAM ROOT
"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM, ROOT = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
REPLAY = ROOT / "assets/replays/demo.brt"
WIDTH, HEIGHT = 160, 90


def raw(program, *arguments):
    return subprocess.run([program, "-v", "error", *map(str, arguments)], capture_output=True, check=True, timeout=120).stdout


def streams(path):
    found = json.loads(raw("ffprobe", "-count_frames", "-show_streams", "-of", "json", f"file:{path}"))["streams"]
    return {stream["codec_type"]: stream for stream in found}


def pixels(path, frame):
    """RGB bytes of the frame with this number in the file."""
    return raw("ffmpeg", "-i", f"file:{path}", "-vf", f"select=eq(n\\,{frame})", "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "rgb24", "-")


def difference(a, b):
    assert len(a) == len(b) == 3 * WIDTH * HEIGHT
    return sum(abs(x - y) for x, y in zip(a, b)) / len(a)


class Movie(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = Path(self.scratch.name)

    def tearDown(self):
        self.scratch.cleanup()

    def command(self, *arguments):
        size = [] if "--size" in arguments else ["--size", f"{WIDTH}x{HEIGHT}"]
        return [str(PROGRAM), "render", str(REPLAY), *size, *arguments]

    def render(self, *arguments, **options):
        return subprocess.run(self.command(*arguments), capture_output=True, text=True, timeout=120, cwd=self.folder, **options)

    def refused(self, *arguments, says, **options):
        """One line beside the progress, status 2, and no file that was not there before."""
        before = sorted(self.folder.rglob("*"))
        result = self.render(*arguments, **options)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        lines = [line for line in result.stderr.splitlines() if not line.endswith("%")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertIn(says, lines[0])
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def path_with(self, script):
        """A PATH on which ffmpeg says its version, and else does what the script says."""
        fake = self.folder / "fake" / "ffmpeg"
        fake.parent.mkdir(exist_ok=True)
        fake.write_text(f'#!/bin/sh\n[ "$1" = -version ] && exit 0\n{script}\n')
        fake.chmod(0o755)
        return dict(os.environ, PATH=f"{fake.parent}:{os.environ['PATH']}")

    def test_size_rate_count_and_sound_are_those_of_the_frames(self):
        result = self.render("--out", "with space.mp4", "--frames", "300..359")
        self.assertEqual(result.returncode, 0, result.stderr)
        path = self.folder / "with space.mp4"
        found = streams(path)
        video, sound = found["video"], found["audio"]
        self.assertEqual((video["width"], video["height"]), (WIDTH, HEIGHT))
        self.assertEqual((video["avg_frame_rate"], video["nb_read_frames"]), ("60/1", "60"))
        self.assertAlmostEqual(float(sound["duration"]), 1.0, delta=0.03)
        self.assertGreater(max(raw("ffmpeg", "-i", f"file:{path}", "-f", "u8", "-")), 135, "glass breaks and nothing is heard")
        self.assertEqual([p.name for p in self.folder.iterdir()], ["with space.mp4"])

    def test_its_pictures_are_the_ones_rendered_alone(self):
        for out in ["-dash:colon.mp4", "pictures"]:
            result = self.render(f"--out={out}", "--frames", "302..312", "--every", "5")
            self.assertEqual(result.returncode, 0, result.stderr)
        path = self.folder / "-dash:colon.mp4"
        video = streams(path)["video"]
        self.assertEqual((video["avg_frame_rate"], video["nb_read_frames"]), ("12/1", "3"))
        alone = [pixels(self.folder / "pictures" / f"frame_{n:06}.png", 0) for n in (302, 307, 312)]
        for i, picture in enumerate(alone):
            self.assertLess(difference(pixels(path, i), picture), 4.0, "half of it is the chroma's coarser grid")
        self.assertGreater(difference(alone[0], alone[2]), 4.0, "the pictures have to differ for this to mean something")

    def test_a_video_replaces_an_older_one(self):
        (self.folder / "x.mp4").write_text("old")
        self.assertEqual(self.render("--out", "x.mp4", "--frames", "0..3").returncode, 0)
        self.assertEqual(streams(self.folder / "x.mp4")["video"]["nb_read_frames"], "4")

    def test_what_cannot_become_a_video_is_refused_before_the_work(self):
        (self.folder / "folder.mp4").mkdir()
        self.refused("--out", "none/x.mp4", says="none/x.mp4: cannot be written: No such file or directory")
        self.refused("--out", "folder.mp4", says="something that is not a file is in its place")
        self.refused("--out", "x.mp4", "--size", "161x90", says="--size 161x90: a video needs even sides")
        self.refused("--out", "x.mp4", says="ffmpeg is missing: apt-get install ffmpeg", env=dict(os.environ, PATH="/nowhere"))

    def test_what_ffmpeg_complains_of_is_passed_on(self):
        for script, says in [("echo disk is gone >&2; echo more >&2; exit 3", "x.mp4: ffmpeg: disk is gone"),
                             ("exit 4", "x.mp4: ffmpeg failed with exit status 4"),
                             ("kill -9 $$", "x.mp4: ffmpeg was ended by signal 9"),
                             ("exit 0", "x.mp4: ffmpeg ended before the last frame")]:
            self.refused("--out", "x.mp4", "--frames", "0..9", says=says, env=self.path_with(script))

    def started(self, script):
        """A rendering that has reached a fake ffmpeg, which writes its number to `encoder` and then does what the script says."""
        reached = self.folder / "encoder"
        child = subprocess.Popen(self.command("--out", "x.mp4", "--frames", "0..299"), cwd=self.folder, text=True, stderr=subprocess.PIPE,
                                 env=self.path_with(f"head -c 100 >/dev/null; echo part >x.mp4.part; echo $$ >'{reached}'; {script}"), start_new_session=True)
        deadline = time.monotonic() + 60
        while not (reached.exists() and reached.stat().st_size) and time.monotonic() < deadline:
            time.sleep(0.02)
        return child, int(reached.read_text())

    def test_ctrl_c_ends_ffmpeg_and_leaves_nothing(self):
        waits, reads = "exec sleep 60", "exec cat >/dev/null"  # one whose input is full, and one that takes all there is
        for script in [waits, reads]:
            for everyone in [False, True]:  # a terminal's goes to ffmpeg as well
                child, encoder = self.started(script)
                before = sorted(path.name for path in self.folder.iterdir())
                self.assertIn("x.mp4.part", before)
                (os.killpg if everyone else os.kill)(child.pid, signal.SIGINT)
                complaint = child.communicate(timeout=20)[1]
                self.assertEqual(child.returncode, 130, complaint)
                self.assertEqual([line for line in complaint.splitlines() if not line.endswith("%")], ["brittle: interrupted"])
                self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["encoder", "fake"])
                with self.assertRaises(ProcessLookupError):
                    os.kill(encoder, 0)
                (self.folder / "encoder").unlink()

    def test_a_signal_leaves_nothing_under_the_name(self):
        child, _ = self.started("exec sleep 60")  # takes the first frame and no more
        os.killpg(child.pid, signal.SIGTERM)
        child.communicate(timeout=60)
        self.assertEqual(child.returncode, -signal.SIGTERM)
        self.assertFalse((self.folder / "x.mp4").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
