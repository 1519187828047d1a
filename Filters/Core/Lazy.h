// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_Lazy_h
#define stipple_Lazy_h

#include <atomic>
#include <mutex>
#include <optional>

namespace stipple
{
/// A value that is made when it is first asked for, once, whatever thread asks.
template <typename T>
class Lazy
{
public:
  template <typename Make>
  const T& get(const Make& make) const
  {
    const T* made = this->Made.load(std::memory_order_acquire);
    if (!made)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Value)
      {
        this->Value.emplace(make());
      }
      made = &*this->Value;
      this->Made.store(made, std::memory_order_release);
    }
    return *made;
  }

private:
  mutable std::mutex Mutex;
  mutable std::optional<T> Value;
  mutable std::atomic<const T*> Made = nullptr;
};
}

#endif
