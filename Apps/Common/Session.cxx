// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

namespace stipple
{
bool Session::operator==(const Session& o) const
{
  return this->model == o.model && this->points == o.points && this->importance == o.importance &&
    this->importanceArray == o.importanceArray && this->importanceImage == o.importanceImage &&
    this->imageProjection == o.imageProjection && this->bandPass == o.bandPass &&
    this->strokes == o.strokes && this->gamma == o.gamma && this->transfer == o.transfer &&
    this->gradation == o.gradation && this->minimumDensity == o.minimumDensity &&
    this->featureAngle == o.featureAngle && this->charts == o.charts &&
    this->featureEdges == o.featureEdges && this->constraints == o.constraints;
}

const std::vector<std::string>& importanceNames()
{
  static const std::vector<std::string> names = { "uniform", "mean", "gaussian", "minimum",
    "maximum", "total", "l2", "image", "array" };
  return names;
}

const std::vector<std::string>& imageProjectionNames()
{
  static const std::vector<std::string> names = { "chart", "x", "y", "z" };
  return names;
}
}
