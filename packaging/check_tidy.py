#!/usr/bin/env python3
"""Runs clang-tidy 14 on the lines of C++ files that changed since a commit; every finding is an error.

    python3 packaging/check_tidy.py [COMMIT]

COMMIT is where the work left origin/main, or else the commit before the last; what is not committed yet counts as changed.
Only .cpp files are read, and changed lines of headers as far as these include them, at most MAX_FILES of them, those with
the most changed lines first: each takes ten seconds, since Qt's, VTK's and Eigen's headers are read for it. What is left
out is told in a line "not checked: ...". The checks are in .clang-tidy.
"""

import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

MAX_FILES = 25
FINDING = re.compile(r"^(?=\S[^\n]*: (?:error|warning): )", re.MULTILINE)  # where one begins
FIND_TIDY = '. packaging/llvm14.sh; find_llvm14 clang-tidy clang-tidy; echo "$found"'


def git(*arguments):
    """What git prints, or nothing where there is no git, no repository or no such commit."""
    try:
        done = subprocess.run(["git", *arguments], capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return ""
    return done.stdout if done.returncode == 0 else ""


def base_commit():
    head = git("rev-parse", "HEAD").strip()
    left = git("merge-base", "origin/main", "HEAD").strip()
    return left if left and left != head else git("rev-parse", "--verify", "--quiet", "HEAD~1").strip()


def changed_lines(base):
    """{file: [[first, last], ...]} of C++ files; an empty list means the whole file."""
    lines, name = {}, None
    diff = git("diff", "--unified=0", "--no-color", "--no-ext-diff", "--no-prefix", "--diff-filter=d", base, "--", "*.cpp", "*.h")
    for line in diff.splitlines():
        if line.startswith("+++ "):
            name = line[4:].rstrip("\t")
        elif hunk := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line):
            first, count = int(hunk[1]), int(hunk[2] or 1)
            if count > 0:
                lines.setdefault(name, []).append([first, first + count - 1])
    for name in git("ls-files", "--others", "--exclude-standard", "--", "*.cpp", "*.h").splitlines():
        lines[name] = []
    return lines


def size(name, ranges):
    return sum(last - first + 1 for first, last in ranges) or len(Path(name).read_bytes().splitlines())


def compiled_files():
    """Those of which the build knows the command."""
    done = subprocess.run(["cmake", "--preset", "tidy"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"clang-tidy: cmake --preset tidy failed:\n{done.stdout}{done.stderr}")
    # Headers that the build makes. Without them clang-tidy says what is missing.
    subprocess.run(["cmake", "--build", "build/tidy", "--target", "message_names"], capture_output=True, check=False)
    root = Path.cwd().resolve()
    commands = json.loads(Path("build/tidy/compile_commands.json").read_text(encoding="utf-8"))
    files = [(Path(entry["directory"]) / entry["file"]).resolve() for entry in commands]
    return {str(file.relative_to(root)) for file in files if file.is_relative_to(root)}


def is_of_change(finding, lines):
    place = re.match(r"(.+?):(\d+):\d+: ", finding)
    if not place or "[clang-diagnostic-error" in finding:
        return bool(re.match(r".*: error: ", finding))
    name, line = os.path.relpath(os.path.realpath(place[1])), int(place[2])  # include roots are links
    return name in lines and (not lines[name] or any(first <= line <= last for first, last in lines[name]))


def main():
    os.chdir(Path(__file__).resolve().parents[1])
    found = subprocess.run(["sh", "-c", FIND_TIDY], capture_output=True, text=True, check=False)
    sys.stderr.write(found.stderr)
    tidy = found.stdout.strip()
    if found.returncode != 0 or tidy.startswith("not checked: "):
        print(tidy, end="\n" if tidy else "")
        return found.returncode
    base = sys.argv[1] if len(sys.argv) > 1 else base_commit()
    if not base or not git("rev-parse", "--verify", "--quiet", f"{base}^{{commit}}"):
        if len(sys.argv) > 1:
            sys.exit(f"clang-tidy: there is no commit {base}")
        print("not checked: clang-tidy, since there is no earlier commit to compare with")
        return 0

    lines = changed_lines(base)
    changed = [name for name in lines if name.endswith(".cpp")]
    compiled = compiled_files() if changed else set()
    files = sorted((name for name in changed if name in compiled), key=lambda name: -size(name, lines[name]))
    if left := len(changed) - len(files):
        print(f"not checked: clang-tidy of {left} changed files that this system's build does not compile")
    if (left := len(files) - MAX_FILES) > 0:
        print(f"not checked: clang-tidy of {left} changed files beyond the {MAX_FILES} with the most changed lines")
    files = files[:MAX_FILES]

    def findings(name):
        """What it says of changed lines, or that it could not read the file."""
        done = subprocess.run([tidy, "--quiet", "-p", "build/tidy", "--warnings-as-errors=*", name], capture_output=True,
                              text=True, check=False)
        if done.returncode != 0 and not FINDING.search(done.stdout):
            return done.stdout + done.stderr
        return "".join(text for text in re.split(FINDING, done.stdout) if is_of_change(text, lines))

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        bad = [text for text in pool.map(findings, files) if text]
    for text in bad:
        print(text)
    print(f"clang-tidy: {len(files)} changed files since {base[:12]}, findings in {len(bad)}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
