#!/bin/sh
# Installs what is missing, builds the release preset and opens Bask on its simulated rig.
# Without a display it runs the three-object example headless instead; its outcome is this script's exit code.
# Arguments go to bask: sh packaging/run.sh run resources/examples/two-circles.json
set -eu
cd "$(dirname "$0")/.."

sh packaging/install-deps.sh run
sh packaging/build.sh release

bask=build/release/app/bask
if [ $# -gt 0 ]; then
    exec "$bask" "$@"
fi
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    exec "$bask"
fi

example=resources/examples/three-objects.json
echo "No display here (neither DISPLAY nor WAYLAND_DISPLAY is set): no window."
echo "Running headless: $bask run $example"
status=0
"$bask" run "$example" || status=$?
case $status in
0) echo "Outcome: every object settled." ;;
1) echo "Outcome: fault." ;;
2) echo "Outcome: bad input." ;;
3) echo "Outcome: not every object settled." ;;
*) echo "Outcome: ended with status $status." ;;
esac
exit $status
