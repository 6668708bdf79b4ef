# Sourced by run, shell and test, after environment.sh. build [--with-tests] TARGET...: configures and builds the
# release preset, quietly unless something fails. Tests, which need packages of their own, stay in a build folder
# that has them.
# shellcheck disable=SC2016,SC2154  # a script of its own; environment.sh says where the project is

# A build folder that was made elsewhere (moved, or by another system's CMake) is of no use here.
configured_here() {
    [ -f "$project/build/release/build.ninja" ] &&
        grep -qx "CMAKE_HOME_DIRECTORY:INTERNAL=$project" "$project/build/release/CMakeCache.txt"
}

# own_program CMD: its name, where CMD is Furrow's window or command line.
own_program() {
    local path
    path=$(realpath -m -- "$1")
    case "$path" in
        "$project/build/release/bin/furrow" | "$project/build/release/bin/furrow-cli") basename "$path" ;;
    esac
}

# progress LOG BEGIN: on a terminal, as long as this script runs: furrow: building ... 310 of 1289 steps, 95 s
progress() {
    local step
    while kill -0 $$ 2>/dev/null; do
        step=$(grep -oE '^\[[0-9]+/[0-9]+\]' "$1" 2>/dev/null | tail -n 1 | tr -d '[]' || true)
        [ -z "$step" ] || printf '\rfurrow: building ... %s of %s steps, %s s ' "${step%/*}" "${step#*/}" $((SECONDS - $2)) >&2
        sleep 1
    done
}

build() {
    local log="$project/build/build.log" begin=$SECONDS status=0 tests=OFF
    if [ "$1" = --with-tests ]; then
        tests=ON
        shift
    elif configured_here && grep -qx 'FURROW_TESTS:BOOL=ON' "$project/build/release/CMakeCache.txt"; then
        tests=ON
    fi
    mkdir -p "$project/build"
    own "$project/build"
    configured_here || rm -rf "$project/build/release"
    say "building ..."
    local teller=
    : >"$log"
    if [ -t 2 ]; then
        progress "$log" $SECONDS &
        teller=$!
    fi
    (enter bash -c '
            set -e
            cd "$1"
            cmake --preset release -DFURROW_TESTS="$2"
            shift 2
            cmake --build --preset release --target "$@"' build "$project" "$tests" "$@") >"$log" 2>&1 </dev/null || status=$?
    if [ -n "$teller" ]; then
        kill "$teller"
        wait "$teller" 2>/dev/null || true
        printf '\n' >&2
    fi
    if [ "$status" -ne 0 ]; then
        grep -E -A6 'error:|CMake Error|undefined reference|FAILED:' "$log" | head -n 40 >&2 || tail -n 20 "$log" >&2
        fail "failed: building (all of it: $log)" \
             "If packages were updated, remove build/release and try again."
    fi
    say "built in $((SECONDS - begin)) s"
}
