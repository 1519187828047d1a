# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Remeshes, and says which of Stipple's libraries this process has."""
from common import count, say
from paraview import simple

remesher = simple.GeometryRemesher(Input=simple.Sphere(), NumberOfPoints=500)
remesher.UpdatePipeline()
with open("/proc/self/maps", encoding="ascii") as file:
    libraries = {line.split(maxsplit=5)[-1].strip() for line in file if "Stipple" in line}
say([count(remesher), sorted(libraries)])
