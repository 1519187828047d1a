// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPGeometryRemesher on the ranks of mpiexec, each with its piece of a torus, but for the last
// rank, which has none if there are three or more.
#include "Check.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPGeometryRemesher.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
constexpr int Sides = 60;
constexpr int Rings = 30;

/// The quads from ring to ring of a torus; part of so many.
vtkSmartPointer<vtkPolyData> pieceOfTorus(int part, int parts)
{
  auto piece = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  const int first = Sides * part / parts;
  const int last = Sides * (part + 1) / parts;
  for (int i = first; i <= last; ++i)
  {
    for (int j = 0; j < Rings; ++j)
    {
      const double u = 2. * 3.14159265358979 * (i % Sides) / Sides;
      const double v = 2. * 3.14159265358979 * j / Rings;
      const double r = 2. + 0.7 * std::cos(v);
      points->InsertNextPoint(r * std::cos(u), r * std::sin(u), 0.7 * std::sin(v));
    }
  }
  for (int i = 0; i < last - first; ++i)
  {
    for (int j = 0; j < Rings; ++j)
    {
      const int k = (j + 1) % Rings;
      cells->InsertNextCell(
        { i * Rings + j, (i + 1) * Rings + j, (i + 1) * Rings + k, i * Rings + k });
    }
  }
  piece->SetPoints(points);
  piece->SetPolys(cells);
  return piece;
}

void keepError(vtkObject*, unsigned long, void* text, void* said)
{
  *static_cast<std::string*>(text) += static_cast<const char*>(said);
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  const int rank = controller->GetLocalProcessId();
  const int ranks = controller->GetNumberOfProcesses();
  {
    constexpr int Points = 700;
    const int parts = ranks > 2 ? ranks - 1 : ranks;
    vtkSmartPointer<vtkPolyData> piece =
      rank < parts ? pieceOfTorus(rank, parts) : vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPGeometryRemesher> remesher;
    test::check(remesher->GetController() == controller, "the global controller is the default");
    std::string error;
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(keepError);
    observer->SetClientData(&error);
    remesher->AddObserver(vtkCommand::ErrorEvent, observer);
    remesher->SetInputDataObject(piece);
    remesher->SetNumberOfPoints(Points);
    remesher->SetTrianglesPerBlock(900);
    remesher->Update();
    test::check(error.empty(), error);
    test::check(remesher->GetNumberOfBlocks() == 4, "3,600 triangles are four blocks");
    std::vector<int> count(Points + 1, 0); // points by id, and triangles
    auto* mesh = vtkPartitionedDataSet::SafeDownCast(remesher->GetOutputDataObject(0));
    int blocks = 0;
    for (unsigned int b = 0; b < mesh->GetNumberOfPartitions(); ++b)
    {
      auto* block = vtkPolyData::SafeDownCast(mesh->GetPartitionAsDataObject(b));
      if (!block)
      {
        continue;
      }
      ++blocks;
      count[Points] += static_cast<int>(block->GetNumberOfPolys());
      vtkDataArray* ids = block->GetPointData()->GetGlobalIds();
      for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
      {
        const int id = static_cast<int>(ids->GetComponent(p, 0));
        if (test::check(id >= 0 && id < Points, "ids are below the number of points"))
        {
          count[id] = 1;
        }
      }
    }
    std::vector<int> all(count.size(), 0);
    controller->AllReduce(
      count.data(), all.data(), static_cast<vtkIdType>(count.size()), vtkCommunicator::SUM_OP);
    int used = 0;
    for (int id = 0; id < Points; ++id)
    {
      used += all[id] > 0 ? 1 : 0;
    }
    test::check(used == Points, "all points are used");
    test::check(all[Points] == 2 * Points, "a torus has two triangles a point");
    test::check(ranks > 4 || blocks > 0, "each rank has a block");
    auto* borders = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(1));
    test::check((borders->GetNumberOfLines() > 0) == (rank == 0), "the first rank has the borders");

    // With ghost cells each partition has all triangles at its own points.
    if (ranks > 1)
    {
      remesher->UpdatePiece(rank, ranks, 1); // as a filter behind it asks for neighbours
    }
    else // the pipeline asks for none, as it has all there is
    {
      remesher->SetMinimumNumberOfGhostLevels(1);
      remesher->Update();
    }
    mesh = vtkPartitionedDataSet::SafeDownCast(remesher->GetOutputDataObject(0));
    std::vector<int> trianglesAt(Points, 0); // without ghosts
    std::vector<int> isOwned(Points, 0);     // by how many partitions
    const auto visit = [&](bool withGhosts, const auto& seen) {
      for (unsigned int b = 0; b < mesh->GetNumberOfPartitions(); ++b)
      {
        auto* block = vtkPolyData::SafeDownCast(mesh->GetPartitionAsDataObject(b));
        for (vtkIdType t = 0; block && t < block->GetNumberOfPolys(); ++t)
        {
          if (withGhosts || block->GetCellGhostArray()->GetValue(t) == 0)
          {
            seen(block, t);
          }
        }
      }
    };
    const auto idsOf = [](vtkPolyData* block, vtkIdType t) {
      vtkNew<vtkIdList> corners;
      block->GetPolys()->GetCellAtId(t, corners);
      std::array<int, 3> ids = {};
      for (int k = 0; k < 3; ++k)
      {
        ids[k] = static_cast<int>(
          block->GetPointData()->GetGlobalIds()->GetComponent(corners->GetId(k), 0));
      }
      return ids;
    };
    visit(false, [&](vtkPolyData* block, vtkIdType t) {
      for (const int id : idsOf(block, t))
      {
        ++trianglesAt[id];
      }
    });
    std::vector<std::map<int, int>> trianglesHere; // by partition and id
    const vtkPolyData* last = nullptr;
    std::vector<std::set<int>> own;
    visit(true, [&](vtkPolyData* block, vtkIdType t) {
      if (block != last)
      {
        last = block;
        trianglesHere.emplace_back();
        own.emplace_back();
        vtkDataArray* ids = block->GetPointData()->GetGlobalIds();
        for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
        {
          isOwned[static_cast<int>(ids->GetComponent(p, 0))] +=
            block->GetPointGhostArray()->GetValue(p) == 0 ? 1 : 0;
        }
      }
      for (const int id : idsOf(block, t))
      {
        ++trianglesHere.back()[id];
        if (block->GetCellGhostArray()->GetValue(t) == 0)
        {
          own.back().insert(id);
        }
      }
    });
    std::vector<int> sum(Points, 0);
    controller->AllReduce(trianglesAt.data(), sum.data(), Points, vtkCommunicator::SUM_OP);
    for (std::size_t b = 0; b < own.size(); ++b)
    {
      for (const int id : own[b])
      {
        test::check(trianglesHere[b][id] == sum[id],
          "point " + std::to_string(id) + " has " + std::to_string(trianglesHere[b][id]) +
            " triangles of " + std::to_string(sum[id]));
      }
    }
    controller->AllReduce(isOwned.data(), sum.data(), Points, vtkCommunicator::SUM_OP);
    test::check(
      std::count(sum.begin(), sum.end(), 1) == Points, "each point is no ghost in one partition");

    // One rank's piece is broken: all ranks hear it, and have nothing.
    if (rank == parts - 1)
    {
      piece->GetPoints()->SetPoint(3, std::nan(""), 0., 0.);
      piece->GetPoints()->Modified();
      piece->Modified();
    }
    remesher->SetNumberOfPoints(Points + 1);
    remesher->Update();
    test::check(error.find("is not finite") != std::string::npos, "the sentence: " + error);
    mesh = vtkPartitionedDataSet::SafeDownCast(remesher->GetOutputDataObject(0));
    test::check(mesh->GetNumberOfPartitions() == 0, "the output is empty");
  }
  const int own = test::failures;
  int failures = 0;
  controller->AllReduce(&own, &failures, 1, vtkCommunicator::SUM_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
