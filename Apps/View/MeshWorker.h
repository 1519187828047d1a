// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The whole pipeline in a thread of its own. The thread has its own copy of the input, and what it
// hands over are copies that it forgets.
#ifndef stipple_MeshWorker_h
#define stipple_MeshWorker_h

#include "DotPainter.h"
#include "MeshColors.h"
#include "MeshFigures.h"
#include "SessionWorker.h"

#include <string>

class vtkGeometryRemesher;
class vtkObject;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
/// What the preview works on: does not depend on where samples are wanted.
struct SamplingInput
{
  vtkSmartPointer<vtkPartitionedDataSetCollection> charts;
  vtkSmartPointer<vtkPolyData> graph;
  vtkSmartPointer<vtkPartitionedDataSetCollection> maps;
  int given = 0; ///< samples on top of those that are asked for
};

struct AtlasResult
{
  Session session; ///< that it was made for
  // To be shown:
  vtkSmartPointer<vtkPartitionedDataSetCollection> charts;
  vtkSmartPointer<vtkPolyData> graph;
  SamplingInput sampling; ///< for another thread: shares nothing with the others
};

struct MeshResult
{
  Session session; ///< that it was made with
  vtkSmartPointer<vtkPolyData> mesh;
  vtkSmartPointer<vtkPolyData> lines;
  vtkSmartPointer<vtkPolyData> creases; ///< sharp lines of the input that are creases to it
  vtkSmartPointer<vtkPolyData> lost;    ///< sharp lines of the input that it has not; null: none
  MeshFigures figures;
  MeshColors colors;
  std::shared_ptr<const DotImages> dots; ///< its vertices, on the charts that were handed over last
  double deviation = 0; ///< of no place is it more, in % of the diagonal; 0: nobody asked
  double seconds = 0;
};

class MeshWorker : public SessionWorker
{
public:
  /// The input is copied.
  explicit MeshWorker(vtkPolyData* input);
  ~MeshWorker() override; ///< stops what runs

  /// Meshes this next; what runs is stopped, unless it still makes charts or maps that the new
  /// session needs as well.
  void start(const Session& session);
  /// Stops what runs before its mesh is done; charts and maps are still finished.
  void relax();
  /// Stops everything at once.
  void cancel();

  [[nodiscard]] bool busy() const { return this->Busy; }
  /// Nothing runs, and all that was done has been taken: not the same, as work may end at any time.
  [[nodiscard]] bool idle();
  /// What runs has no maps yet.
  [[nodiscard]] bool makesCharts() const { return this->Busy && !this->MapsDone; }
  [[nodiscard]] double progress() const { return this->Fraction; }
  /// The number of points that is tried, where one is looked for; else 0.
  [[nodiscard]] int tried() const { return this->Busy ? this->Tried.load() : 0; }

  /// What is done since it was asked last; null if nothing.
  [[nodiscard]] std::unique_ptr<AtlasResult> takeAtlas();
  [[nodiscard]] std::unique_ptr<MeshResult> takeMesh();
  /// The sentence of what failed; empty if nothing did.
  [[nodiscard]] std::string takeError();

private:
  enum Stop
  {
    GoOn,
    BeforeTheMesh, ///< once charts and maps are done
    AtOnce
  };
  static void onEvent(vtkObject* caller, unsigned long event, void* self, void* callData);
  void stop() override { this->StopAsked = AtOnce; }
  void prepare(const Session& session) override;
  void takeImage(vtkImageData* image) override;
  void perform(const Session& session) override;
  void publishAtlas();
  bool inspect(MeshResult& result);

  vtkSmartPointer<vtkGeometryRemesher> Remesher; ///< the thread's
  TriangleSurface Input;                         ///< the thread's
  std::unique_ptr<NearestTriangle> NearestInput; ///< the thread's; made when first needed
  unsigned long PublishedTime = 0;               ///< the thread's
  Session Current;                               ///< written under the mutex
  std::unique_ptr<AtlasResult> Atlas;
  std::unique_ptr<MeshResult> Mesh;
  std::string Error;
  std::atomic<int> StopAsked{ GoOn };
  std::atomic<bool> MapsDone{ false }; ///< of what runs
  std::atomic<double> Fraction{ 0. };
  std::atomic<int> Tried{ 0 };
};
}

#endif
