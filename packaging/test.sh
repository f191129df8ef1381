#!/bin/sh
# Installs what is missing, builds the ci preset, and runs every check and test. What could not be looked at here is named at the end.
# Where clang is installed, each fuzzer searches for 20 s too. Fails if any of them fails.
set -eu
cd "$(dirname "$0")/.."

sh packaging/install-deps.sh
sh packaging/build.sh ci

failed=
not_checked=
# check NAME COMMAND...: what it could not look at here is said again at the end.
check() {
    name=$1
    shift
    "$@" >"build/$name.log" 2>&1 || failed="$failed $name"
    cat "build/$name.log" >&2
    not_checked="$not_checked$(grep '^not checked: ' "build/$name.log" || true)"
}
check include-check python3 packaging/check_includes.py
check format-check sh packaging/check_format.sh
check documentation-check sh packaging/check_docs.sh
check clang-tidy python3 packaging/check_tidy.py
[ -z "$failed" ] || echo "FAILED before the tests:$failed"

ctest --preset ci -j 2 || failed="$failed ctest"
# Against real time, four at a time since they mostly wait. A test that fails while this machine holds even a sleeping
# thread up is tried once more; one that is held up again proves nothing either way: it is skipped, and named below.
ctest --preset ci-device || failed="$failed ctest-device"
not_judged=$(grep '^not judged: ' build/ci/Testing/Temporary/LastTest.log || true)
if echo 'int main() {}' | clang++ -fsanitize=fuzzer-no-link,address -x c++ - -o /dev/null 2>/dev/null; then
    sh packaging/build.sh fuzz
    ctest --preset fuzz || failed="$failed fuzz"
else
    echo "fuzz: skipped, clang++ with sanitizers is not installed" >&2
fi
[ -z "$not_checked" ] || echo "$not_checked"
if [ -n "$not_judged" ]; then
    echo "Tests against real time, on a machine that did not give it:"
    echo "$not_judged"
fi
if [ -n "$failed" ]; then
    echo "FAILED:$failed" >&2
    exit 1
fi
