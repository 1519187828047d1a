# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Shell functions for Debian's ParaView, not installed: its Python package and that of VTK, which Stipple needs, exclude
# each other. Sourced after Apps/setup.sh, in the root of the sources.

# What of ParaView's needs, and of its picture's, does not come along with stipple_packages.
stipple_paraview_packages="openmpi-bin python3-six xvfb libxtst6 libgl1-mesa-dri python3-vtk9"

# stipple_unpack_paraview FOLDER: ParaView there, once; and where programs and CMake look for it.
stipple_unpack_paraview()
{
  if [ ! -e "$1/unpacked" ]; then
    stipple_start=$(date +%s)
    stipple_say "unpacking ParaView into $1"
    rm -rf "$1"
    mkdir -p "$1/packages"
    chmod 755 "$1" "$1/packages" # apt drops its rights for downloading
    (
      cd "$1/packages"
      # Lists may be old, or none.
      packages="paraview paraview-dev python3-paraview libqt5help5 libqt5opengl5 libqt5sql5 libqt5svg5"
      # shellcheck disable=SC2086 # words on purpose
      if ! apt-get download -q $packages >download.log 2>&1; then
        [ "$(id -u)" -ne 0 ] || apt-get update -q >update.log 2>&1 || true
        apt-get download -q $packages >download.log 2>&1 || {
          cat download.log >&2
          exit 1
        }
      fi
      for package in *.deb; do
        dpkg-deb -x "$package" ..
      done
    ) || stipple_fail "could not download ParaView"
    rm -r "$1/packages"
    touch "$1/unpacked"
    stipple_say "unpacked ($(stipple_seconds "$stipple_start"))"
  fi
  stipple_paraview_libraries=$(dirname "$(find "$1/usr/lib" -name 'libvtkRemotingCore-pv*.so' | head -n 1)")
  stipple_paraview_cmake=$(dirname "$(find "$stipple_paraview_libraries/cmake" -name paraview-config.cmake)")
  export QT_PLUGIN_PATH="$stipple_paraview_libraries/qt5/plugins" # icons
  export LD_LIBRARY_PATH="$stipple_paraview_libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
}
