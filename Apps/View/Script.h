// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Interaction from files: vtkInteractorEventRecorder's format, written and played.
#ifndef stipple_Script_h
#define stipple_Script_h

#include "Progress.h"

#include <string>

class vtkInteractorEventRecorder;
class vtkRenderWindowInteractor;

namespace stipple
{
class Application;

/// Plays the pointer's and the keys' events of a recording, each followed by a turn of the loop,
/// and waits for what follows from them.
[[nodiscard]] Status playEvents(Application& application, const std::string& file);
}

#endif
