# SPDX-License-Identifier: Apache-2.0
# Shell functions that ./demo and ./check share: timed stages and their table, and the build of a preset. To be sourced.

jobs=$(nproc)
[ "$jobs" -ge 2 ] || jobs=2

stages=()

# stage NAME COMMAND…: runs the command, says what it does and how long it took; a failure ends the script.
stage()
{
    local name=$1 started=$EPOCHREALTIME status=0
    shift
    printf '== %s\n' "$name"
    # Not `if "$@"`: that would switch errexit off inside the command.
    set +e
    (set -e; "$@")
    status=$?
    set -e
    local seconds
    seconds=$(awk -v a="$started" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f", b - a }')
    if [ "$status" -ne 0 ]; then
        printf '== %s: FAILED after %s s\n' "$name" "$seconds" >&2
        exit "$status"
    fi
    printf '== %s: %s s\n' "$name" "$seconds"
    stages+=("$seconds $name")
}

# whatIsChecked: a name for the files that are checked, the compiler and the data; empty where files differ from HEAD.
whatIsChecked()
{
    [ -z "$(git status --porcelain 2>&1)" ] || return 0
    { git rev-parse 'HEAD^{tree}'; "${CXX:-c++}" --version; echo "${OSGTRAINER_REAL_DATA:-}"; } | sha256sum | cut -c 1-16
}

# stageOnce NAME COMMAND…: a stage that is left out where it has passed before on the same files, so that hours of work that were broken
# off go on where they stopped. What passed stands in build/passed, a folder for each state of the files.
stageOnce()
{
    local state mark
    state=$(whatIsChecked)
    mark=build/passed/$state/${1//[^a-z0-9]/-}
    if [ -n "$state" ] && [ -f "$mark" ]; then
        printf '== %s: passed before on these files, %s s (remove %s to run it again)\n' "$1" "$(cat "$mark")" "$mark"
        stages+=("$(cat "$mark") $1 (before)")
        return
    fi
    stage "$@"
    [ -n "$state" ] || return 0
    mkdir -p "${mark%/*}"
    printf '%s\n' "${stages[-1]%% *}" >"$mark"
}

# stageTable: the seconds of all stages, one a line, and their sum.
stageTable()
{
    printf '%s\n' "${stages[@]}" | awk '{ all += $1; seconds = $1; $1 = ""; printf "%9.1f s %s\n", seconds, $0 } END { printf "%9.1f s  in all\n", all }'
}

# quietly LOG COMMAND…: the command's output goes to the log, and to the terminal only when it fails.
quietly()
{
    local log=$1
    shift
    if ! "$@" >"$log" 2>&1; then
        cat "$log" >&2
        return 1
    fi
}

# buildPreset PRESET [TARGET…]: configures the preset's build folder and builds (everything, or the targets).
# ccache spares the core-only tree, and a fresh clone, what the release tree has compiled; nothing depends on it.
buildPreset()
{
    local preset=$1 folder=build launcher=()
    shift
    [ "$preset" = release ] || folder=build-$preset
    mkdir -p "$folder"
    if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
    quietly "$folder/configure.log" cmake --preset "$preset" "${launcher[@]}" ${CONFIGURE_WITH:-}
    NINJA_STATUS='[%f/%t %es] ' cmake --build "$folder" --parallel "$jobs" ${1:+--target "$@"}
}
