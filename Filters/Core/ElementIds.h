// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Ids of a mesh's elements, each a type of its own: a face cannot be taken for a vertex. An id is
// an int inside and costs nothing.
#ifndef stipple_ElementIds_h
#define stipple_ElementIds_h

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace stipple
{
template <typename Element>
class ElementId
{
public:
  constexpr ElementId() = default; ///< none
  constexpr explicit ElementId(int index)
    : Index(index)
  {
  }
  /// From 0; negative if there is none.
  constexpr int index() const { return this->Index; }
  constexpr bool valid() const { return this->Index >= 0; }

  friend constexpr bool operator==(ElementId a, ElementId b) { return a.Index == b.Index; }
  friend constexpr bool operator!=(ElementId a, ElementId b) { return a.Index != b.Index; }
  friend constexpr bool operator<(ElementId a, ElementId b) { return a.Index < b.Index; }
  friend constexpr bool operator>(ElementId a, ElementId b) { return a.Index > b.Index; }

private:
  int Index = -1;
  template <typename, typename>
  friend class ElementArray;
};

using Vertex = ElementId<struct VertexElement>;     ///< a point of a surface
using Halfedge = ElementId<struct HalfedgeElement>; ///< an edge in the direction of one triangle
using Face = ElementId<struct FaceElement>;         ///< a triangle
using Chart = ElementId<struct ChartElement>;       ///< a disk of the atlas
using BackboneId = ElementId<struct BackboneElement>;

/// The ids from first up to, but not with, last: for (Face f : surface.faces()).
template <typename Id>
class ElementRange
{
public:
  class Iterator
  {
  public:
    constexpr explicit Iterator(int index)
      : Index(index)
    {
    }
    constexpr Id operator*() const { return Id(this->Index); }
    constexpr Iterator& operator++()
    {
      ++this->Index;
      return *this;
    }
    constexpr bool operator!=(const Iterator& o) const { return this->Index != o.Index; }

  private:
    int Index;
  };
  constexpr ElementRange(int first, int last)
    : First(first)
    , Last(last)
  {
  }
  constexpr Iterator begin() const { return Iterator(this->First); }
  constexpr Iterator end() const { return Iterator(this->Last); }
  constexpr int size() const { return this->Last - this->First; }

private:
  int First;
  int Last;
};

/// One value an element: a vector that takes ids of one kind only.
template <typename Id, typename T>
class ElementArray
{
public:
  ElementArray() = default;
  explicit ElementArray(std::size_t size, const T& value = T())
    : Values(size, value)
  {
  }
  T& operator[](Id id) { return this->Values[static_cast<std::size_t>(id.index())]; }
  const T& operator[](Id id) const { return this->Values[static_cast<std::size_t>(id.index())]; }

  std::size_t size() const { return this->Values.size(); }
  bool empty() const { return this->Values.empty(); }
  void clear() { this->Values.clear(); }
  void reserve(std::size_t size) { this->Values.reserve(size); }
  void resize(std::size_t size, const T& value = T()) { this->Values.resize(size, value); }
  void assign(std::size_t size, const T& value) { this->Values.assign(size, value); }
  void push_back(const T& value) { this->Values.push_back(value); }
  ElementRange<Id> ids() const { return { 0, static_cast<int>(this->Values.size()) }; }
  auto begin() { return this->Values.begin(); }
  auto end() { return this->Values.end(); }
  auto begin() const { return this->Values.begin(); }
  auto end() const { return this->Values.end(); }
  bool operator==(const ElementArray& o) const { return this->Values == o.Values; }

  /// For callers that still count elements with an int; they read and write ids as ints, too.
  auto& operator[](std::size_t i) { return plain(this->Values[i]); }
  const auto& operator[](std::size_t i) const { return plain(this->Values[i]); }

private:
  template <typename U>
  static auto& plain(U& value)
  {
    if constexpr (std::is_class_v<std::remove_const_t<U>>)
    {
      return plainId(value);
    }
    else
    {
      return value;
    }
  }
  template <typename E>
  static int& plainId(ElementId<E>& id)
  {
    return id.Index;
  }
  template <typename E>
  static const int& plainId(const ElementId<E>& id)
  {
    return id.Index;
  }
  template <typename U>
  static U& plainId(U& value)
  {
    return value;
  }
  std::vector<T> Values;
};
}

/// So that ids are keys of unordered containers.
namespace std
{
template <typename Element>
struct hash<stipple::ElementId<Element>>
{
  std::size_t operator()(stipple::ElementId<Element> id) const noexcept
  {
    return std::hash<int>()(id.index());
  }
};
}

#endif
