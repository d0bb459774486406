# SPDX-License-Identifier: MIT
# Sourced by the scripts that have stages: strict mode, the project's root as current folder, no standard input, and
# stages that are named, timed and summed up. The first command that fails ends the script and names its stage.
# shellcheck shell=bash
set -euo pipefail
shopt -s inherit_errexit
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
exec </dev/null

current_stage="start"
finished_stages=()
stage_note=""
closing=""  # printed last, when all went well

# stage NAME COMMAND [ARGUMENT...]: runs the command; it may leave a remark for the summary in stage_note.
stage() {
  current_stage=$1
  shift
  stage_note=""
  local begin=$SECONDS
  printf '\n==> %s\n' "$current_stage"
  "$@"
  local seconds=$((SECONDS - begin))
  printf '<== %s: %d s\n' "$current_stage" "$seconds"
  finished_stages+=("$(printf "  %-20s %5d s%s" "$current_stage" "$seconds" "${stage_note:+  $stage_note}")")
  current_stage=""
}

print_summary() {
  local status=$?
  printf '\nSummary of %s\n' "${0##*/}"
  if ((${#finished_stages[@]})); then printf '%s\n' "${finished_stages[@]}"; fi
  if ((status)); then
    printf '  FAILED in stage "%s" after %d s\n' "$current_stage" "$SECONDS" >&2
  else
    printf '  all stages passed in %d s\n%s' "$SECONDS" "$closing"
  fi
}
trap print_summary EXIT
# Without these, a shell that is ended while a command runs would sum up with the status of that command.
trap 'exit 130' INT
trap 'exit 143' TERM HUP

# Where there is no home folder to keep ccache's store in, keep it beside the builds.
if [[ ! -w ${HOME:-/nonexistent} ]]; then export CCACHE_DIR="$PWD/build/ccache"; fi

# configure PRESET [OPTION...]: with these parts in addition to what the folder was configured with before (REGISTA_TESTS,
# REGISTA_BENCHMARKS), so that scripts that need more or less do not rebuild each other's files.
configure() {
  local options=(-DREGISTA_WERROR=ON) part cache="build/$1/CMakeCache.txt" from
  # CMake refuses a folder that it has prepared for another place, and names a file that nobody has to edit.
  from=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache" 2>/dev/null || true)
  if [[ -n $from && $(realpath -m -- "$from") != "$(pwd -P)" ]]; then
    echo "build/$1 was made for the checkout in $from; remove it: rm -r build/$1" >&2
    return 2
  fi
  for part in REGISTA_TESTS REGISTA_BENCHMARKS; do
    if [[ " ${*:2} " == *" $part "* ]]; then
      options+=("-D$part=ON")
    elif ! grep -qs "^$part:[A-Z]*=" "$cache"; then
      options+=("-D$part=OFF")
    fi
  done
  cmake --preset "$1" "${options[@]}"
}
