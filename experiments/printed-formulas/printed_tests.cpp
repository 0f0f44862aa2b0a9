#include "experiments/printed-formulas/printed_tests.hpp"

#include <algorithm>

#include "poly/solution.hpp"

namespace lamina::experiments {
namespace {

using number::Rational;
using Polynomial = std::vector<Rational>;

void add_product(Polynomial& sum, const Rational& factor, const Polynomial& a,
                 const Polynomial& b) {
  sum.resize(std::max(sum.size(), a.size() + b.size() - 1));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      sum[i + j] += factor * a[i] * b[j];
    }
  }
}

}  // namespace

RayLine ray_line(surface::Sweep sweep, const geometry::ExactRay& local) {
  const auto& [o, d] = local;
  if (sweep == surface::Sweep::Conic) {
    return {o.y * d.z - o.z * d.y, o.z * d.x - o.x * d.z, o.x * d.y - o.y * d.x};
  }
  return {d.y, -d.x, d.x * o.y - d.y * o.x};
}

bool rules_out(const RayLine& line, const geometry::Rectangle& box, bool as_printed) {
  const bool falls = line.falls();
  const Rational first = line.at(box.u_min, falls ? box.v_min : box.v_max);
  const Rational second = line.at(box.u_max, falls && !as_printed ? box.v_max : box.v_min);
  return first.sign() * second.sign() > 0;
}

std::vector<Rational> rotational_crossings(const surface::SweptSurface& surface,
                                           const geometry::ExactRay& local, bool as_printed) {
  const auto& [o, d] = local;
  // Equation 9.
  const Rational a = d.x * d.x + d.y * d.y;
  const Rational b = 2 * (d.z * (d.x * o.x + d.y * o.y) - o.z * a);
  const Rational x = d.x * o.z - d.z * o.x;
  const Rational y = d.y * o.z - d.z * o.y;
  const Rational d_squared = d.z * d.z;
  constexpr int kBits = 200;
  std::vector<Rational> crossings;
  const auto pieces = surface.contour().pieces();
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (!surface.sweeps(i)) {
      continue;
    }
    const geometry::ContourPiece& piece = pieces[i];
    Polynomial p{x * x + y * y};
    add_product(p, a, piece.v, piece.v);
    add_product(p, b, piece.v, {1});
    add_product(p, -d_squared, piece.u, as_printed ? Polynomial{1} : piece.u);
    if (std::all_of(p.begin(), p.end(), [](const Rational& c) { return c.is_zero(); })) {
      continue;
    }
    for (const number::Root& s : poly::exact_roots(p, {Rational(0), Rational(1)})) {
      if (s.multiplicity() % 2 == 1 && compare(s, Rational(1)) < 0) {
        crossings.push_back((geometry::value_at(piece.v, enclosure(s, kBits).lower) - o.z) / d.z);
      }
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace lamina::experiments
