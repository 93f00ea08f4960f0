#!/usr/bin/env python3
"""The rules bite: a small house with one fault at a time, and the line that must come out."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from check_house import check_tree, find_cycle  # noqa: E402


def problems_of(files):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return "\n".join(check_tree(root))


def header(text=""):
    return "#pragma once\n" + text


class Rules(unittest.TestCase):
    def test_a_house_in_order_has_no_problem(self):
        self.assertEqual(problems_of({"engine/core/a.h": header(), "engine/math/b.h": header('#include "engine/core/a.h"\n')}), "")

    def test_an_arrow_the_wrong_way_is_named(self):
        text = problems_of({"engine/render/a.h": header('#include "engine/physics/b.h"\n'), "engine/physics/b.h": header()})
        self.assertIn("engine/render/a.h:2: engine/render includes engine/physics", text)

    def test_a_path_not_from_the_root_is_named(self):
        self.assertIn("expected a path from the root", problems_of({"engine/core/a.h": header('#include "b.h"\n')}))

    def test_a_cycle_is_shown(self):
        text = problems_of({"engine/core/a.h": header('#include "engine/core/b.h"\n'), "engine/core/b.h": header('#include "engine/core/a.h"\n')})
        self.assertIn("include cycle: engine/core/a.h -> engine/core/b.h -> engine/core/a.h", text)
        self.assertIsNone(find_cycle({"a": ["b", "c"], "b": ["c"], "c": []}))

    def test_size_words_and_doors(self):
        self.assertIn("601 lines", problems_of({"engine/core/a.cpp": "\n" * 601}))
        self.assertIn("unfinished", problems_of({"tools/a.py": "# TO" + "DO later\n"}))
        self.assertIn("includes Eigen", problems_of({"engine/geometry/a.cpp": "#include <Eigen/Core>\n"}))
        self.assertIn("SDL stays", problems_of({"engine/runtime/a.cpp": "SDL_Event event;\n"}))
        self.assertIn("libm differs", problems_of({"engine/physics/a.cpp": "float x = std::sin(1.0f);\n"}))
        self.assertIn("order or its values", problems_of({"game/sim/a.cpp": "std::unordered_map<int, int> m;\n"}))
        self.assertIn("without #pragma once", problems_of({"engine/core/a.h": "\n"}))
        self.assertIn("notes: at the top level", problems_of({"notes": "x"}))


if __name__ == "__main__":
    unittest.main()
