// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockOutput.h"

#include "BlockStorage.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace stipple
{
namespace
{
/// A question for the arrays of a place.
struct Question
{
  BlockPlace place;
  int isTriangle = 0;
};

/// Answers: a point a question, and a cell. Arrays of points of those for points, of cells of the
/// others.
vtkSmartPointer<vtkPolyData> answer(
  const SurfaceBlocks& blocks, const std::vector<Question>& questions)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdTypeArray> source;
  source->SetName("SourceCellId");
  vtkNew<vtkIdList> corners;
  const auto n = static_cast<vtkIdType>(questions.size());
  points->SetNumberOfPoints(n);
  source->SetNumberOfTuples(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    points->SetPoint(i, 0., 0., 0.);
    cells->InsertNextCell(1, &i);
  }
  bool isFirst = true;
  for (const SurfaceBlock& own : blocks.own)
  {
    std::vector<vtkIdType> ofBlock;
    for (vtkIdType i = 0; i < n; ++i)
    {
      if (questions[static_cast<std::size_t>(i)].place.block == own.number)
      {
        ofBlock.push_back(i);
      }
    }
    if (ofBlock.empty())
    {
      continue;
    }
    const BlockInMemory block(own);
    vtkPointData* from = block->data->GetPointData();
    if (isFirst)
    {
      result->GetPointData()->CopyAllOn();
      result->GetPointData()->InterpolateAllocate(from, n);
      result->GetCellData()->CopyAllOn();
      result->GetCellData()->CopyAllocate(block->data->GetCellData(), n);
      isFirst = false;
    }
    for (const vtkIdType i : ofBlock)
    {
      const BlockPlace& place = questions[static_cast<std::size_t>(i)].place;
      block->data->GetPolys()->GetCellAtId(place.triangle, corners);
      std::array<double, 3> bary = place.bary;
      result->GetPointData()->InterpolatePoint(from, i, corners, bary.data());
      // Integers are the nearest corner's.
      std::array<Vec3, 3> corner;
      for (int k = 0; k < 3; ++k)
      {
        block->data->GetPoint(corners->GetId(k), corner[k].data());
      }
      const int nearest = nearestCorner(Vec3(bary.data()), corner[0], corner[1], corner[2]);
      for (int a = 0; a < result->GetPointData()->GetNumberOfArrays(); ++a)
      {
        vtkAbstractArray* array = result->GetPointData()->GetAbstractArray(a);
        vtkAbstractArray* given = from->GetAbstractArray(array->GetName());
        if (given && array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE)
        {
          array->SetTuple(i, corners->GetId(nearest), given);
        }
      }
      result->GetCellData()->CopyData(block->data->GetCellData(), place.triangle, i);
      source->SetValue(i, block->cellId[static_cast<std::size_t>(place.triangle)]);
    }
  }
  result->SetPoints(points);
  result->SetVerts(cells);
  if (!questions.empty())
  {
    result->GetPointData()->AddArray(source);
  }
  return result;
}

/// Takes a tuple over from the array of that name.
void copyTuple(vtkDataSetAttributes* from, vtkIdType i, vtkDataSetAttributes* to, vtkIdType at)
{
  for (int a = 0; a < to->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = to->GetAbstractArray(a);
    if (vtkAbstractArray* given = from->GetAbstractArray(array->GetName()))
    {
      array->SetTuple(at, i, given);
    }
  }
}

/// Empty arrays like those of a block's surface, of so many tuples.
void prepare(vtkDataSetAttributes* like, vtkIdType tuples, vtkDataSetAttributes* to)
{
  for (int a = 0; a < like->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = like->GetAbstractArray(a);
    if (!array->GetName())
    {
      continue;
    }
    auto own = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
    own->SetName(array->GetName());
    own->SetNumberOfComponents(array->GetNumberOfComponents());
    own->SetNumberOfTuples(tuples);
    to->AddArray(own);
  }
}
}

Status writeBlocks(const SurfaceBlocks& blocks, std::vector<BlockMesh>& meshes,
  const RankMessages& ranks, vtkPartitionedDataSet* output)
{
  // Ask for what the remesher does not know.
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<Question>> questions(size);
  struct Asked
  {
    std::size_t rank;
    vtkIdType number;
  };
  std::vector<std::vector<Asked>> ofPoints(meshes.size());
  std::vector<std::vector<Asked>> ofTriangles(meshes.size());
  const auto ask = [&](const BlockPlace& place, bool isTriangle) {
    const auto rank = static_cast<std::size_t>(blocks.rankOf(place.block, ranks.size()));
    questions[rank].push_back({ place, isTriangle ? 1 : 0 });
    return Asked{ rank, static_cast<vtkIdType>(questions[rank].size()) - 1 };
  };
  std::vector<std::vector<int>> used(meshes.size()); // points, ascending ids
  for (std::size_t b = 0; b < meshes.size(); ++b)
  {
    const BlockMesh& mesh = meshes[b];
    std::vector<char> isUsed(mesh.id.size(), 0);
    for (const auto& t : mesh.triangles)
    {
      isUsed[t[0]] = isUsed[t[1]] = isUsed[t[2]] = 1;
    }
    for (std::size_t p = 0; p < mesh.id.size(); ++p)
    {
      if (isUsed[p] != 0)
      {
        used[b].push_back(static_cast<int>(p));
      }
    }
    std::sort(
      used[b].begin(), used[b].end(), [&](int p, int q) { return mesh.id[p] < mesh.id[q]; });
    for (const int p : used[b])
    {
      ofPoints[b].push_back(mesh.data[p] < 0 ? ask(mesh.place[p], false) : Asked{ 0, -1 });
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      ofTriangles[b].push_back(
        mesh.triangleData[t] < 0 ? ask(mesh.trianglePlace[t], true) : Asked{ 0, -1 });
    }
  }
  std::vector<Bytes> messages;
  for (const std::vector<Question>& list : questions)
  {
    messages.push_back(RankMessages::bytesOf(list));
  }
  std::vector<Bytes> replies;
  for (const Bytes& asked : ranks.exchange(std::move(messages)))
  {
    std::vector<Question> list;
    RankMessages::append(asked, list);
    vtkNew<vtkCharArray> packed;
    if (!list.empty())
    {
      vtkCommunicator::MarshalDataObject(answer(blocks, list), packed);
    }
    replies.emplace_back(
      packed->GetPointer(0), packed->GetPointer(0) + packed->GetNumberOfValues());
  }
  std::vector<vtkSmartPointer<vtkPolyData>> answers;
  for (const Bytes& reply : ranks.exchange(std::move(replies)))
  {
    vtkNew<vtkCharArray> packed;
    packed->SetNumberOfValues(static_cast<vtkIdType>(reply.size()));
    std::copy(reply.begin(), reply.end(), packed->GetPointer(0));
    answers.push_back(reply.empty()
        ? nullptr
        : vtkPolyData::SafeDownCast(vtkCommunicator::UnMarshalDataObject(packed)));
  }

  output->SetNumberOfPartitions(static_cast<unsigned int>(blocks.count));
  for (std::size_t b = 0; b < meshes.size(); ++b)
  {
    const BlockMesh& mesh = meshes[b];
    const BlockInMemory block(blocks.own[b]);
    vtkPolyData* surface = block->data;
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("GlobalPointIds");
    prepare(surface->GetPointData(), static_cast<vtkIdType>(used[b].size()), data->GetPointData());
    vtkNew<vtkIdTypeArray> source;
    source->SetName("SourceCellId");
    source->SetNumberOfTuples(static_cast<vtkIdType>(used[b].size()));
    data->GetPointData()->AddArray(source);
    std::vector<vtkIdType> newId(mesh.id.size(), -1);
    for (std::size_t i = 0; i < used[b].size(); ++i)
    {
      const int p = used[b][i];
      newId[p] = points->InsertNextPoint(mesh.position[p].data());
      ids->InsertNextValue(static_cast<vtkIdType>(mesh.id[p]));
      const Asked& asked = ofPoints[b][i];
      const bool isOwn = asked.number < 0;
      copyTuple((isOwn ? mesh.arrays.Get() : answers[asked.rank].Get())->GetPointData(),
        isOwn ? mesh.data[p] : asked.number, data->GetPointData(), newId[p]);
    }
    vtkNew<vtkCellArray> cells;
    prepare(
      surface->GetCellData(), static_cast<vtkIdType>(mesh.triangles.size()), data->GetCellData());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      std::array<int, 3> t = mesh.triangles[i];
      std::rotate(t.begin(),
        std::min_element(t.begin(), t.end(), [&](int p, int q) { return mesh.id[p] < mesh.id[q]; }),
        t.end());
      const vtkIdType cell = cells->InsertNextCell({ newId[t[0]], newId[t[1]], newId[t[2]] });
      const Asked& asked = ofTriangles[b][i];
      const bool isOwn = asked.number < 0;
      copyTuple((isOwn ? mesh.arrays.Get() : answers[asked.rank].Get())->GetCellData(),
        isOwn ? mesh.triangleData[i] : asked.number, data->GetCellData(), cell);
    }
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetGlobalIds(ids);
    output->SetPartition(static_cast<unsigned int>(blocks.own[b].number), data);
  }
  return Status::success();
}
}
