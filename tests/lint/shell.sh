#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# shell.sh ROOT: shellcheck finds nothing in the scripts. Exit status 77 where it is absent.
set -euo pipefail

cd "$1"
if ! command -v shellcheck >/dev/null; then
    echo "SKIPPED: no shellcheck; nothing was checked"
    exit 77
fi
shopt -s nullglob
scripts=()
for file in scripts/* .ci/* tests/*/*.sh benchmarks/*.sh; do
    [[ -f "$file" && "$(head -c 2 "$file")" == '#!' && "$(head -n 1 "$file")" == *bash* ]] && scripts+=("$file")
done
shellcheck "${scripts[@]}"
