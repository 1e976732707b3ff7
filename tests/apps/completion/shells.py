# SPDX-License-Identifier: MIT
"""A shell in a terminal of its own: types a line, presses a key, reads the line back."""

import os
import pty
import re
import select
import shutil
import signal
import time

# Each begins a line with what is typed, completes it, and prints it between these marks.
BEGIN, END = "line<<", ">>line"


def found(name):
    return shutil.which(name)


class Shell:
    """Bash or zsh without a user's settings, in `folder`, with `program` as camopt."""

    # Control-X d prints the line; control-X a completes with all that fits, one after the other.
    BASH = [
        "PS1=; PS2=; unset HISTFILE",
        "bind 'set enable-bracketed-paste off'; bind 'set bell-style none'; bind '\"\\C-xa\": insert-completions'",
        "_show() { printf '\\n" + "line%s%s%sline\\n' '<<' \"$READLINE_LINE\" '>>'; READLINE_LINE=; READLINE_POINT=0; }",
        "bind -x '\"\\C-xd\": _show'",
    ]
    ZSH = [
        "PS1=; RPS1=; unset HISTFILE; unsetopt zle_bracketed_paste prompt_sp beep list_beep",
        "fpath=({scripts} $fpath); autoload -Uz compinit; compinit -u -D",
        "zstyle ':completion:*' insert-ids menu; _all() { compstate[insert]=all; compstate[list]=; }",
        "zle -C all-that-fit complete-word _every; _every() { _main_complete; compstate[insert]=all; compstate[list]=; }",
        "_show() { print -r -- ; print -r -- 'line''<<'\"$BUFFER\"'>>''line'; BUFFER=; }; zle -N _show",
        "bindkey -e; bindkey '^Xd' _show; bindkey '^Xa' all-that-fit",
    ]

    def __init__(self, name, program, scripts, folder):
        command = {"bash": ["bash", "--norc", "--noprofile", "-i"], "zsh": ["zsh", "-f", "-i"]}[name]
        path = os.path.dirname(program) + os.pathsep + os.environ.get("PATH", "")
        surroundings = dict(os.environ, PATH=path, TERM="dumb", INPUTRC="/dev/null", COLUMNS="10000", LC_ALL="C.UTF-8")
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execvpe(command[0], command, surroundings)
        settings = self.BASH + [f"source {scripts}/camopt.bash"] if name == "bash" else self.ZSH
        for line in ["stty -echo columns 10000"] + settings:
            self.send(line.replace("{scripts}", scripts) + "\n")
        self.shown("")

    def send(self, text):
        os.write(self.terminal, text.encode())

    def until_end(self, seconds=20):
        seen, limit = "", time.monotonic() + seconds
        while END not in seen:
            if time.monotonic() > limit:
                raise TimeoutError(f"the shell shows no line after {seconds} s; it wrote: {seen!r}")
            if select.select([self.terminal], [], [], 0.1)[0]:
                seen += os.read(self.terminal, 65536).decode(errors="replace")
        return seen

    def shown(self, keys):
        """The line after these keys."""
        self.send(keys + "\x18d")
        seen = self.until_end()
        return re.search(re.escape(BEGIN) + "(.*?)" + re.escape(END), seen, re.S).group(1)

    def completed(self, line):
        """The line after a tab: what is certain is added."""
        return self.shown(line + "\t")

    def fitting(self, line):
        """Every word that fits in place of the last one."""
        return self.shown(line + "\x18a").strip().split(" ")[line.count(" "):]

    def close(self):
        os.kill(self.process, signal.SIGKILL)
        os.waitpid(self.process, 0)
        os.close(self.terminal)
