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
[ "$(complete_bash quoin-cli render --step l)" = last ]
[ "$(complete_bash quoin-cli report --sections title,jo)" = title,joints ]

# Values are those that a refusal lists.
offered_are_known() {
  local refused known
  refused=$("$program" "$@" zzz -o "$scratch/out.$ending" 2>&1 || true)
  known=$(sed -n 's/^.* is not one of \(.*\) (see .*$/\1/p' <<<"$refused" | tr -d ' ' | tr ',' '\n' | sort)
  [ -n "$known" ] && [ "$known" = "$(complete_bash quoin-cli "${@:1:$#-2}" "${@: -1}" "")" ] \
    || { echo "$*: offered: $(complete_bash quoin-cli "${@:1:$#-2}" "${@: -1}" "")"; echo "$refused"; exit 1; }
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
echo '{}' >"$scratch/x.quoin"
ending=png
offered_are_known render "$scratch/x.quoin" --view
offered_are_known render "$scratch/x.quoin" --field
offered_are_known render "$scratch/x.quoin" --diagram
offered_are_known render "$scratch/x.quoin" --show
offered_are_known study plot "$scratch" --kind
ending=csv
offered_are_known export "$scratch/x.quoin" --table

# Those without a list of their own: each is taken, another one is refused.
for unit in $(complete_bash quoin-cli export --unit ""); do
  said=$("$program" export "$scratch/x.quoin" --unit "$unit" -o "$scratch/out.dxf" 2>&1 || true)
  [[ $said != *--unit* ]]
done
[ "$(complete_bash quoin-cli import --unit "")" = "$(complete_bash quoin-cli export --unit "")" ]
[ "$(complete_bash quoin-cli export --unit "" | wc -l)" = 6 ]
for law in $(complete_bash quoin-cli law ""); do
  "$program" law "$law" --csv "$scratch/law.csv"
done
for group in $(complete_bash quoin-cli verify ""); do
  said=$("$program" verify "$group" zzz 2>&1 || true)
  [[ $said == *zzz* && $said != *"$group"* ]]
done
[ "$(complete_bash quoin-cli law "" | wc -l)" = 9 ]
[ "$(complete_bash quoin-cli verify "" | wc -l)" = 14 ]
[ "$(complete_bash quoin-cli capacity --spectrum type)" = $'type1\ntype2' ]

if command -v fish >/dev/null; then
  offered() { fish --no-config -c 'source $argv[1]; complete -C $argv[2]' "$fish" "$1" | cut -f1; }
  [ "$(offered 'quoin-cli so')" = solve ]
  [ "$(offered 'quoin-cli study plot --kin')" = --kind ]
  [ "$(offered 'quoin-cli render --view mo')" = model ]
  [ "$(offered 'quoin-cli report --sections title,jo')" = title,joints ]
fi
if command -v zsh >/dev/null; then
  zsh -n "$zsh"
fi
