// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingLibrary.h"

#include <dlfcn.h>

#include <filesystem>

namespace stipple
{
namespace
{
using Entry = const DrawingLibrary* (*)();

struct Loaded
{
  const DrawingLibrary* library = nullptr;
  std::string problem;

  Loaded()
  {
    // By its name alone, and from here: it lies where this program's other libraries are found. Its
    // OpenGL is everyone's from now on, as if it were linked.
    void* handle = dlopen(STIPPLE_DRAWING_LIBRARY, RTLD_NOW | RTLD_GLOBAL);
    const auto entry = handle ? reinterpret_cast<Entry>(dlsym(handle, "stippleDrawing")) : nullptr;
    if (entry)
    {
      this->library = entry();
      return;
    }
    const char* why = dlerror();
    this->problem = std::string("cannot load " STIPPLE_DRAWING_LIBRARY
                                ", or there is not enough memory for it: ") +
      (why ? why : "it is another one");
  }
};

/// Whether there may be graphics hardware, which is seen without loading anything.
bool mayHaveGraphicsHardware()
{
#ifdef __linux__
  // Direct rendering, NVIDIA's own driver, Windows' below WSL.
  for (const char* device : { "/dev/dri", "/dev/nvidiactl", "/dev/dxg" })
  {
    std::error_code code;
    if (std::filesystem::exists(device, code))
    {
      return true;
    }
  }
  return false;
#else
  return true;
#endif
}
}

Status loadDrawing(const DrawingLibrary*& library)
{
  static const Loaded loaded;
  library = loaded.library;
  return library ? Status::success() : Status::error(loaded.problem);
}

Status loadDrawingForMaps(const std::string& backend)
{
  if (backend == "opengl" || (backend != "cpu" && mayHaveGraphicsHardware()))
  {
    const DrawingLibrary* library = nullptr;
    if (Status status = loadDrawing(library); !status.ok() && backend == "opengl")
    {
      return status; // else the maps are the CPU's
    }
  }
  return Status::success();
}
}
