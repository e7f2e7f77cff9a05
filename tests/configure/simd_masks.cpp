/// Does a masked assignment of std::experimental::simd do what it says? That of libstdc++ 12 does not where
/// clang compiles it for AVX-512: the lanes are not set, and a fluid made with it is wrong without a word.
#include <experimental/simd>

namespace stdx = std::experimental;

template <class Real>
int wrong_lanes(int set) {
  using Vector = stdx::native_simd<Real>;
  const auto lane = [](auto i) { return static_cast<Real>(static_cast<int>(i)); };
  const typename Vector::mask_type mask = Vector(lane) < static_cast<Real>(set);
  Vector v = Real(1);
  where(mask, v) = Vector(Real(2));
  int wrong = 0;
  for (int i = 0; i < static_cast<int>(Vector::size()); ++i)
    wrong += v[static_cast<std::size_t>(i)] == (i < set ? Real(2) : Real(1)) ? 0 : 1;
  return wrong;
}

int main(int count, char**) {  // count is 1, which the compiler does not know
  return wrong_lanes<float>(count) + wrong_lanes<double>(count);
}
