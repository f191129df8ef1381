#!/bin/sh
# Installs what is missing, builds the release preset and packs it for this release of Debian or Ubuntu; the last line is the
# file's name. Install it with: sudo apt install ./FILE
set -eu
cd "$(dirname "$0")/.."

sh packaging/install-deps.sh package
sh packaging/build.sh release
(cd build/release && rm -f bask_*.deb && cpack --config CPackConfig.cmake >package.log) || {
    cat build/release/package.log >&2
    exit 1
}
ls build/release/bask_*.deb
