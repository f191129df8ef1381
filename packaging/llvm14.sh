# For the scripts of checks to include: finds programs of LLVM 14. Other versions format and judge otherwise.

# find_llvm14 PROGRAM CHECK: sets $found to PROGRAM of version 14. Where there is none it ends the script: with 1, or with 0
# and a line "not checked: CHECK ..." on a system that has no package of it (Debian 13).
find_llvm14() {
    for found in "$1-14" "$1"; do
        if command -v "$found" >/dev/null 2>&1 && "$found" --version | grep -q 'version 14\.'; then
            return 0
        fi
    done
    # g++ shows that the lists of packages are there.
    if has_package g++ && ! has_package "$1-14"; then
        echo "not checked: $2, since this system has no package $1-14 and other versions judge otherwise"
        exit 0
    fi
    echo "$2 check: $1 of version 14 is not installed; sh packaging/install-deps.sh does that" >&2
    exit 1
}

has_package() {
    LC_ALL=C apt-cache policy "$1" 2>/dev/null | grep -q '^  Candidate: [^(]'
}
