#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: installs the packages on a bare system, runs every program on
# a small cloud, and compiles users' programs there. Needs root and debootstrap.
#
# usage: check_packages.sh [FOLDER_OF_PACKAGES]     (default: build/packages)

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
packages=$(cd "${1:-$here/build/packages}" && pwd)
bare=$here/build/bare
root=$bare/root
mirror=${PSR_DEBIAN_MIRROR:-http://deb.debian.org/debian}
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")

release() {
  mountpoint -q "$root/proc" && umount "$root/proc"
  return 0
}
trap release EXIT

# The smallest system there is; made once.
if [[ ! -d $bare/$suite ]]; then
  rm -rf "$bare/part"
  debootstrap --variant=minbase "$suite" "$bare/part" "$mirror"
  mv "$bare/part" "$bare/$suite"
fi
release
rm -rf "$root"
cp -a "$bare/$suite" "$root"
mkdir "$root/check"
cp "$packages"/*.deb "$here/scripts/bare/use_packages.sh" "$root/check"
mount -t proc proc "$root/proc"
chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
  LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash /check/use_packages.sh
