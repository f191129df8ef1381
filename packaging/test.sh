#!/bin/sh
# Installs what is missing, builds the ci preset, and runs the include check, the format check and every test.
# Fails if any of them fails. ctest's closing lines are the last ones.
set -eu
cd "$(dirname "$0")/.."

sh packaging/install-deps.sh
sh packaging/build.sh ci

failed=
python3 packaging/check_includes.py || failed="$failed include-check"
sh packaging/check_format.sh || failed="$failed format-check"
[ -z "$failed" ] || echo "FAILED before the tests:$failed"

ctest --preset ci -j 2 || failed="$failed ctest"
if [ -n "$failed" ]; then
    echo "FAILED:$failed" >&2
    exit 1
fi
