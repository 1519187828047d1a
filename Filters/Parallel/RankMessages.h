// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What ranks tell one another, as vectors of plain values. Each call is made by all ranks.
#ifndef stipple_RankMessages_h
#define stipple_RankMessages_h

#include "Guarded.h"
#include "StippleFiltersParallelModule.h"

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

class vtkMultiProcessController;

namespace stipple
{
using Bytes = std::vector<char>;

class STIPPLEFILTERSPARALLEL_EXPORT RankMessages
{
public:
  /// Null is one rank.
  explicit RankMessages(vtkMultiProcessController* controller);

  int rank() const { return this->Rank; }
  int size() const { return this->Size; }
  /// Bytes that this rank has sent to others.
  double sent() const { return this->Sent; }

  /// To each value, those of all ranks are added.
  void sum(std::vector<long long>& values) const;
  /// Of each value the least of all ranks.
  void minimum(std::vector<double>& values) const;

  /// Each rank's bytes to all, by rank.
  std::vector<Bytes> gather(const Bytes& own) const;
  /// bytes[r] goes to rank r; answers what each rank sent here.
  std::vector<Bytes> exchange(std::vector<Bytes> bytes) const;

  /// Each rank's values to all, one rank's behind the other's.
  template <typename T>
  std::vector<T> gatherAll(const std::vector<T>& own) const
  {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> all;
    for (const Bytes& bytes : this->gather(bytesOf(own)))
    {
      append(bytes, all);
    }
    return all;
  }

  /// A failure on one rank is that of all ranks: of the first rank that has one, its sentence.
  Status agree(const Status& own) const;

  template <typename T>
  static Bytes bytesOf(const std::vector<T>& values)
  {
    Bytes bytes(values.size() * sizeof(T));
    if (!values.empty())
    {
      std::memcpy(bytes.data(), values.data(), bytes.size());
    }
    return bytes;
  }
  template <typename T>
  static void append(const Bytes& bytes, std::vector<T>& values)
  {
    const std::size_t before = values.size();
    values.resize(before + bytes.size() / sizeof(T));
    if (!bytes.empty())
    {
      std::memcpy(values.data() + before, bytes.data(), bytes.size());
    }
  }

private:
  vtkMultiProcessController* Controller = nullptr; // null with one rank
  int Rank = 0;
  int Size = 1;
  mutable double Sent = 0;
};
}

#endif
