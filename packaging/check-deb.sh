#!/bin/sh
# Checks a package as the person meets it who installs it: lintian and the validators, then a clean Debian in which it is installed,
# its window opened under Xvfb, an example run, and the package purged.
#   sudo sh packaging/check-deb.sh FILE.deb      its tools: packaging/install-deps.sh package
# The clean Debian is made once by debootstrap, $BASK_ROOTS/$BASK_SUITE (default: /var/cache/bask, this system's release), and copied
# for each check. A picture of the window is left in build/check-deb.png.
set -eu
deb=$(readlink -f "${1:?usage: sh packaging/check-deb.sh FILE.deb}")
cd "$(dirname "$0")/.."
if [ "$(id -u)" -ne 0 ]; then
    echo "check-deb.sh: a clean Debian takes root: sudo sh packaging/check-deb.sh $deb" >&2
    exit 2
fi
# Mounts and processes of its own, which end with it.
if [ -z "${BASK_UNSHARED:-}" ]; then
    BASK_UNSHARED=1 exec unshare --mount --pid --fork --kill-child --mount-proc sh "$0" "$deb"
fi

roots=${BASK_ROOTS:-/var/cache/bask}
suite=${BASK_SUITE:-$(. /etc/os-release && echo "$VERSION_CODENAME")}
most_ms=${BASK_MOST_MS:-3000} # from start to first picture, on a machine that is not busy
files=$(mktemp -d)
root=
trap 'for at in proc dev/pts tmp/.X11-unix; do umount "$root/$at" 2>/dev/null || :; done
      rm -rf --one-file-system "$files" ${root:+"$root"}' EXIT

step() { echo "check-deb: $*"; }
fail() { echo "check-deb: FAILED: $*" >&2; exit 1; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
install_packages() { inside apt-get -qq "$@" -y --no-install-recommends >"$files/apt.log" 2>&1 || { cat "$files/apt.log" >&2; fail "apt-get $1"; }; }
milliseconds() { date +%s%3N; }

step "$(basename "$deb"): $(stat -c %s "$deb") bytes, installed $(dpkg-deb -f "$deb" Installed-Size) KiB"
step "depends: $(dpkg-deb -f "$deb" Depends)"

step lintian
lintian --allow-root --fail-on error "$deb" || fail lintian
step validators
dpkg-deb -x "$deb" "$files/package"
desktop-file-validate "$files"/package/usr/share/applications/*.desktop || fail desktop-file-validate
appstreamcli validate --no-net "$files"/package/usr/share/metainfo/*.xml || fail "appstreamcli validate"

if [ ! -e "$roots/$suite/etc/debian_version" ]; then
    step "making a clean $suite in $roots"
    mkdir -p "$roots"
    debootstrap "$suite" "$roots/$suite" >"$roots/$suite.log" 2>&1 || fail "debootstrap: see $roots/$suite.log"
fi
root=$(mktemp -d -p "$roots" check-XXXXXX)
# No function: in the background its process would be a shell's.
as_person="chroot --userspec=person:person $root env -i PATH=/usr/bin LC_ALL=C.UTF-8 HOME=/home/person XDG_RUNTIME_DIR=/home/person/runtime"
cp -a --reflink=auto "$roots/$suite/." "$root"
mount -t proc proc "$root/proc"
mount --bind /dev/pts "$root/dev/pts"
mkdir -p "$root/tmp/.X11-unix" /tmp/.X11-unix
mount --bind /tmp/.X11-unix "$root/tmp/.X11-unix"
printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d"
chmod 755 "$root/usr/sbin/policy-rc.d"
cp /etc/resolv.conf "$root/etc/" 2>/dev/null || :
inside useradd --create-home person
inside install -d -o person -m 700 /home/person/runtime
cp "$deb" "$root/tmp/bask.deb"

step "its dependencies in a clean $suite"
inside apt-get -qq update
install_packages satisfy "$(dpkg-deb -f "$deb" Depends)"
installed_files() { inside find / -xdev \( -path /proc -o -path /tmp -o -path /var/cache -o -path /var/log -o -path /var/lib/apt -o -path /var/lib/dpkg -o -path /home \) -prune -o -print | LC_ALL=C sort; }
installed_files >"$files/before"
step install
install_packages install /tmp/bask.deb
[ "$(inside dpkg-query -W -f '${db:Status-Abbrev}' bask)" = "ii " ] || fail "it is not installed"
grep -q '^Setting up' "$files/apt.log" && [ "$(grep -c '^Setting up' "$files/apt.log")" -eq 1 ] || fail "it brought other packages along"

if inside udevadm verify --help >/dev/null 2>&1; then # since Debian 13
    inside udevadm verify --no-summary /usr/lib/udev/rules.d/60-bask.rules || fail "udevadm verify"
fi

step "the program without a display"
$as_person bask --version
example=/usr/share/doc/bask/examples/three-objects.json
$as_person bask run "$example" -o /home/person/run.bask || fail "bask run: exit code $?"
$as_person bask study view-factor -o /home/person/study >/dev/null 2>&1 || fail "bask study (figures)"

Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp 3>"$files/display" >/dev/null 2>&1 &
while [ ! -s "$files/display" ]; do sleep 0.1; done
DISPLAY=:$(cat "$files/display")
export DISPLAY
echo '{"format": "bask-rig", "version": 1, "rig": {"name": "bench"}}' >"$root/home/person/rig.json"

# open_window NAME [FILE]: waits for a window whose title has NAME and for its first picture, and closes it.
open_window() {
    title=$1
    shift
    rm -f "$files/said"
    began=$(milliseconds)
    $as_person DISPLAY="$DISPLAY" BASK_TIMING=1 bask "$@" 2>"$files/said" &
    program=$!
    window=$(timeout 60 xdotool search --sync --onlyvisible --class '^bask$' | head -n 1) || fail "no window came: $(cat "$files/said")"
    mapped_ms=$(($(milliseconds) - began))
    for _ in $(seq 300); do
        picture_ms=$(sed -n 's/^first picture: \([0-9]*\) ms$/\1/p' "$files/said")
        xdotool getwindowname "$window" | grep -qF "$title" && [ -n "$picture_ms" ] && break
        sleep 0.1
    done
    [ -n "$picture_ms" ] || fail "no picture came: $(cat "$files/said")"
    xdotool getwindowname "$window" | grep -qF "$title" || fail "the title is $(xdotool getwindowname "$window")"
    xprop -id "$window" _NET_WM_ICON | grep -q 'Icon (' || fail "the window has no icon: is the SVG plugin there?"
    sleep 1
    import -window root "$files/window.png"
    [ "$(identify -format %k "$files/window.png")" -gt 50 ] || fail "the picture is blank"
    kill $program
    wait $program || fail "bask ended with $?: $(cat "$files/said")"
    grep -v '^first picture' "$files/said" >&2 || :
    step "window with ${1:-no file}: mapped after $mapped_ms ms, first picture after $picture_ms ms"
}
best_ms=
for _ in 1 2 3; do
    open_window "Three objects"
    [ -n "$best_ms" ] && [ "$best_ms" -le "$picture_ms" ] || best_ms=$picture_ms
done
[ "$best_ms" -le $most_ms ] || fail "the first picture came after $best_ms ms at the best, more than $most_ms"
mkdir -p build
open_window two-circles.json /usr/share/doc/bask/examples/two-circles.json
open_window "triangle*" /home/person/rig.json # the example, changed
open_window "Three objects" /home/person/run.bask
cp "$files/window.png" build/check-deb.png

step purge
inside apt-get -qq purge -y bask >"$files/apt.log" 2>&1 || fail "apt-get purge"
installed_files >"$files/after"
diff "$files/before" "$files/after" >"$files/left" || { cat "$files/left" >&2; fail "purging left or took files"; }
step passed
