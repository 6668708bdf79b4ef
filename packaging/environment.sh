# Shared by the scripts of this folder: where the build environment is and how to enter it.
# Sourced, not run. Debian 13 and Ubuntu 25.04 (and newer) are used as they are. On anything older a
# Debian 13 root in the user's cache folder takes their place, entered through a private mount
# namespace (namespace.sh), so that nothing is ever left mounted on the host.

# Debian leaves these out for ordinary users; debootstrap, chroot and pivot_root are there.
PATH=$PATH:/usr/local/sbin:/usr/sbin:/sbin

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
cache=${XDG_CACHE_HOME:-$HOME/.cache}/furrow
root=$cache/debian13
# shellcheck disable=SC2034  # for setup
log=$cache/setup.log

say() { printf 'furrow: %s\n' "$*" >&2; }

# fail WHAT WHAT_TO_DO
fail() {
    printf 'furrow: %s\n' "$1" >&2
    printf '        %s\n' "$2" >&2
    exit 1
}

# packages to-run|all: what the window is built and run with, or what tests and checks need, too.
packages() {
    local lists=("$project/packaging/packages.txt")
    [ "$1" = to-run ] || lists+=("$project/packaging/packages-tests.txt")
    sed 's/#.*//' "${lists[@]}" | xargs -n1
}

packages_key() { packages "$1" | sort | sha1sum | cut -c1-12; }

# A folder for each list, so that clones whose lists differ do not take each other's packages away.
validators() {
    local source="$project/tests/validators"
    printf '%s/node-%s' "$cache" "$(cat "$source/package.json" "$source/package-lock.json" | sha1sum | cut -c1-12)"
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        fail "this needs the rights of root, and there is no sudo here." \
             "Install it (as root: apt-get install sudo && adduser $(id -un) sudo), log in again and run this again."
    fi
}

# own FOLDER [EXCEPT]: what lies there as root's, from an earlier run with sudo, becomes the user's. Looks
# at FOLDER and what is directly in it; EXCEPT stays as it is.
own() {
    [ "$(id -u)" != 0 ] && [ -n "$(find "$1" -maxdepth 1 ! -path "${2:-}" -user 0 -print -quit)" ] || return 0
    say "$1 holds files of root's; they become yours ..."
    as_root find "$1" -path "${2:-}" -prune -o -user 0 -exec chown -h "$(id -u):$(id -g)" {} +
}

# FURROW_FORCE_ROOT=1 uses the Debian 13 root on a new host too (a reproducible build environment).
host_is_new_enough() {
    [ -z "${FURROW_FORCE_ROOT:-}" ] || return 1
    [ -r /etc/os-release ] || return 1
    local ID='' VERSION_ID='' VERSION_CODENAME=''
    . /etc/os-release
    case "$ID" in
        debian) dpkg --compare-versions "${VERSION_ID:-99}" ge 13 ;;
        ubuntu) dpkg --compare-versions "$VERSION_ID" ge 25.04 ;;
        *) return 1 ;;
    esac
}

# Folders at the top of the host that hold no part of its system: a file that somebody names may be in any,
# such as /data or /srv.
top_folders() {
    local folder
    for folder in /*/; do
        folder=${folder%/}
        case "$folder" in
            /bin | /boot | /dev | /etc | /lib* | /lost+found | /proc | /root | /run | /sbin | /sys | /usr | /var) ;;
            *) [ -L "$folder" ] || [ ! -x "$folder" ] || printf '%s\n' "$folder" ;;
        esac
    done
}

# The folders of the host that are in the Debian 13 root, too, at the same paths. Those that do not exist
# are left out.
shared_folders() {
    top_folders
    printf '%s\n' "$HOME" /tmp "${TMPDIR:-/tmp}" /run/media "$project" "$(dirname "$project")/shared" "$cache" \
        /dev /sys /proc "/run/user/$(id -u)"
}

# The host's time zone, where the Debian 13 root knows it.
time_zone() {
    local zone
    zone=$(readlink -f /etc/localtime)
    zone=${zone##*/zoneinfo/}
    [ ! -f "$root/usr/share/zoneinfo/$zone" ] || printf '%s\n' "$zone"
}

# The caller's environment as a script, but for what only makes sense on the host's own file system.
# shellcheck disable=SC2030,SC2031  # nothing of it is to last
environment() (
    export PATH=/usr/lib/qt6/bin:/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
    export LANG=C.UTF-8
    export debian_chroot=furrow
    local zone
    zone=${TZ:-$(time_zone)}
    [ -z "$zone" ] || export TZ="$zone"
    unset LD_LIBRARY_PATH LD_PRELOAD LC_ALL LANGUAGE
    unset PERL5LIB PYTHONPATH PYTHONHOME GI_TYPELIB_PATH QT_PLUGIN_PATH QML_IMPORT_PATH QML2_IMPORT_PATH
    export -p
    printf 'umask %s\n' "$(umask)"
)

# No privilege is needed where the kernel lets users have namespaces of their own and mount in them.
user_namespaces_work() {
    unshare --user --map-current-user --keep-caps --mount mount -t tmpfs furrow /tmp 2>/dev/null
}

# through_sudo STATE CMD...: sudo is a process of root's, which the user may not end. Signals go to what
# runs below it instead, which is the user's own and says its number in STATE/pid; before that, there is
# nothing to end, and without STATE nothing begins. Those of the keyboard are passed on by sudo itself.
through_sudo() {
    local state=$1 signals=(HUP TERM) signal child status interrupted=1
    shift
    trap 'rm -rf "$state"' EXIT
    command -v sudo >/dev/null ||
        fail "this system lets only root mount file systems, and there is no sudo here." \
             "Allow user namespaces (sysctl user.max_user_namespaces), or install sudo."
    { : </dev/tty; } 2>/dev/null || signals+=(INT QUIT)
    trap 'interrupted=1' INT QUIT
    for signal in "${signals[@]}"; do
        # shellcheck disable=SC2064  # each its own
        trap "pass_on $signal; interrupted=1" "$signal"
    done
    : >"$state/pid"
    (trap - INT QUIT HUP TERM EXIT; exec sudo "$@") <&0 &
    child=$!
    while [ -n "$interrupted" ]; do
        interrupted=
        status=0
        wait "$child" || status=$?
    done
    exit "$status"
}

# pass_on SIGNAL: part of through_sudo.
pass_on() {
    [ -s "$state/pid" ] || exit $((128 + $(kill -l "$1")))
    kill -s "$1" "$(cat "$state/pid")" 2>/dev/null || true
}

# enter CMD...: runs CMD in the build environment, in the caller's folder and as the caller.
enter() {
    export CCACHE_DIR=${CCACHE_DIR:-$cache/ccache}
    # Clones in other folders share what was compiled.
    export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$project} CCACHE_NOHASHDIR=1
    # What is compiled for the first time is not read twice: the compiler itself tells what it included.
    export CCACHE_DEPEND=1
    # Without these nothing that uses a precompiled header is shared.
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
    FURROW_NODE_MODULES=$(validators)/node_modules
    export FURROW_NODE_MODULES
    if host_is_new_enough; then
        # shellcheck disable=SC2031
        export PATH=/usr/lib/qt6/bin:$PATH
        exec "$@"
    fi
    # What the host mounts and unmounts later, a stick for one, is followed.
    local state folders identity mounting=(unshare --mount --propagation slave)
    # CMD is the caller's: rights that were needed for mounting are given up.
    identity="setpriv --reuid=$(id -u) --regid=$(id -g) --groups=$(id -G | tr ' ' ,)"
    mapfile -t folders < <(shared_folders)
    state=$(mktemp -d /tmp/furrow-enter.XXXXXX)
    environment >"$state/environment"
    local script=(bash -c "$(cat "$project/packaging/namespace.sh")" furrow "$root" "$state" "$project" "$PWD")
    local arguments=("${folders[@]}" -- "$@")
    if [ "$(id -u)" = 0 ]; then
        exec "${mounting[@]}" "${script[@]}" '' "${arguments[@]}"
    elif user_namespaces_work; then
        exec "${mounting[@]}" --user --map-current-user --keep-caps \
            "${script[@]}" "setpriv --inh-caps=-all --ambient-caps=-all" "${arguments[@]}"
    else
        through_sudo "$state" "${mounting[@]}" "${script[@]}" "$identity" "${arguments[@]}"
    fi
}
