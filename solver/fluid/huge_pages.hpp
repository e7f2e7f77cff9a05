#pragma once
/// Large arrays on large pages, where the system has them.
#include <cstdint>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace dld {

/// Sets `values` to n times `value`, on pages of 2 MiB if Linux will give them: a lattice of tens of MiB
/// otherwise spends a fifth of its time on looking up pages. Elsewhere, and for small arrays, a plain
/// assignment.
template <class Real>
void assign_on_huge_pages(std::vector<Real>& values, std::size_t n, Real value) {
  values.reserve(n);
#ifdef __linux__
  constexpr std::uintptr_t page = 2u << 20;
  const auto begin = reinterpret_cast<std::uintptr_t>(values.data());
  const std::uintptr_t first = (begin + page - 1) / page * page,
                       last = (begin + n * sizeof(Real)) / page * page;
  // Advice only: nothing depends on whether it is taken.
  if (last > first) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
  values.assign(n, value);
}

}  // namespace dld
