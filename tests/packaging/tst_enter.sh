#!/usr/bin/env bash
# The build environment is entered by people who may not write into the Debian 13 root. A root of a few
# programs stands for it, without any place to mount on; where this runs as root, it is root's, and another
# user enters it.
set -euo pipefail

source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
# Not in /tmp, which is mounted as a whole.
work=$(mktemp -d "/var/tmp/furrow enter.XXXXXX")
trap 'rm -rf "$work"' EXIT
home="$work/home/user" project="$work/land/of others/furrow" root="$work/cache/furrow/debian13"
# shellcheck source=tests/packaging/rows.sh
. "$source/tests/packaging/rows.sh"

# A program with the libraries that it needs.
install_program() {
    local program library
    program=$(command -v "$1")
    install -D "$program" "$root/usr/bin/$1"
    for library in $(ldd "$program" | grep -o '/[^ ]*'); do
        [ -e "$root$library" ] || install -D "$library" "$root$library"
    done
}

make_root() {
    local program
    mkdir -p "$root"/{proc,dev,sys,tmp,etc,home,var,usr/bin}
    printf 'in memory only\n' >"$root/etc/passwd"
    : >"$root/etc/fstab"  # as any Debian has: umount asks it
    for program in bash setpriv umount rm cat id touch stat mkdir chmod; do install_program "$program"; done
    # Stands for the build: a program that says what it is given.
    cat >"$root/usr/bin/cmake" <<'CMAKE'
#!/usr/bin/bash
set -e
[ "$1" = --build ] || exit 0
echo built >>build/count
mkdir -p build/release/bin
printf '#!/usr/bin/bash\necho "given $*"\n' >"build/release/bin/$5"
chmod +x "build/release/bin/$5"
CMAKE
    chmod +x "$root/usr/bin/cmake"
}

make_project() {
    mkdir -p "$project/tests" "$home/kept"
    cp -r "$source/packaging" "$project/"
    cp -r "$source/tests/validators" "$project/tests/"
    printf '#!/bin/sh\n' >"$project/packaging/setup"
    mkdir "$project/build"
    printf 'of the project\n' >"$project/file"
    printf 'of the home folder\n' >"$home/file"
    # Stands for sudo where signals are tried: it only runs what it is given.
    mkdir -p "$home/bin"
    printf '#!/bin/sh\nexec "$@"\n' >"$home/bin/sudo"
    chmod +x "$home/bin/sudo"
    chmod -R a+rX "$work"
    chmod 500 "$home/kept"
    [ "$(id -u)" != 0 ] || chown -R 65534:65534 "$home" "$project/build"
}

# What runs in it is the caller's: nobody's, where this test is root's.
other=()
[ "$(id -u)" != 0 ] || other=(setpriv --reuid=65534 --regid=65534 --clear-groups)

# become FUNCTION ARGUMENT...: this shell becomes one that runs a function of environment.sh.
become() {
    # shellcheck disable=SC2016
    exec "${other[@]}" env HOME="$home" XDG_CACHE_HOME="$work/cache" FURROW_FORCE_ROOT=1 PATH="$home/bin:$PATH" \
        bash -euc '. "$1/packaging/environment.sh"; cd "$1"; shift; "$@"' bash "$project" "$@"
}

in_project() { (become "$@"); }

# Below sudo a command gets the signals that are sent to the script that called it.
signals_below_sudo() {
    local state="$home/state" begun="$home/begun" status=0
    "${other[@]}" mkdir "$state"
    "${other[@]}" mkfifo "$begun"
    # shellcheck disable=SC2016
    become through_sudo "$state" bash -c '
        sleep 60 &
        trap "kill %1; exit 9" TERM
        echo $$ >"$1/pid"; echo >"$2"; wait' bash "$state" "$begun" &
    read -r <"$begun"
    kill -TERM $!
    wait $! || status=$?
    expect signalsReachWhatRunsBelowSudo "$status $(ls "$state" 2>/dev/null)" '9 '
}

make_root
make_project
if ! "${other[@]}" unshare --user --map-current-user --keep-caps --mount mount -t tmpfs furrow /tmp; then
    row 'SKIP   ' entersWithoutRights "needs user namespaces"
    exit 0
fi
before=$(cd "$root" && find . | sort)

expect runsInTheRoot "$(in_project enter cat /etc/passwd)" "$(cat /etc/passwd)"
expect findsProjectAnywhere "$(in_project enter cat "$project/file" file)" $'of the project\nof the project'
expect findsHome "$(in_project enter cat "$home/file")" 'of the home folder'
expect findsOtherFolders "$(in_project enter stat -c %i /srv /mnt)" "$(stat -c %i /srv /mnt)"
expect isTheCaller "$(in_project enter id -u)" "$("${other[@]}" id -u)"
in_project enter touch "$home/written"
expect filesAreTheCallers "$(stat -c %u "$home/written")" "$("${other[@]}" id -u)"
status=0
in_project enter touch "$home/kept/file" 2>/dev/null || status=$?
expect hasNoMoreRights "$status" 1
status=0
in_project enter touch /lost 2>/dev/null || status=$?
expect refusesWhatWouldBeLost "$status" 1
status=0
in_project enter bash -c 'exit 37' || status=$?
expect passesStatusOn "$status" 37
expect passesInputOn "$(printf 'a\nb' | in_project enter cat)" $'a\nb'
signals_below_sudo
for row in buildsWhatIsMissing buildsItOnce; do
    seen=$(in_project packaging/shell build/release/bin/furrow-cli plan 'a field' 2>/dev/null || true)
    expect "$row" "$seen, $(cat "$project/build/count")" 'given plan a field, built'
done
if [ "$(id -u)" = 0 ]; then
    other=()
    expect rootEnters "$(in_project enter id -u)" 0
fi
expect leavesTheRootAlone "$(cd "$root" && find . | sort)" "$before"
exit "$failed"
