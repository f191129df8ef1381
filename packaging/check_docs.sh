#!/bin/sh
# Checks that Doxygen reads the comments of the engine's headers without a warning, and writes them as pages:
# build/doxygen/html/index.html.
set -eu
cd "$(dirname "$0")/.."

if ! command -v doxygen >/dev/null 2>&1; then
    echo "documentation check: doxygen is not installed: sh packaging/install-deps.sh" >&2
    exit 1
fi
rm -rf build/doxygen
names=build/names/engine/base # headers that the build makes
mkdir -p "$names"
cmake "-DTABLES=engine/base/message_table.inc;engine/base/alarm_table.inc" "-DCODES=$names/message_names.inc" \
    "-DCONDITIONS=$names/condition_names.inc" -P engine/base/message_names.cmake
if ! doxygen packaging/Doxyfile; then
    echo "documentation check: doxygen $(doxygen --version) has warnings; packaging/Doxyfile says which count" >&2
    exit 1
fi
echo "documentation check: $(find engine -name '*.h' | wc -l) headers" >&2
