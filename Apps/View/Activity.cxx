// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Activity.h"

#include "MessageText.h"
#include "SamplingConstants.h"
#include "SceneActors.h"

#include <tuple>

namespace stipple
{
bool Activity::works() const
{
  return this->showsBar() || this->mesh == Mesh::Waiting;
}

std::string Activity::note() const
{
  return this->mesh == Mesh::Current ? "" : (this->works() ? "updating ..." : "not up to date");
}

std::string Activity::sampleNote() const
{
  return this->sampleProblem.empty() && (this->samples || this->works()) ? "sampling ..."
                                                                         : "no samples";
}

bool Activity::alarms() const
{
  return this->mesh == Mesh::Failed || !this->sampleProblem.empty();
}

std::string Activity::sentence() const
{
  if (this->mesh == Mesh::Failed)
  {
    return this->meshProblem;
  }
  if (!this->sampleProblem.empty())
  {
    return this->sampleProblem;
  }
  if (!this->reading.empty())
  {
    return "Reading " + this->reading + " ...; Esc gives it up.";
  }
  if (this->savesMesh && this->works())
  {
    return this->meshPath + " will be written when the mesh is done.";
  }
  const std::string makes = "Return makes the mesh" +
    (this->savesMesh ? " and writes " + this->meshFile : std::string()) + ".";
  switch (this->mesh)
  {
    case Mesh::Charts:
      return "Cutting into charts; Esc stops it.";
    case Mesh::Making:
      return this->tried > 0
        ? "Trying " + grouped(this->tried) + " points for the distance; Esc stops it."
        : this->byLevels
        ? "Meshing some " + numberText(twoDigits(this->points)) + " points; Esc stops it."
        : "Meshing; Esc stops it.";
    case Mesh::Asks:
      return (this->byLevels ? "So many levels make some " : "Edges so short take some ") +
        numberText(twoDigits(this->points)) + " points" +
        (this->points > SamplingConstants::MostSamples
            ? ": there can be " + grouped(SamplingConstants::MostSamples) + "."
            : ". " + makes);
    case Mesh::Stopped:
      return "Stopped. " + makes;
    default:
      return this->sampling ? "Sampling ..." : "";
  }
}

bool Activity::operator==(const Activity& other) const
{
  const auto all = [](const Activity& a) {
    return std::tie(a.reading, a.mesh, a.points, a.byLevels, a.tried, a.progress, a.savesMesh,
      a.sampling, a.samples, a.meshFile, a.meshPath, a.sampleProblem, a.meshProblem);
  };
  return all(*this) == all(other);
}
}
