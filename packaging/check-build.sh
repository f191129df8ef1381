#!/bin/sh
# Builds and tests these sources on another release than this system's, in a system of its own that debootstrap makes:
#   sudo sh packaging/check-build.sh                       Debian 13: every check and test, the headless example, the Debian package
#   sudo sh packaging/check-build.sh 'ctest --preset ci -R marker'    a command in place of these
#   BASK_SUITE=bookworm, BASK_ROOTS=FOLDER                 another release; the place of the systems (default: /var/cache/bask)
# $BASK_ROOTS/SUITE is the clean system of check-deb.sh; its copy $BASK_ROOTS/SUITE-build has the packages and keeps what was built,
# in bask-build. An ordinary user runs the commands there, without a network and with the sources as they lie here, read-only.
set -eu
cd "$(dirname "$0")/.."
if [ "$(id -u)" -ne 0 ]; then
    echo "check-build.sh: a system of its own takes root: sudo sh packaging/check-build.sh" >&2
    exit 2
fi
# Mounts and processes of its own, which end with it.
if [ -z "${BASK_UNSHARED:-}" ]; then
    BASK_UNSHARED=1 exec unshare --mount --pid --fork --kill-child --mount-proc sh packaging/check-build.sh "$@"
fi

everything='sh packaging/test.sh && sh packaging/run.sh && sh packaging/make-deb.sh && lintian --fail-on error build/release/bask_*.deb'
command=${*:-$everything}
roots=${BASK_ROOTS:-/var/cache/bask}
suite=${BASK_SUITE:-trixie}
root=$roots/$suite-build

step() { echo "check-build: $*"; }
fail() { echo "check-build: FAILED: $*" >&2; exit 1; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }

if [ ! -e "$roots/$suite/etc/debian_version" ]; then
    command -v debootstrap >/dev/null || sh packaging/install-deps.sh package || fail "install-deps.sh package"
    step "making a clean $suite in $roots"
    mkdir -p "$roots"
    debootstrap "$suite" "$roots/$suite" >"$roots/$suite.log" 2>&1 || fail "debootstrap: see $roots/$suite.log"
fi
[ -e "$root/bask" ] || cp -a --reflink=auto "$roots/$suite/." "$root"
inside id person >/dev/null 2>&1 || inside useradd --create-home person
printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d"
chmod 755 "$root/usr/sbin/policy-rc.d"
cp /etc/resolv.conf "$root/etc/" 2>/dev/null || :
inside install -d -o person -g person /bask /bask-build

mount -t proc proc "$root/proc"
mount --bind /dev/pts "$root/dev/pts"
mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
[ -d build ] || install -d -o "$(stat -c %u .)" -g "$(stat -c %g .)" build
mount --bind . "$root/bask"
mount -o remount,ro,bind "$root/bask"
mount --bind "$root/bask-build" "$root/bask/build"

for kind in all package; do
    inside sh /bask/packaging/install-deps.sh $kind || fail "install-deps.sh $kind"
done
said=$(inside sh /bask/packaging/install-deps.sh 2>&1)
[ -z "$said" ] || fail "install-deps.sh asks for packages that it has installed: $said"

step "$suite: $command"
unshare --net sh -c 'chroot "$1" ip link set lo up &&
    exec chroot --userspec=person:person "$1" env -i PATH=/usr/bin HOME=/home/person LC_ALL=C.UTF-8 sh -c "cd /bask && $2"' \
    - "$root" "$command" || fail "$suite: $command"
step passed
