#!/bin/sh
# Checks that every C++ file is as clang-format 14 writes it; --fix rewrites them. Other versions format differently, so
# where version 14 is missing (Debian 13) the check says so and is skipped.
set -eu
cd "$(dirname "$0")/.."

formatter=
for candidate in clang-format-14 clang-format; do
    if command -v $candidate >/dev/null 2>&1 && $candidate --version | grep -q 'version 14\.'; then
        formatter=$candidate
        break
    fi
done
if [ -z "$formatter" ]; then
    echo "format check: skipped, clang-format 14 is not installed" >&2
    exit 0
fi

mode="--dry-run --Werror"
[ "${1:-}" != --fix ] || mode=-i
folders=
for folder in app benchmarks engine tests widgets; do
    [ ! -d $folder ] || folders="$folders $folder"
done
# Words of $folders and $mode are meant to split.
if ! find $folders -name '*.h' -o -name '*.cpp' | sort | xargs $formatter $mode; then
    echo "format check: run 'sh packaging/check_format.sh --fix'" >&2
    exit 1
fi
echo "format check: $(find $folders -name '*.h' -o -name '*.cpp' | wc -l) files" >&2
