// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockRemeshing.h"

#include "CoincidentPoints.h"
#include "CutSurface.h"
#include "FeatureDetection.h"
#include "FilterExecution.h"
#include "MessageText.h"
#include "PolyDataConversion.h"
#include "RegionArrays.h"
#include "SampleSet.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDataArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>

namespace stipple
{
namespace
{
/// A mesh of triangles in which points can be contracted.
class Contraction
{
public:
  explicit Contraction(TriangleSurface& mesh)
    : Mesh(mesh)
    , Source(mesh.triangles.size())
  {
    std::iota(this->Source.begin(), this->Source.end(), 0);
  }
  /// The triangle that it was at first.
  int sourceOf(std::size_t triangle) const { return this->Source[triangle]; }

  enum class Outcome
  {
    Contracted,
    Swapped,
    Impossible
  };
  /// Contracts a point of the border into a neighbour on it. Where the edges do not allow it, one
  /// is swapped, and it may be tried again: the point then has a triangle less.
  Outcome contract(int p, const std::vector<char>& isExtra)
  {
    // Neighbours on the border, and triangles about p.
    std::map<int, int> outgoing;
    std::map<int, int> incoming;
    std::vector<int> about;
    for (int f = 0; f < this->Mesh.numberOfFaces(); ++f)
    {
      const Triangle& t = this->Mesh.triangles[f];
      for (int k = 0; k < 3; ++k)
      {
        if (t[k] == p)
        {
          about.push_back(f);
          ++outgoing[t[(k + 1) % 3]];
          ++incoming[t[(k + 2) % 3]];
        }
      }
    }
    std::vector<int> ends;
    for (const auto& [q, count] : outgoing)
    {
      if (incoming.count(q) == 0)
      {
        ends.push_back(q);
      }
    }
    for (const auto& [q, count] : incoming)
    {
      if (outgoing.count(q) == 0)
      {
        ends.push_back(q);
      }
    }
    double best = -2;
    int into = -1;
    for (const int q : ends)
    {
      if (isExtra[q])
      {
        continue;
      }
      const double worst = this->worstAfter(p, q, about, outgoing, incoming);
      if (worst > best)
      {
        best = worst;
        into = q;
      }
    }
    if (into < 0)
    {
      return this->swapAbout(p, about) ? Outcome::Swapped : Outcome::Impossible;
    }
    std::vector<Triangle>& triangles = this->Mesh.triangles;
    std::vector<Triangle> left;
    std::vector<int> sourceOfLeft;
    for (std::size_t f = 0; f < triangles.size(); ++f)
    {
      Triangle t = triangles[f];
      const bool hasP = std::find(t.begin(), t.end(), p) != t.end();
      if (hasP && std::find(t.begin(), t.end(), into) != t.end())
      {
        continue;
      }
      std::replace(t.begin(), t.end(), p, into);
      left.push_back(t);
      sourceOfLeft.push_back(this->Source[f]);
    }
    triangles = std::move(left);
    this->Source = std::move(sourceOfLeft);
    return Outcome::Contracted;
  }

private:
  /// Swaps an edge from p to the inside, so that p has one triangle less: the first that can be.
  bool swapAbout(int p, const std::vector<int>& about)
  {
    std::vector<Triangle>& triangles = this->Mesh.triangles;
    for (const int f : about)
    {
      for (const int g : about)
      {
        // f is (p, b, c), g is (p, c, d): they become (p, b, d) and (b, c, d).
        Triangle first = triangles[f];
        Triangle second = triangles[g];
        std::rotate(first.begin(), std::find(first.begin(), first.end(), p), first.end());
        std::rotate(second.begin(), std::find(second.begin(), second.end(), p), second.end());
        const int b = first[1];
        const int d = second[2];
        if (first[2] != second[1] ||
          std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
            return std::count(t.begin(), t.end(), b) > 0 && std::count(t.begin(), t.end(), d) > 0;
          }))
        {
          continue;
        }
        triangles[f] = { p, b, d };
        triangles[g] = { b, first[2], d };
        return true;
      }
    }
    return false;
  }

  /// Of the triangles about p the worst agreement of normals before and after, with as much of
  /// their shape; less than -1 if the edges do not allow it.
  double worstAfter(int p, int q, const std::vector<int>& about, const std::map<int, int>& outgoing,
    const std::map<int, int>& incoming) const
  {
    std::set<int> neighbours;
    for (const auto* side : { &outgoing, &incoming })
    {
      for (const auto& [r, count] : *side)
      {
        neighbours.insert(r);
      }
    }
    std::set<int> common;
    for (const Triangle& t : this->Mesh.triangles)
    {
      if (std::find(t.begin(), t.end(), q) != t.end())
      {
        for (const int r : t)
        {
          if (r != q && r != p && neighbours.count(r) > 0)
          {
            common.insert(r);
          }
        }
      }
    }
    if (common.size() != 1)
    {
      return -3;
    }
    double worst = 1;
    for (const int f : about)
    {
      Triangle t = this->Mesh.triangles[f];
      if (std::find(t.begin(), t.end(), q) != t.end())
      {
        continue;
      }
      const Vec3 before = this->Mesh.faceNormal(Face(f));
      std::replace(t.begin(), t.end(), p, q);
      const Vec3& a = this->Mesh.points[t[0]];
      const Vec3 after = (this->Mesh.points[t[1]] - a).cross(this->Mesh.points[t[2]] - a);
      const double longest = std::max(
        { (this->Mesh.points[t[1]] - a).squaredNorm(), (this->Mesh.points[t[2]] - a).squaredNorm(),
          (this->Mesh.points[t[2]] - this->Mesh.points[t[1]]).squaredNorm() });
      worst = std::min(worst, longest > 0 ? after.dot(before) / longest : -1.);
    }
    return worst;
  }

  TriangleSurface& Mesh;
  std::vector<int> Source;
};

/// The block's own triangles, with the borders' samples as points.
struct BorderedSurface
{
  vtkSmartPointer<vtkPolyData> data;
  std::vector<int> sourceTriangle; // of the block
  std::vector<vtkIdType> idOf;     // of the block's points, -1 if no own triangle has it
  std::map<Place, int> sampleAt;   // by exact position
  vtkNew<vtkIdTypeArray> fixedEdges;
  vtkNew<vtkIdTypeArray> fixedPoints;
  vtkNew<vtkIdTypeArray> sharpEdges;
};

void makeBordered(const SurfaceBlock& block, const BlockOutline& outline,
  const BlockBorders& borders, BorderedSurface& result)
{
  const TriangleSurface all = fromPolyData(block.data);
  const auto edgeOf = [&](int p, int q) {
    return std::array<long long, 2>{ { std::min(block.pointId[p], block.pointId[q]),
      std::max(block.pointId[p], block.pointId[q]) } };
  };
  result.data = vtkSmartPointer<vtkPolyData>::New();
  vtkPointData* from = block.data->GetPointData();
  vtkPointData* to = result.data->GetPointData();
  to->CopyAllOn();
  to->InterpolateAllocate(from);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  result.idOf.assign(block.pointId.size(), -1);
  std::map<int, vtkIdType> ofSample; // inside edges
  const auto idOf = [&](int p) {
    if (result.idOf[p] < 0)
    {
      result.idOf[p] = points->InsertNextPoint(all.points[p].data());
      to->CopyData(from, p, result.idOf[p]);
    }
    return result.idOf[p];
  };
  std::vector<std::array<vtkIdType, 3>> triangles;
  for (int f = 0; f < block.numberOfOwn; ++f)
  {
    const Triangle& t = all.triangles[f];
    std::vector<std::array<vtkIdType, 3>> pieces(1);
    pieces[0] = { { idOf(t[0]), idOf(t[1]), idOf(t[2]) } };
    for (int k = 0; k < 3; ++k)
    {
      const int p = t[k];
      const int q = t[(k + 1) % 3];
      const auto found = borders.onEdge.find(edgeOf(p, q));
      if (found == borders.onEdge.end())
      {
        continue;
      }
      std::vector<int> samples = found->second;
      if (block.pointId[p] > block.pointId[q])
      {
        std::reverse(samples.begin(), samples.end());
      }
      vtkIdType tail = idOf(p);
      const vtkIdType head = idOf(q);
      for (const int s : samples)
      {
        const auto [known, isNew] = ofSample.try_emplace(s, points->GetNumberOfPoints());
        if (isNew)
        {
          const BorderSample& sample = borders.samples[s];
          points->InsertNextPoint(sample.position.data());
          const bool isAhead = block.pointId[p] == sample.a;
          to->InterpolateEdge(from, known->second, isAhead ? p : q, isAhead ? q : p, sample.t);
        }
        // The piece with the edge from tail to head becomes two.
        for (std::size_t i = 0; i < pieces.size(); ++i)
        {
          const std::array<vtkIdType, 3> piece = pieces[i];
          int c = 0;
          while (c < 3 && (piece[c] != tail || piece[(c + 1) % 3] != head))
          {
            ++c;
          }
          if (c < 3)
          {
            const vtkIdType apex = piece[(c + 2) % 3];
            pieces[i] = { { tail, known->second, apex } };
            pieces.push_back({ { known->second, head, apex } });
            break;
          }
        }
        tail = known->second;
      }
    }
    for (const auto& piece : pieces)
    {
      triangles.push_back(piece);
      result.sourceTriangle.push_back(f);
    }
  }
  vtkNew<vtkCellArray> cells;
  result.data->GetCellData()->CopyAllOn();
  result.data->GetCellData()->CopyAllocate(block.data->GetCellData());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    cells->InsertNextCell(3, triangles[i].data());
    result.data->GetCellData()->CopyData(
      block.data->GetCellData(), result.sourceTriangle[i], static_cast<vtkIdType>(i));
  }
  result.data->SetPoints(points);
  result.data->SetPolys(cells);
  to->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  result.data->GetCellData()->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);

  // The border, from point to point.
  const std::set<std::array<long long, 2>> boundary(
    borders.boundary.begin(), borders.boundary.end());
  std::map<long long, int> local;
  for (std::size_t p = 0; p < block.pointId.size(); ++p)
  {
    local[block.pointId[p]] = static_cast<int>(p);
  }
  result.fixedEdges->SetNumberOfComponents(2);
  std::set<int> fixed;
  for (const OpenEdge& edge : outline.openEdges)
  {
    if (boundary.count(edge.point) > 0)
    {
      continue;
    }
    const int p = local.at(edge.point[0]);
    const int q = local.at(edge.point[1]);
    std::vector<vtkIdType> chain(1, result.idOf[p]);
    if (const auto found = borders.onEdge.find(edgeOf(p, q)); found != borders.onEdge.end())
    {
      std::vector<int> samples = found->second;
      if (block.pointId[p] > block.pointId[q])
      {
        std::reverse(samples.begin(), samples.end());
      }
      for (const int s : samples)
      {
        chain.push_back(ofSample.at(s));
        fixed.insert(s);
        result.fixedPoints->InsertNextValue(ofSample.at(s));
      }
    }
    chain.push_back(result.idOf[q]);
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      result.fixedEdges->InsertNextValue(chain[i - 1]);
      result.fixedEdges->InsertNextValue(chain[i]);
    }
    for (const int end : { p, q })
    {
      const auto found = borders.atPoint.find(block.pointId[end]);
      if (found != borders.atPoint.end() && fixed.insert(found->second).second)
      {
        result.fixedPoints->InsertNextValue(result.idOf[end]);
      }
    }
  }
  for (const int s : fixed)
  {
    result.sampleAt[placeOf(borders.samples[s].position.data())] = s;
  }
  // Creases inside; those on the border are fixed edges already.
  std::set<std::array<long long, 2>> open;
  for (const OpenEdge& edge : outline.openEdges)
  {
    open.insert(
      { { std::min(edge.point[0], edge.point[1]), std::max(edge.point[0], edge.point[1]) } });
  }
  result.sharpEdges->SetNumberOfComponents(2);
  for (const auto& [p, q] : outline.creases)
  {
    if (open.count(edgeOf(p, q)) == 0)
    {
      result.sharpEdges->InsertNextValue(result.idOf[p]);
      result.sharpEdges->InsertNextValue(result.idOf[q]);
    }
  }
}

/// Sets what blocks need, and puts it back.
class BlockParameters
{
public:
  BlockParameters(
    vtkGeometryRemesher* remesher, const BorderedSurface& surface, int points, bool isWhole)
    : Remesher(remesher)
    , Angle(remesher->GetFeatureAngle())
    , Growth(remesher->GetControlMap()->GetGrowth())
    , Points(remesher->GetNumberOfPoints())
  {
    remesher->SetNumberOfPoints(points);
    if (isWhole)
    {
      return;
    }
    vtkConformalAtlas* atlas = remesher->GetAtlas();
    remesher->SetFeatureAngle(180.);
    remesher->GetControlMap()->SetGrowth(0.);
    atlas->SetSharpEdges(surface.sharpEdges);
    atlas->SetFixedEdges(surface.fixedEdges);
    atlas->SetFixedPoints(surface.fixedPoints);
  }
  ~BlockParameters()
  {
    vtkConformalAtlas* atlas = this->Remesher->GetAtlas();
    atlas->SetSharpEdges(nullptr);
    atlas->SetFixedEdges(nullptr);
    atlas->SetFixedPoints(nullptr);
    this->Remesher->SetFeatureAngle(this->Angle);
    this->Remesher->GetControlMap()->SetGrowth(this->Growth);
    this->Remesher->SetNumberOfPoints(this->Points);
    this->Remesher->SetInputDataObject(0, nullptr);
  }
  BlockParameters(const BlockParameters&) = delete;
  BlockParameters& operator=(const BlockParameters&) = delete;

private:
  vtkGeometryRemesher* Remesher;
  double Angle;
  double Growth;
  int Points;
};

void noteError(vtkObject*, unsigned long, void* data, void* text)
{
  auto* sentence = static_cast<std::string*>(data);
  if (sentence->empty() && text)
  {
    *sentence = sentenceOf(static_cast<const char*>(text));
  }
}

void passProgress(vtkObject* remesher, unsigned long, void* progress, void* fraction)
{
  if (!report(*static_cast<const Progress*>(progress), *static_cast<const double*>(fraction)))
  {
    vtkAlgorithm::SafeDownCast(remesher)->SetAbortExecute(1);
  }
}

/// Updates the remesher; its error is the status.
Status update(vtkGeometryRemesher* remesher, Progress progress)
{
  vtkNew<vtkCallbackCommand> teller;
  teller->SetClientData(&progress);
  teller->SetCallback(passProgress);
  const unsigned long telling = remesher->AddObserver(vtkCommand::ProgressEvent, teller);
  std::string sentence;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&sentence);
  observer->SetCallback(noteError);
  const unsigned long tag = remesher->AddObserver(vtkCommand::ErrorEvent, observer);
  remesher->Update();
  remesher->RemoveObserver(tag);
  remesher->RemoveObserver(telling);
  takeStop(remesher);
  switch (remesher->GetErrorCode())
  {
    case 0:
      return sentence.empty() ? Status::success() : Status::internal(sentence);
    case vtkGeometryRemesher::ABORTED:
      return Status::aborted();
    case vtkGeometryRemesher::TOO_FEW_POINTS:
      return Status::tooFewPoints(sentence, remesher->GetLeastNumberOfPoints());
    case vtkGeometryRemesher::BAD_INPUT:
      return Status::error(sentence);
    default:
      return Status::internal(sentence);
  }
}

/// The remesher's mesh without what the border has besides its samples; what was not one of these
/// is counted.
Status takeMesh(const SurfaceBlock& block, const BorderedSurface& surface,
  vtkGeometryRemesher* remesher, BlockMesh& mesh, int& numberOfOthers)
{
  mesh = {};
  vtkPolyData* output = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(0));
  TriangleSurface given = fromPolyData(output);
  const auto n = given.points.size();
  std::vector<int> sample(n, -1);
  std::set<int> met;
  for (std::size_t p = 0; p < n; ++p)
  {
    const auto found = surface.sampleAt.find(placeOf(given.points[p].data()));
    if (found != surface.sampleAt.end())
    {
      sample[p] = found->second;
      met.insert(found->second);
    }
  }
  if (met.size() != surface.sampleAt.size())
  {
    return Status::internal("The mesh of block " + std::to_string(block.number) + " lacks " +
      std::to_string(surface.sampleAt.size() - met.size()) + " of the " +
      std::to_string(surface.sampleAt.size()) + " points on its border.");
  }

  // Where seams end on the border, and where the sampler needed more to make a planar graph of it,
  // this block has points that its neighbours do not have.
  auto* graph = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(3));
  vtkDataArray* keep = graph->GetCellData()->GetArray("Keep");
  std::set<Place> extraAt;
  vtkIdType size;
  const vtkIdType* ids;
  std::set<int> fixedLines;
  for (vtkIdType l = 0; l < graph->GetNumberOfLines(); ++l)
  {
    graph->GetLines()->GetCellAtId(l, size, ids);
    if (keep->GetComponent(graph->GetNumberOfVerts() + l, 0) == static_cast<double>(Keep::Edges))
    {
      fixedLines.insert(static_cast<int>(l));
      for (const vtkIdType end : { ids[0], ids[size - 1] })
      {
        const Place place = placeOf(graph->GetPoint(end));
        if (surface.sampleAt.count(place) == 0)
        {
          extraAt.insert(place);
        }
      }
    }
  }
  std::vector<char> isExtra(n, 0);
  std::vector<int> extras;
  vtkDataArray* kind = output->GetPointData()->GetArray("SampleKind");
  vtkDataArray* backboneOf = output->GetPointData()->GetArray("BackboneId");
  for (std::size_t p = 0; p < n; ++p)
  {
    const auto id = static_cast<vtkIdType>(p);
    const bool isBetween = kind->GetComponent(id, 0) == static_cast<double>(SampleKind::Backbone) &&
      fixedLines.count(static_cast<int>(backboneOf->GetComponent(id, 0))) > 0;
    if (isBetween || extraAt.count(placeOf(given.points[p].data())) > 0)
    {
      isExtra[p] = 1;
      extras.push_back(static_cast<int>(p));
    }
  }
  Contraction contraction(given);
  for (bool goesOn = true; goesOn && !extras.empty();)
  {
    goesOn = false;
    for (std::size_t i = 0; i < extras.size(); ++i)
    {
      auto outcome = Contraction::Outcome::Swapped;
      while (outcome == Contraction::Outcome::Swapped)
      {
        outcome = contraction.contract(extras[i], isExtra);
      }
      if (outcome == Contraction::Outcome::Contracted)
      {
        isExtra[extras[i]] = 0;
        sample[extras[i]] = -2; // gone
        extras.erase(extras.begin() + static_cast<std::ptrdiff_t>(i));
        goesOn = true;
        break;
      }
    }
  }
  if (!extras.empty())
  {
    return Status::tooFewPoints("A block's border is too coarse for its mesh: use more points, or "
                                "larger blocks.");
  }

  // What is left, in order: points of the border are several where the block only touches itself.
  std::vector<int> newId(n, -1);
  std::map<int, int> ofSample;
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  mesh.arrays = vtkSmartPointer<vtkPolyData>::New();
  mesh.arrays->GetPointData()->CopyAllOn();
  mesh.arrays->GetPointData()->CopyAllocate(output->GetPointData());
  long long others = 0;
  for (std::size_t p = 0; p < n; ++p)
  {
    if (sample[p] == -2)
    {
      continue;
    }
    if (sample[p] >= 0)
    {
      const auto [found, isNew] = ofSample.try_emplace(sample[p], static_cast<int>(mesh.id.size()));
      newId[p] = found->second;
      if (!isNew)
      {
        continue;
      }
    }
    newId[p] = static_cast<int>(mesh.id.size());
    mesh.id.push_back(sample[p] >= 0 ? sample[p] : -1 - others++); // numbered by the caller
    mesh.position.push_back(given.points[p]);
    mesh.place.emplace_back();
    mesh.data.push_back(newId[p]);
    mesh.arrays->GetPointData()->CopyData(
      output->GetPointData(), static_cast<vtkIdType>(p), newId[p]);
  }
  mesh.arrays->GetCellData()->CopyAllOn();
  mesh.arrays->GetCellData()->CopyAllocate(output->GetCellData());
  for (std::size_t f = 0; f < given.triangles.size(); ++f)
  {
    const Triangle& t = given.triangles[f];
    const int number = static_cast<int>(mesh.triangles.size());
    mesh.triangles.push_back({ { newId[t[0]], newId[t[1]], newId[t[2]] } });
    mesh.trianglePlace.emplace_back();
    mesh.triangleData.push_back(number);
    mesh.arrays->GetCellData()->CopyData(output->GetCellData(), contraction.sourceOf(f), number);
  }
  auto* lines = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(1));
  vtkDataArray* backbone = lines->GetCellData()->GetArray("BackboneId");
  for (vtkIdType l = 0; l < lines->GetNumberOfLines(); ++l)
  {
    lines->GetLines()->GetCellAtId(l, size, ids);
    if (fixedLines.count(static_cast<int>(backbone->GetComponent(l, 0))) > 0)
    {
      continue;
    }
    for (vtkIdType i = 1; i < size; ++i)
    {
      const std::array<int, 2> line = { { newId[ids[i - 1]], newId[ids[i]] } };
      if (line[0] >= 0 && line[1] >= 0 && line[0] != line[1])
      {
        mesh.lines.push_back(line);
      }
    }
  }
  if (vtkDataArray* source = mesh.arrays->GetPointData()->GetArray("SourceCellId"))
  {
    for (vtkIdType p = 0; p < source->GetNumberOfTuples(); ++p)
    {
      const int t = surface.sourceTriangle[static_cast<std::size_t>(source->GetComponent(p, 0))];
      source->SetComponent(p, 0, static_cast<double>(block.cellId[t]));
    }
  }
  numberOfOthers = static_cast<int>(others);
  return Status::success();
}
}

Status remeshBlock(const SurfaceBlock& block, const BlockOutline& outline,
  const BlockBorders& borders, int points, bool isWhole, vtkGeometryRemesher* remesher,
  const Progress& progress, BlockMesh& mesh)
{
  mesh = {};
  BorderedSurface surface;
  makeBordered(block, outline, borders, surface);
  const BlockParameters parameters(remesher, surface, points, isWhole);
  remesher->SetInputData(surface.data);
  // Of those that are asked for some may be spent on the border: then as many more.
  constexpr int Rounds = 8;
  int others = 0;
  for (int round = 0; round < Rounds && others != points; ++round)
  {
    remesher->SetNumberOfPoints(remesher->GetNumberOfPoints() + (round > 0 ? points - others : 0));
    if (Status status = update(remesher, progress); !status.ok())
    {
      return status;
    }
    if (Status status = takeMesh(block, surface, remesher, mesh, others); !status.ok())
    {
      return status;
    }
  }
  if (others != points)
  {
    return Status::internal("Block " + std::to_string(block.number) + " has " +
      std::to_string(others) + " points of its own where " + std::to_string(points) +
      " were asked for.");
  }
  return Status::success();
}
}
