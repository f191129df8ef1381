#!/bin/sh
# Builds and runs tests of the engine under sanitizers, and fails for what these find:
#   address and undefined behaviour (preset asan)    the unit and runtime tests, without those of commands
#   threads (preset tsan)                            tests of threads without Qt, whose locks it does not see
#   sh packaging/test-sanitizers.sh asan|tsan        one of the two
set -eu
cd "$(dirname "$0")/.."

sh packaging/install-deps.sh
# OpenCV and GDAL are not built for it: what they do among themselves is theirs.
export TSAN_OPTIONS="ignore_noninstrumented_modules=1 ${TSAN_OPTIONS:-}"
failed=
for preset in ${1:-asan tsan}; do
    case $preset in
    asan) targets=engine_tests ;;
    tsan) targets=thread_tests ;;
    *) echo "test-sanitizers.sh: unknown preset '$preset'" >&2; exit 2 ;;
    esac
    start=$(date +%s)
    sh packaging/build.sh "$preset" --target "$targets"
    built=$(date +%s)
    # GCC 12's thread sanitizer stops at addresses as random as newer kernels make them; some containers do not let that be changed.
    run=
    if [ "$preset" = tsan ] && setarch --addr-no-randomize true 2>/dev/null; then run="setarch --addr-no-randomize"; fi
    # Words of $run are meant to split.
    $run ctest --test-dir "build/$preset" -L "^$targets\$" -j 2 --no-tests=error --output-on-failure || failed="$failed $preset"
    echo "$preset: built in $((built - start)) s, run in $(($(date +%s) - built)) s"
done
if [ -n "$failed" ]; then
    echo "FAILED:$failed" >&2
    exit 1
fi
