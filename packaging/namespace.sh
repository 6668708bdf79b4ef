# Run by enter (environment.sh) in a mount namespace of its own, with the rights to mount there: as root, or
# as an ordinary user in a user namespace. Runs CMD in a file tree that is made of the Debian 13 root and of
# folders of the host. The tree itself lies in memory: any path can be a place to mount on, and nothing is
# ever written into the root, which an ordinary user could not.
# Arguments: ROOT STATE PROJECT CWD IDENTITY FOLDER... -- CMD...
#   STATE     a folder with the script "environment"; removed, unless it has a file "pid", which takes the
#             number of CMD's process
#   CWD       where CMD runs, if that is in one of the folders; PROJECT if not
#   IDENTITY  a command to run CMD by, as the caller and with no more rights than the caller has
set -euo pipefail
shopt -s nullglob dotglob
umask 022  # the caller's comes with the environment
PATH=/usr/sbin:/usr/bin:/sbin:/bin

root=$1 state=$2 project=$3 cwd=$4 identity=$5
shift 5
folders=()
while [ "$1" != -- ]; do
    folders+=("$1")
    shift
done
shift
trap 'rm -rf "$state"' EXIT  # where something fails: what is run by exec does not come here

# Empty in the root: CMD sees the host's.
tree=$root/proc
declare -A opened=()
in_memory=() bound=()

# open FOLDER: makes a folder of the tree one that takes new entries. What the root has there is in it.
open() {
    local folder=$1 entry place
    [ -z "${opened[$folder]:-}" ] || return 0
    [ "$folder" = / ] || open "$(dirname "$folder")"
    opened[$folder]=1
    mkdir -p "$tree$folder"
    [ -d "$root$folder" ] || return 0
    mount -t tmpfs -o mode=755 furrow "$tree$folder"
    in_memory+=("$folder")
    for entry in "$root${folder%/}"/*; do
        place=$tree${entry#"$root"}
        if [ "$entry" = "$tree" ]; then
            mkdir "$place"
        elif [ -L "$entry" ]; then
            cp -P "$entry" "$place"
        elif [ -d "$entry" ]; then
            mkdir "$place"
            mount --rbind "$entry" "$place"
        else
            : >"$place"
            mount --bind "$entry" "$place"
        fi
    done
}

# The folder is in one that is mounted already.
is_bound() {
    local outer
    for outer in "${bound[@]}"; do
        case "$1/" in "$outer"/*) return 0 ;; esac
    done
    return 1
}

# Every bind is recursive, so sticks below /media and a project on a disk of its own are there.
bind() {
    [ -d "$1" ] && [ "$1" != / ] && ! is_bound "$1" || return 0
    open "$(dirname "$1")"
    mkdir -p "$tree$1"
    mount --rbind "$1" "$tree$1"
    bound+=("$1")
}

open /
# The root may lie in a folder that is mounted next; the tree is left out there, or it would hold itself.
mount --make-unbindable "$tree"
for folder in "${folders[@]}"; do
    bind "$folder"
    bind "$(readlink -f "$folder")"  # what a symbolic link to it, or on the way to it, leads to
done
for file in /etc/passwd /etc/group /etc/hosts /etc/resolv.conf /etc/machine-id /etc/ssl/certs/ca-certificates.crt; do
    if [ -f "$file" ] && [ -f "$root$file" ] && [ ! -L "$root$file" ]; then
        mount --bind "$(readlink -f "$file")" "$tree$file"
    fi
done
mkdir "$tree/.host"
# Files written beside the folders would be lost at the end: refused instead.
for folder in "${in_memory[@]}"; do mount -o remount,bind,ro "$tree$folder"; done

is_bound "$cwd" || cwd=$project
cd "$tree"
# The host's own tree is left behind for good, where it can be (not below a chroot).
if pivot_root . .host 2>/dev/null; then
    umount --lazy /.host
    change=
else
    change="chroot ."
fi
# shellcheck disable=SC2016,SC2086  # a script of its own; commands with their options
exec $change $identity bash -c '
    . "$1/environment" || exit
    cd "$2"
    if [ -e "$1/pid" ]; then echo $$ >"$1/pid"; else rm -rf "$1"; fi
    shift 2
    exec "$@"' bash "$state" "$cwd" "$@"
