#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

namespace fourwis
{

/// The number of allocations of all threads since the start of the program. To be included by one file of a program.
inline std::atomic<long> allocations{0};

}  // namespace fourwis

namespace
{

void* counted(void* memory)
{
  ++fourwis::allocations;
  return memory ? memory : throw std::bad_alloc();
}

}  // namespace

// Not inlined: otherwise the compiler sees that memory of `new` goes to `free`, and warns.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  return counted(std::malloc(size));
}

[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment)
{
  const std::size_t unit = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}

[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}
