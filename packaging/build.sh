#!/bin/sh
# Configures (when needed) and builds one preset of CMakePresets.json, or targets of it:
#   sh packaging/build.sh release
#   sh packaging/build.sh asan --target engine_tests
# The configuration's output goes to build/<preset>-configure.log and is shown when it fails.
set -eu
cd "$(dirname "$0")/.."

preset=${1:?usage: sh packaging/build.sh PRESET [OPTION OF cmake --build...]}
shift
ninja_file=build/$preset/build.ninja
log=build/$preset-configure.log

# Ninja runs CMake again by itself when a CMakeLists.txt changes, but does not know of the presets.
if [ ! -e "$ninja_file" ] || [ CMakePresets.json -nt "$ninja_file" ]; then
    mkdir -p build
    echo "Configuring preset $preset (log: $log)"
    if ! cmake --preset "$preset" >"$log" 2>&1; then
        tail -n 40 "$log" >&2
        echo "Configuration failed." >&2
        exit 1
    fi
fi
echo "Building preset $preset"
cmake --build --preset "$preset" "$@"
