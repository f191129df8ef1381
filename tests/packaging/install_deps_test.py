"""Does install-deps.sh ask apt for what is missing, and only then? Run against pretended dpkg-query and apt tools."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "packaging" / "install-deps.sh"

DPKG_QUERY = '#!/bin/sh\nfor name; do :; done\ngrep -qx "$name" "$STATE/installed" && printf "%s" installed || exit 1\n'
APT_CACHE = ('#!/bin/sh\n[ -e "$STATE/updated" ] || exit 0\n'
             'if grep -qx "$2" "$STATE/archive"; then echo "$2:"; echo "  Candidate: 1.0"\n'
             'else echo "$2:"; echo "  Candidate: (none)"; fi\n')
APT_GET = ('#!/bin/sh\necho "$@" >>"$STATE/calls"\nfor word; do\n'
           '  [ "$word" != update ] || touch "$STATE/updated"\n'
           '  ! grep -qx -e "$word" "$STATE/archive" || echo "$word" >>"$STATE/installed"\ndone\n')
IDENTITY = '#!/bin/sh\necho "$PRETENDED_UID"\n'


class InstallDeps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.state = Path(folder.name)
        self.tools = self.state / "bin"
        self.tools.mkdir()
        for name, text in [("dpkg-query", DPKG_QUERY), ("apt-cache", APT_CACHE), ("apt-get", APT_GET), ("id", IDENTITY)]:
            (self.tools / name).write_text(text, encoding="utf-8")
            (self.tools / name).chmod(0o755)
        for tool in ["sh", "env", "grep", "sed", "cut", "tr", "touch", "cat"]:
            real = next(p for p in (Path(d) / tool for d in ["/usr/bin", "/bin"]) if p.exists())
            (self.tools / tool).symlink_to(real)
        self.write("installed", [])
        # A system with the older name of the SVG package and without LLVM 14.
        self.all = sorted({name.rstrip("?") for entry in self.entries() for name in entry.split("|")}
                          - {"clang-format-14", "clang-tidy-14", "qt6-svg-dev"})
        self.write("archive", self.all)

    def write(self, name, lines):
        (self.state / name).write_text("".join(line + "\n" for line in lines), encoding="utf-8")

    def calls(self):
        path = self.state / "calls"
        return path.read_text(encoding="utf-8").splitlines() if path.exists() else []

    @staticmethod
    def entries():
        words = SCRIPT.read_text(encoding="utf-8")
        lists = [words.split(f'{name}="')[1].split('"')[0] for name in ("run_packages", "test_packages", "package_packages")]
        return " ".join(lists).split()

    def run_script(self, *arguments, uid="0"):
        environment = {"PATH": str(self.tools), "STATE": str(self.state), "PRETENDED_UID": uid}
        return subprocess.run(["/bin/sh", str(SCRIPT), *arguments], env=environment, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, check=False)

    def test_fresh_system_then_nothing_the_second_time(self):
        first = self.run_script()
        self.assertEqual(first.returncode, 0, first.stderr)
        update, install = self.calls()
        self.assertIn("update", update.split())
        self.assertIn("--no-install-recommends", install.split())
        self.assertIn("libqt6svg6-dev", install.split())
        self.assertNotIn("qt6-svg-dev", install.split())
        self.assertNotIn("clang-format-14", install.split())
        os.remove(self.state / "calls")

        second = self.run_script()
        self.assertEqual((second.returncode, second.stdout, self.calls()), (0, "", []))

    def test_only_the_missing_one_is_installed(self):
        self.write("installed", [name for name in self.all if name != "cmake"])
        self.assertEqual(self.run_script().returncode, 0)
        install = self.calls()[-1].split()
        self.assertEqual(install[install.index("--no-install-recommends") + 1:], ["cmake"])

    def test_running_needs_no_test_packages(self):
        self.assertEqual(self.run_script("run").returncode, 0)
        install = self.calls()[-1].split()
        self.assertIn("libvtk9-dev", install)
        self.assertNotIn("libgtest-dev", install)
        self.assertNotIn("lintian", install)

    def test_making_the_package_needs_its_tools_and_no_test_packages(self):
        self.assertEqual(self.run_script("package").returncode, 0)
        install = self.calls()[-1].split()
        self.assertIn("libvtk9-dev", install)
        self.assertIn("dpkg-dev", install)
        self.assertNotIn("libgtest-dev", install)

    def test_package_that_the_system_does_not_have_is_named(self):
        self.write("archive", [name for name in self.all if name != "libvtk9-dev"])
        done = self.run_script()
        self.assertEqual(done.returncode, 1)
        self.assertIn("libvtk9-dev", done.stderr)
        self.assertEqual(len(self.calls()), 1, "nothing is installed")

    def test_without_root_and_sudo_it_says_what_to_install(self):
        done = self.run_script(uid="1000")
        self.assertEqual(done.returncode, 1)
        self.assertIn("libvtk9-dev", done.stderr)
        self.assertEqual(self.calls(), [])

    def test_unknown_argument(self):
        self.assertEqual(self.run_script("--everything").returncode, 2)


if __name__ == "__main__":
    unittest.main()
