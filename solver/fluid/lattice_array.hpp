#pragma once
/// Memory of the lattice: aligned to cache lines, and large arrays on large pages where the system has them.
#include <cstddef>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace dld {

/// Rows begin on a cache line, so that a vector of 64 bytes lies in one: a load or store that crosses into
/// the next one costs twice. Arrays of 2 MiB and more are on pages of 2 MiB if Linux will give them: a
/// lattice of tens of MiB otherwise spends a fifth of its time on looking up pages.
template <class Value>
struct LatticeAllocator {
  using value_type = Value;

  LatticeAllocator() = default;
  template <class Other>
  explicit LatticeAllocator(const LatticeAllocator<Other>&) {}

  Value* allocate(std::size_t n) {
    const std::size_t bytes = n * sizeof(Value), at = alignment(n);
    void* const memory = ::operator new(bytes, std::align_val_t(at));
#ifdef __linux__
    // Advice only: nothing depends on whether it is taken.
    if (at == page) madvise(memory, bytes / page * page, MADV_HUGEPAGE);
#endif
    return static_cast<Value*>(memory);
  }
  void deallocate(Value* memory, std::size_t n) {
    ::operator delete(memory, std::align_val_t(alignment(n)));
  }
  friend bool operator==(const LatticeAllocator&, const LatticeAllocator&) {
    return true;
  }

 private:
  static constexpr std::size_t page = 2u << 20, line = 64;
  static std::size_t alignment(std::size_t n) {
    return n * sizeof(Value) < page ? line : page;
  }
};

template <class Value>
using LatticeArray = std::vector<Value, LatticeAllocator<Value>>;

}  // namespace dld
