// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_SurfaceShading_h
#define stipple_SurfaceShading_h

class vtkActor;

namespace stipple
{
/// The five lights of addLights() without highlights, which no surface here has: VTK works them out
/// for every pixel all the same, and that is half of a frame without graphics hardware.
void addPlainLight(vtkActor* actor);
}

#endif
