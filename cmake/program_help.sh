# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: reads what a program prints for --help; to be sourced. The
# functions read the text from standard input.

# A line "--name<tab>argument and default, or -<tab>description" for each option.
help_options() {
  awk '
    function flush() {
      if (name != "") print name "\t" (takes == "" ? "-" : takes) "\t" text
      name = ""
    }
    /^Options:/ { inside = 1; next }
    inside && /^[^ ]/ { flush(); exit }
    inside && /^  -/ && match($0, /--[a-z0-9-]+/) {
      flush()
      name = substr($0, RSTART, RLENGTH)
      text = substr($0, RSTART + RLENGTH)
      sub(/^ \]/, "", text)
      takes = ""
      if (match(text, /^ arg( \(=[^)]*\))?/)) {
        takes = substr(text, 2, RLENGTH - 1)
        text = substr(text, RLENGTH + 1)
      }
      sub(/^ +/, "", text)
      next
    }
    inside { sub(/^ +/, ""); sub(/ +$/, "", text); text = text " " $0 }
    END { flush() }'
}

# The arguments as they stand after the program in the first line, [options] left out.
help_synopsis() {
  sed -n '1s/^Usage: [^ ]* //p' | sed 's/ *\[options\]//'
}

# The lines between the first one and the options.
help_summary() {
  sed -e '1,2d' -e '/^Options:/,$d'
}

# The lines of the examples.
help_examples() {
  sed -n '/^Examples:/,/^$/p' | sed -e '/^Examples:/d' -e '/^$/d'
}

# The sentence about exit codes, on one line.
help_exit_codes() {
  sed -n '/^Exit codes:/,$p' | tr '\n' ' ' | sed -e 's/^Exit codes: *//' -e 's/ *$//'
}
