# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what Doxygen reads of a Markdown page: the same page, with
# names for its headings and links that lead to pages of the site. The names are those
# that repositories on the web give to headings, after the name of the page.
#
# Bold code and short symbols (L_1, s^T) are given in HTML, which Doxygen needs for both.
#
# usage: awk -v top=FOLDER -f page_filter.awk PAGE
#   PSR_PAGES  in the environment: all pages, as paths from the top

# doc/concepts/field.md -> doc_concepts_field; the page README.md of a folder has the
# folder's name, that of the top is the site's main page.
function page_name(path) {
  if (path == "README.md") return "mainpage"
  sub(/\/README\.md$/, "", path)
  sub(/\.md$/, "", path)
  gsub(/[^A-Za-z0-9]/, "_", path)
  return path
}

# "Two `code` words" -> two-code-words
function slug(heading) {
  heading = tolower(heading)
  gsub(/[^a-z0-9 _-]/, "", heading)
  gsub(/ /, "-", heading)
  return heading
}

# A path as seen from this page -> as seen from the top, without any "..".
function resolved(target,    parts, n, i, kept, path) {
  if (folder != "") target = folder "/" target
  n = split(target, parts, "/")
  kept = 0
  for (i = 1; i <= n; ++i) {
    if (parts[i] == "" || parts[i] == ".") continue
    if (parts[i] == "..") --kept
    else stack[++kept] = parts[i]
  }
  path = stack[1]
  for (i = 2; i <= kept; ++i) path = path "/" stack[i]
  return kept > 0 ? path : ""
}

# Doxygen's name of the page with the source text of a file.
function source_page(path) {
  sub(/.*\//, "", path)
  gsub(/_/, "__", path)
  gsub(/\./, "_8", path)
  return path "_source.html"
}

# Where a link leads on the site; empty when the site has no such place.
function destination(target,    hash, at, path) {
  hash = ""
  if ((at = index(target, "#")) > 0) {
    hash = "-" substr(target, at + 1)
    target = substr(target, 1, at - 1)
  }
  path = target == "" ? page : resolved(target)
  if (path == "README.md" && hash == "") return "index.html"
  if (path ~ /\.md$/) return "@ref " page_name(path) hash
  if (path in folders) return "@ref " page_name(path)
  if (path ~ /\.cpp$/) return source_page(path)
  if (path == "LICENSE") return path
  return ""
}

# The line with its links turned; a link that leads nowhere leaves its text.
function with_links(line,    done, at, target, where, label) {
  done = ""
  while (match(line, /\]\([^)]*\)/)) {
    target = substr(line, RSTART + 2, RLENGTH - 3)
    at = RSTART
    label = substr(line, 1, at - 1)
    line = substr(line, RSTART + RLENGTH)
    if (target ~ /^[a-z]+:/) {
      done = done label "](" target ")"
    } else if (target ~ /\.(png|svg|jpg)$/) {
      sub(/.*\//, "", target)
      done = done label "](" target ")"
    } else if ((where = destination(target)) != "") {
      done = done label "](" where ")"
    } else {
      match(label, /\[[^\[]*$/)
      done = done substr(label, 1, RSTART - 1) substr(label, RSTART + 1)
    }
  }
  return done line
}

# What stands outside `code` and links gets its symbols set low and high.
function with_symbols(line,    n, parts, i, out) {
  while (match(line, /\*\*`[^`]*`\*\*/))
    line = substr(line, 1, RSTART - 1) "<b>" substr(line, RSTART + 2, RLENGTH - 4) "</b>" \
      substr(line, RSTART + RLENGTH)
  n = split(line, parts, "`")
  out = ""
  for (i = 1; i <= n; ++i) {
    if (i % 2 == 1 && parts[i] !~ /\]\(/) parts[i] = raised(lowered(parts[i]))
    out = out (i > 1 ? "`" : "") parts[i]
  }
  return out
}

function lowered(text,    out, token, rest) {
  out = ""
  while (match(text, symbol)) {
    token = substr(text, RSTART, RLENGTH)
    rest = substr(text, RSTART + RLENGTH)
    out = out substr(text, 1, RSTART - 1)
    match(token, /_[A-Za-z0-9]+/)
    out = out substr(token, 1, RSTART - 1) "<sub>" substr(token, RSTART + 1, RLENGTH - 1) \
      "</sub>"
    text = substr(token, RSTART + RLENGTH) rest
  }
  return out text
}

function raised(text,    out, token) {
  out = ""
  while (match(text, /[A-Za-z0-9)]\^-?[A-Za-z0-9]+/)) {
    token = substr(text, RSTART, RLENGTH)
    out = out substr(text, 1, RSTART) "<sup>" substr(token, 3) "</sup>"
    text = substr(text, RSTART + RLENGTH)
  }
  return out text
}

BEGIN {
  # The folders below doc that have pages.
  page_count = split(ENVIRON["PSR_PAGES"], pages, " ")
  for (i = 1; i <= page_count; ++i) {
    folder = pages[i]
    if (folder ~ /^doc\/.*\//) {
      sub(/\/[^\/]*$/, "", folder)
      folders[folder] = 1
    }
  }
  # A letter and its index, which are not part of a name or of a path.
  symbol = "(^|[^A-Za-z0-9_./-])[A-Za-z]_[A-Za-z0-9][A-Za-z0-9]?" \
    "($|[^A-Za-z0-9_./]|[.]( |$))"
}

FNR == 1 {
  page = FILENAME
  if (index(page, top "/") == 1) page = substr(page, length(top) + 2)
  folder = page
  if (!sub(/\/[^\/]*$/, "", folder)) folder = ""
  titled = 0
}

/^ *```/ { fenced = !fenced }
fenced || /^    / { print; next }

# Doxygen wants the text of a link on one line.
held != "" {
  if ($0 ~ /^ *($|[-*+|#>]|[0-9]+\.)/) print with_links(with_symbols(held))
  else $0 = held " " $0
  held = ""
}
!/^ *[|#]/ && /\[[A-Za-z`][^\]]*$/ { held = $0; next }

/^#+ / {
  text = $0
  sub(/^#+ +/, "", text)
  if (!titled && $1 == "#") {
    titled = 1
    sub(/^[0-9]+\. +/, "", text) # Doxygen would begin a list
    print "# " text " {#" page_name(page) "}"
  } else {
    name = slug(text)
    if (seen[name]++) name = name "-" seen[name] - 1
    print with_links($0) " {#" page_name(page) "-" name "}"
  }
  next
}

{ print with_links(with_symbols($0)) }

END { if (held != "") print with_links(with_symbols(held)) }

# The first page of a folder holds the others in the tree of pages.
END {
  if (page ~ /^doc\/.*\/README\.md$/) {
    print "\n<div style=\"display:none\">"
    for (i = 1; i <= page_count; ++i)
      if (index(pages[i], folder "/") == 1 && pages[i] != page)
        print "@subpage " page_name(pages[i])
    print "</div>"
  }
}
