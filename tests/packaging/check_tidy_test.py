"""Does the clang-tidy check look at what changed, fail for what it finds there and tell what it leaves out? Run in a small
repository, against pretended clang-tidy and cmake."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

PACKAGING = Path(__file__).resolve().parents[2] / "packaging"

# It finds each line that says "bad", and follows includes.
TIDY = r'''#!/bin/sh
if [ "$1" = --version ]; then echo "  LLVM version 14.0.6"; exit 0; fi
for file; do :; done
echo "$file" >>"$STATE/read"
bad=0
for part in "$file" $(sed -n 's/#include "\(.*\)"/\1/p' "$file"); do
    for line in $(grep -n bad "$part" | cut -d: -f1); do
        bad=1
        echo "$PWD/$part:$line:1: error: this is bad [pretended,-warnings-as-errors]"
        echo "    bad"
    done
done
exit $bad
'''
CMAKE = '#!/bin/sh\nmkdir -p build/tidy\ncp "$STATE/commands" build/tidy/compile_commands.json\n'
APT_CACHE = '#!/bin/sh\necho "$2:"\n[ "$2" = g++ ] && echo "  Candidate: 1.0" || echo "  Candidate: (none)"\n'


class CheckTidy(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.state = Path(folder.name).resolve()
        self.root = self.state / "project"
        (self.root / "packaging").mkdir(parents=True)
        for name in ["check_tidy.py", "llvm14.sh"]:
            shutil.copy(PACKAGING / name, self.root / "packaging")
        self.tools = self.state / "bin"
        self.tools.mkdir()
        for tool in ["sh", "cat", "cp", "cut", "grep", "mkdir", "sed", "git", "python3"]:
            (self.tools / tool).symlink_to(shutil.which(tool))
        self.tool("clang-tidy-14", TIDY)
        self.tool("cmake", CMAKE)
        self.environment = {"PATH": str(self.tools), "STATE": str(self.state), "HOME": str(self.state), "LC_ALL": "C.UTF-8",
                            **{f"GIT_{who}_{what}": "a@b.example" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}}
        self.write(".gitignore", "/build/\n")
        self.git("init", "--quiet", "--initial-branch=main")
        self.compiled = []

    def tool(self, name, text):
        (self.tools / name).write_text(text, encoding="utf-8")
        (self.tools / name).chmod(0o755)

    def git(self, *arguments):
        subprocess.run(["git", *arguments], cwd=self.root, env=self.environment, check=True, capture_output=True)

    def write(self, name, text):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text, encoding="utf-8")

    def commit(self, **files):
        for name, text in files.items():
            self.write(name + ".cpp", text)
            self.compiled.append(name + ".cpp")
        self.git("add", ".")
        self.git("commit", "--quiet", "--allow-empty", "--message", "x")

    def check(self, *arguments):
        commands = [{"directory": str(self.root), "file": name, "command": ""} for name in self.compiled]
        (self.state / "commands").write_text(json.dumps(commands), encoding="utf-8")
        done = subprocess.run(["python3", "-B", "packaging/check_tidy.py", *arguments], cwd=self.root, env=self.environment,
                              capture_output=True, text=True, check=False)
        read = self.state / "read"
        self.read = sorted(read.read_text(encoding="utf-8").split()) if read.exists() else []
        return done

    def test_changed_lines_are_held_clean_and_others_left_alone(self):
        self.commit(a="good\nbad\n", b="bad\n")
        self.commit(a="good\nbad\ngood\n")
        done = self.check()
        self.assertEqual((done.returncode, self.read), (0, ["a.cpp"]), done.stdout + done.stderr)

        self.commit(a="good\nbad\ngood\nbad\n")
        done = self.check()
        self.assertEqual(done.returncode, 1)
        self.assertIn("a.cpp:4:1: error", done.stdout)
        self.assertNotIn("a.cpp:2:1", done.stdout)

    def test_what_is_not_committed_counts(self):
        self.commit(a="good\n")
        self.commit()
        self.write("a.cpp", "bad\n")
        self.assertEqual(self.check().returncode, 1)
        self.write("a.cpp", "good\n")
        self.assertEqual(self.check().returncode, 0)
        self.write("new.cpp", "bad\n")
        self.compiled.append("new.cpp")
        self.assertEqual(self.check().returncode, 1)

    def test_changed_headers_are_seen_where_a_changed_file_includes_them(self):
        self.write("a.h", "good\n")
        self.commit(a='#include "a.h"\n')
        self.write("a.h", "good\nbad\n")
        self.commit(a='#include "a.h"\ngood\n')
        done = self.check()
        self.assertEqual(done.returncode, 1)
        self.assertIn("a.h:2:1: error", done.stdout)

    def test_work_is_compared_with_where_it_left_origin(self):
        self.commit(a="good\n", b="good\n")
        self.git("update-ref", "refs/remotes/origin/main", "HEAD")
        self.commit(a="bad\n")
        self.commit(b="good\ngood\n")
        self.assertEqual((self.check().returncode, self.read), (1, ["a.cpp", "b.cpp"]))
        self.assertEqual(self.check("HEAD~1").returncode, 0)
        self.assertEqual(self.check("no-such-commit").returncode, 1)

    def test_a_file_that_cannot_be_read_fails(self):
        self.tool("clang-tidy-14", '#!/bin/sh\n[ "$1" != --version ] || exec echo "version 14.0.6"\n'
                  'echo "/usr/include/x.h:1:1: error: no such file [clang-diagnostic-error]"; exit 1\n')
        self.commit(a="good\n")
        self.commit(a="good\ngood\n")
        self.assertEqual(self.check().returncode, 1)

    def test_what_is_left_out_is_told(self):
        self.commit(other="good\n")
        self.compiled.remove("other.cpp")
        self.commit(other="bad\n", **{f"a{i}": "bad\n" if i == 7 else "good\n" * (i + 2) for i in range(42)})
        self.compiled.remove("other.cpp")
        done = self.check()
        self.assertEqual((done.returncode, len(self.read)), (0, 25), done.stdout + done.stderr)
        self.assertIn("not checked: clang-tidy of 17 changed files beyond the 25", done.stdout)
        self.assertIn("not checked: clang-tidy of 1 changed files that", done.stdout)

    def test_without_an_earlier_commit_it_says_so(self):
        self.commit(a="bad\n")
        done = self.check()
        self.assertEqual(done.returncode, 0)
        self.assertTrue(done.stdout.startswith("not checked: clang-tidy, "), done.stdout)

    def test_missing_tool_fails_where_the_system_could_have_it(self):
        os.remove(self.tools / "clang-tidy-14")
        self.commit(a="good\n")
        self.commit(a="good\ngood\n")
        self.assertEqual(self.check().returncode, 1)
        self.tool("apt-cache", APT_CACHE)
        done = self.check()
        self.assertEqual(done.returncode, 0)
        self.assertTrue(done.stdout.startswith("not checked: clang-tidy, "), done.stdout)


if __name__ == "__main__":
    unittest.main()
