// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockGhosts.h"

#include "SurfaceBlocks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace stipple
{
namespace
{
using Corners = std::array<vtkIdType, 3>;

Corners cornersOf(vtkPolyData* data, vtkIdType triangle)
{
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  data->GetPolys()->GetCellAtId(triangle, size, points);
  return { { points[0], points[1], points[2] } };
}

std::vector<long long> globalIds(vtkPolyData* data)
{
  std::vector<long long> ids;
  vtkDataArray* array = data->GetPointData()->GetGlobalIds();
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    ids.push_back(static_cast<long long>(array->GetComponent(p, 0)));
  }
  return ids;
}

/// Some of a partition's triangles, with their points and all arrays.
vtkSmartPointer<vtkPolyData> extract(vtkPolyData* from, const std::set<vtkIdType>& triangles)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  part->GetPointData()->CopyAllOn();
  part->GetPointData()->CopyAllocate(from->GetPointData());
  part->GetCellData()->CopyAllOn();
  part->GetCellData()->CopyAllocate(from->GetCellData());
  std::unordered_map<vtkIdType, vtkIdType> newId;
  for (const vtkIdType t : triangles)
  {
    Corners corners = cornersOf(from, t);
    for (vtkIdType& p : corners)
    {
      const auto [found, isNew] = newId.try_emplace(p, points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(from->GetPoint(p));
        part->GetPointData()->CopyData(from->GetPointData(), p, found->second);
      }
      p = found->second;
    }
    const vtkIdType cell = cells->InsertNextCell(3, corners.data());
    part->GetCellData()->CopyData(from->GetCellData(), t, cell);
  }
  part->SetPoints(points);
  part->SetPolys(cells);
  return part;
}

/// Behind the tuples of each array that of the same name.
void appendTuple(vtkDataSetAttributes* from, vtkIdType i, vtkDataSetAttributes* to)
{
  for (int a = 0; a < to->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = to->GetAbstractArray(a);
    array->InsertNextTuple(i, from->GetAbstractArray(array->GetName()));
  }
}

/// One of this rank's partitions.
class Part
{
public:
  Part(int number, vtkPolyData* data)
    : Number(number)
    , Data(data)
    , NumberOfOwnPoints(data->GetNumberOfPoints())
    , NumberOfOwnTriangles(data->GetNumberOfPolys())
    , Own(globalIds(data))
    , About(Own.size())
    , IsElsewhere(Own.size(), 0)
  {
    for (vtkIdType p = 0; p < this->NumberOfOwnPoints; ++p)
    {
      this->PointOf.emplace(this->Own[static_cast<std::size_t>(p)], p);
    }
    for (vtkIdType t = 0; t < this->NumberOfOwnTriangles; ++t)
    {
      for (const vtkIdType p : cornersOf(data, t))
      {
        this->About[static_cast<std::size_t>(p)].push_back(t);
      }
    }
  }

  int number() const { return this->Number; }
  const std::vector<long long>& ownIds() const { return this->Own; }

  /// Of points at whose triangles this partition's end: ends of edges of one triangle.
  std::vector<long long> rim() const
  {
    std::map<std::pair<long long, long long>, int> trianglesOf;
    for (vtkIdType t = 0; t < this->NumberOfOwnTriangles; ++t)
    {
      const Corners c = cornersOf(this->Data, t);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto ends = std::minmax({ this->idOf(c[k]), this->idOf(c[(k + 1) % 3]) });
        ++trianglesOf[{ ends.first, ends.second }];
      }
    }
    std::set<long long> ids;
    for (const auto& [ends, triangles] : trianglesOf)
    {
      if (triangles == 1)
      {
        ids.insert({ ends.first, ends.second });
      }
    }
    return { ids.begin(), ids.end() };
  }

  /// Adds own triangles about a point to those that another partition has not been given yet.
  void findAbout(long long id, int other, std::set<vtkIdType>& triangles)
  {
    const auto found = this->PointOf.find(id);
    if (found != this->PointOf.end() && found->second < this->NumberOfOwnPoints)
    {
      for (const vtkIdType t : this->About[static_cast<std::size_t>(found->second)])
      {
        if (this->Given[other].insert(t).second)
        {
          triangles.insert(t);
        }
      }
    }
  }
  vtkSmartPointer<vtkPolyData> extracted(const std::set<vtkIdType>& triangles) const
  {
    return extract(this->Data, triangles);
  }

  /// Puts another partition's triangles behind the others; answers which points are new.
  std::vector<long long> append(int other, vtkPolyData* ghosts)
  {
    std::vector<long long> added;
    const std::vector<long long> ids = globalIds(ghosts);
    std::vector<vtkIdType> here;
    for (std::size_t p = 0; p < ids.size(); ++p)
    {
      const auto [found, isNew] =
        this->PointOf.try_emplace(ids[p], this->Data->GetNumberOfPoints());
      if (isNew)
      {
        const auto at = static_cast<vtkIdType>(p);
        this->Data->GetPoints()->InsertNextPoint(ghosts->GetPoint(at));
        appendTuple(ghosts->GetPointData(), at, this->Data->GetPointData());
        added.push_back(ids[p]);
      }
      else if (found->second < this->NumberOfOwnPoints && other < this->Number)
      {
        this->IsElsewhere[static_cast<std::size_t>(found->second)] = 1;
      }
      here.push_back(found->second);
    }
    for (vtkIdType t = 0; t < ghosts->GetNumberOfPolys(); ++t)
    {
      Corners corners = cornersOf(ghosts, t);
      for (vtkIdType& p : corners)
      {
        p = here[static_cast<std::size_t>(p)];
      }
      this->Data->GetPolys()->InsertNextCell(3, corners.data());
      appendTuple(ghosts->GetCellData(), t, this->Data->GetCellData());
    }
    return added;
  }

  /// Says what is a ghost.
  void mark()
  {
    // Arrays of the data set's own: VTK 9.1 must be told of others, and later ones need not.
    vtkUnsignedCharArray* points = this->Data->AllocatePointGhostArray();
    for (vtkIdType p = 0; p < points->GetNumberOfTuples(); ++p)
    {
      if (p >= this->NumberOfOwnPoints || this->IsElsewhere[static_cast<std::size_t>(p)] != 0)
      {
        points->SetValue(p, vtkDataSetAttributes::DUPLICATEPOINT);
      }
    }
    vtkUnsignedCharArray* triangles = this->Data->AllocateCellGhostArray();
    for (vtkIdType t = this->NumberOfOwnTriangles; t < triangles->GetNumberOfTuples(); ++t)
    {
      triangles->SetValue(t, vtkDataSetAttributes::DUPLICATECELL);
    }
    this->Data->Modified();
  }

private:
  long long idOf(vtkIdType ownPoint) const { return this->Own[static_cast<std::size_t>(ownPoint)]; }

  int Number;
  vtkPolyData* Data;
  vtkIdType NumberOfOwnPoints;
  vtkIdType NumberOfOwnTriangles;
  std::vector<long long> Own;                // ids, by own point
  std::vector<std::vector<vtkIdType>> About; // own triangles, by own point
  std::vector<char> IsElsewhere;             // own points that are no ghosts in another partition
  std::unordered_map<long long, vtkIdType> PointOf;
  std::map<int, std::set<vtkIdType>> Given; // own triangles that other partitions have
};

/// Triangles on their way from one partition to another.
struct Parcel
{
  int to = 0;
  int from = 0;
  vtkSmartPointer<vtkPolyData> triangles;
};

/// Which partitions have a triangle at a point is asked of the rank that the point's id falls to.
class GhostExchange
{
public:
  GhostExchange(const RankMessages& ranks, vtkPartitionedDataSet* blocks)
    : Ranks(ranks)
  {
    this->Blocks.count = static_cast<int>(blocks->GetNumberOfPartitions());
    for (int b = 0; b < this->Blocks.count; ++b)
    {
      if (auto* data = vtkPolyData::SafeDownCast(
            blocks->GetPartitionAsDataObject(static_cast<unsigned int>(b))))
      {
        this->PartOf.emplace(b, this->Parts.size());
        this->Parts.emplace_back(b, data);
      }
    }
  }

  void add(int levels)
  {
    std::vector<std::vector<long long>> front; // ids of points whose triangles are asked for
    std::vector<std::vector<long long>> all;
    for (const Part& part : this->Parts)
    {
      front.push_back(part.rim());
      all.push_back(part.ownIds());
    }
    for (const AtPoint& at : this->toDirectory(all))
    {
      this->Directory[at.id].push_back(at.block);
    }
    for (int level = 0; level < levels; ++level)
    {
      std::vector<std::vector<long long>> added(this->Parts.size());
      for (const Parcel& parcel : this->send(this->parcels(this->toDirectory(front))))
      {
        const std::size_t part = this->PartOf.at(parcel.to);
        const auto ids = this->Parts[part].append(parcel.from, parcel.triangles);
        added[part].insert(added[part].end(), ids.begin(), ids.end());
      }
      front = std::move(added);
    }
    for (Part& part : this->Parts)
    {
      part.mark();
    }
  }

private:
  struct AtPoint
  {
    long long id;
    long long block;
  };
  struct Request
  {
    long long id;
    long long of; ///< the partition whose triangles are asked for
    long long by;
  };

  int rankOf(long long block) const
  {
    return this->Blocks.rankOf(static_cast<int>(block), this->Ranks.size());
  }
  template <typename T>
  std::vector<T> exchange(const std::vector<std::vector<T>>& lists) const
  {
    std::vector<Bytes> messages;
    for (const std::vector<T>& list : lists)
    {
      messages.push_back(RankMessages::bytesOf(list));
    }
    std::vector<T> received;
    for (const Bytes& bytes : this->Ranks.exchange(std::move(messages)))
    {
      RankMessages::append(bytes, received);
    }
    return received;
  }

  /// Ids, by partition, to the ranks that know about them.
  std::vector<AtPoint> toDirectory(const std::vector<std::vector<long long>>& ids) const
  {
    std::vector<std::vector<AtPoint>> lists(static_cast<std::size_t>(this->Ranks.size()));
    for (std::size_t b = 0; b < ids.size(); ++b)
    {
      for (const long long id : ids[b])
      {
        lists[static_cast<std::size_t>(id % this->Ranks.size())].push_back(
          { id, this->Parts[b].number() });
      }
    }
    return this->exchange(lists);
  }

  /// What others have asked of this rank's partitions, by way of the directory.
  std::vector<Parcel> parcels(const std::vector<AtPoint>& asked)
  {
    std::vector<std::vector<Request>> requests(static_cast<std::size_t>(this->Ranks.size()));
    for (const AtPoint& at : asked)
    {
      for (const long long block : this->Directory[at.id])
      {
        if (block != at.block)
        {
          requests[static_cast<std::size_t>(this->rankOf(block))].push_back(
            { at.id, block, at.block });
        }
      }
    }
    std::map<std::pair<int, int>, std::set<vtkIdType>> triangles; // by who asks, and who has them
    for (const Request& r : this->exchange(requests))
    {
      const int of = static_cast<int>(r.of);
      const int by = static_cast<int>(r.by);
      this->Parts[this->PartOf.at(of)].findAbout(r.id, by, triangles[{ by, of }]);
    }
    std::vector<Parcel> result;
    for (const auto& [ends, list] : triangles)
    {
      if (!list.empty())
      {
        const Part& part = this->Parts[this->PartOf.at(ends.second)];
        result.push_back({ ends.first, ends.second, part.extracted(list) });
      }
    }
    return result;
  }

  /// Answers what came for this rank, in the order of partitions, so that it does not depend on
  /// the number of ranks.
  std::vector<Parcel> send(const std::vector<Parcel>& parcels) const
  {
    struct Label
    {
      int to;
      int from;
      long long size;
    };
    std::vector<Bytes> messages(static_cast<std::size_t>(this->Ranks.size()));
    for (const Parcel& parcel : parcels)
    {
      vtkNew<vtkCharArray> packed;
      vtkCommunicator::MarshalDataObject(parcel.triangles, packed);
      const Bytes label = RankMessages::bytesOf(
        std::vector<Label>{ { parcel.to, parcel.from, packed->GetNumberOfValues() } });
      Bytes& message = messages[static_cast<std::size_t>(this->rankOf(parcel.to))];
      message.insert(message.end(), label.begin(), label.end());
      message.insert(
        message.end(), packed->GetPointer(0), packed->GetPointer(0) + packed->GetNumberOfValues());
    }
    std::vector<Parcel> received;
    for (const Bytes& message : this->Ranks.exchange(std::move(messages)))
    {
      for (std::size_t at = 0; at < message.size();)
      {
        Label label;
        std::memcpy(&label, message.data() + at, sizeof(label));
        at += sizeof(label);
        vtkNew<vtkCharArray> packed;
        packed->SetNumberOfValues(static_cast<vtkIdType>(label.size));
        std::memcpy(
          packed->GetPointer(0), message.data() + at, static_cast<std::size_t>(label.size));
        at += static_cast<std::size_t>(label.size);
        received.push_back({ label.to, label.from,
          vtkPolyData::SafeDownCast(vtkCommunicator::UnMarshalDataObject(packed)) });
      }
    }
    std::sort(received.begin(), received.end(), [](const Parcel& a, const Parcel& b) {
      return std::make_pair(a.to, a.from) < std::make_pair(b.to, b.from);
    });
    return received;
  }

  const RankMessages& Ranks;
  SurfaceBlocks Blocks; // how they are dealt
  std::vector<Part> Parts;
  std::map<int, std::size_t> PartOf;                               // by number
  std::unordered_map<long long, std::vector<long long>> Directory; // partitions at points
};
}

Status addGhostCells(int levels, const RankMessages& ranks, vtkPartitionedDataSet* blocks)
{
  if (levels <= 0)
  {
    return Status::success();
  }
  return ranks.agree(guarded([&] {
    GhostExchange(ranks, blocks).add(levels);
    return Status::success();
  }));
}

vtkSmartPointer<vtkPolyData> withoutGhosts(vtkPolyData* data)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  if (!data->GetCellData()->HasArray(name) && !data->GetPointData()->HasArray(name))
  {
    return data;
  }
  auto own = vtkSmartPointer<vtkPolyData>::New();
  own->ShallowCopy(data);
  if (own->HasAnyGhostCells())
  {
    own->RemoveGhostCells();
  }
  own->GetPointData()->RemoveArray(name);
  own->GetCellData()->RemoveArray(name);
  return own;
}
}
