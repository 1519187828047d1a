# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the filters' libraries load: nothing that renders. Usage: test_links.py LIBRARY..."""
import os
import re
import subprocess
import sys

RENDERING = r"libvtk(Rendering|Interaction|Views|Charts|glew|glad)\w*|lib(GL\w*|EGL|OpenGL|OSMesa|X11|Stipple(Rendering|OSMesa)\w*)"


def rendering_libraries(library):
    """Those of them that the library loads, itself or through others."""
    lines = subprocess.run(["ldd", library], check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines()
    names = [os.path.basename(line.split()[0]) for line in lines if line.strip()]
    if not any(name.startswith("libvtkCommonCore") for name in names):
        sys.exit(f"ldd lists no VTK for {library}: {lines}")
    return [name for name in names if re.match(rf"({RENDERING})[-.]", name)]


filters = [library for library in sys.argv[1:] if "Filters" in os.path.basename(library)]
others = [library for library in sys.argv[1:] if library not in filters]
if len(filters) < 8 or not others:
    sys.exit(f"{len(filters)} libraries of filters and {len(others)} of rendering: too few")
failures = 0
for library in filters:
    if found := rendering_libraries(library):
        print(f"FAILED: {library} loads {', '.join(found)}")
        failures += 1
for library in others:  # the pattern finds what there is to find
    found = " ".join(rendering_libraries(library))
    if not all(name in found for name in ("libvtkRenderingOpenGL2", "libvtkRenderingCore", "libGL")):
        print(f"FAILED: {library} renders, but only {found} is seen")
        failures += 1
sys.exit(failures)
