// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// StippleMeshCheck MESH.off REFERENCE.off [FEATURE-ANGLE]
//
// Checks a mesh against the surface that it was made of, and prints what it found as JSON. It
// shares no code with the project, so that it does not repeat the project's mistakes: it uses
// nothing but the C++ standard library.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace
{
using Point = std::array<double, 3>;

Point operator-(const Point& a, const Point& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}
Point operator+(const Point& a, const Point& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}
Point operator*(double t, const Point& a)
{
  return { { t * a[0], t * a[1], t * a[2] } };
}
double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point& a, const Point& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}
double norm(const Point& a)
{
  return std::sqrt(dot(a, a));
}

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
};

Mesh read(const char* file)
{
  std::ifstream stream(file);
  std::string word;
  int points = 0;
  int faces = 0;
  int edges = 0;
  if (!(stream >> word >> points >> faces >> edges) || word != "OFF")
  {
    std::fprintf(stderr, "MeshCheck: cannot read '%s'\n", file);
    std::exit(2);
  }
  Mesh mesh;
  mesh.points.resize(points);
  for (Point& p : mesh.points)
  {
    stream >> p[0] >> p[1] >> p[2];
  }
  for (int f = 0; f < faces; ++f)
  {
    int size = 0;
    stream >> size;
    std::vector<int> ids(size);
    for (int& id : ids)
    {
      stream >> id;
    }
    for (int k = 2; k < size; ++k)
    {
      mesh.triangles.push_back({ { ids[0], ids[k - 1], ids[k] } });
    }
  }
  if (!stream)
  {
    std::fprintf(stderr, "MeshCheck: '%s' ends too early\n", file);
    std::exit(2);
  }
  if (mesh.triangles.empty())
  {
    std::fprintf(stderr, "MeshCheck: '%s' has no triangle\n", file);
    std::exit(2);
  }
  return mesh;
}

/// Points at the same place become one.
void weld(Mesh& mesh)
{
  std::map<Point, int> places;
  std::vector<Point> points;
  std::vector<int> index;
  for (const Point& p : mesh.points)
  {
    const auto found = places.emplace(p, static_cast<int>(points.size()));
    if (found.second)
    {
      points.push_back(p);
    }
    index.push_back(found.first->second);
  }
  mesh.points = points;
  for (auto& t : mesh.triangles)
  {
    t = { { index[t[0]], index[t[1]], index[t[2]] } };
  }
}

double diagonal(const Mesh& mesh)
{
  Point low = mesh.points[mesh.triangles[0][0]];
  Point high = low;
  for (const auto& t : mesh.triangles)
  {
    for (int p : t)
    {
      for (int k = 0; k < 3; ++k)
      {
        low[k] = std::min(low[k], mesh.points[p][k]);
        high[k] = std::max(high[k], mesh.points[p][k]);
      }
    }
  }
  return norm(high - low);
}

/// Number of connected sets among the nodes that edges name.
int connectedSets(const std::set<std::pair<int, int>>& edges)
{
  std::map<int, std::vector<int>> neighbours;
  for (const auto& e : edges)
  {
    neighbours[e.first].push_back(e.second);
    neighbours[e.second].push_back(e.first);
  }
  std::set<int> seen;
  int count = 0;
  for (const auto& start : neighbours)
  {
    std::vector<int> stack;
    if (seen.insert(start.first).second)
    {
      ++count;
      stack.push_back(start.first);
    }
    while (!stack.empty())
    {
      const int p = stack.back();
      stack.pop_back();
      for (int q : neighbours[p])
      {
        if (seen.insert(q).second)
        {
          stack.push_back(q);
        }
      }
    }
  }
  return count;
}

using Figures = std::map<std::string, double>;

void measureTopology(const Mesh& mesh, const std::string& prefix, Figures& out)
{
  std::map<std::pair<int, int>, int> directed;
  std::set<std::pair<int, int>> edges;
  std::vector<std::vector<std::pair<int, int>>> link(mesh.points.size());
  double degenerate = 0;
  for (const auto& t : mesh.triangles)
  {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[k];
      const int b = t[(k + 1) % 3];
      ++directed[{ a, b }];
      edges.insert({ std::min(a, b), std::max(a, b) });
      link[t[(k + 2) % 3]].push_back({ a, b });
      longest = std::max(longest, norm(mesh.points[a] - mesh.points[b]));
    }
    const double area = 0.5 *
      norm(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]));
    degenerate += !(area > 1e-12 * longest * longest);
  }
  std::set<std::pair<int, int>> boundary;
  double inconsistent = 0;
  for (const auto& e : directed)
  {
    inconsistent += e.second > 1;
    if (directed.count({ e.first.second, e.first.first }) == 0)
    {
      boundary.insert(e.first);
    }
  }
  // A vertex is manifold if its link, the edges opposite to it, is one path or one cycle.
  double unused = 0;
  double singular = 0;
  for (const auto& opposite : link)
  {
    std::map<int, int> degree;
    for (const auto& e : opposite)
    {
      ++degree[e.first];
      ++degree[e.second];
    }
    bool simple = true;
    for (const auto& d : degree)
    {
      simple = simple && d.second <= 2;
    }
    unused += opposite.empty();
    singular +=
      !opposite.empty() && (!simple || connectedSets({ opposite.begin(), opposite.end() }) != 1);
  }
  out[prefix + "points"] = static_cast<double>(mesh.points.size());
  out[prefix + "triangles"] = static_cast<double>(mesh.triangles.size());
  out[prefix + "unused_points"] = unused;
  out[prefix + "singular_vertices"] = singular;
  out[prefix + "inconsistent_edges"] = inconsistent;
  out[prefix + "degenerate"] = degenerate;
  out[prefix + "components"] = connectedSets(edges);
  out[prefix + "boundary_loops"] = connectedSets(boundary);
  out[prefix + "euler"] = static_cast<double>(mesh.points.size()) - unused -
    static_cast<double>(edges.size()) + static_cast<double>(mesh.triangles.size());
}

/// Squared distance to a triangle: to its plane if the foot lies within, else to its nearest edge.
double squaredDistance(const Point& p, const Point& a, const Point& b, const Point& c)
{
  const Point n = cross(b - a, c - a);
  const double nn = dot(n, n);
  if (nn > 0 && dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
    dot(cross(a - c, p - c), n) >= 0)
  {
    const double d = dot(p - a, n);
    return d * d / nn;
  }
  const auto toEdge = [&p](const Point& s, const Point& e) {
    const Point u = e - s;
    const double uu = dot(u, u);
    const double t = uu > 0 ? std::clamp(dot(p - s, u) / uu, 0., 1.) : 0.;
    const Point d = p - (s + t * u);
    return dot(d, d);
  };
  return std::min({ toEdge(a, b), toEdge(b, c), toEdge(c, a) });
}

/// Nearest distances by a grid of cubes, searched shell by shell.
class Grid
{
public:
  explicit Grid(const Mesh& mesh)
    : Surface(mesh)
    , Size(diagonal(mesh) / std::max(8., std::sqrt(static_cast<double>(mesh.triangles.size()))))
  {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      Cube low = { { 1 << 30, 1 << 30, 1 << 30 } };
      Cube high = { { -(1 << 30), -(1 << 30), -(1 << 30) } };
      for (int p : mesh.triangles[t])
      {
        const Cube cube = this->cubeOf(mesh.points[p]);
        for (int k = 0; k < 3; ++k)
        {
          low[k] = std::min(low[k], cube[k]);
          high[k] = std::max(high[k], cube[k]);
        }
      }
      for (int i = low[0]; i <= high[0]; ++i)
      {
        for (int j = low[1]; j <= high[1]; ++j)
        {
          for (int k = low[2]; k <= high[2]; ++k)
          {
            this->Cubes[{ { i, j, k } }].push_back(static_cast<int>(t));
          }
        }
      }
    }
  }

  double distance(const Point& p) const
  {
    const Cube at = this->cubeOf(p);
    double best = 1e300;
    // What lies in the shell r is at least (r - 1) cubes away.
    for (int r = 0; r < 4096 && std::sqrt(best) > (r - 1) * this->Size; ++r)
    {
      for (int i = -r; i <= r; ++i)
      {
        for (int j = -r; j <= r; ++j)
        {
          const bool face = std::abs(i) == r || std::abs(j) == r;
          for (int k = -r; k <= r; k += face ? 1 : std::max(1, 2 * r))
          {
            const auto found = this->Cubes.find({ { at[0] + i, at[1] + j, at[2] + k } });
            if (found == this->Cubes.end())
            {
              continue;
            }
            for (int t : found->second)
            {
              const auto& c = this->Surface.triangles[t];
              best = std::min(best,
                squaredDistance(p, this->Surface.points[c[0]], this->Surface.points[c[1]],
                  this->Surface.points[c[2]]));
            }
          }
        }
      }
    }
    return std::sqrt(best);
  }

private:
  using Cube = std::array<int, 3>;
  Cube cubeOf(const Point& p) const
  {
    return { { static_cast<int>(std::floor(p[0] / this->Size)),
      static_cast<int>(std::floor(p[1] / this->Size)),
      static_cast<int>(std::floor(p[2] / this->Size)) } };
  }
  const Mesh& Surface;
  double Size;
  std::map<Cube, std::vector<int>> Cubes;
};

/// Mean length of the triangles' edges.
double meanEdge(const Mesh& mesh)
{
  double total = 0;
  for (const auto& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      total += norm(mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]);
    }
  }
  return total / std::max(1., 3. * static_cast<double>(mesh.triangles.size()));
}

/// Largest distance of some points spread over `from` (vertices, and points within triangles) to
/// `to`.
double oneSided(const Mesh& from, const Mesh& to)
{
  const Grid grid(to);
  double largest = 0;
  for (const auto& t : from.triangles)
  {
    for (int p : t)
    {
      largest = std::max(largest, grid.distance(from.points[p]));
    }
    const Point middle = 1. / 3. * (from.points[t[0]] + from.points[t[1]] + from.points[t[2]]);
    largest = std::max(largest, grid.distance(middle));
  }
  return largest;
}

/// A maximal chain of sharp edges between nodes.
using Chain = std::vector<int>;

struct Features
{
  std::set<int> corners; ///< three or more sharp edges meet, or two turn by more than 60 degrees
  std::vector<Chain> chains;
};

Features findFeatures(const Mesh& mesh, double angle)
{
  std::map<std::pair<int, int>, std::vector<Point>> normals;
  for (const auto& t : mesh.triangles)
  {
    const Point n =
      cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
    for (int k = 0; k < 3; ++k)
    {
      normals[{ std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]) }].push_back(
        1. / norm(n) * n);
    }
  }
  std::map<int, std::vector<int>> sharp;
  for (const auto& e : normals)
  {
    if (e.second.size() == 2 &&
      std::acos(std::clamp(dot(e.second[0], e.second[1]), -1., 1.)) * 57.29577951308232 > angle)
    {
      sharp[e.first.first].push_back(e.first.second);
      sharp[e.first.second].push_back(e.first.first);
    }
  }
  Features features;
  std::set<int> ends;
  for (const auto& s : sharp)
  {
    const Point& p = mesh.points[s.first];
    bool corner = s.second.size() > 2;
    if (s.second.size() == 2)
    {
      const Point u = p - mesh.points[s.second[0]];
      const Point v = mesh.points[s.second[1]] - p;
      corner = dot(u, v) < 0.5 * norm(u) * norm(v);
    }
    if (corner)
    {
      features.corners.insert(s.first);
    }
    if (corner || s.second.size() == 1)
    {
      ends.insert(s.first);
    }
  }
  std::set<std::pair<int, int>> walked;
  const auto walk = [&](int from, int to) {
    Chain chain = { from };
    while (walked.insert({ from, to }).second && walked.insert({ to, from }).second)
    {
      chain.push_back(to);
      if (ends.count(to))
      {
        break;
      }
      const int next = sharp[to][0] == from ? sharp[to][1] : sharp[to][0];
      from = to;
      to = next;
    }
    if (chain.size() > 1)
    {
      features.chains.push_back(chain);
    }
  };
  for (int end : ends)
  {
    for (int next : std::vector<int>(sharp[end]))
    {
      walk(end, next);
    }
  }
  for (const auto& s : sharp) // cycles
  {
    walk(s.first, s.second[0]);
  }
  return features;
}

/// Whether the mesh has each corner as a vertex, and each chain as a chain of edges.
void checkFeatures(const Mesh& mesh, const Mesh& reference, double angle, Figures& out)
{
  const Features features = findFeatures(reference, angle);
  const double tolerance = 1e-9 * diagonal(reference);
  std::set<std::pair<int, int>> edges;
  for (const auto& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert({ std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]) });
    }
  }
  double lostCorners = 0;
  for (int corner : features.corners)
  {
    double nearest = 1e300;
    for (const Point& p : mesh.points)
    {
      nearest = std::min(nearest, norm(p - reference.points[corner]));
    }
    lostCorners += nearest > tolerance;
  }
  double brokenChains = 0;
  double emptyChains = 0;
  for (const Chain& chain : features.chains)
  {
    std::map<double, int> along; // vertices of the mesh by arc length
    double length = 0;
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      const Point& a = reference.points[chain[i - 1]];
      const Point u = reference.points[chain[i]] - a;
      const double l = norm(u);
      for (std::size_t p = 0; p < mesh.points.size(); ++p)
      {
        const Point d = mesh.points[p] - a;
        const double t = dot(d, u) / (l * l);
        if (t >= -tolerance / l && t <= 1 + tolerance / l && norm(d - t * u) <= tolerance)
        {
          along.emplace(length + t * l, static_cast<int>(p));
        }
      }
      length += l;
    }
    std::vector<int> vertices;
    for (const auto& v : along)
    {
      if (vertices.empty() || vertices.back() != v.second)
      {
        vertices.push_back(v.second);
      }
    }
    if (chain.front() == chain.back() && !vertices.empty() && vertices.front() != vertices.back())
    {
      vertices.push_back(vertices.front());
    }
    emptyChains += vertices.size() < 2;
    bool broken = false;
    for (std::size_t i = 1; i < vertices.size(); ++i)
    {
      broken = broken ||
        edges.count(
          { std::min(vertices[i - 1], vertices[i]), std::max(vertices[i - 1], vertices[i]) }) == 0;
    }
    brokenChains += broken;
  }
  out["corners"] = static_cast<double>(features.corners.size());
  out["lost_corners"] = lostCorners;
  out["chains"] = static_cast<double>(features.chains.size());
  out["broken_chains"] = brokenChains;
  out["empty_chains"] = emptyChains;
}
}

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::fprintf(stderr, "usage: StippleMeshCheck MESH.off REFERENCE.off [FEATURE-ANGLE]\n");
    return 2;
  }
  const Mesh mesh = read(argv[1]);
  Mesh reference = read(argv[2]);
  weld(reference);
  Figures figures;
  measureTopology(mesh, "", figures);
  measureTopology(reference, "reference_", figures);
  figures["edge_percent"] = 100. * meanEdge(mesh) / diagonal(reference);
  figures["hausdorff_percent"] =
    100. * std::max(oneSided(mesh, reference), oneSided(reference, mesh)) / diagonal(reference);
  if (argc > 3)
  {
    checkFeatures(mesh, reference, std::atof(argv[3]), figures);
  }
  std::printf("{");
  const char* separator = "";
  for (const auto& figure : figures)
  {
    std::printf("%s\"%s\": %.17g", separator, figure.first.c_str(), figure.second);
    separator = ", ";
  }
  std::printf("}\n");
  return 0;
}
