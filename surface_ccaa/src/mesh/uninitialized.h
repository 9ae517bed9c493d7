// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: big arrays whose first touch is the write that fills them.
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief Allocator that leaves plain values uninitialised when a vector grows by
 * resize(). Zeroing an array that is filled right afterwards costs a pass over memory,
 * and one thread pays all its page faults. */
template <typename T>
struct UninitializedAllocator : std::allocator<T> {
  template <typename Other>
  struct rebind {
    using other = UninitializedAllocator<Other>;
  };

  template <typename Item>
  void
  construct(Item* item)
  {
    ::new (static_cast<void*>(item)) Item;
  }
  template <typename Item, typename... Arguments>
  void
  construct(Item* item, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(item)) Item(std::forward<Arguments>(arguments)...);
  }
};

/** \brief A vector for plain values; after resize(n) the new items must be written
 * before they are read. */
template <typename T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

} // namespace pcl::ccaa
