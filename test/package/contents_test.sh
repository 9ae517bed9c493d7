#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: checks one thing about the Debian packages.
#
# usage: contents_test.sh CASE PACKAGES SOURCE VERSION PROGRAM...

set -euo pipefail
check=$1
packages=$2
source=$3
version=$4
programs=("${@:5}")
failed=0

# file_of runtime|dev|tools|doc|python
file_of() {
  case $1 in
    runtime) ls "$packages"/libpclsurfacerepair[0-9]*.deb ;;
    dev) ls "$packages"/libpclsurfacerepair-dev_*.deb ;;
    tools) ls "$packages"/pclsurfacerepair-tools_*.deb ;;
    doc) ls "$packages"/libpclsurfacerepair-doc_*_all.deb ;;
    python) ls "$packages"/python3-pcl-surface-repair_*.deb ;;
  esac
}

files_in() {
  dpkg-deb --fsys-tarfile "$(file_of "$1")" | tar -t | sed 's/^\.//'
}

field() {
  dpkg-deb -f "$(file_of "$1")" "$2"
}

complain() {
  echo "$*" >&2
  failed=1
}

# holds PACKAGE PATTERN...: each pattern matches the whole name of one of its files
holds() {
  local package=$1 files pattern
  files=$(files_in "$package")
  for pattern in "${@:2}"; do
    grep -qxE "$pattern" <<<"$files" || complain "$package lacks $pattern"
  done
}

lacks() {
  files_in "$1" | grep -E "$2" && complain "$1 must not hold $2"
  return 0
}

case $check in
  runtime)
    for library in ccaa repair; do
      holds runtime "/usr/lib/.*/libpcl_surface_$library\.so\.${version//./\\.}" \
        "/usr/lib/.*/libpcl_surface_$library\.so\.${version%.*}"
    done
    lacks runtime '\.h$|\.so$|/bin/'
    ;;
  dev)
    holds dev '/usr/lib/.*/cmake/PclSurfaceRepair/PclSurfaceRepairConfig\.cmake' \
      '/usr/lib/.*/pkgconfig/pcl_surface_(ccaa|repair)\.pc' \
      '/usr/lib/.*/libpcl_surface_(ccaa|repair)\.so'
    while read -r header; do
      holds dev "/usr/include/${header//./\\.}"
    done <"$source/test/package/installed_headers.txt"
    lacks dev '\.so\.[0-9]|/bin/'
    ;;
  tools)
    ((${#programs[@]} > 0)) || complain "no programs to look for"
    for program in "${programs[@]}"; do
      holds tools "/usr/bin/$program" "/usr/share/man/man1/$program\.1\.gz" \
        "/usr/share/bash-completion/completions/$program"
    done
    while read -r file; do
      holds tools "/usr/share/pclsurfacerepair/${file//./\\.}"
    done < <(cd "$source/scripts" && find tiles -type f)
    ;;
  doc)
    docs=/usr/share/doc/PclSurfaceRepair
    while read -r page; do
      holds doc "$docs/${page//./\\.}"
    done < <(cd "$source" && find doc -name '*.md' -o -path 'doc/examples/*.cpp' -o -path 'doc/examples/*.py')
    holds doc "$docs/README\.md" "$docs/test/consumer/Makefile"
    ;;
  python)
    modules=/usr/lib/python3/dist-packages/pclsurfacerepair
    while read -r module; do
      holds python "$modules/${module//./\\.}"
    done < <(cd "$source/apps/python/pclsurfacerepair" && ls)
    holds python "$modules/_core\..*\.so" "$modules/_options\.py"
    lacks python '__pycache__|\.(cpp|h)$'
    [[ $(field python Depends) == *"$(field runtime Package) (= $version-"*python3-numpy* ]] ||
      complain "python: it needs its version of the libraries, and numpy"
    ;;
  site)
    if [[ -z ${PSR_DOXYGEN:-} ]]; then
      echo 'skipped: Doxygen was missing when the build was configured, so there is no site'
      exit 0
    fi
    holds doc '/usr/share/doc/PclSurfaceRepair/html/index\.html'
    ;;
  common)
    for package in runtime dev tools doc $(ls "$packages" | grep -o '^python' | head -1); do
      name=$(field "$package" Package)
      holds "$package" "/usr/share/doc/$name/copyright" \
        "/usr/share/doc/$name/changelog(\.Debian)?\.gz"
      dpkg-deb -c "$(file_of "$package")" |
        grep -vE '^(l|drwxr-xr-x root/root|-rw(-r--|xr-x)r-[-x] root/root)' &&
        complain "$package: owner or permissions"
    done
    ;;
  dependencies)
    library=$(field runtime Package)
    for package in dev tools; do
      [[ $(field "$package" Depends) == *"$library (= $version-"* ]] ||
        complain "$package does not depend on its version of $library"
    done
    [[ $(field runtime Depends) == *libpcl-common* ]] || complain "$library: no PCL"
    [[ $(field dev Depends) == *libpcl-dev* ]] || complain "dev: no libpcl-dev"
    ;;
  *) complain "unknown case $check" ;;
esac
exit "$failed"
