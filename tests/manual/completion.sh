#!/bin/bash
# Completions know every subcommand and every option that --help shows, and complete them; every
# subcommand has a manual page.
#
#   completion.sh QUOIN-CLI BASH ZSH FISH PAGE "SUBCOMMAND..."
set -euo pipefail
program=$1 bash=$2 zsh=$3 fish=$4 page=$5 documented=$6
export LC_ALL=C.UTF-8

names=$("$program" --help | sed -n 's/^  \([a-z]\+\) .*/\1/p')
[ "$(sort <<<"$names")" = "$(tr ' ' '\n' <<<"$documented" | sort)" ] \
  || { echo "src/cli/base/subcommand.h lists other subcommands than main.c"; exit 1; }

# Options as --help shows them, for a subcommand or an action of one.
options() {
  "$program" "$@" --help | sed -nE 's,^ +(-[a-z]\, )?(--[a-z-]+).*,\2,p' | sort -u
}

# What bash offers for a command line whose last word is being typed.
complete_bash() {
  bash --norc -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _quoin_cli 2>/dev/null
    printf "%s\n" "${COMPREPLY[@]}"' - "$bash" "$@" | sort -u
}

actions=$("$program" study --help | sed -n 's/^  study \([a-z]\+\) .*/\1/p')
[ -n "$actions" ]
while read -r command; do
  shown=$(options $command)
  [ "$shown" = "$(complete_bash quoin-cli $command --)" ] \
    || { echo "bash: quoin-cli $command:"; diff <(echo "$shown") <(complete_bash quoin-cli $command --); exit 1; }
  grep -q "^## $command\$" "$page"
  for option in $shown; do
    grep -q -- "-l ${option#--} \|-l ${option#--}\$" "$fish"
    grep -q -- "'\*\?${option}[=[]" "$zsh"
  done
done < <(grep -v '^study$' <<<"$names"; sed 's/^/study /' <<<"$actions")

[ "$(complete_bash quoin-cli so)" = solve ]
[ "$(complete_bash quoin-cli study pl)" = plot ]
[ "$(complete_bash quoin-cli generate co)" = column ]
[ "$(complete_bash quoin-cli render --view mo)" = model ]
[ "$(complete_bash quoin-cli render --no-such)" = "" ]

if command -v fish >/dev/null; then
  offered() { fish --no-config -c 'source $argv[1]; complete -C $argv[2]' "$fish" "$1" | cut -f1; }
  [ "$(offered 'quoin-cli so')" = solve ]
  [ "$(offered 'quoin-cli study plot --kin')" = --kind ]
  [ "$(offered 'quoin-cli render --view mo')" = model ]
fi
if command -v zsh >/dev/null; then
  zsh -n "$zsh"
fi
