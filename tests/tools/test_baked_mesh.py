#!/usr/bin/env python3
"""Meshes that segments carry, from outside: they are what is seen of a room, and change nothing else.

usage: test_baked_mesh.py PROGRAM ROOT
"""
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

PROGRAM, ROOT = Path(sys.argv[1]), Path(sys.argv[2])
GREY, RED = (128, 128, 128), (230, 20, 20)
LEVEL = {"levels/mesh.xml": '<level><room type="mesh/room" length="100"/></level>',
         "rooms/mesh/room.lua": 'function init() mgSegment("mesh/wall", 0) mgLength(64) end',
         "segments/mesh/wall.xml": '<segment size="12 10 16"><box pos="0 1 -9" size="4 4 1" color=".5 .5 .5"/></segment>'}


def brittle(*arguments):
    return subprocess.run([str(PROGRAM), *map(str, arguments)], capture_output=True, text=True, timeout=120, cwd=ROOT)


def front_of_the_wall(color, corners=((-4, -3), (4, -3), (4, 5), (-4, 5)), last=3):
    """The bytes of a mesh that is the wall's front alone."""
    half = bytes([*(value // 2 for value in color), 255])
    vertices = b"".join(struct.pack("<5f", x, y, -8, 0.01, 0.01) + half for x, y in corners)
    return zlib.compress(struct.pack("<I", len(corners)) + vertices + struct.pack("<7I", 2, 0, 1, 2, 0, 2, last))


def middle(picture):
    """The colour in the middle of a picture of 64 x 36."""
    pixels = subprocess.run(["ffmpeg", "-v", "error", "-i", str(picture), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                            capture_output=True, check=True).stdout
    at = 3 * (64 * 18 + 32)
    return tuple(pixels[at:at + 3])


class BakedMesh(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        for name, text in LEVEL.items():
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(text)
        (self.folder / "game.lua").write_text('level("mesh") seed(1)\nrun(5)\nexpect_problems(0)\n')
        self.replay = self.folder / "game.brt"
        result = brittle("smoke", self.folder / "game.lua", "--assets", self.folder, "--record", self.replay)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def picture(self, says=""):
        result = brittle("render", self.replay, "--assets", self.folder, "--out", self.folder / "out", "--frames", "5",
                         "--size", "64x36", "--backend", "osmesa")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual("".join(line for line in result.stderr.splitlines() if not line.endswith("%")), says)
        return middle(self.folder / "out/frame_000005.png")

    def carry(self, mesh, name="wall.mesh"):
        (self.folder / "segments/mesh" / name).write_bytes(mesh)

    def expect_color(self, seen, wanted):
        """Fog and light are on it: as red, or as grey, as that."""
        self.assertEqual(seen[0] > seen[1] + 60, wanted == RED, seen)
        self.assertLess(abs(seen[1] - seen[2]), 40, seen)

    def test_a_mesh_is_seen_in_place_of_the_boxes_however_it_is_wound(self):
        self.expect_color(self.picture(), GREY)
        self.carry(front_of_the_wall(RED))
        self.expect_color(self.picture(), RED)
        self.carry(front_of_the_wall(RED, corners=((-4, -3), (-4, 5), (4, 5), (4, -3))))
        self.expect_color(self.picture(), RED)

    def test_it_is_found_under_the_name_that_assets_are_stored_under(self):
        self.carry(front_of_the_wall(RED), "wall.mesh.mp3")
        self.expect_color(self.picture(), RED)

    def test_a_fault_is_one_line_of_play_and_of_check_and_the_boxes_are_seen(self):
        self.carry(front_of_the_wall(RED, last=4))
        says = "segments/mesh/wall.mesh: baked mesh: index 5, got '4', expected a vertex, of which there are 4"
        self.expect_color(self.picture("warning: content: " + says), GREY)
        result = brittle("check", self.folder)
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"{self.folder}/{says}\n", result.stdout)

    def test_a_recorded_game_plays_the_same_with_and_without_it(self):
        self.carry(front_of_the_wall(RED))
        result = brittle("verify", self.replay, "--assets", self.folder)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
