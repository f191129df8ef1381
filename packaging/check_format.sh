#!/bin/sh
# Checks that every C++ file is as clang-format 14 writes it; --fix rewrites them. Where that version is missing it fails, or
# says "not checked: format" on a system that has no package of it.
set -eu
cd "$(dirname "$0")/.."

. packaging/llvm14.sh
find_llvm14 clang-format format

mode="--dry-run --Werror"
[ "${1:-}" != --fix ] || mode=-i
folders=
for folder in app benchmarks engine tests widgets; do
    [ ! -d $folder ] || folders="$folders $folder"
done
# Words of $folders and $mode are meant to split.
if ! find $folders -name '*.h' -o -name '*.cpp' | sort | xargs "$found" $mode; then
    echo "format check: run 'sh packaging/check_format.sh --fix'" >&2
    exit 1
fi
echo "format check: $(find $folders -name '*.h' -o -name '*.cpp' | wc -l) files" >&2
