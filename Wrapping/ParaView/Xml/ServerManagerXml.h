// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// ParaView's description of the filters, from a template and the table of options.
#ifndef stipple_ServerManagerXml_h
#define stipple_ServerManagerXml_h

#include "Progress.h"

class vtkXMLDataElement;

namespace stipple
{
/// Puts ParaView's properties in the places of a template's elements:
///
/// - <Option name="gamma"/>: the property of that option. What else stands there, attributes and
///   elements, goes to the property; but `max` is where a slider ends, and `arrays` the domain of
///   Input that lists arrays for a text.
/// - <Rest group="sampling"/>: those of the group's options that the proxy has nowhere else, as
///   advanced ones, so that a new row of the table is in ParaView, too.
/// - <Stage class="vtkControlMap"/>: the same of the options of a class.
/// - <Without option="preset"/>: the proxy has not that one.
/// - <Group label="Features">: properties and their group. Its other attributes go to the group.
///
/// A property is named as the class's property, or as the option where two would have one name. A
/// proxy with options="by name" has them set by vtkPVSurfaceAlgorithm, so has one with
/// options="of blocks", whose table is that of blocks; one with options="by setter" by the class's
/// own methods.
Status makeServerManagerXml(vtkXMLDataElement* tree);
}

#endif
