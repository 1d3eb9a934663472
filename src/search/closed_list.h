#pragma once

#include <cstdint>
#include <vector>

namespace fourwis
{

/// The best node known of each cell of the search's state space: an open-addressing hash table of 64-bit keys.
class ClosedList
{
public:
  ClosedList() { clear(1u << 12); }

  /// The node of a cell; inserts -1 for a cell not seen before. The reference is valid until the next call.
  int& operator[](std::uint64_t key)
  {
    if (2 * (used_ + 1) > entries_.size()) grow();
    Entry& entry = find(key);
    if (entry.key == kEmpty)
    {
      entry = {key, -1};
      ++used_;
    }
    return entry.node;
  }

private:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};
  struct Entry
  {
    std::uint64_t key = kEmpty;
    int node = -1;
  };

  Entry& find(std::uint64_t key)
  {
    // Fibonacci hashing; the multiplier is 2^64 / golden ratio.
    std::size_t slot = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> 20) & mask_;
    while (entries_[slot].key != kEmpty && entries_[slot].key != key) slot = (slot + 1) & mask_;
    return entries_[slot];
  }

  void clear(std::size_t size)
  {
    entries_.assign(size, {});
    mask_ = size - 1;
    used_ = 0;
  }

  void grow()
  {
    std::vector<Entry> old;
    old.swap(entries_);
    clear(2 * old.size());
    for (const Entry& entry : old)
      if (entry.key != kEmpty)
      {
        find(entry.key) = entry;
        ++used_;
      }
  }

  std::vector<Entry> entries_;
  std::size_t mask_ = 0;
  std::size_t used_ = 0;
};

}  // namespace fourwis
