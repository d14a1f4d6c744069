# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Sourced by the other scripts: long steps with short output.

export PYTHONUTF8=1 # what Python prints and reads is UTF-8 in every locale
jobs=$(nproc)
# Compilers at a time: a unit with precompiled headers takes up to 1.2 GB.
compilers=$(awk -v most="$jobs" '/^MemAvailable:/ { room = int($2 / 1200000) } END { print room < 1 ? 1 : room < most ? room : most }' "${MOTORBENCH_MEMINFO:-/proc/meminfo}")

lanes=$jobs # how many commands may run beside each other
besides=() # those that were begun and not waited for

# beside COMMAND…: in the background, as soon as there is room. In a process group of its own, so that what it starts ends with it.
beside() {
    while [ "$(jobs -rp | wc -l)" -ge "$lanes" ]; do wait -n || true; done
    set -m
    "$@" </dev/null &
    set +m
    besides+=($!)
}

# all_beside: waits for all of them; the status of the last that failed, or 0.
all_beside() {
    local each status=0
    for each in "${besides[@]}"; do wait "$each" || status=$?; done
    besides=()
    return "$status"
}

# end_beside: ends what still runs in the background. For the trap of a script that has something there; it also needs traps of INT,
# TERM and HUP, or it ends without the other one.
end_beside() {
    local each begun
    begun=$(jobs -p)
    for each in $begun; do kill -- "-$each" 2>/dev/null || kill "$each" 2>/dev/null || true; done
    wait
    for each in $begun; do kill -- "-$each" 2>/dev/null || true; done # a program that was just being started has not heard the first
}

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
        quietly "build $preset${1:+: $*}" cmake --build "build/$preset" -j "$compilers" ${1:+--target "$@"}
}
