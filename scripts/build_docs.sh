#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: builds the documentation site from the pages and the headers.
# A warning of Doxygen's, a dead link on the site or a page that its navigation has not is an
# error. Doxygen's own search knows names and titles; a page of ours searches the text.
#
# usage: build_docs.sh        needs doxygen; result: build/docs/html/index.html

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# A page "Concepts" for the folder doc/concepts, with all pages in it, and so on; a folder
# with a README.md has one already.
folder_pages() {
  local folder name page
  for folder in doc/*/; do
    compgen -G "$folder*.md" >/dev/null && [[ ! -e ${folder}README.md ]] || continue
    name=$(basename "$folder")
    echo "/** \\page doc_$name ${name^}"
    for page in "$folder"*.md; do
      page=${page%.md}
      echo " - \\subpage ${page//[^A-Za-z0-9]/_}"
    done
    echo "*/"
  done
}

# The page that searches.
search_page() {
  cat <<'END'
/** \page search_text Search in all pages
\htmlonly
<p><input id="query" type="search" size="40" autofocus oninput="showParts(this.value)"></p>
<ul id="found"></ul>
<script src="text_index.js"></script>
<script src="full_text.js"></script>
\endhtmlonly
All words have to be there, in any place. The names of classes and functions are found by the
field above.
*/
END
}

# Each part of each page: its address, heading and text.
text_index() {
  local page
  echo "const TEXT_INDEX = ["
  for page in $PSR_PAGES; do
    awk -v top="$PSR_TOP" -f doc/doxygen/page_filter.awk "$page" | awk '
      function flush() {
        gsub(/!\[[^]]*\]\([^)]*\)|\]\([^)]*\)|<[^>]*>|[][`|*\\"\t]/, " ", text)
        gsub(/["\\]/, "", heading)
        gsub(/ +/, " ", text)
        if (address != "") printf "[\"%s\", \"%s\", \"%s\"],\n", address, heading, text
        text = ""
      }
      /^ *```/ { fenced = !fenced; next }
      !fenced && /^#+ .*\{#.*\}$/ {
        flush()
        match($0, /\{#.*\}$/)
        id = substr($0, RSTART + 2, RLENGTH - 3)
        heading = substr($0, 1, RSTART - 2)
        sub(/^#+ /, "", heading)
        gsub(/`|\]\([^)]*\)|\[/, "", heading)
        if (file == "") { file = id == "mainpage" ? "index" : id; title = heading }
        else heading = title ": " heading
        address = file ".html#" (file == id || id == "mainpage" ? "top" : id)
        next
      }
      { text = text " " $0 }
      END { flush() }'
  done
  echo "];"
}

# Pages that cannot be reached from the site's navigation.
unlisted_pages() {
  local id
  sed -nE 's/^\["([^"#]*)#top", .*/\1/p' "$1/text_index.js" | while IFS= read -r id; do
    grep -qF "\"$id\"" "$1"/navtreeindex*.js || echo "not in the navigation: $id"
  done
}

# Addresses in the site's pages that lead to no file of it.
dead_links() {
  local site=$1 page target
  grep -oE '(href|src)="[^":#]+[^":]*"' "$site"/*.html |
    sed -E -e 's/:(href|src)="/\t/' -e 's/[#?"].*//' | sort -u |
    while IFS=$'\t' read -r page target; do
      [[ -e $site/$target ]] || echo "dead link in ${page##*/}: $target"
    done
}

PSR_TOP=$PWD
PSR_VERSION=$(sed -nE 's/^ *VERSION ([0-9.]+)$/\1/p' CMakeLists.txt)
PSR_IMAGE_FOLDERS=$(find doc -name '*.png' -printf '%h\n' | sort -u | tr '\n' ' ')
PSR_PAGES=$(find doc README.md CONTRIBUTING.md SECURITY.md CHANGELOG.md surface_* -name '*.md' | sort | tr '\n' ' ')
export PSR_PAGES PSR_TOP PSR_VERSION PSR_IMAGE_FOLDERS

rm -rf build/docs
mkdir -p build/docs
{
  search_page
  folder_pages
} >build/docs/pages.dox
doxygen doc/doxygen/Doxyfile
text_index >build/docs/html/text_index.js
dead=$(dead_links build/docs/html && unlisted_pages build/docs/html)
if [[ -n $dead ]]; then
  echo "$dead" >&2
  exit 1
fi
echo "Documentation: $PWD/build/docs/html/index.html"
