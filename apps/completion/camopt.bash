# SPDX-License-Identifier: MIT
# Completion of camopt for bash 4.4 and later; installed to share/bash-completion/completions/camopt. By hand: source this file.
# The program itself says what fits (apps/completion.cpp), so this file knows no command and no option.

# What readline took apart at '=' and ':' put together again, up to the cursor: into _camopt_words.
_camopt_join_words() {
    local rest="${COMP_LINE:0:COMP_POINT}" word joined i
    _camopt_words=()
    for ((i = 0; i <= COMP_CWORD; ++i)); do
        joined=yes
        while [[ "$rest" == [[:space:]]* ]]; do
            joined=no
            rest="${rest:1}"
        done
        word="${COMP_WORDS[i]}"
        ((i < COMP_CWORD)) || word="$rest"
        rest="${rest:${#word}}"
        if [[ $joined == yes && i -gt 0 ]]; then
            _camopt_words[-1]+="$word"
        else
            _camopt_words+=("$word")
        fi
    done
}

_camopt() {
    local _camopt_words answer typed prefix
    _camopt_join_words
    typed="${_camopt_words[-1]}"
    COMPREPLY=()
    while IFS= read -r answer; do
        case "$answer" in
            :folders) compopt -o filenames && mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$typed") ;;
            :files) compopt -o filenames && mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$typed") ;;
            :scenes | :results)
                compopt -o filenames
                mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
                    compgen -f -X '!*.toml' -- "$typed"
                    compgen -d -- "$typed"
                )
                ;;
            *) COMPREPLY+=("$answer") ;;
        esac
    done < <("${1/#\~\//$HOME/}" __complete "${_camopt_words[@]:1}" 2>/dev/null)
    [[ "${COMPREPLY[*]}" == *[=:] ]] && compopt -o nospace
    # Readline replaces only what follows the last '=' or ':'.
    prefix="${typed%"${typed##*[=:]}"}"
    COMPREPLY=("${COMPREPLY[@]#"$prefix"}")
}

complete -F _camopt camopt
