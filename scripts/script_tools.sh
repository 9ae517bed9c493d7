# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what several scripts need; to be sourced at the top folder.

# size=WxH picture NAME MESH OPTIONS...: $images/NAME.png
picture() {
  pcl_render_mesh "$2" "$images/$1.png" --size "${size:-420x360}" "${@:3}"
}

# download_package NAME FOLDER: the file of a Debian package.
download_package() {
  # As root apt would warn that it cannot download as a user of less rights.
  (cd "$2" && apt-get -qq -o APT::Sandbox::User=root download "$1" </dev/null)
}

# unpack_package NAME FOLDER: the content of a Debian package below FOLDER/NAME; nothing is
# installed.
unpack_package() {
  local folder=$2/$1
  [[ ! -e $folder/usr ]] || return 0
  rm -rf "$folder"
  mkdir -p "$folder"
  if ! download_package "$1" "$folder" 2>/dev/null; then
    scripts/install_dependencies.sh --update # apt did not know the package
    download_package "$1" "$folder"
  fi
  dpkg-deb -x "$folder/$1"_*.deb "$folder"
}
