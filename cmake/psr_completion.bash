# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the functions in every program's bash completion. The caller
# has: options, a text; values, from option to kind; arguments, the kinds in their order.
# shellcheck shell=bash disable=SC2154

# Files of the given endings and folders; all files if there is no ending.
_psr_files() {
  local file ending
  while IFS= read -r file; do
    if [[ -d $file || $# -eq 0 ]]; then
      COMPREPLY+=("$file")
    else
      for ending in "$@"; do
        [[ ${file,,} == *."$ending" ]] && COMPREPLY+=("$file")
      done
    fi
  done < <(compgen -f -- "$current")
}

# Candidates of a kind: "words a b", "files ply vtk", "folder", "nothing".
_psr_candidates() {
  local kind=$1
  shift
  case $kind in
    words) mapfile -t COMPREPLY < <(compgen -W "$*" -- "$current") ;;
    files) _psr_files "$@" ;;
    folder) mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
  esac
}

# How many arguments without a dash stand before the cursor.
_psr_argument_count() {
  local count=0 i word
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if [[ ${COMP_WORDS[i + 1]} == '=' ]]; then
      ((i += 2))
    elif [[ -n ${values[$word]:-} ]]; then
      ((i += 1))
    elif [[ $word != -* || $word == - ]]; then
      ((count += 1))
    fi
  done
  echo "$count"
}

_psr_complete() {
  COMPREPLY=()
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  # Bash takes --option=value for three words.
  if [[ $current == '=' ]]; then
    current=''
  elif [[ $previous == '=' ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  local kind=${values[$previous]:-} place
  if [[ -z $kind && $current == -* ]]; then
    kind="words $options"
  elif [[ -z $kind ]]; then
    place=$(_psr_argument_count)
    if ((place >= ${#arguments[@]})) && [[ ${arguments[-1]} == repeat* ]]; then
      place=$((${#arguments[@]} - 1))
    fi
    kind=${arguments[place]:-nothing}
    kind=${kind#repeat }
  fi
  # Kinds are lists of words.
  # shellcheck disable=SC2086
  _psr_candidates $kind
}
