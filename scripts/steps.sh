# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Sourced by the other scripts: long steps with short output.

jobs=$(nproc)

times=() # "SECONDS TITLE" of each step that took one

note_time() {
    [ "$2" -lt 1 ] || times+=("$(printf '%6d s  %s' "$2" "$1")")
}

# timed TITLE COMMAND…: a step with output of its own.
timed() {
    local title=$1 start=$SECONDS status=0
    shift
    "$@" || status=$?
    note_time "$title" $((SECONDS - start))
    return "$status"
}

# tell_times: the seconds of each step, and of all since the script began.
tell_times() {
    [ ${#times[@]} = 0 ] || printf '%s\n' "${times[@]}"
    printf '%6d s  in all\n' "$SECONDS"
}

# quietly TITLE COMMAND…: one line for a step that works, its output for one that does not.
quietly() {
    local title=$1 log status=0 start=$SECONDS
    shift
    log=$(mktemp)
    printf '%-72s ' "$title"
    "$@" >"$log" 2>&1 </dev/null || status=$?
    if [ "$status" = 0 ]; then
        printf 'ok (%d s)\n' $((SECONDS - start))
    else
        printf 'FAILED (exit status %d), the end of its output:\n' "$status"
        # not the progress, and not the command lines of the compiler
        { grep -vE '^\[[0-9]+/[0-9]+\] |^(/usr/bin/|: && ).*(c\+\+|g\+\+|cmake) ' "$log" || true; } | tail -n 80
    fi
    rm -f "$log"
    note_time "$title" $((SECONDS - start))
    return "$status"
}

# build PRESET [-DOPTION=VALUE…] -- [TARGET…]: configures and builds; no target means all.
build() {
    local preset=$1 options=()
    shift
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        options+=("$1")
        shift
    done
    shift
    quietly "configure $preset" cmake --preset "$preset" "${options[@]}" &&
        quietly "build $preset${1:+: $*}" cmake --build "build/$preset" -j "$jobs" ${1:+--target "$@"}
}
