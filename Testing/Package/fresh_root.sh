#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# In a fresh Debian: installs the packages of a folder, and uses what they have as somebody would who has no sources.
#
#   sh fresh_root.sh PACKAGES
set -eu
export DEBIAN_FRONTEND=noninteractive
packages=$1
work=$(mktemp -d)
trap 'echo "fresh_root.sh: FAILED (see above)" >&2' EXIT

quietly()
{
  "$@" >"$work/log" 2>&1 || { tail -n 40 "$work/log"; return 1; }
}

# have WHAT PATTERN COMMAND...: what the command prints has the pattern.
have()
{
  what=$1
  pattern=$2
  shift 2
  "$@" >"$work/seen" 2>&1 || { echo "$what: '$*' failed:"; cat "$work/seen"; return 1; }
  grep -q -e "$pattern" "$work/seen" || { echo "$what: no '$pattern' in:"; head -n 40 "$work/seen"; return 1; }
  echo "ok: $what"
}

# All of Stipple at once, with what it recommends, as Debian's defaults have it.
start=$(date +%s)
quietly apt-get install -y "$packages"/*.deb
echo "ok: installed ($(($(date +%s) - start)) s)"
quietly dpkg --configure --pending
have "nothing is half-installed" "^$" sh -c 'echo; dpkg --audit'
# Who reads man pages, completions and desktop files; and a compiler.
quietly apt-get install -y --no-install-recommends \
  bash-completion desktop-file-utils man-db shared-mime-info zsh cmake g++ ninja-build file

cd "$work"
printf 'OFF\n8 12 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n' >cube.off
for t in "0 2 1" "1 2 3" "4 5 6" "5 7 6" "0 1 4" "1 5 4" "2 6 3" "3 6 7" "0 4 2" "2 4 6" "1 3 5" "3 7 5"; do
  echo "3 $t" >>cube.off
done
have "versions" "^stipple [0-9]" stipple --version
have "a renderer without a display" "OpenGL renderer: .*(.*)" stipple --version
stipple cube.off -o cube.ply --points 500 --picture cube.png
have "a remeshed cube" "element vertex 500" head -c 400 cube.ply
have "a picture" "PNG image" file cube.png
have "the window's program" "^usage: stipple-view" stipple-view --help

cat >remesh.py <<'END'
import numpy, stipple
points, triangles = stipple.remesh(([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]), 200)
print(points.shape, stipple.quality((points, triangles))["euler"])
END
have "Python" "^(200, 3) 2$" python3 remesh.py
have "Python's modules are compiled" "pyc$" sh -c 'ls /usr/lib/python3/dist-packages/stipple/__pycache__'

for program in stipple stipple-view; do
  have "man $program" "$program - remesh" env MANPAGER=cat man $program
  have "bash completes $program" "^$program: --version$" bash -c '
    . /usr/share/bash-completion/bash_completion
    _completion_loader "$1"
    COMP_WORDS=("$1" --versi) COMP_CWORD=1
    "_${1//-/_}"
    echo "$1: ${COMPREPLY[*]}"' bash $program
  have "zsh completes $program" "^_$program$" zsh -c "autoload -Uz compinit; compinit -D -u; print \$_comps[$program]"
done
have "whatis" "number of points" whatis stipple
have "the desktop file" "^$" sh -c 'echo; desktop-file-validate /usr/share/applications/stipple-view.desktop'
quietly dpkg-trigger --no-await /usr/share/mime/packages
quietly dpkg --configure --pending
have "MIME types" ":model/x-ply:\*.ply" cat /usr/share/mime/globs2
have "what opens them" "^model/x-ply=stipple-view.desktop" cat /usr/share/applications/mimeinfo.cache
have "the icon" "<svg" cat /usr/share/icons/hicolor/scalable/apps/stipple.svg
have "documents" "Stipple" cat /usr/share/doc/stipple-doc/README.md
have "pages of the classes" "vtkGeometryRemesher" ls /usr/share/doc/stipple-doc/html

# C++: README's example, where find_package() finds the package by itself.
mkdir example example/out
for language in cpp cmake; do
  sed -n "/^\`\`\`$language\$/,/^\`\`\`\$/p" /tests/README.md | sed '1d;$d' >example/$language
done
mv example/cpp example/main.cxx
mv example/cmake example/CMakeLists.txt
quietly cmake -S example -B example/build -G Ninja
quietly cmake --build example/build
stipple cube.off -o example/out/bunny.ply --points 3000
(cd example && build/example)
have "C++" "element vertex 2000" head -c 400 example/bunny-cxx.ply

quietly apt-get purge -y stipple "^libstipple0" python3-stipple libstipple-dev stipple-doc
find / -xdev \( -path /proc -o -path /packages -o -path /tests -o -path /var/cache/man -o -path "$work" \) -prune -o -iname "*stipple*" -print >"$work/left"
[ ! -s "$work/left" ] || { echo "left after a purge:"; cat "$work/left"; exit 1; }
echo "ok: nothing is left"
trap - EXIT
