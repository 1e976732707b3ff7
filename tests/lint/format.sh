#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# format.sh ROOT: clang-format 14 would change nothing. Exit status 77 where it is absent.
set -euo pipefail

cd "$1"
formatter="$(command -v clang-format-14 || command -v clang-format || true)"
if [[ -z "$formatter" ]]; then
    echo "SKIPPED: no clang-format; nothing was checked"
    exit 77
fi
if [[ "$("$formatter" --version)" != *"version 14."* ]]; then
    echo "SKIPPED: other versions than clang-format 14 format otherwise; nothing was checked"
    exit 77
fi
find . \( -name 'build*' -o -name out -o -path ./.git \) -prune -o \
    \( -name '*.hpp' -o -name '*.cpp' -o -name '*.[ch]' \) -print0 | xargs -0 -r "$formatter" --dry-run -Werror
