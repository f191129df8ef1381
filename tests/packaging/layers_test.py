"""Does an include that ARCHITECTURE.md does not allow fail to compile, and does the table say what CMake links?

Takes a build directory with a compile_commands.json.
"""

import json
import re
import shlex
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(sys.argv.pop(1)) if len(sys.argv) > 1 else ROOT / "build" / "ci"


def commands():
    return json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))


def compiles(folder, header):
    """Whether a source of this folder could include the header: by the include roots of its target."""
    entry = next(e for e in commands() if f"/{folder}/CMakeFiles/bask_" in e["command"] and "_autogen" not in e["file"])
    flags = [word for word in shlex.split(entry["command"])
             if word.startswith(("-I", "-std", "-isystem", "/usr/include", "/usr/lib")) and word != "-include"]
    words = [shlex.split(entry["command"])[0]] if "ccache" not in entry["command"] else ["c++"]
    done = subprocess.run(words + flags + ["-fsyntax-only", "-x", "c++", "-"], input=f'#include "{header}"\n',
                          capture_output=True, text=True, check=False, cwd=entry["directory"])
    return done.returncode == 0


def links():
    """Folder -> folders that its library links for its headers or its sources, by CMake's own lines."""
    names, out = {}, {}
    for file in list((ROOT / "engine").glob("*/CMakeLists.txt")) + list((ROOT / "widgets").glob("*/CMakeLists.txt")):
        match = re.search(r"bask_library\((\w+)(.*?)\)", file.read_text(encoding="utf-8"), re.DOTALL)
        if match:
            names[match.group(1)] = file.parent.relative_to(ROOT).as_posix()
            out[file.parent.relative_to(ROOT).as_posix()] = match.group(2)
    return {folder: {names[word] for word in re.findall(r"bask_\w+", text) if word in names} - {folder}
            for folder, text in out.items()}


def table():
    rows = {}
    for line in (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8").splitlines():
        match = re.match(r"\| `((?:engine|widgets)/\w+)` \| ([^|]*) \|", line)
        if match:
            rows[match.group(1)] = match.group(2)
    return rows


class Layers(unittest.TestCase):
    def test_headers_of_what_is_not_linked_are_not_found(self):
        for folder, header in [("engine/shape", "engine/model/experiment.h"),
                               ("engine/control", "engine/recording/session_file.h"),
                               ("engine/drivers", "engine/simulation/simulated_rig.h"),
                               ("engine/rig", "engine/runtime/servo_loop.h"),
                               ("widgets/common", "engine/runtime/engine_worker.h"),
                               ("widgets/run", "engine/runtime/servo_loop.h"),
                               ("widgets/rig", "engine/drivers/grbl_robot.h"),
                               ("widgets/review", "widgets/run/run_page.h"),
                               ("widgets/run", "app/document.h")]:
            with self.subTest(folder=folder, header=header):
                self.assertFalse(compiles(folder, header))

    def test_headers_of_what_is_linked_are_found(self):
        for folder, header in [("engine/model", "engine/control/robot_limits.h"),
                               ("widgets/run", "engine/runtime/snapshot.h"),
                               ("widgets/rig", "engine/drivers/driver_catalogue.h"),
                               ("widgets/run", "widgets/plots/trace_plot.h")]:
            with self.subTest(folder=folder, header=header):
                self.assertTrue(compiles(folder, header))

    def test_the_table_names_each_folder_with_what_it_links(self):
        rows = table()
        for folder, linked in links().items():
            with self.subTest(folder=folder):
                self.assertIn(folder, rows)
                self.assertEqual({f"{folder.split('/')[0]}/{w}" if "/" not in w else w
                                  for w in re.findall(r"[\w/]+", rows[folder]) if w != "nothing"}, linked)


if __name__ == "__main__":
    unittest.main()
