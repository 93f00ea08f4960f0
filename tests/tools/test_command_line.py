#!/usr/bin/env python3
"""The program from outside: wrong input gives one line, exit status 2 and nothing half-written; help has examples.

usage: test_command_line.py PROGRAM ROOT
"""
import json
import os
import pty
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM, ROOT = Path(sys.argv[1]), Path(sys.argv[2])
SCRIPT = 'level("first") seed(7)\nthrow{tick=60, x=0, y=0}\nrun(150)\nexpect_finite()\n'


def brittle(*arguments, **options):
    return subprocess.run([str(PROGRAM), *map(str, arguments)], capture_output=True, text=True, timeout=120, cwd=ROOT, **options)


def off_screen(folder):
    """An environment without display or loudspeaker, that keeps its progress in `folder`."""
    return dict(os.environ, SDL_VIDEODRIVER="offscreen", SDL_AUDIODRIVER="dummy", XDG_DATA_HOME=folder)


class CommandLine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        (cls.folder / "game.lua").write_text(SCRIPT)
        cls.replay = cls.folder / "game.brt"
        result = brittle("smoke", cls.folder / "game.lua", "--record", cls.replay)
        assert result.returncode == 0, result.stdout + result.stderr

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def refused(self, *arguments, says):
        """One line on standard error, status 2, and no file that was not there before."""
        before = sorted(self.folder.rglob("*"))
        result = brittle(*arguments)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertTrue(result.stderr.startswith("brittle: "), result.stderr)
        self.assertIn(says, result.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def render(self, *arguments, says, replay=None):
        self.refused("render", replay or self.replay, "--out", self.folder / "out", *arguments, says=says)

    def test_every_command_has_help_with_examples(self):
        for command in ["play", "render", "verify", "smoke", "check", "explain"]:
            result = brittle(command, "--help")
            self.assertEqual(result.returncode, 0)
            self.assertIn("Examples:", result.stdout, command)
        self.assertEqual(brittle("--help").returncode, 0)

    def test_unknown_commands_and_options_are_refused(self):
        self.refused(says="subcommand")
        self.refused("smash", says="smash")
        self.refused("render", self.replay, says="--out")
        self.refused("verify", self.replay, "--quick", says="--quick")

    def test_sizes_and_ranges(self):
        for size in ["0x0", "640", "640x", "-5x5", "99999x5", "5x5x5", "axb"]:
            self.render("--size", size, says=f"--size {size}: expected WIDTHxHEIGHT")
        self.render("--size", "16384x16384", says="--size 16384x16384: expected at most 33177600 pixels")
        self.render("--frames", "9..3", says="ends before it begins")
        for frames in ["x", "..", "1..", "-1..5", "1..2..3"]:
            self.render(f"--frames={frames}", says="expected FIRST..LAST")
        for option in ["--frames", "--size", "--sound"]:
            self.render(option, "", says=f"{option}: expected a text, got an empty one")
        self.render("--frames", "100..9999", says="the replay has frames 0..150")
        self.render("--backend", "vulkan", says="expected egl, osmesa or null")
        self.render("--every", "0", says="--every")
        self.render("--samples", "3", says="--samples")
        for seed in ["-1", "1.5", "x", "18446744073709551616"]:
            self.refused("explain", f"--seed={seed}", says=f"{seed}: expected a whole number from 0")
        for rooms in ["0", "-1", "4294967295"]:
            self.refused("explain", f"--rooms={rooms}", says="--rooms")
        self.refused("explain", "--room", "4294967295", says="no room 4294967295, it has")

    def test_an_accuracy_that_is_none_is_refused_with_the_names(self):
        names = "--accuracy fast: expected phone, balanced, accurate or reference"
        for command in [["play"], ["explain"], ["smoke", self.folder / "game.lua"]]:
            self.refused(*command, "--accuracy", "fast", says=names)
        self.render("--accuracy", "fast", says=names)

    def test_names_of_effects_may_have_blanks_about_them_but_none_may_be_missing(self):
        script = self.folder / "game.lua"
        alone, spaced = [brittle("smoke", script, "--without", names).stdout for names in ["stacks,bloom", " stacks , bloom"]]
        self.assertIn("0 failed", alone)
        self.assertEqual(alone, spaced)
        for names in ["bloom,", ",bloom", "bloom,,stacks", ",", " "]:
            self.refused("smoke", script, "--without", names, says=f"--without {names}: no effect ''")

    def test_a_replay_is_played_at_the_accuracy_it_was_recorded_with(self):
        states = set()
        for preset in ["phone", "balanced", "accurate", "reference"]:
            replay = self.folder / f"{preset}.brt"
            result = brittle("smoke", self.folder / "game.lua", "--accuracy", preset, "--record", replay)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            verified = brittle("verify", replay)
            self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
            states.add(verified.stdout.split()[-1])
        self.assertEqual(len(states), 4, "presets that play the same")
        self.assertEqual((self.folder / "balanced.brt").read_bytes(), self.replay.read_bytes())

    def test_another_accuracy_renders_the_same_throws_otherwise(self):
        replay = self.folder / "window.brt"
        result = brittle("smoke", "tests/smoke/first_window.lua", "--record", replay)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        frames = {}
        for accuracy in ["", "balanced", "reference"]:
            out = self.folder / f"frames {accuracy}"
            result = brittle("render", replay, "--out", out, "--size", "320x180", "--frames", "240", "--backend", "osmesa",
                             *(["--accuracy", accuracy] if accuracy else []))
            self.assertEqual(result.returncode, 0, result.stderr)
            frames[accuracy] = (out / "frame_000240.png").read_bytes()
        self.assertEqual(frames[""], frames["balanced"])
        self.assertTrue(frames[""] != frames["reference"], "the same picture")

    def test_missing_and_damaged_replays(self):
        self.render(replay=self.folder / "none.brt", says="no such file")
        self.refused("verify", self.folder, says="not a file, expected a replay (.brt)")
        empty, cut, other = self.folder / "empty.brt", self.folder / "cut.brt", self.folder / "other.brt"
        data = self.replay.read_bytes()
        empty.write_bytes(b"")
        cut.write_bytes(data[:-1])
        other.write_bytes(data[:12] + struct.pack("<I", 4000000) + data[16:])
        self.render(replay=empty, says="empty, expected a replay")
        self.render(replay=cut, says="cut short or damaged")
        self.refused("verify", other, says="simulation version 4000000, this build plays version")
        self.refused("verify", self.folder / "game.lua", says="not a Brittle replay")

    def test_an_out_folder_that_cannot_be_written(self):
        blocked = self.folder / "file"
        blocked.write_text("")
        self.refused("render", self.replay, "--out", blocked / "frames", says="--out needs a folder that can be written")
        for place in [blocked / "a.brt", self.folder, "/dev/null"]:
            self.refused("smoke", self.folder / "game.lua", "--record", place, says=f"{place}: cannot be written")
            self.refused("play", "--record", place, says=f"{place}: cannot be written")
        self.assertTrue(Path("/dev/null").is_char_device())

    def test_levels_and_assets_that_are_not_there(self):
        self.refused("explain", "no_such_level", says="no_such_level")
        self.refused("explain", "two\nlines", says="two lines")
        self.refused("explain", "../first", says="leads out of the assets")
        self.refused("explain", "--mode", "easy", says="expected training, classic, mayhem or zen")
        self.refused("explain", "--assets", self.folder / "none", says="none")
        self.refused("smoke", self.folder / "none.lua", says="no such file")
        self.refused("check", self.folder / "none", says="no such")

    def test_a_window_nobody_can_see_is_refused(self):
        for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
            os.environ.pop(name, None)
        self.refused("play", says="no display")
        os.environ["DISPLAY"] = ":4711"  # nobody's
        self.refused("play", says="no display")
        os.environ.pop("DISPLAY")

    def test_playing_off_screen_records_a_game_that_verifies(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = off_screen(folder)
            game = Path(folder) / "game.brt"
            result = brittle("play", "--frames", "20", "--size", "160x90", "--record", game, env=environment)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(brittle("verify", game).returncode, 0)

    def test_playing_and_explaining_say_what_is_wrong_with_the_content_once(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = off_screen(folder)
            for name, text in {"levels/bad.xml": '<level><room type="bad/room" length="100"/></level>',
                               "rooms/bad/room.lua": 'function init() mgLength(mgSegment("bad/hall", 0)) end',
                               "segments/bad/hall.xml": '<segment size="12 10 16">\n<box pos="0 -1 wrong" size="5 .2 8"/></segment>'}.items():
                (Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
                (Path(folder) / name).write_text(text)
            for command in [["play", "bad", "--frames", "20", "--size", "160x90", "--mute"], ["explain", "bad", "--rooms", "1"]]:
                result = brittle(*command, "--assets", folder, env=environment)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(result.stderr.count("segments/bad/hall.xml:2"), 1, result.stderr)

    def test_what_was_reached_is_kept_and_lines_that_are_none_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = off_screen(folder)
            kept = Path(folder) / "brittle" / "progress.txt"
            kept.parent.mkdir()
            kept.write_text("41 3 first\nnonsense\n")
            result = brittle("play", "--frames", "2", "--size", "160x90", env=environment)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("progress.txt:2: nonsense: expected", result.stderr)
            self.assertEqual(kept.read_text(), "41 3 first\n")

    def test_a_damaged_progress_is_kept_beside_the_new_one_and_no_older_one_is_lost(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = off_screen(folder)
            progress = Path(folder) / "brittle" / "progress.txt"
            progress.parent.mkdir()
            names = ["progress.txt.damaged", "progress.txt.damaged.2", "progress.txt.damaged.3"]
            first, second, third = b"41 3 first\n39 \xff6 fir", b"\0\n" * 500, b"7 1 first\n" + b"x" * (1 << 20)
            for damage in [first, second, first, third]:
                progress.write_bytes(damage)
                result = brittle("play", "--frames", "2", "--size", "160x90", "--mute", env=environment, errors="replace")
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(sum("damaged, kept as it was in" in line for line in result.stderr.splitlines()), 1, result.stderr)
                self.assertLess(result.stderr.count("\n"), 15, result.stderr)
                self.assertLess(len(progress.read_bytes()), 100)
            self.assertEqual(sorted(path.name for path in progress.parent.iterdir()), ["progress.txt", *names])
            self.assertEqual([(progress.parent / name).read_bytes() for name in names], [first, second, third])

    def test_a_damaged_progress_that_cannot_be_kept_stays(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = off_screen(folder)
            progress = Path(folder) / "brittle" / "progress.txt"
            progress.parent.mkdir()
            progress.write_text("nonsense\n")
            for number in range(20):
                (progress.parent / ("progress.txt.damaged" + (f".{number + 1}" if number else ""))).write_text(str(number))
            result = brittle("play", "--frames", "2", "--size", "160x90", "--mute", env=environment)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("progress.txt: damaged, and stays as it is", result.stderr)
            self.assertEqual(progress.read_text(), "nonsense\n")
            self.assertEqual((progress.parent / "progress.txt.damaged").read_text(), "0")

    def test_a_failed_expectation_is_an_answer_not_an_error(self):
        script = self.folder / "greedy.lua"
        script.write_text('run(10)\nexpect_broken(1000)\n')
        result = brittle("smoke", script)
        self.assertEqual(result.returncode, 1)
        self.assertIn("expect_broken", result.stdout)

    def test_what_was_left_out_is_said(self):
        result = brittle("smoke", "tests/smoke/gallery.lua")
        self.assertRegex(result.stdout, r"\n  left out: \d+ [a-z ]+, .*\d+ bodies passed", result.stdout)
        level = self.folder / "bar" / "levels" / "bar.xml"
        level.parent.mkdir(parents=True)
        (level.parent.parent / "rooms").mkdir()
        level.write_text('<level><room type="bar" length="100"/></level>')
        # Bars that nobody breaks are passed.
        (level.parent.parent / "rooms" / "bar.lua").write_text(
            "function init() mgObstacle('bar', 0, 3, -20) mgObstacle('bar', 0, 3, -40) mgLength(160) end")
        (level.parent.parent / "obstacles").mkdir()
        (level.parent.parent / "obstacles" / "bar.lua").write_text(
            "function init() mgStatic(1) mgCreateBox(mgCreateBody(3, 0, 0), 1, 0.1, 0.1) end")
        explained = brittle("explain", "bar", "--assets", level.parent.parent, "--rooms", "1", "--json")
        self.assertEqual(explained.returncode, 0, explained.stderr)
        room = json.loads(explained.stdout)[0]
        self.assertGreaterEqual(room["left_out"]["bodies passed"], 2)
        for effect in room["effects"]:
            for number in ["bytes", "ms_per_tick", "ms_per_frame"]:
                self.assertIsInstance(effect[number], (int, float))
                self.assertGreaterEqual(effect[number + "_noise"], 0)
        table = brittle("explain", "bar", "--assets", level.parent.parent, "--rooms", "1").stdout
        self.assertRegex(table, r"(?m)^  fog .* < 0\.\d{3} .*, 1 time$")  # fog costs no tick anything

    def test_a_script_cannot_throw_more_than_a_tick_holds(self):
        script = self.folder / "eager.lua"
        script.write_text("for i = 1, 9 do throw{tick=5} end\nrun(9)\nexpect_finite()\n")
        result = brittle("smoke", script, "--record", self.folder / "eager.brt")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("eager.lua:1: throw: tick 5: more than 8 throws", result.stdout)

    def test_the_recorded_game_verifies_and_a_changed_input_is_found(self):
        result = brittle("verify", self.replay)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("150 ticks", result.stdout)

    def test_a_part_of_a_recorded_game_verifies(self):
        result = brittle("verify", self.replay, "--ticks", "40")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("40 ticks", result.stdout)
        self.refused("verify", self.replay, "--ticks", "0", says="--ticks")

    def test_a_script_played_with_several_seeds_says_how_its_games_ended(self):
        result = brittle("smoke", self.folder / "game.lua", "--seeds", "3")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("3 seeds, balls left: median 24, min 24, max 24; 0 at the checkpoint", result.stdout)
        for setting in ["skill", "=x", "="]:
            self.refused("smoke", self.folder / "game.lua", "--set", setting, says=f"--set {setting}: expected NAME=TEXT")

    def test_a_setting_that_no_script_asks_for_is_refused(self):
        script = self.folder / "asks.lua"
        script.write_text('level("first")\nassert(setting("skill", "good") ~= "bad")\nrun(1)\nexpect_finite()\n')
        self.assertEqual(brittle("smoke", script, self.folder / "game.lua", "--set", "skill=good").returncode, 0)
        never = self.folder / "never.brt"
        for arguments in [("--record", never), ("--seeds", "2")]:
            self.refused("smoke", script, "--set", "skil=good", *arguments,
                         says="--set skil=good: no script asks for it, expected skill")
        self.refused("smoke", self.folder / "game.lua", "--set", "skill=good", says="no script asks for it, expected none")
        result = brittle("smoke", ROOT / "assets/player.lua", "--set", "skill=godo")
        self.assertEqual(result.returncode, 1)
        self.assertIn("skill=godo: expected careless, average, good or idle", result.stdout)

    def test_check_counts_one_thing_as_one(self):
        for name, text in {"levels/one.xml": '<level><room type="one" length="1"/></level>', "rooms/one.lua": "function init() end",
                           "segments/one.xml": '<segment size="1 1 1"><bxo/><box pos="0 0 0" size="1 1 1"/></segment>'}.items():
            (self.folder / "one" / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / "one" / name).write_text(text)
        lines = brittle("check", self.folder / "one").stdout.splitlines()
        self.assertEqual(lines[-1], "1 level, 1 room (1 tried), 1 segment (1 box, 0 obstacles), 0 meshes, 1 script, 0 other files skipped: 1 problem")
        self.assertIn("one.xml:1: unknown element, got 'bxo', expected", lines[0])

    def test_check_tries_the_rooms_of_a_folder(self):
        folder = self.folder / "pack"
        for name, text in {"levels/a.xml.mp3": '<level>\n<room type="a" length="1" lenght="2"/><room type="none" length="1"/></level>',
                           "rooms/a.lua": 'function init()\n mgSegment("a", 0) mgSegment("b") mgGravity(99)\nend',
                           "segments/a.xml": '<segment size="1 1 1"><bxo/>\n<obstacle pos="0 1 -1" type="wrong" param1="sped=3"/>\n'
                                             '<obstacle pos="0 1 -1" type="scoretop" param1="sttic=1"/>\n'
                                             '<obstacle pos="0 1 -1" type="submarine"/></segment>',
                           "obstacles/wrong.lua": 'a = mgGetFloat("speed", 1)\nfunction init() while true do end end'}.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
        found = brittle("check", folder)
        self.assertEqual(found.returncode, 1)
        lines = found.stdout.replace(f"{folder}/", "").splitlines()
        self.assertEqual(lines[:-1], [
            "levels/a.xml.mp3:2: the room has no script, got 'none', expected a file rooms/none.lua",
            "segments/a.xml:1: unknown element, got 'bxo', expected one of box, obstacle, decal, powerup, water, model",
            "segments/a.xml:4: unknown obstacle type, got 'submarine', expected a file obstacles/submarine.lua",
            "levels/a.xml.mp3:2: an attribute that rooms/a.lua never asks for, got 'lenght=2', expected none",
            "rooms/a.lua:2: segment b: segments/b.xml: there is no such file",
            "rooms/a.lua:2: mgGravity: argument 1 is 99, expected -10 to 10",
            "segments/a.xml:2: a parameter that obstacles/wrong.lua never asks for, got 'sped=3', expected speed",
            "segments/a.xml:3: a parameter that obstacles/scoretop.lua never asks for, got 'sttic=1', expected static",
            "segments/a.xml:2: obstacle wrong: obstacles/wrong.lua:2: the budget of 200000 instructions is used up"])
        self.assertIn("2 rooms (1 tried)", lines[-1])
        self.assertIn("9 problems", lines[-1])
        self.assertIn("trying rooms: 100 %", found.stderr)
        for part in ["segments", "segments/a.xml", "levels/a.xml.mp3"]:
            self.assertNotIn("tried", brittle("check", folder / part).stdout)

    def test_check_tries_nothing_where_there_is_nothing_to_try(self):
        (self.folder / "parts").mkdir()
        (self.folder / "parts" / "a.lua").write_text("x = 1")
        result = brittle("check", self.folder / "parts")
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)

    def test_ctrl_c_ends_a_check(self):
        folder = self.folder / "endless"
        for name, text in {"levels/a.xml": "<level>" + 500 * '<room type="a" length="1"/>' + "</level>",
                           "rooms/a.lua": "function init() while true do end end"}.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
        self.interrupted("check", folder, after="")

    def test_a_number_that_a_script_of_ours_needs_is_asked_for(self):
        for command in [("fuzz", "--seconds"), ("fuzz", "--seconds", "soon"), ("cross_hash", "--ticks")]:
            result = subprocess.run([str(ROOT / "tools" / command[0]), *command[1:]], capture_output=True, text=True, timeout=60)
            self.assertEqual(result.returncode, 2, result.stdout)
            self.assertRegex(result.stderr, r"\A.*expected a whole number, like .*\n\Z")

    def test_progress_is_a_bar_on_a_terminal_and_lines_elsewhere(self):
        plain = brittle("verify", self.replay).stderr
        self.assertIn(": 100 %\n", plain)
        self.assertNotIn("\r", plain)
        controller, terminal = pty.openpty()
        child = subprocess.Popen([str(PROGRAM), "verify", str(self.replay)], stdout=subprocess.DEVNULL, stderr=terminal, cwd=ROOT)
        os.close(terminal)
        shown = b""
        try:
            while chunk := os.read(controller, 4096):
                shown += chunk
        except OSError:  # the way a terminal says that the other end is closed
            pass
        os.close(controller)
        self.assertEqual(child.wait(timeout=60), 0)
        self.assertIn("[" + 40 * "#" + "] 100 %", shown.decode())
        self.assertTrue(shown.endswith(b"\r\n"))

    def test_a_range_renders_the_same_alone_as_in_the_whole(self):
        whole, part = self.folder / "whole", self.folder / "part"
        for out, frames in [(whole, "0..150"), (part, "100..150")]:
            result = brittle("render", self.replay, "--out", out, "--size", "160x90", "--frames", frames, "--every", "50")
            self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(sorted(p.name for p in whole.iterdir()), [f"frame_{n:06}.png" for n in (0, 50, 100, 150)])
        for name in ["frame_000100.png", "frame_000150.png"]:
            self.assertEqual((whole / name).read_bytes(), (part / name).read_bytes(), name)

    def test_the_sound_of_a_range_is_cut_out_of_the_whole(self):
        sounds = {}
        for name, frames in [("whole", "0..150"), ("again", "0..150"), ("begin", "0..100"), ("end", "90..150")]:
            path = self.folder / f"{name}.wav"
            result = brittle("render", self.replay, "--sound", path, "--frames", frames)
            self.assertEqual(result.returncode, 0, result.stderr)
            sounds[name] = path.read_bytes()[44:]
        tick = 800 * 4
        self.assertEqual(len(sounds["whole"]), 151 * tick)
        self.assertEqual(sounds["whole"], sounds["again"])
        self.assertEqual(sounds["whole"][:101 * tick], sounds["begin"])
        self.assertEqual(sounds["whole"][90 * tick:], sounds["end"])
        self.assertTrue(any(sounds["whole"][60 * tick:]), "a ball was thrown and nothing is heard")

    def test_a_sound_file_that_cannot_be_written(self):
        self.refused("render", self.replay, "--sound", self.folder / "none" / "a.wav", says="cannot be written")

    def test_without_an_audio_device_the_game_is_silent_and_says_so(self):
        environment = dict(os.environ, SDL_VIDEODRIVER="offscreen", SDL_AUDIODRIVER="nosuchdriver")
        for arguments, lines in [([], 1), (["--mute"], 0)]:
            result = brittle("play", "--frames", "5", "--size", "160x90", *arguments, env=environment)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(result.stderr.count("no sound: "), lines, result.stderr)

    def test_the_null_backend_runs_without_gl_and_draws_nothing(self):
        environment = dict(os.environ, __EGL_VENDOR_LIBRARY_DIRS=str(self.folder / "nowhere"))
        out = self.folder / "null"
        result = brittle("render", self.replay, "--out", out, "--size", "64x36", "--backend", "null", "--every", "50", env=environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([line for line in result.stderr.splitlines() if not line.endswith("%")], [])  # no misuse of GL
        pictures = [path.read_bytes() for path in sorted(out.iterdir())]
        self.assertEqual(len(pictures), 4)
        self.assertEqual(set(pictures), {pictures[0]})

    def interrupted(self, *arguments, after="%", env=None):
        """Ctrl-C once standard error has said `after`: status 130, and one line beside the progress."""
        child = subprocess.Popen([str(PROGRAM), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT,
                                 env=env)
        if after:
            while after not in child.stderr.readline():
                self.assertIsNone(child.poll())
        else:
            time.sleep(1.0 if env else 0.5)
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 130, out + err)
        self.assertEqual([line for line in err.splitlines() if not line.endswith("%")], ["brittle: interrupted"])
        self.assertEqual(out, "")

    def test_ctrl_c_leaves_nothing_half_written(self):
        script = self.folder / "long.lua"
        script.write_text("run(200000)\nexpect_finite()\n")
        demo = ROOT / "assets/replays/demo.brt"
        before = sorted(self.folder.rglob("*"))
        self.interrupted("smoke", script, "--record", self.folder / "never.brt", after="")
        self.interrupted("smoke", script, script, "--seeds", 5, after="")
        self.interrupted("verify", demo, demo)
        self.interrupted("render", demo, "--sound", self.folder / "never.wav")
        self.assertEqual(sorted(self.folder.rglob("*")), before)
        frames = self.folder / "some"
        self.interrupted("render", demo, "--out", frames, "--size", "64x36")
        self.assertTrue(list(frames.iterdir()))
        for picture in frames.iterdir():
            self.assertEqual(picture.suffix, ".png")
            self.assertTrue(picture.read_bytes().endswith(b"IEND\xaeB`\x82"), picture)

    def test_ctrl_c_ends_an_explanation(self):
        self.interrupted("explain", "first", after="")

    def test_ctrl_c_ends_a_game_that_is_played_and_keeps_its_recording(self):
        with tempfile.TemporaryDirectory() as folder:
            game = Path(folder) / "game.brt"
            self.interrupted("play", "--size", "160x90", "--mute", "--record", game, after="", env=off_screen(folder))
            self.assertEqual(brittle("verify", game).returncode, 0)

    def test_a_second_ctrl_c_ends_at_once(self):
        script = self.folder / "endless.lua"
        script.write_text("while true do end\n")
        child = subprocess.Popen([str(PROGRAM), "smoke", str(script)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=ROOT)
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        time.sleep(0.1)
        child.send_signal(signal.SIGINT)
        self.assertIn(child.wait(timeout=60), [-signal.SIGINT, 130])

    def test_without_gl_it_says_what_is_missing(self):
        environment = dict(os.environ, __EGL_VENDOR_LIBRARY_DIRS=str(self.folder / "nowhere"))
        before = sorted(self.folder.rglob("*"))
        result = brittle("render", self.replay, "--out", self.folder / "dark", "--size", "64x36", env=environment)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
