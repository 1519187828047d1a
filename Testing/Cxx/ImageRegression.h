// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Strict comparison of a picture with Testing/Data/Baseline/NAME.png. VTK's own comparison forgives
// shifts and averages neighbours, which makes it nearly blind to meshes: here every pixel counts
// for itself.
//
// The driver's arguments say where: -D the data folder, -T the folder for what failed. A failing
// picture is left there as NAME.png, with NAME.diff.png. With STIPPLE_WRITE_BASELINES set in the
// environment, the picture becomes the baseline.
#ifndef ImageRegression_h
#define ImageRegression_h

#include "vtkImageData.h"
#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWindowToImageFilter.h"

#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

namespace test
{
inline std::string argument(int argc, char* argv[], const char* name, const char* otherwise)
{
  for (int k = 1; k + 1 < argc; ++k)
  {
    if (std::strcmp(argv[k], name) == 0)
    {
      return argv[k + 1];
    }
  }
  return otherwise;
}

inline bool writePicture(vtkImageData* image, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

/// True if the RGB image is the baseline, but for differences of at most 16 of 255 in a channel.
inline bool comparePicture(vtkImageData* image, const std::string& name, int argc, char* argv[])
{
  const std::string folder = argument(argc, argv, "-T", ".");
  const std::string baseline =
    argument(argc, argv, "-D", ".") + std::string("/Baseline/") + name + ".png";
  if (std::getenv("STIPPLE_WRITE_BASELINES"))
  {
    return writePicture(image, baseline);
  }
  vtksys::SystemTools::MakeDirectory(folder);
  const std::string failed = folder + "/" + name + ".png";
  if (!vtksys::SystemTools::FileExists(baseline, true))
  {
    writePicture(image, failed);
    std::cerr << name << ": there is no baseline " << baseline << "; the picture is " << failed
              << "\n";
    return false;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(baseline.c_str());
  reader->Update();
  const int* size = image->GetDimensions();
  const int* wanted = reader->GetOutput()->GetDimensions();
  if (size[0] != wanted[0] || size[1] != wanted[1] ||
    image->GetNumberOfScalarComponents() != reader->GetOutput()->GetNumberOfScalarComponents())
  {
    writePicture(image, failed);
    std::cerr << name
              << ": the size or the number of channels differs from the baseline; the picture is "
              << failed << "\n";
    return false;
  }
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(image);
  difference->SetImageConnection(reader->GetOutputPort());
  difference->AllowShiftOff();
  difference->AveragingOff();
  difference->SetThreshold(16);
  difference->Update();
  if (difference->GetThresholdedError() > 0.)
  {
    writePicture(image, failed);
    writePicture(difference->GetOutput(), folder + "/" + name + ".diff.png");
    std::cerr << name << ": differs from the baseline by " << difference->GetThresholdedError()
              << "; the picture is " << failed << "\n";
    return false;
  }
  return true;
}

inline vtkSmartPointer<vtkImageData> takePicture(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->ReadFrontBufferOff();
  filter->Update();
  return filter->GetOutput();
}

inline bool compareWindow(vtkRenderWindow* window, const std::string& name, int argc, char* argv[])
{
  return comparePicture(takePicture(window), name, argc, argv);
}
} // namespace test

#endif
