// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// StippleAbortTimes MODEL.off SUBDIVISIONS POINTS ABORTS
//
// Remeshes a surface, and again, stopped at random moments of that time, so often; then once more
// to the end. Prints as JSON the seconds that it took from the wish to the end (median, largest,
// largest by stage), by the clock, which a busy machine makes longer, and of processors since the
// filter was told, at most 10 ms after; and what must not be: aborts that left a mesh, threads or
// memory behind, other bytes afterwards.
#include "MeshFile.h"
#include "Messages.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkConformalAtlas.h"
#include "vtkGeometryRemesher.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <malloc.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

using Clock = std::chrono::steady_clock;

namespace
{
constexpr std::array<const char*, 6> StageNames = { "atlas", "maps", "control", "sampling",
  "meshing", "optimisation" };

double secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Of all threads together.
double processorSeconds()
{
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double medianOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0. : values[values.size() / 2];
}

/// A number of /proc/self/status: "Threads", "VmRSS" (in KB).
long statusOf(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, name.size() + 1, name + ":") == 0)
    {
      return std::atol(line.c_str() + name.size() + 1);
    }
  }
  return -1;
}

/// How many more than so many there are: the kernel counts one that has ended, and was waited for,
/// for some moments more.
long threadsBeyond(long threads)
{
  long more = statusOf("Threads") - threads;
  for (int i = 0; i < 100 && more > 0; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    more = statusOf("Threads") - threads;
  }
  return more;
}

/// In KB: what is allocated, and what of the memory the process keeps once what is free has been
/// given back.
struct Memory
{
  long allocated;
  long resident;

  static Memory now()
  {
    malloc_trim(0);
    const struct mallinfo2 info = mallinfo2(); // of all arenas
    return { static_cast<long>((info.uordblks + info.hblkhd) / 1024), statusOf("VmRSS") };
  }
};

/// By how much the least of the second half of the measurements is more than the least of the
/// first. What aborts leave behind adds up, and shows in both; what lies free between memory in use
/// differs with the timing of threads, five to ten megabytes in one run of four, and not at all if
/// they share an arena (MALLOC_ARENA_MAX=1, mallopt(3)).
long growthOf(const std::vector<Memory>& memory, long Memory::*kind)
{
  const auto less = [kind](const Memory& a, const Memory& b) { return a.*kind < b.*kind; };
  const auto middle = memory.begin() + static_cast<std::ptrdiff_t>(memory.size() / 2);
  return (*std::min_element(middle, memory.end(), less)).*kind -
    (*std::min_element(memory.begin(), middle, less)).*kind;
}

/// Points and corners, hashed (FNV-1a).
std::uint64_t hashOf(vtkPolyData* mesh)
{
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&hash](const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
    {
      hash = (hash ^ bytes[i]) * 1099511628211u;
    }
  };
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    add(x, sizeof(x));
  }
  for (vtkIdType c = 0; c < mesh->GetNumberOfPolys(); ++c)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(c, size, ids);
    add(ids, sizeof(vtkIdType) * static_cast<std::size_t>(size));
  }
  return hash;
}

/// Wishes the end of a remesh at a moment, which the remesher hears of as users' programs tell it:
/// by an observer of its progress.
class Wish
{
public:
  explicit Wish(vtkGeometryRemesher* remesher)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject* caller, unsigned long event, void* self, void* data) {
      auto* wish = static_cast<Wish*>(self);
      if (event == vtkGeometryRemesher::StageStartEvent)
      {
        wish->Stage = *static_cast<int*>(data);
      }
      else if (!wish->Told && secondsSince(wish->Begin) >= wish->After)
      {
        wish->Told = true;
        wish->ProcessorsWhenTold = processorSeconds();
        static_cast<vtkGeometryRemesher*>(caller)->SetAbortExecute(1);
      }
    });
    remesher->AddObserver(vtkCommand::ProgressEvent, command);
    remesher->AddObserver(vtkGeometryRemesher::StageStartEvent, command);
  }
  void make(double after)
  {
    this->After = after;
    this->Told = false;
    this->Begin = Clock::now();
  }
  /// Seconds since the wish; negative if its moment has not come.
  double waited() const { return secondsSince(this->Begin) - this->After; }
  /// Processors' seconds since the filter was told.
  double worked() const { return this->Told ? processorSeconds() - this->ProcessorsWhenTold : 0.; }
  int stage() const { return this->Stage; }

private:
  Clock::time_point Begin;
  double After = 0;
  bool Told = false;
  double ProcessorsWhenTold = 0;
  int Stage = 0;
};

vtkSmartPointer<vtkPolyData> readInput(const char* file, int subdivisions)
{
  vtkSmartPointer<vtkPolyData> mesh;
  if (!stipple::readMesh(file, mesh).ok())
  {
    return nullptr;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  vtkNew<vtkLoopSubdivisionFilter> subdivision;
  subdivision->SetInputConnection(triangles->GetOutputPort());
  subdivision->SetNumberOfSubdivisions(subdivisions);
  vtkAlgorithm* last = triangles;
  if (subdivisions > 0)
  {
    last = subdivision;
  }
  last->Update();
  return vtkPolyData::SafeDownCast(last->GetOutputDataObject(0));
}
}

int main(int argc, char* argv[])
{
  if (argc != 5)
  {
    std::fprintf(stderr, "usage: StippleAbortTimes MODEL SUBDIVISIONS POINTS ABORTS\n");
    return 2;
  }
  const auto window = stipple::CollectingOutputWindow::install();
  const auto input = readInput(argv[1], std::atoi(argv[2]));
  if (!input)
  {
    std::fprintf(stderr, "AbortTimes: cannot read '%s'\n", argv[1]);
    return 2;
  }
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(input);
  remesher->SetNumberOfPoints(std::atoi(argv[3]));
  Wish wish(remesher);

  const auto runToTheEnd = [&] {
    remesher->GetAtlas()->Modified(); // from the beginning
    wish.make(1e9);
    remesher->Update();
    return 1e9 + wish.waited();
  };
  runToTheEnd();
  double whole = runToTheEnd(); // libraries are loaded, caches are warm
  const std::uint64_t expected = hashOf(remesher->GetOutput());
  const long threads = statusOf("Threads");

  std::mt19937 random(1);
  std::vector<double> waits;
  std::vector<double> works;
  std::array<double, StageNames.size()> longest = {}; // by stage
  std::array<double, StageNames.size()> mostWork = {};
  int meshes = 0;
  int missed = 0;
  const int aborts = std::atoi(argv[4]);
  std::vector<Memory> memory; // after whole runs between the aborts
  const auto measure = [&] {
    whole = runToTheEnd();
    memory.push_back(Memory::now());
  };
  for (int i = 0; i < aborts; ++i)
  {
    if (i > 0 && i % std::max(1, aborts / 6) == 0)
    {
      measure();
    }
    remesher->GetAtlas()->Modified();
    const double moment = whole * std::uniform_real_distribution<>(0., .98)(random);
    wish.make(moment);
    remesher->Update();
    const double waited = wish.waited();
    const double worked = wish.worked();
    if (remesher->GetErrorCode() == 0) // it was done before its time: the machine is less busy now
    {
      whole = moment + waited;
      ++missed;
      continue;
    }
    meshes += remesher->GetOutput()->GetNumberOfPoints() > 0 ||
      remesher->GetErrorCode() != vtkGeometryRemesher::ABORTED;
    waits.push_back(waited);
    works.push_back(worked);
    const auto stage = static_cast<std::size_t>(wish.stage());
    longest[stage] = std::max(longest[stage], waited);
    mostWork[stage] = std::max(mostWork[stage], worked);
  }
  const long moreThreads = threadsBeyond(threads);
  measure();
  std::string stages;
  for (std::size_t i = 0; i < StageNames.size(); ++i)
  {
    stages += std::string(i > 0 ? ", " : "") + "\"" + StageNames[i] + "\": [" +
      std::to_string(longest[i]) + ", " + std::to_string(mostWork[i]) + "]";
  }
  std::printf(
    "{\"triangles\": %lld, \"seconds\": %.3f, \"aborts\": %zu, \"missed\": %d, \"median\": "
    "%.4f, \"largest\": %.4f, \"median_of_processors\": %.4f, \"largest_of_processors\": %.4f, "
    "\"largest_by_stage\": {%s}, \"left_meshes\": %d, \"more_threads\": %ld, "
    "\"memory_growth_kb\": %ld, \"resident_growth_kb\": %ld, \"same_bytes\": %s}\n",
    static_cast<long long>(input->GetNumberOfPolys()), whole, waits.size(), missed, medianOf(waits),
    waits.empty() ? 0. : *std::max_element(waits.begin(), waits.end()), medianOf(works),
    works.empty() ? 0. : *std::max_element(works.begin(), works.end()), stages.c_str(), meshes,
    moreThreads, growthOf(memory, &Memory::allocated), growthOf(memory, &Memory::resident),
    hashOf(remesher->GetOutput()) == expected ? "true" : "false");
  return 0;
}
