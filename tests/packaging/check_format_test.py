"""Does the format check fail where its tool is missing, and pass without it only where the system has no package of it?"""

import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

PACKAGING = Path(__file__).resolve().parents[2] / "packaging"

# Refuses what says "ugly", as the real one does what it would write otherwise.
FORMATTER = ('#!/bin/sh\nif [ "$1" = --version ]; then echo "clang-format version %s"; exit 0; fi\n'
             'if [ "$1" = -i ]; then shift; sed -i s/ugly/fine/ "$@"; else shift 2; ! grep ugly "$@" >&2; fi\n')
APT_CACHE = '#!/bin/sh\necho "$2:"\nif [ "$2" = g++ ] || [ "$2" = "%s" ]; then echo "  Candidate: 1.0"; else echo "  Candidate: (none)"; fi\n'


class CheckFormat(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "packaging").mkdir()
        for name in ["check_format.sh", "llvm14.sh"]:
            shutil.copy(PACKAGING / name, self.root / "packaging")
        self.file = self.root / "engine" / "a.cpp"
        self.file.parent.mkdir()
        self.file.write_text("fine\n", encoding="utf-8")
        self.tools = self.root / "bin"
        self.tools.mkdir()
        for tool in ["sh", "grep", "sed", "find", "sort", "xargs", "wc", "dirname"]:
            (self.tools / tool).symlink_to(shutil.which(tool))

    def tool(self, name, text):
        (self.tools / name).write_text(text, encoding="utf-8")
        (self.tools / name).chmod(0o755)

    def run_script(self, *arguments):
        return subprocess.run(["/bin/sh", str(self.root / "packaging" / "check_format.sh"), *arguments],
                              env={"PATH": str(self.tools)}, capture_output=True, text=True, check=False)

    def test_files_as_it_writes_them_pass(self):
        self.tool("clang-format-14", FORMATTER % "14.0.6")
        done = self.run_script()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 files", done.stderr)

    def test_another_format_fails_until_it_is_mended(self):
        self.tool("clang-format-14", FORMATTER % "14.0.6")
        self.file.write_text("ugly\n", encoding="utf-8")
        self.assertEqual(self.run_script().returncode, 1)
        self.assertEqual(self.run_script("--fix").returncode, 0)
        self.assertEqual(self.file.read_text(encoding="utf-8"), "fine\n")
        self.assertEqual(self.run_script().returncode, 0)

    def test_missing_tool_fails_where_it_could_be_installed(self):
        self.tool("apt-cache", APT_CACHE % "clang-format-14")
        done = self.run_script()
        self.assertEqual(done.returncode, 1)
        self.assertIn("not installed", done.stderr)

    def test_another_version_is_a_missing_tool(self):
        self.tool("apt-cache", APT_CACHE % "clang-format-14")
        self.tool("clang-format", FORMATTER % "19.1.7")
        self.assertEqual(self.run_script().returncode, 1)

    def test_system_without_the_package_is_told_that_nothing_was_checked(self):
        self.tool("apt-cache", APT_CACHE % "clang-format-19")
        self.tool("clang-format", FORMATTER % "19.1.7")
        done = self.run_script()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("not checked: format, "), done.stdout)

    def test_missing_tool_fails_where_nobody_knows_the_packages(self):
        self.assertEqual(self.run_script().returncode, 1)


if __name__ == "__main__":
    unittest.main()
