#!/bin/sh
# Installs the packages that Bask needs on Debian 12 or Debian 13 (and on Ubuntu 24.04, by its lists: never tried). Silent when they are all there.
#   sh packaging/install-deps.sh          everything: build, run, tests and checks
#   sh packaging/install-deps.sh run      what building and running Bask takes
#   sh packaging/install-deps.sh package  that, and what making and checking the Debian package takes
#   sh packaging/install-deps.sh --list   prints the names for this system, installs nothing
# In the lists, a|b is the first of the two that the system has (Ubuntu 24.04 keeps some older names), and a trailing ? marks
# a package that Bask does without where the system lacks it.
set -eu

run_packages="
    g++ cmake ninja-build pkg-config
    libeigen3-dev nlohmann-json3-dev libopencv-dev libvtk9-dev libqcustomplot-dev libdxflib-dev libceres-dev libhdf5-dev libmosquitto-dev zlib1g-dev libpng-dev libsqlite3-dev libssl-dev
    qt6-base-dev libqt6opengl6-dev? qt6-svg-dev|libqt6svg6-dev
    qt6-serialport-dev|libqt6serialport6-dev
    qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n
    libgl-dev libgl1-mesa-dri fonts-dejavu-core"
test_packages="
    libgtest-dev libbenchmark-dev libqt6sql6-sqlite socat mbpoll libmodbus-dev mosquitto mosquitto-clients openssl python3-pymodbus python3-serial-asyncio|python3-serial python3-h5py python3-pil python3-pyatspi at-spi2-core dbus-daemon ccache python3 git xvfb xauth fonts-noto-cjk? doxygen clang-format-14? clang-tidy-14? clang? libclang-rt-dev?
    desktop-file-utils appstream libglib2.0-bin"
package_packages="
    dpkg-dev lintian debootstrap desktop-file-utils appstream xvfb xdotool x11-utils imagemagick"

usage() {
    sed -n '2,6s/^# \{0,1\}//p' "$0"
}

want=all
only_list=no
for argument in "$@"; do
    case $argument in
    run | package | all) want=$argument ;;
    --list) only_list=yes ;;
    -h | --help) usage; exit 0 ;;
    *) echo "install-deps.sh: unknown argument '$argument'" >&2; usage >&2; exit 2 ;;
    esac
done

entries=$run_packages
case $want in
package) entries="$entries $package_packages" ;;
all) entries="$entries $test_packages" ;;
esac

if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg-query >/dev/null 2>&1; then
    echo "install-deps.sh: this system has no apt-get. Bask is built on Debian 12 and Debian 13;" >&2
    echo "elsewhere install the counterparts of these packages and run CMake yourself:" >&2
    echo "$entries" >&2
    exit 1
fi

system=unknown
if [ -r /etc/os-release ]; then
    system=$(. /etc/os-release && echo "${ID:-unknown} ${VERSION_ID:-}")
fi
case $system in
"debian 12" | "debian 13" | "ubuntu 24.04") ;;
*) echo "install-deps.sh: '$system' is not one of Debian 12, Debian 13, Ubuntu 24.04; trying their package names." >&2 ;;
esac

installed() {
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null | cut -c 1-9)" = installed ]
}

available() {
    LC_ALL=C apt-cache policy "$1" 2>/dev/null | grep -q '^  Candidate: [^(]'
}

# First of the alternatives "a|b" for which the test $1 holds; fails when there is none.
first_that() {
    for name in $(echo "$2" | tr '|' ' '); do
        if "$1" "$name"; then
            echo "$name"
            return 0
        fi
    done
    return 1
}

needed=
optional=
for entry in $entries; do
    names=${entry%\?}
    first_that installed "$names" >/dev/null && continue
    if [ "$names" = "$entry" ]; then
        needed="$needed $names"
    elif first_that available "$names" >/dev/null; then
        optional="$optional $names"
    fi
done

if [ $only_list = yes ]; then
    for entry in $entries; do
        names=${entry%\?}
        first_that installed "$names" || first_that available "$names" || echo "$entry (not known here)"
    done
    exit 0
fi
[ -n "$needed$optional" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
        echo "install-deps.sh: packages are missing and there is neither root nor sudo. Install as root:" >&2
        echo "   $needed$optional" >&2
        exit 1
    fi
    as_root=sudo
fi

apt() {
    if [ -t 1 ]; then
        $as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 "$@"
    else
        $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 "$@" >/dev/null
    fi
}

echo "Bask needs packages that are not installed yet:$needed$optional"
echo "Running: ${as_root:+$as_root }apt-get update"
apt update

chosen=
for names in $needed $optional; do
    if name=$(first_that available "$names"); then
        chosen="$chosen $name"
    else
        echo "install-deps.sh: $system has no package $names" >&2
        exit 1
    fi
done
# Optional ones were unknown before the first update of a fresh system.
for entry in $entries; do
    names=${entry%\?}
    [ "$names" != "$entry" ] || continue
    case "$chosen " in *" $names "*) continue ;; esac
    first_that installed "$names" >/dev/null && continue
    if name=$(first_that available "$names"); then chosen="$chosen $name"; fi
done

echo "Running: ${as_root:+$as_root }apt-get install --no-install-recommends$chosen"
apt install -y --no-install-recommends $chosen
echo "Packages are in place."
