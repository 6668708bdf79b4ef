# Shared by the scripts of this folder: where the build environment is and how to enter it.
# Sourced, not run. Debian 13 and Ubuntu 25.04 (and newer) are used as they are. On anything older a
# Debian 13 root in the user's cache folder takes their place, entered through a private mount
# namespace, so that nothing is ever left mounted on the host.

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cache=${XDG_CACHE_HOME:-$HOME/.cache}/furrow
root=$cache/debian13
log=$cache/setup.log

say() { printf 'furrow: %s\n' "$*" >&2; }

# fail WHAT WHAT_TO_DO
fail() {
    printf 'furrow: %s\n' "$1" >&2
    printf '        %s\n' "$2" >&2
    exit 1
}

packages() { sed 's/#.*//' "$project/packaging/packages.txt" | xargs -n1; }

packages_key() { packages | sort | sha1sum | cut -c1-12; }

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
        fail "setting up packages needs the rights of root, and there is no sudo here." \
             "Run packaging/setup once as root, or install sudo."
    fi
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

# What is mounted into the root, in this order: the home folder first, because the root itself may lie
# in it. Every bind is recursive, so sticks below /media and a project on a disk of its own are there.
# Arguments: ROOT PROJECT HOME UID GID ENV_FILE CMD...
enter_script='
set -e
root=$1 project=$2 home=$3 uid=$4 gid=$5 env_file=$6 cwd=$7
shift 7
bind() { [ -d "$1" ] || return 0; mkdir -p "$root$1"; mount --rbind "$1" "$root$1"; }
bind "$home"
bind /tmp
bind /media
bind /mnt
bind "$project"
shared=$(dirname "$project")/shared
[ ! -d "$shared" ] || bind "$shared"
case "$cwd/" in "$home"/*|/tmp/*|/media/*|/mnt/*|"$project"/*|"$shared"/*) ;; *) cwd=$project ;; esac
bind /dev
bind /sys
[ ! -d "/run/user/$uid" ] || bind "/run/user/$uid"
mount --rbind /proc "$root/proc"
for file in /etc/passwd /etc/group /etc/hosts /etc/resolv.conf /etc/localtime /etc/machine-id \
            /etc/ssl/certs/ca-certificates.crt; do
    [ -f "$file" ] || continue
    [ -e "$root$file" ] || : > "$root$file" 2>/dev/null || continue
    mount --bind "$(readlink -f "$file")" "$(readlink -f "$root$file" || echo "$root$file")" 2>/dev/null || true
done
if [ "$(id -u)" = "$uid" ]; then user=; else user=--userspec=$uid:$gid; fi
exec chroot $user "$root" /bin/bash -c "
    . \"\$1\"; rm -f \"\$1\"; cd \"\$2\"; shift 2
    exec \"\$@\"
" bash "$env_file" "$cwd" "$@"
'

# enter CMD...: runs CMD in the build environment, in the caller's folder and as the caller.
enter() {
    export PATH_OF_ENVIRONMENT=/usr/lib/qt6/bin:/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
    export CCACHE_DIR=${CCACHE_DIR:-$cache/ccache}
    # Clones in other folders share what was compiled.
    export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$project} CCACHE_NOHASHDIR=1
    export FURROW_NODE_MODULES=$(validators)/node_modules
    if host_is_new_enough; then
        export PATH=/usr/lib/qt6/bin:$PATH
        unset PATH_OF_ENVIRONMENT
        exec "$@"
    fi
    local env_file
    env_file=$(mktemp /tmp/furrow-env.XXXXXX)
    # The caller's environment, but for what only makes sense on the host's own file system.
    (
        export PATH=$PATH_OF_ENVIRONMENT
        export LANG=C.UTF-8
        export debian_chroot=furrow
        unset PATH_OF_ENVIRONMENT LD_LIBRARY_PATH LD_PRELOAD LC_ALL LANGUAGE
        unset PERL5LIB PYTHONPATH PYTHONHOME GI_TYPELIB_PATH QT_PLUGIN_PATH QML_IMPORT_PATH QML2_IMPORT_PATH
        export -p
    ) >"$env_file"
    local arguments=(bash -c "$enter_script" bash "$root" "$project" "$HOME" "$(id -u)" "$(id -g)"
                     "$env_file" "$PWD" "$@")
    local namespace=(unshare --mount --propagation private)
    if [ "$(id -u)" = 0 ]; then
        exec "${namespace[@]}" "${arguments[@]}"
    elif unshare --user --map-current-user --keep-caps --mount true 2>/dev/null; then
        # No privilege is needed where the kernel lets users have namespaces of their own.
        exec unshare --user --map-current-user --keep-caps --mount --propagation private "${arguments[@]}"
    else
        exec sudo "${namespace[@]}" "${arguments[@]}"
    fi
}
