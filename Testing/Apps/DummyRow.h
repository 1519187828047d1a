// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One more row for the table of options, for tests of what is made of the table: a second gamma.
#ifndef DummyRow_h
#define DummyRow_h

#include "OptionTable.h"

inline void addDummyRow()
{
  stipple::Option dummy = *stipple::findOption("gamma");
  dummy.group = stipple::Option::Group::Mesh;
  dummy.name = "dummy_power";
  dummy.argument = "P";
  dummy.help = "what no one needs";
  dummy.unit = "dummies";
  dummy.high = 7.5;
  dummy.initial = 1.25;
  stipple::optionTable().push_back(dummy);
}

#endif
