// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SavedFiles.h"

#include "AtlasSurface.h"
#include "ChartsInOnePiece.h"
#include "MapPicture.h"
#include "MeshFile.h"
#include "Messages.h"
#include "OutputFiles.h"
#include "XmlNames.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPartitionedDataSetCollectionWriter.h"

#include <cstdio>
#include <filesystem>

namespace stipple
{
namespace
{
template <typename WriterT, typename DataT>
Status write(WriterT* writer, DataT* data, const std::string& now, const std::string& target)
{
  ErrorCollector errors(writer);
  writer->SetFileName(now.c_str());
  writer->SetInputData(data);
  writer->Write();
  return writer->GetErrorCode() == 0 && errors.first().empty() && std::filesystem::exists(now)
    ? Status::success()
    : Status::error("cannot write '" + target + "'");
}
}

Status saveCharts(
  vtkPartitionedDataSetCollection* charts, const std::string& file, OutputFiles& files)
{
  if (fileExtension(file) == ".vtp")
  {
    return writeMesh(chartsInOnePiece(charts), files.aside(file), file);
  }
  // The pieces go to a folder that is named like the file.
  const std::filesystem::path target = std::filesystem::absolute(file);
  std::string folder;
  if (Status status = files.asideFolder(target.parent_path().string(), folder); !status.ok())
  {
    return status;
  }
  vtkNew<vtkPartitionedDataSetCollection> named;
  for (unsigned int c = 0; c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    named->SetPartition(c, 0, withXmlNames(chartOf(charts, c)));
  }
  vtkNew<vtkXMLPartitionedDataSetCollectionWriter> writer;
  return write(writer.Get(), named.Get(), folder + "/" + target.filename().string(), file);
}

Status saveMaps(
  vtkPartitionedDataSetCollection* maps, const std::string& target, OutputFiles& files)
{
  std::string folder;
  Status status = files.asideFolder(target, folder);
  const std::vector<std::string> names = mapNames(maps);
  for (unsigned int c = 0; status.ok() && c < maps->GetNumberOfPartitionedDataSets(); ++c)
  {
    char chart[32];
    std::snprintf(chart, sizeof(chart), "chart%03u", c);
    auto* image = vtkImageData::SafeDownCast(maps->GetPartitionAsDataObject(c, 0));
    if (!image)
    {
      continue;
    }
    vtkNew<vtkXMLImageDataWriter> writer;
    status = write(writer.Get(), withXmlNames(image).Get(), folder + "/" + chart + ".vti", target);
    for (std::size_t i = 0; status.ok() && i < names.size(); ++i)
    {
      std::string file = std::string(chart) + "_" + names[i] + ".png";
      for (char& letter : file)
      {
        letter = letter == '/' ? '_' : letter; // an array of the input may have any name
      }
      if (const vtkSmartPointer<vtkImageData> picture =
            mapPicture(maps, static_cast<int>(c), names[i]))
      {
        vtkNew<vtkPNGWriter> png;
        status = write(png.Get(), picture.Get(), folder + "/" + file, target);
      }
    }
  }
  return status;
}

Status saveSamples(vtkPolyData* samples, const std::string& file, OutputFiles& files)
{
  return writeMesh(samples, files.aside(file), file);
}
}
