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

# Every script configures a preset through these two: with different options they would rebuild each other's files for ever.
#
# A build of this preset begins with nothing: no folder, and no compiler cache that could know what it needs.
begins_with_nothing() {
  if [[ -e build/$1/CMakeCache.txt ]]; then return 1; fi
  if ! command -v ccache >/dev/null || [[ -n ${CCACHE_DISABLE-} ]]; then return 0; fi
  [[ $(ccache --print-stats | awk '$1 == "files_in_cache" { print $2 }') -eq 0 ]]
}

# configure PRESET: with everything that the preset has, tests too. One that begins with nothing is built in batches of
# files, which is faster, and stays so.
configure() {
  local everything=(-DREGISTA_WERROR=ON)
  if begins_with_nothing "$1"; then everything+=(-DREGISTA_BATCHES=ON); fi
  if [[ $1 == release ]]; then everything+=(-DREGISTA_TESTS=ON -DREGISTA_BENCHMARKS=ON); fi
  cmake --preset "$1" "${everything[@]}"
}

# The program of the release build, for which the packages of the tests need not be there. A folder that was configured with
# tests keeps them.
configure_program() {
  local cache=build/release/CMakeCache.txt options=(-DREGISTA_WERROR=ON)
  if ! grep -qs '^REGISTA_TESTS:[A-Z]*=ON' "$cache"; then options+=(-DREGISTA_TESTS=OFF -DREGISTA_BENCHMARKS=OFF); fi
  if begins_with_nothing release; then
    options+=(-DREGISTA_BATCHES=ON -DREGISTA_PRECOMPILE=ON)
  fi
  cmake --preset release "${options[@]}"
}
