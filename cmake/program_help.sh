# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: reads what a program prints for --help; to be sourced. The
# functions read the text from standard input.

# The headings of the groups of options, without the colon.
help_groups() {
  sed -n 's/^\(Options.*\):$/\1/p'
}

# help_options [GROUP]: a line "--name<tab>argument and default, or -<tab>description" for
# each option, of all groups or of one.
help_options() {
  awk -v group="${1:-}" '
    function flush() {
      sub(/ +$/, "", text)
      if (name != "") print name "\t" (takes == "" ? "-" : takes) "\t" text
      name = ""
    }
    /^Options.*:$/ { flush(); inside = group == "" || $0 == group ":"; next }
    inside && /^[^ ]/ { flush(); exit }
    inside && /^  -/ && match($0, /--[a-z0-9-]+/) {
      flush()
      name = substr($0, RSTART, RLENGTH)
      text = substr($0, RSTART + RLENGTH)
      sub(/^ \]/, "", text)
      takes = ""
      if (match(text, /^ (arg( \(=[^)]*\))?|\[=arg\(=[^)]*\)\])/)) {
        takes = substr(text, 2, RLENGTH - 1)
        text = substr(text, RLENGTH + 1)
      }
      sub(/^ +/, "", text)
      next
    }
    inside { sub(/^ +/, ""); sub(/ +$/, "", text); text = text " " $0 }
    END { flush() }'
}

# What may follow the program, a line for each way to call it, without [options].
help_synopsis() {
  sed -n '1,/^$/p' | sed -nE 's/^(Usage:|      ) [^ ]+ +//p' | sed 's/ *\[options\]//'
}

# What stands between the synopsis and the options.
help_summary() {
  sed -e '1,/^$/d' -e '/^Options:/,$d'
}

# help_argument NAME: what the summary says of an argument, on one line.
help_argument() {
  help_summary | awk -v name="$1" '
    $1 == name && /^[^ ]+  / { inside = 1; sub(/^[^ ]+ +/, ""); print; next }
    inside && /^   / { print; next }
    { inside = 0 }' | tr '\n' ' '
}

# The lines of the examples.
help_examples() {
  sed -n '/^Examples:/,/^$/p' | sed -e '/^Examples:/d' -e '/^$/d'
}

# The sentence about exit codes, on one line.
help_exit_codes() {
  sed -n '/^Exit codes:/,$p' | tr '\n' ' ' | sed -e 's/^Exit codes: *//' -e 's/ *$//'
}
