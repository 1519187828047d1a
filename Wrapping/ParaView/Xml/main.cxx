// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// StippleServerManagerXml TEMPLATE OUTPUT: ParaView's description of the filters. For tests: with
// --dummy behind, the table of options has one more row; --table alone prints it.
#include "DummyRow.h"
#include "OptionTable.h"
#include "ServerManagerXml.h"

#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  const std::string last = argv[argc - 1];
  if (argc == 2 && last == "--table")
  {
    std::cout << stipple::optionTableText();
    return 0;
  }
  if (argc == 4 && last == "--dummy")
  {
    addDummyRow();
  }
  else if (argc != 3)
  {
    std::cerr << "usage: StippleServerManagerXml TEMPLATE OUTPUT\n";
    return 2;
  }
  const auto tree = vtk::TakeSmartPointer(vtkXMLUtilities::ReadElementFromFile(argv[1]));
  if (!tree)
  {
    std::cerr << "cannot read " << argv[1] << "\n";
    return 1;
  }
  const stipple::Status status = stipple::makeServerManagerXml(tree);
  if (!status.ok())
  {
    std::cerr << argv[1] << ": " << status.message() << "\n";
    return 1;
  }
  const vtkIndent indent;
  if (!vtkXMLUtilities::WriteElementToFile(tree, argv[2], &const_cast<vtkIndent&>(indent)))
  {
    std::cerr << "cannot write " << argv[2] << "\n";
    return 1;
  }
  return 0;
}
