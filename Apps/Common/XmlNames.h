// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Names of arrays in VTK's XML files, which VTK 9.1 writes as they are: with an ampersand, a quote
// or bytes that are no text, its own reader cannot read the file.
#ifndef stipple_XmlNames_h
#define stipple_XmlNames_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;
class vtkPolyData;

namespace stipple
{
/// A name as it stands between quotes in an XML file: a reader finds it again. Bytes that are not
/// UTF-8, and control characters, become '?'.
[[nodiscard]] std::string xmlName(const std::string& name);

/// The data set, or a shallow copy of it whose arrays have such names.
[[nodiscard]] vtkSmartPointer<vtkPolyData> withXmlNames(vtkPolyData* data);
[[nodiscard]] vtkSmartPointer<vtkImageData> withXmlNames(vtkImageData* data);
}

#endif
