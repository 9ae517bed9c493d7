#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: builds the documentation site from the pages and the headers.
# A warning of Doxygen's or a dead link on the site is an error.
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
folder_pages >build/docs/pages.dox
doxygen doc/doxygen/Doxyfile
dead=$(dead_links build/docs/html)
if [[ -n $dead ]]; then
  echo "$dead" >&2
  exit 1
fi
echo "Documentation: $PWD/build/docs/html/index.html"
