// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Many short lists in one array, one behind the other, as rows of sparse matrices are stored.
#ifndef stipple_CompressedRows_h
#define stipple_CompressedRows_h

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace stipple
{
/// Rows of values, filled at once: a stable counting sort, in linear time. `Index` counts all
/// values.
template <typename Value, typename Index = int>
class CompressedRows
{
public:
  /// The values of a row, in the order in which they were told.
  template <typename Pointer>
  struct Row
  {
    Pointer first;
    Pointer last;
    Pointer begin() const { return this->first; }
    Pointer end() const { return this->last; }
    std::size_t size() const { return static_cast<std::size_t>(this->last - this->first); }
  };

  CompressedRows() = default;
  /// forEach(add) is called twice, and calls add(row, value) for the same values both times.
  template <typename ForEach>
  CompressedRows(std::size_t rows, const ForEach& forEach)
    : Begin(rows + 1, 0)
  {
    forEach([this](std::size_t row, const Value&) { ++this->Begin[row + 1]; });
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    this->Values.resize(static_cast<std::size_t>(this->Begin.back()));
    std::vector<Index> next(this->Begin.begin(), this->Begin.end() - 1);
    forEach([&](std::size_t row, const Value& value) { this->Values[next[row]++] = value; });
  }

  std::size_t numberOfRows() const { return this->Begin.empty() ? 0 : this->Begin.size() - 1; }
  Row<const Value*> operator[](std::size_t row) const
  {
    return { this->Values.data() + this->Begin[row], this->Values.data() + this->Begin[row + 1] };
  }
  Row<Value*> operator[](std::size_t row)
  {
    return { this->Values.data() + this->Begin[row], this->Values.data() + this->Begin[row + 1] };
  }
  /// Of all rows, one behind the other; nothing is left here.
  std::vector<Value> takeValues() { return std::move(this->Values); }

private:
  std::vector<Index> Begin; // of each row in Values, and the end
  std::vector<Value> Values;
};
}

#endif
