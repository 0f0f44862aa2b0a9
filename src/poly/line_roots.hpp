// The sign changes of a polynomial along a whole line: what a ray needs of a surface.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "base/seeded_stream.hpp"
#include "number/traits.hpp"

namespace lamina::poly {

using number::RoundedNumber;

/// Up to four roots of odd multiplicity, ascending. Roots of even multiplicity are touches,
/// no crossings: a solver that sees two equal roots leaves both out. A root may be an
/// infinity where it overflows; NaN never appears.
template <RoundedNumber Number>
struct LineRoots {
  std::array<Number, 4> t{};
  int count = 0;

  /// Inserts in ascending order; a root equal to one that is there removes it (a touch).
  void cross(const Number& root) {
    if (!(root == root)) {
      return;
    }
    int place = count;
    while (place > 0 && root < t[place - 1]) {
      --place;
    }
    if (place > 0 && t[place - 1] == root) {
      for (int i = place; i < count; ++i) {
        t[i - 1] = t[i];
      }
      --count;
      return;
    }
    for (int i = count; i > place; --i) {
      t[i] = t[i - 1];
    }
    t[place] = root;
    ++count;
  }
};

/// A solver's mistake made on purpose, to see what becomes of it.
struct RootFault {
  enum class Kind : std::uint8_t {
    None,
    Drop,    ///< one root of a polynomial is lost
    Double,  ///< one root of a polynomial is given twice, if it has less than four
  };
  Kind kind = Kind::None;
  double rate = 0;  ///< of the polynomials with roots
};

/// Makes the mistake, or not, at random; the same for the same roots and `place`. The root 0 of a
/// ray that starts on the surface is one as any other.
template <RoundedNumber Number>
void spoil(LineRoots<Number>& roots, const RootFault& fault, std::uint64_t place) {
  if (fault.kind == RootFault::Kind::None || roots.count == 0) {
    return;
  }
  base::SeededStream stream("poly/root-fault",
                            std::bit_cast<std::uint64_t>(static_cast<double>(roots.t[0])), place);
  if (!stream.chance(fault.rate)) {
    return;
  }
  const auto chosen = static_cast<int>(stream.below(static_cast<std::uint64_t>(roots.count)));
  if (fault.kind == RootFault::Kind::Drop) {
    for (int i = chosen; i + 1 < roots.count; ++i) {
      roots.t[i] = roots.t[i + 1];
    }
    --roots.count;
  } else if (roots.count < static_cast<int>(roots.t.size())) {
    for (int i = roots.count; i > chosen; --i) {
      roots.t[i] = roots.t[i - 1];
    }
    ++roots.count;
  }
}

}  // namespace lamina::poly
