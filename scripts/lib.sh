# shellcheck shell=bash
# What all scripts share: source it after `set -euo pipefail`. It goes to the repository's root.
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { printf '== %s\n' "$*"; }
fail() {
    printf '\nscripts/%s failed: %s\n' "$(basename "$0")" "$1" >&2
    shift
    local line
    for line in "$@"; do printf '  %s\n' "$line" >&2; done
    exit 1
}

# The first argument of the scripts: what is asked for. $2 … are the words allowed; the last is the
# default.
parts_of() {
    local asked=$1 word
    shift
    if [[ -z $asked ]]; then
        echo "${!#}"
        return
    fi
    for word in "$@"; do
        if [[ $word == "$asked" ]]; then
            echo "$asked"
            return
        fi
    done
    fail "\"$asked\" is none of: $*"
}

jobs_of_this_machine() { echo "${VERSORIUM_JOBS:-$(nproc 2>/dev/null || echo 2)}"; }
