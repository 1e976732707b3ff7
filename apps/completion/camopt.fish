# SPDX-License-Identifier: MIT
# Completion of camopt for fish; installed to share/fish/vendor_completions.d. The program itself says what fits
# (apps/completion.cpp), so this file knows no command and no option.

function __camopt_complete
    set -l words (commandline -opc)
    set -l typed (commandline -ct)
    for answer in (command $words[1] __complete $words[2..-1] "$typed" 2>/dev/null)
        switch $answer
            case ':folders'
                __fish_complete_directories "$typed" ''
            case ':files'
                __fish_complete_path "$typed" ''
            case ':scenes' ':results'
                __fish_complete_suffix .toml
            case '*'
                echo $answer
        end
    end
end

complete -c camopt -f -a '(__camopt_complete)'
