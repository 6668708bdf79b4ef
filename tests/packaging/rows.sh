# shellcheck shell=bash
# Sourced by the tests of this folder. Rows are written as QtTest writes them, so that packaging/test counts them.
# shellcheck disable=SC2034  # for the test

failed=0

row() { printf '%s: %s::%s()%s\n' "$1" "$(basename "$0" .sh)" "$2" "${3:+ $3}"; }

# expect ROW SEEN EXPECTED
expect() {
    if [ "$2" = "$3" ]; then
        row 'PASS   ' "$1"
    else
        row 'FAIL!  ' "$1" "seen '$2', expected '$3'"
        failed=1
    fi
}
