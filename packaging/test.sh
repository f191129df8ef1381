#!/bin/sh
# Installs what is missing, builds the ci preset, and runs the include check, the format check and every test.
# Where clang is installed, each fuzzer searches for 20 s too. Fails if any of them fails.
set -eu
cd "$(dirname "$0")/.."

sh packaging/install-deps.sh
sh packaging/build.sh ci

failed=
python3 packaging/check_includes.py || failed="$failed include-check"
sh packaging/check_format.sh || failed="$failed format-check"
[ -z "$failed" ] || echo "FAILED before the tests:$failed"

ctest --preset ci -j 2 || failed="$failed ctest"
# Against real time: where another program on this machine held one up, it is tried once more, and said so.
ctest --preset ci-device -j 2 || failed="$failed ctest-device"
if echo 'int main() {}' | clang++ -fsanitize=fuzzer-no-link,address -x c++ - -o /dev/null 2>/dev/null; then
    sh packaging/build.sh fuzz
    ctest --preset fuzz || failed="$failed fuzz"
else
    echo "fuzz: skipped, clang++ with sanitizers is not installed" >&2
fi
if [ -n "$failed" ]; then
    echo "FAILED:$failed" >&2
    exit 1
fi
