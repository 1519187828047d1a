// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceBlocks.h"

#include "BlockCuts.h"
#include "BlockGhosts.h"
#include "BlockStorage.h"
#include "PolyDataConversion.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

namespace stipple
{
namespace
{
const char* const PointIds = "stipple block point";
const char* const RawIds = "stipple block copy";
const char* const CellIds = "stipple block cell";
const char* const TriangleIds = "stipple block triangle";
const char* const OwnBlocks = "stipple block own";

/// A copy of a point and what it is counted as.
struct Copy
{
  std::array<double, 3> x;
  long long id;
};

std::size_t hashOf(const std::array<double, 3>& x)
{
  std::uint64_t h = 0x9E3779B97F4A7C15ULL;
  for (const double c : x)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &c, sizeof bits);
    h = (h ^ bits) * 0xFF51AFD7ED558CCDULL;
    h ^= h >> 32;
  }
  return static_cast<std::size_t>(h);
}

/// For every point of this rank the least number of all copies at its place.
std::vector<long long> weld(const std::vector<Copy>& points, const RankMessages& ranks)
{
  if (ranks.size() == 1)
  {
    std::vector<vtkIdType> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](vtkIdType a, vtkIdType b) {
      return points[a].x < points[b].x ||
        (points[a].x == points[b].x && points[a].id < points[b].id);
    });
    std::vector<long long> result(points.size());
    for (std::size_t first = 0, i = 0; i < order.size(); ++i)
    {
      first = points[order[i]].x == points[order[first]].x ? first : i;
      result[order[i]] = points[order[first]].id;
    }
    return result;
  }
  // Each place has a rank that looks after it.
  std::vector<std::vector<Copy>> toRank(static_cast<std::size_t>(ranks.size()));
  std::vector<int> rankOf(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    rankOf[p] = static_cast<int>(hashOf(points[p].x) % static_cast<std::size_t>(ranks.size()));
    toRank[rankOf[p]].push_back(points[p]);
  }
  std::vector<Bytes> messages;
  for (std::vector<Copy>& copies : toRank)
  {
    messages.push_back(RankMessages::bytesOf(copies));
    copies = {};
  }
  const std::vector<Bytes> asked = ranks.exchange(std::move(messages));
  std::vector<std::vector<Copy>> questions(asked.size());
  std::vector<const Copy*> all;
  for (std::size_t r = 0; r < asked.size(); ++r)
  {
    RankMessages::append(asked[r], questions[r]);
    for (const Copy& copy : questions[r])
    {
      all.push_back(&copy);
    }
  }
  std::sort(all.begin(), all.end(),
    [](const Copy* a, const Copy* b) { return a->x < b->x || (a->x == b->x && a->id < b->id); });
  for (std::size_t first = 0, i = 0; i < all.size(); ++i)
  {
    first = all[i]->x == all[first]->x ? first : i;
    const_cast<Copy*>(all[i])->id = all[first]->id; // the least comes first, and stays
  }
  messages.clear();
  for (const std::vector<Copy>& answers : questions)
  {
    std::vector<long long> ids;
    std::transform(answers.begin(), answers.end(), std::back_inserter(ids),
      [](const Copy& copy) { return copy.id; });
    messages.push_back(RankMessages::bytesOf(ids));
  }
  const std::vector<Bytes> answered = ranks.exchange(std::move(messages));
  std::vector<std::vector<long long>> ids(answered.size());
  for (std::size_t r = 0; r < answered.size(); ++r)
  {
    RankMessages::append(answered[r], ids[r]);
  }
  std::vector<std::size_t> next(ids.size(), 0);
  std::vector<long long> result(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    result[p] = ids[rankOf[p]][next[rankOf[p]]++];
  }
  return result;
}

/// How many come before this rank's.
long long offsetOf(long long own, const RankMessages& ranks)
{
  const std::vector<long long> all = ranks.gatherAll(std::vector<long long>(1, own));
  return std::accumulate(all.begin(), all.begin() + ranks.rank(), 0LL);
}

using Box = std::array<double, 6>; // least, and minus the largest

Box emptyBox()
{
  Box box;
  box.fill(std::numeric_limits<double>::infinity());
  return box;
}

void add(Box& box, const Vec3& x)
{
  for (int k = 0; k < 3; ++k)
  {
    box[k] = std::min(box[k], x[k]);
    box[k + 3] = std::min(box[k + 3], -x[k]);
  }
}

bool touches(const Box& a, const Box& b)
{
  for (int k = 0; k < 3; ++k)
  {
    if (a[k] > -b[k + 3] || b[k] > -a[k + 3])
    {
      return false;
    }
  }
  return true;
}

void addIds(vtkDataSetAttributes* data, const char* name, const std::vector<long long>& ids)
{
  vtkNew<vtkLongLongArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  data->AddArray(array);
}

std::vector<long long> takeIds(vtkDataSetAttributes* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  std::vector<long long> ids;
  auto* typed = vtkLongLongArray::SafeDownCast(array); // more digits than a double has
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    ids.push_back(typed ? typed->GetValue(i) : static_cast<long long>(array->GetComponent(i, 0)));
  }
  data->RemoveArray(name);
  return ids;
}

/// A piece's triangles, numbered within the surface.
struct ReadPiece
{
  vtkSmartPointer<vtkPolyData> data;
  TriangleSurface surface;
  std::vector<int> sourceCell;
};

class BlockMaker
{
public:
  BlockMaker(const SurfacePieces& pieces, const std::string& folder, const RankMessages& ranks,
    SurfaceBlocks& blocks)
    : Pieces(pieces)
    , Folder(folder)
    , Ranks(ranks)
    , Blocks(blocks)
  {
  }

  Status run(long long trianglesPerBlock, long long points)
  {
    if (Status status = this->Ranks.agree(guarded([this] { return this->look(); })); !status.ok())
    {
      return status;
    }
    this->number();
    std::vector<long long> total(1, static_cast<long long>(this->Centres.size()));
    this->Ranks.sum(total);
    this->Blocks.numberOfTriangles = total[0];
    this->Blocks.isInFiles = !this->Folder.empty();
    this->Blocks.count =
      static_cast<int>(std::max(1LL, (total[0] + trianglesPerBlock - 1) / trianglesPerBlock));
    const double reach =
      3. * edgeLengthOf(this->Blocks.area, static_cast<double>(points > 0 ? points : total[0] / 2));
    this->BlockOf = cutIntoBlocks(this->Centres, this->Blocks.count, this->Ranks);
    this->Centres = {};
    if (Status status = this->Ranks.agree(this->measureBoxes(reach)); !status.ok())
    {
      return status;
    }
    return this->Ranks.agree(guarded([this] { return this->move(); }));
  }

private:
  Status read(int p, ReadPiece& piece) const
  {
    if (Status status = this->Pieces.read(p, piece.data); !status.ok())
    {
      return status;
    }
    piece.data = withoutGhosts(piece.data);
    return readPolyData(piece.data, piece.surface, &piece.sourceCell);
  }

  /// Counts, and notes where everything is.
  Status look()
  {
    Box box = emptyBox();
    this->HasGlobalIds = true;
    for (int p = 0; p < this->Pieces.count; ++p)
    {
      ReadPiece piece;
      if (Status status = this->read(p, piece); !status.ok())
      {
        return status;
      }
      vtkDataArray* global = piece.data->GetPointData()->GetGlobalIds();
      this->HasGlobalIds = this->HasGlobalIds && (global || piece.surface.points.empty());
      for (std::size_t i = 0; i < piece.surface.points.size(); ++i)
      {
        const Vec3& x = piece.surface.points[i];
        if (!x.allFinite())
        {
          return Status::error("Point " + std::to_string(i) + " of piece " + std::to_string(p) +
            " is not finite: remove it, or the triangles that use it.");
        }
        this->Points.push_back({ { { x.x() + 0., x.y() + 0., x.z() + 0. } },
          global ? static_cast<long long>(global->GetComponent(static_cast<vtkIdType>(i), 0))
                 : 0 });
      }
      this->Begin.push_back({ static_cast<long long>(this->Points.size()) -
          static_cast<long long>(piece.surface.points.size()),
        this->NumberOfCells, static_cast<long long>(this->Centres.size()) });
      double areaOfPiece = 0;
      for (const Triangle& t : piece.surface.triangles)
      {
        areaOfPiece += triangleArea(
          piece.surface.points[t[0]], piece.surface.points[t[1]], piece.surface.points[t[2]]);
        Vec3 sum = Vec3::Zero();
        for (const int corner : t)
        {
          add(box, piece.surface.points[corner]);
          sum += piece.surface.points[corner];
        }
        sum /= 3.;
        this->Centres.push_back({ { static_cast<float>(sum.x()), static_cast<float>(sum.y()),
          static_cast<float>(sum.z()) } });
      }
      this->Areas.push_back(areaOfPiece);
      this->NumberOfCells += piece.data->GetNumberOfCells();
    }
    this->OfAll.assign(box.begin(), box.end());
    return Status::success();
  }

  void number()
  {
    this->Ranks.minimum(this->OfAll);
    for (const double area : this->Ranks.gatherAll(this->Areas)) // piece by piece, on any ranks
    {
      this->Blocks.area += area;
    }
    Vec3 sides;
    for (int k = 0; k < 3; ++k)
    {
      sides[k] = -this->OfAll[k + 3] - this->OfAll[k];
    }
    this->Blocks.diagonal = sides.allFinite() ? sides.norm() : 0.;
    std::vector<long long> without(1, this->HasGlobalIds ? 0 : 1);
    this->Ranks.sum(without);
    const long long firstPoint = offsetOf(static_cast<long long>(this->Points.size()), this->Ranks);
    const long long firstCell = offsetOf(this->NumberOfCells, this->Ranks);
    const long long firstTriangle =
      offsetOf(static_cast<long long>(this->Centres.size()), this->Ranks);
    this->FirstPoint = firstPoint;
    for (auto& begin : this->Begin)
    {
      begin[1] += firstCell;
      begin[2] += firstTriangle;
    }
    this->FirstTriangle = firstTriangle;
    if (without[0] == 0)
    {
      for (const Copy& point : this->Points)
      {
        this->PointId.push_back(point.id);
      }
    }
    else
    {
      for (std::size_t p = 0; p < this->Points.size(); ++p)
      {
        this->Points[p].id = firstPoint + static_cast<long long>(p);
      }
      this->PointId = weld(this->Points, this->Ranks);
    }
    this->Points = {};
  }

  Status measureBoxes(double reach)
  {
    std::vector<double> boxes(
      6 * static_cast<std::size_t>(this->Blocks.count), std::numeric_limits<double>::infinity());
    Status status = Status::success();
    std::size_t t = 0;
    for (int p = 0; p < this->Pieces.count && status.ok(); ++p)
    {
      ReadPiece piece;
      status = this->read(p, piece);
      for (const Triangle& triangle : piece.surface.triangles)
      {
        Box box = emptyBox();
        for (const int corner : triangle)
        {
          add(box, piece.surface.points[corner]);
        }
        double* ofBlock = boxes.data() + 6 * this->BlockOf[t++];
        std::transform(box.begin(), box.end(), ofBlock, ofBlock,
          [](double a, double b) { return std::min(a, b); });
      }
    }
    this->Ranks.minimum(boxes);
    for (int b = 0; b < this->Blocks.count; ++b)
    {
      Box box;
      std::transform(boxes.begin() + 6 * b, boxes.begin() + 6 * b + 6, box.begin(),
        [&](double side) { return side - reach; });
      this->Boxes.push_back(box);
    }
    return status;
  }

  /// The triangles of a piece that a block gets.
  vtkSmartPointer<vtkPolyData> part(
    const ReadPiece& piece, int p, const std::vector<int>& triangles) const
  {
    auto result = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    vtkPointData* from = piece.data->GetPointData();
    vtkPointData* to = result->GetPointData();
    to->CopyAllOn();
    to->CopyAllocate(from);
    result->GetCellData()->CopyAllOn();
    result->GetCellData()->CopyAllocate(piece.data->GetCellData());
    std::unordered_map<int, vtkIdType> known;
    std::vector<long long> ids;
    std::vector<long long> rawIds;
    std::vector<long long> cellIds;
    std::vector<long long> triangleIds;
    std::vector<long long> blocks;
    for (const int t : triangles)
    {
      const Triangle& corners = piece.surface.triangles[t];
      cells->InsertNextCell(3);
      for (const int corner : corners)
      {
        const auto [found, isNew] = known.try_emplace(corner, points->GetNumberOfPoints());
        if (isNew)
        {
          points->InsertNextPoint(piece.surface.points[corner].data());
          to->CopyData(from, corner, found->second);
          ids.push_back(this->PointId[this->Begin[p][0] + corner]);
          rawIds.push_back(this->FirstPoint + this->Begin[p][0] + corner);
        }
        cells->InsertCellPoint(found->second);
      }
      const auto number = static_cast<vtkIdType>(cellIds.size());
      result->GetCellData()->CopyData(piece.data->GetCellData(), piece.sourceCell[t], number);
      cellIds.push_back(this->Begin[p][1] + piece.sourceCell[t]);
      triangleIds.push_back(this->Begin[p][2] + t);
      blocks.push_back(this->BlockOf[this->Begin[p][2] - this->FirstTriangle + t]);
    }
    result->SetPoints(points);
    result->SetPolys(cells);
    // Appending drops arrays that are active as ids of all.
    to->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
    result->GetCellData()->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
    addIds(to, PointIds, ids);
    addIds(to, RawIds, rawIds);
    addIds(result->GetCellData(), CellIds, cellIds);
    addIds(result->GetCellData(), TriangleIds, triangleIds);
    addIds(result->GetCellData(), OwnBlocks, blocks);
    return result;
  }

  Status move()
  {
    const auto n = static_cast<std::size_t>(this->Blocks.count);
    std::vector<std::vector<vtkSmartPointer<vtkPolyData>>> here(n); // by block
    std::vector<Bytes> messages(static_cast<std::size_t>(this->Ranks.size()));
    Status status = Status::success();
    for (int p = 0; p < this->Pieces.count && status.ok(); ++p)
    {
      ReadPiece piece;
      status = this->read(p, piece);
      std::vector<std::vector<int>> triangles(n);
      for (int t = 0; t < piece.surface.numberOfFaces(); ++t)
      {
        const int own = this->BlockOf[this->Begin[p][2] - this->FirstTriangle + t];
        Box box = emptyBox();
        const Triangle& corners = piece.surface.triangles[t];
        const long long* ids = this->PointId.data() + this->Begin[p][0];
        if (ids[corners[0]] == ids[corners[1]] || ids[corners[1]] == ids[corners[2]] ||
          ids[corners[2]] == ids[corners[0]])
        {
          continue; // nothing is left of it
        }
        for (const int corner : corners)
        {
          add(box, piece.surface.points[corner]);
        }
        for (int b = 0; b < this->Blocks.count; ++b)
        {
          if (b == own || touches(box, this->Boxes[b]))
          {
            triangles[b].push_back(t);
          }
        }
      }
      for (int b = 0; b < this->Blocks.count; ++b)
      {
        if (triangles[b].empty())
        {
          continue;
        }
        const vtkSmartPointer<vtkPolyData> part = this->part(piece, p, triangles[b]);
        const int rank = this->Blocks.rankOf(b, this->Ranks.size());
        if (rank == this->Ranks.rank() && this->Folder.empty())
        {
          here[b].push_back(part);
          continue;
        }
        const Bytes packed = pack(part);
        if (rank == this->Ranks.rank())
        {
          status = this->keepPart(b, packed);
          if (!status.ok())
          {
            break;
          }
          continue;
        }
        const std::array<long long, 2> head = { { b, static_cast<long long>(packed.size()) } };
        Bytes& message = messages[rank];
        const auto* bytes = reinterpret_cast<const char*>(head.data());
        message.insert(message.end(), bytes, bytes + sizeof head);
        message.insert(message.end(), packed.begin(), packed.end());
      }
    }
    if (Status all = this->Ranks.agree(status); !all.ok())
    {
      return all;
    }
    const std::vector<Bytes> received = this->Ranks.exchange(std::move(messages));
    for (std::size_t r = 0; r < received.size(); ++r)
    {
      for (std::size_t at = 0; at < received[r].size();)
      {
        std::array<long long, 2> head;
        std::memcpy(head.data(), received[r].data() + at, sizeof head);
        at += sizeof head;
        const auto begin = received[r].begin() + static_cast<std::ptrdiff_t>(at);
        const Bytes packed(begin, begin + static_cast<std::ptrdiff_t>(head[1]));
        at += static_cast<std::size_t>(head[1]);
        if (this->Folder.empty())
        {
          here[head[0]].push_back(unpack(packed));
        }
        else if (status.ok())
        {
          status = this->keepPart(static_cast<int>(head[0]), packed);
        }
      }
    }
    for (int b = 0; b < this->Blocks.count; ++b)
    {
      SurfaceBlock block;
      block.number = b;
      if (!this->Folder.empty() && status.ok())
      {
        block.file = this->fileOf(b) + ".block";
        this->takeParts(b, here[b]);
      }
      this->assemble(here[b], block);
      here[b].clear();
      if (block.numberOfOwn > 0)
      {
        park(block);
        this->Blocks.own.push_back(std::move(block));
      }
    }
    return status;
  }

  std::string fileOf(int block) const
  {
    return this->Folder + "/" + std::to_string(this->Ranks.rank()) + "-" + std::to_string(block);
  }

  Status keepPart(int block, const Bytes& packed) const
  {
    std::ofstream file(this->fileOf(block) + ".parts", std::ios::binary | std::ios::app);
    writeBytes(file, packed);
    file.close();
    return file ? Status::success()
                : Status::error("cannot write '" + this->fileOf(block) + ".parts'");
  }

  void takeParts(int block, std::vector<vtkSmartPointer<vtkPolyData>>& parts) const
  {
    const std::string name = this->fileOf(block) + ".parts";
    std::ifstream file(name, std::ios::binary);
    while (file.peek() != std::ifstream::traits_type::eof())
    {
      parts.push_back(unpack(readBytes(file)));
    }
    file.close();
    std::remove(name.c_str());
  }

  /// Puts the parts of a block together, in the order of their ids.
  void assemble(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, SurfaceBlock& block) const
  {
    if (parts.empty())
    {
      return;
    }
    vtkNew<vtkAppendPolyData> append;
    append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    for (vtkPolyData* part : parts)
    {
      append->AddInputData(part);
    }
    append->Update();
    vtkPolyData* all = append->GetOutput();
    const std::vector<long long> pointIds = takeIds(all->GetPointData(), PointIds);
    const std::vector<long long> rawIds = takeIds(all->GetPointData(), RawIds);
    const std::vector<long long> cellIds = takeIds(all->GetCellData(), CellIds);
    const std::vector<long long> triangleIds = takeIds(all->GetCellData(), TriangleIds);
    const std::vector<long long> owner = takeIds(all->GetCellData(), OwnBlocks);

    std::vector<vtkIdType> order(pointIds.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](vtkIdType a, vtkIdType b) {
      return std::pair(pointIds[a], rawIds[a]) < std::pair(pointIds[b], rawIds[b]);
    });
    block.data = vtkSmartPointer<vtkPolyData>::New();
    block.data->GetPointData()->CopyAllOn();
    block.data->GetPointData()->CopyAllocate(all->GetPointData());
    block.data->GetCellData()->CopyAllOn();
    block.data->GetCellData()->CopyAllocate(all->GetCellData());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    std::vector<vtkIdType> newId(pointIds.size());
    for (const vtkIdType p : order)
    {
      if (block.pointId.empty() || block.pointId.back() != pointIds[p])
      {
        const vtkIdType id = points->InsertNextPoint(all->GetPoint(p));
        block.data->GetPointData()->CopyData(all->GetPointData(), p, id);
        block.pointId.push_back(pointIds[p]);
      }
      newId[p] = points->GetNumberOfPoints() - 1;
    }
    order.resize(triangleIds.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](vtkIdType t) {
      return std::pair(owner[t] == block.number ? 0 : 1, triangleIds[t]);
    };
    std::sort(
      order.begin(), order.end(), [&](vtkIdType a, vtkIdType b) { return key(a) < key(b); });
    vtkNew<vtkCellArray> cells;
    vtkIdType size;
    const vtkIdType* corners;
    for (const vtkIdType t : order)
    {
      all->GetPolys()->GetCellAtId(t, size, corners);
      const vtkIdType id =
        cells->InsertNextCell({ newId[corners[0]], newId[corners[1]], newId[corners[2]] });
      block.data->GetCellData()->CopyData(all->GetCellData(), t, id);
      block.cellId.push_back(cellIds[t]);
      block.triangleId.push_back(triangleIds[t]);
      block.owner.push_back(static_cast<int>(owner[t]));
      block.numberOfOwn += owner[t] == block.number ? 1 : 0;
    }
    block.data->SetPoints(points);
    block.data->SetPolys(cells);
  }

  const SurfacePieces& Pieces;
  const std::string& Folder; // of files, or empty
  const RankMessages& Ranks;
  SurfaceBlocks& Blocks;
  std::vector<Copy> Points;
  std::vector<Centre> Centres;
  std::vector<long long> PointId; // by this rank's points, piece by piece
  std::vector<int> BlockOf;       // by this rank's triangles, piece by piece
  /// Of each piece the first point, of this rank, and the first cell and triangle, of all.
  std::vector<std::array<long long, 3>> Begin;
  std::vector<double> OfAll;
  std::vector<double> Areas; // of pieces
  std::vector<Box> Boxes;
  long long NumberOfCells = 0;
  long long FirstPoint = 0;
  long long FirstTriangle = 0;
  bool HasGlobalIds = true;
};
}

Status makeBlocks(const SurfacePieces& pieces, long long trianglesPerBlock, long long points,
  const std::string& folder, const RankMessages& ranks, SurfaceBlocks& blocks)
{
  blocks = {};
  return BlockMaker(pieces, folder, ranks, blocks).run(trianglesPerBlock, points);
}

void moveTriangles(const std::map<long long, int>& newOwner, SurfaceBlocks& blocks)
{
  for (SurfaceBlock& kept : blocks.own)
  {
    if (newOwner.empty())
    {
      return;
    }
    SurfaceBlock block = *BlockInMemory(kept);
    bool isChanged = false;
    for (std::size_t t = 0; t < block.owner.size(); ++t)
    {
      const auto found = newOwner.find(block.triangleId[t]);
      if (found != newOwner.end() && block.owner[t] != found->second)
      {
        block.owner[t] = found->second;
        isChanged = true;
      }
    }
    if (!isChanged)
    {
      continue;
    }
    std::vector<vtkIdType> order(block.owner.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](vtkIdType t) {
      return std::pair(block.owner[t] == block.number ? 0 : 1, block.triangleId[t]);
    };
    std::sort(
      order.begin(), order.end(), [&](vtkIdType a, vtkIdType b) { return key(a) < key(b); });
    SurfaceBlock sorted;
    sorted.number = block.number;
    sorted.pointId = block.pointId;
    sorted.data = vtkSmartPointer<vtkPolyData>::New();
    sorted.data->SetPoints(block.data->GetPoints());
    sorted.data->GetPointData()->ShallowCopy(block.data->GetPointData());
    sorted.data->GetCellData()->CopyAllOn();
    sorted.data->GetCellData()->CopyAllocate(block.data->GetCellData());
    vtkNew<vtkCellArray> cells;
    vtkIdType size;
    const vtkIdType* corners;
    for (const vtkIdType t : order)
    {
      block.data->GetPolys()->GetCellAtId(t, size, corners);
      const vtkIdType id = cells->InsertNextCell(size, corners);
      sorted.data->GetCellData()->CopyData(block.data->GetCellData(), t, id);
      sorted.cellId.push_back(block.cellId[t]);
      sorted.triangleId.push_back(block.triangleId[t]);
      sorted.owner.push_back(block.owner[t]);
      sorted.numberOfOwn += block.owner[t] == block.number ? 1 : 0;
    }
    sorted.data->SetPolys(cells);
    sorted.file = kept.file;
    kept = std::move(sorted);
    park(kept);
  }
}
}
