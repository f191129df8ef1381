#!/bin/sh
# Builds the release preset and packs it: build/release/bask_0.1.0_amd64.deb. Install it with: apt install ./that.deb
set -eu
cd "$(dirname "$0")/.."
sh packaging/install-deps.sh run
sh packaging/build.sh release
(cd build/release && cpack --config CPackConfig.cmake)
