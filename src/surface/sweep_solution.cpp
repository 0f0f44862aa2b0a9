#include "surface/sweep_solution.hpp"

#include <algorithm>
#include <chrono>

#include "geometry/rounding.hpp"
#include "number/all_numbers.hpp"
#include "surface/rounded_sphere_sweep.hpp"

namespace lamina::surface {
namespace {

// The crossings of the solid that a swept surface bounds with planes z = 0 and z = 1, from its own.
template <number::RoundedNumber Number>
void cross_half_spaces(const RoundedSweep<Number>& sweep, const geometry::Ray<Number>& local,
                       bool starts_inside,
                       std::vector<typename RoundedSweep<Number>::Crossing>& crossings) {
  using Crossing = typename RoundedSweep<Number>::Crossing;
  if (sweep.sweep() == Sweep::Rotational) {
    return;
  }
  const Number& o_z = local.origin.z;
  const Number& d_z = local.direction.z;
  // Of the surface, of z >= 0 and of z <= 1, for t towards -infinity.
  std::array inside{starts_inside, d_z == 0 ? o_z >= 0 : d_z < 0, d_z == 0 ? o_z <= 1 : d_z > 0};
  if (d_z != 0) {
    crossings.push_back({-o_z / d_z, Number(0), kBasePlane});
    crossings.push_back({(1 - o_z) / d_z, Number(0), kCapPlane});
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& x, const Crossing& y) { return x.t < y.t; });
  }
  const auto in_all = [&inside] { return inside[0] && inside[1] && inside[2]; };
  std::erase_if(crossings, [&](const Crossing& crossing) {
    const bool before = in_all();
    bool& one = inside[crossing.piece == kBasePlane ? 1 : crossing.piece == kCapPlane ? 2 : 0];
    one = !one;
    return before == in_all();
  });
}

template <number::RoundedNumber Number>
void find(const RoundedSweep<Number>& sweep, const geometry::Ray<Number>& local,
          const SweepMethod& method,
          std::vector<typename RoundedSweep<Number>::Crossing>& crossings) {
  sweep.find_crossings(local, method.solvers, crossings);
  std::vector<typename RoundedSweep<Number>::Crossing> scratch;
  const bool starts_inside =
      method.caps == SweepMethod::Caps::HalfSpaces &&
      sweep.side_at_minus_infinity(local, crossings, method.solvers, scratch) < 0;
  if (method.lost && !crossings.empty()) {
    crossings.erase(crossings.begin() +
                    static_cast<std::ptrdiff_t>(*method.lost % crossings.size()));
  }
  switch (method.caps) {
    case SweepMethod::Caps::None:
      break;
    case SweepMethod::Caps::Parity:
      trim_by_parity(sweep, local, crossings);
      break;
    case SweepMethod::Caps::HalfSpaces:
      cross_half_spaces(sweep, local, starts_inside, crossings);
      break;
  }
}

template <number::RoundedNumber Number>
void find(const RoundedSphereSweep<Number>& sweep, const geometry::Ray<Number>& local,
          const SweepMethod& method,
          std::vector<typename RoundedSweep<Number>::Crossing>& crossings) {
  sweep.find_crossings(local, method.solvers, crossings);
}

template <number::RoundedNumber Number>
RoundedSweep<Number> in_number(const SweptSurface& surface, const SweepMethod& method) {
  return RoundedSweep<Number>(surface, method.printed);
}

template <number::RoundedNumber Number>
RoundedSphereSweep<Number> in_number(const SphereSweep& surface, const SweepMethod& /*method*/) {
  return RoundedSphereSweep<Number>(surface);
}

}  // namespace

template <number::RoundedNumber Number>
std::vector<FoundCrossing> cross_sweep(const AnySweep& surface, const geometry::ExactRay& local,
                                       const SweepMethod& method) {
  using Traits = number::number_traits<Number>;
  const geometry::Ray<Number> ray = geometry::rounded<Number>(local);
  std::vector<FoundCrossing> found;
  std::visit(
      [&](const auto& exact) {
        const auto sweep = in_number<Number>(exact, method);
        std::vector<typename RoundedSweep<Number>::Crossing> crossings;
        find(sweep, ray, method, crossings);
        for (const auto& crossing : crossings) {
          geometry::ExactPoint normal{0, 0, 0};
          if (crossing.piece != kBasePlane && crossing.piece != kCapPlane) {
            const auto n = sweep.normal(ray.origin + crossing.t * ray.direction, crossing);
            normal = {Traits::to_exact(n.x), Traits::to_exact(n.y), Traits::to_exact(n.z)};
          }
          found.push_back(
              {Traits::to_exact(crossing.t), Traits::to_exact(crossing.s), crossing.piece, normal});
        }
      },
      surface);
  return found;
}

template <number::RoundedNumber Number>
double seconds_to_cross(const std::vector<AnySweep>& surfaces,
                        const std::vector<geometry::ExactRay>& local, const SweepMethod& method) {
  using Rounded = std::variant<RoundedSweep<Number>, RoundedSphereSweep<Number>>;
  std::vector<Rounded> sweeps;
  std::vector<geometry::Ray<Number>> rays;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    sweeps.push_back(std::visit(
        [&method](const auto& exact) { return Rounded(in_number<Number>(exact, method)); },
        surfaces[i]));
    rays.push_back(geometry::rounded<Number>(local[i]));
  }
  std::vector<typename RoundedSweep<Number>::Crossing> crossings;
  const auto start = std::chrono::steady_clock::now();
  // What is found must be used, or the compiler may leave it out.
  [[maybe_unused]] volatile std::size_t count = 0;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    std::visit([&](const auto& sweep) { find(sweep, rays[i], method, crossings); }, sweeps[i]);
    count = crossings.size();
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

#define LAMINA_INSTANTIATE(Number)                                     \
  template std::vector<FoundCrossing> cross_sweep<Number>(             \
      const AnySweep&, const geometry::ExactRay&, const SweepMethod&); \
  template double seconds_to_cross<Number>(                            \
      const std::vector<AnySweep>&, const std::vector<geometry::ExactRay>&, const SweepMethod&);
LAMINA_FOR_EACH_ROUNDED_NUMBER(LAMINA_INSTANTIATE)
#undef LAMINA_INSTANTIATE

}  // namespace lamina::surface
