#include "surface/carrier.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "base/contract.hpp"

namespace lamina::surface {
namespace {

using geometry::AffineMap;
using geometry::ExactPoint;
using geometry::ExactRay;
using number::Integer;
using number::IntegerPolynomial;
using number::Interval;
using number::Rational;
using number::Root;

using Exponents = std::array<int, 4>;        // of x, y, z, w
using Form = std::map<Exponents, Rational>;  // a homogeneous polynomial

// The monomials of a degree in x, y, z, w: x^d first, w^d last.
const std::vector<Exponents>& monomials_of(int degree) {
  static const std::array<std::vector<Exponents>, 5> all = [] {
    std::array<std::vector<Exponents>, 5> result;
    for (int d = 0; d <= 4; ++d) {
      for (int x = d; x >= 0; --x) {
        for (int y = d - x; y >= 0; --y) {
          for (int z = d - x - y; z >= 0; --z) {
            result[d].push_back({x, y, z, d - x - y - z});
          }
        }
      }
    }
    return result;
  }();
  return all.at(degree);
}

Form add(const Form& a, const Form& b, const Rational& factor) {
  Form sum = a;
  for (const auto& [exponents, coefficient] : b) {
    sum[exponents] += factor * coefficient;
  }
  return sum;
}

Form multiply(const Form& a, const Form& b) {
  Form product;
  for (const auto& [ea, ca] : a) {
    for (const auto& [eb, cb] : b) {
      product[{ea[0] + eb[0], ea[1] + eb[1], ea[2] + eb[2], ea[3] + eb[3]}] += ca * cb;
    }
  }
  return product;
}

// The local coordinates x, y, z, w as linear forms of the world's.
std::array<Form, 4> local_coordinates(const AffineMap& to_local) {
  std::array<Form, 4> forms;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = to_local.rows[i];
    forms[i] = {{{1, 0, 0, 0}, row[0]},
                {{0, 1, 0, 0}, row[1]},
                {{0, 0, 1, 0}, row[2]},
                {{0, 0, 0, 1}, row[3]}};
  }
  forms[3] = {{{0, 0, 0, 1}, Rational(1)}};
  return forms;
}

Form world_form(const LocalSurface& surface, const AffineMap& to_local) {
  const auto [x, y, z, w] = local_coordinates(to_local);
  const auto& c = surface.coefficients;
  switch (surface.kind) {
    case Kind::Plane:
      return add(add(add(add({}, x, c[0]), y, c[1]), z, c[2]), w, c[3]);
    case Kind::Quadric: {
      const std::array<std::pair<const Form&, const Form&>, 10> factors{
          {{x, x}, {y, y}, {z, z}, {x, y}, {x, z}, {y, z}, {x, w}, {y, w}, {z, w}, {w, w}}};
      Form sum;
      for (std::size_t i = 0; i < factors.size(); ++i) {
        sum = add(sum, multiply(factors[i].first, factors[i].second), c[i]);
      }
      return sum;
    }
    case Kind::Torus: {
      const Rational major_squared = c[0] * c[0];
      const Form ww = multiply(w, w);
      const Form across = add(multiply(x, x), multiply(y, y), 1);
      const Form inner = add(add(across, multiply(z, z), 1), ww, major_squared - c[1] * c[1]);
      return add(multiply(inner, inner), multiply(across, ww), -4 * major_squared);
    }
    case Kind::Sweep:
      break;
  }
  return {};
}

// Divides by the highest power of w in all terms: a quadric whose quadratic part is zero is
// a plane.
int reduce_degree(Form& form, int degree) {
  const auto divisible = [&form] {
    for (const auto& [exponents, coefficient] : form) {
      if (!coefficient.is_zero() && exponents[3] == 0) {
        return false;
      }
    }
    return true;
  };
  while (degree > 1 && divisible()) {
    Form reduced;
    for (const auto& [e, coefficient] : form) {
      if (e[3] > 0) {
        reduced[{e[0], e[1], e[2], e[3] - 1}] = coefficient;
      }
    }
    form = std::move(reduced);
    --degree;
  }
  return degree;
}

template <typename Ring>
std::vector<Ring> multiply(const std::vector<Ring>& a, const std::vector<Ring>& b) {
  std::vector<Ring> product(a.size() + b.size() - 1, Integer(0) * a.front());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      product[i + j] += a[i] * b[j];
    }
  }
  return product;
}

std::array<std::vector<Integer>, 4> homogeneous(const ExactRay& ray) {
  Integer common = 1;
  for (const Rational* value : {&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x,
                                &ray.direction.y, &ray.direction.z}) {
    common = lcm(common, Integer(denominator(*value)));
  }
  const auto linear = [&common](const Rational& origin, const Rational& direction) {
    std::vector<Integer> coordinate{numerator(origin) * (common / denominator(origin))};
    if (!direction.is_zero()) {
      coordinate.push_back(numerator(direction) * (common / denominator(direction)));
    }
    return coordinate;
  };
  return {linear(ray.origin.x, ray.direction.x),
          linear(ray.origin.y, ray.direction.y),
          linear(ray.origin.z, ray.direction.z),
          {common}};
}

std::array<std::vector<Interval>, 4> enclosed(const geometry::Vector3<Interval>& origin,
                                              const ExactPoint& direction) {
  const int bits = origin.x.bits();
  const auto linear = [bits](const Interval& from, const Rational& along) {
    std::vector<Interval> coordinate{from};
    if (!along.is_zero()) {
      coordinate.emplace_back(along, bits);
    }
    return coordinate;
  };
  return {linear(origin.x, direction.x),
          linear(origin.y, direction.y),
          linear(origin.z, direction.z),
          {Interval(Rational(1), bits)}};
}

// A gradient in local coordinates as one in the world's.
ExactPoint to_world(const AffineMap& to_local, const ExactPoint& gradient) {
  const auto along = [&](std::size_t axis) -> Rational {
    return to_local.rows[0][axis] * gradient.x + to_local.rows[1][axis] * gradient.y +
           to_local.rows[2][axis] * gradient.z;
  };
  return {along(0), along(1), along(2)};
}

}  // namespace

std::strong_ordering operator<=>(const Carrier& a, const Carrier& b) {
  if (const auto order = a.degree <=> b.degree; order != 0) {
    return order;
  }
  for (std::size_t i = 0; i < a.coefficients.size(); ++i) {
    if (const int order = a.coefficients[i].compare(b.coefficients[i]); order != 0) {
      return order <=> 0;
    }
  }
  if (a.sweep == b.sweep) {
    return std::strong_ordering::equal;
  }
  // Both have one, as they have the same degree.
  if (const auto order = a.sweep->surface <=> b.sweep->surface; order != 0) {
    return order;
  }
  const auto& rows = a.sweep->to_local.rows;
  const auto& others = b.sweep->to_local.rows;
  return rows == others  ? std::strong_ordering::equal
         : rows < others ? std::strong_ordering::less
                         : std::strong_ordering::greater;
}

OrientedCarrier carrier_of(const LocalSurface& surface, const AffineMap& to_local) {
  if (surface.kind == Kind::Sweep) {
    const PlacedSweep placed = surface.sweep ? PlacedSweep{*surface.sweep, to_local}
                                             : PlacedSweep{*surface.sphere_sweep, to_local};
    return {{0, {}, std::make_shared<const PlacedSweep>(placed)}, 1};
  }
  Form form = world_form(surface, to_local);
  const int written_degree = surface.kind == Kind::Plane     ? 1
                             : surface.kind == Kind::Quadric ? 2
                                                             : 4;
  OrientedCarrier result;
  result.carrier.degree = reduce_degree(form, written_degree);

  Integer denominators = 1;
  Integer numerators = 0;
  for (const auto& [exponents, coefficient] : form) {
    denominators = lcm(denominators, Integer(denominator(coefficient)));
  }
  bool constant = true;
  for (const Exponents& exponents : monomials_of(result.carrier.degree)) {
    const auto found = form.find(exponents);
    const Rational value = found == form.end() ? Rational(0) : found->second * denominators;
    result.carrier.coefficients.emplace_back(numerator(value));
    numerators = gcd(numerators, result.carrier.coefficients.back());
    constant = constant && (value.is_zero() || exponents[3] == result.carrier.degree);
  }
  if (constant) {
    throw base::InputError("the equation of this surface is constant: it has no points or all");
  }
  for (const Integer& coefficient : result.carrier.coefficients) {
    if (!coefficient.is_zero()) {
      result.side = coefficient.sign();
      break;
    }
  }
  for (Integer& coefficient : result.carrier.coefficients) {
    coefficient /= result.side * numerators;
  }
  return result;
}

template <typename Ring>
const std::vector<std::vector<Ring>>& LineMonomials<Ring>::monomials(int degree) {
  std::vector<Polynomial>& result = monomials_.at(degree);
  if (!result.empty()) {
    return result;
  }
  if (degree == 1) {
    result.assign(coordinates_.begin(), coordinates_.end());
    return result;
  }
  // Each monomial is a coordinate times one of the next lower degree, which are in the same
  // order: x times all of them, y times those without x, and so on.
  const std::vector<Polynomial>& lower = monomials(degree - 1);
  const std::vector<Exponents>& lower_exponents = monomials_of(degree - 1);
  for (const Exponents& exponents : monomials_of(degree)) {
    std::size_t coordinate = 0;
    while (exponents[coordinate] == 0) {
      ++coordinate;
    }
    Exponents rest = exponents;
    --rest[coordinate];
    const auto position = std::find(lower_exponents.begin(), lower_exponents.end(), rest);
    result.push_back(multiply(coordinates_[coordinate], lower[position - lower_exponents.begin()]));
  }
  return result;
}

template <typename Ring>
std::vector<Ring> LineMonomials<Ring>::restrict(const Carrier& carrier) {
  const std::vector<Polynomial>& powers = monomials(carrier.degree);
  const Ring zero = Integer(0) * coordinates_[3].front();
  std::vector<Ring> sum(static_cast<std::size_t>(carrier.degree) + 1, zero);
  for (std::size_t m = 0; m < powers.size(); ++m) {
    if (carrier.coefficients[m].is_zero()) {
      continue;
    }
    for (std::size_t i = 0; i < powers[m].size(); ++i) {
      sum[i] += carrier.coefficients[m] * powers[m][i];
    }
  }
  return sum;
}

RayMonomials::RayMonomials(const ExactRay& ray) : line_(homogeneous(ray)) {}

IntegerPolynomial RayMonomials::restrict(const Carrier& carrier) {
  return IntegerPolynomial(line_.restrict(carrier));
}

EnclosedRayMonomials::EnclosedRayMonomials(const geometry::Vector3<Interval>& origin,
                                           const ExactPoint& direction)
    : line_(enclosed(origin, direction)), direction_(ExactRay{{0, 0, 0}, direction}) {}

std::vector<Interval> EnclosedRayMonomials::restrict(const Carrier& carrier) {
  std::vector<Interval> coefficients = line_.restrict(carrier);
  if (direction_.restrict(carrier).degree() < carrier.degree) {
    coefficients.pop_back();
  }
  return coefficients;
}

CarrierOnRay::CarrierOnRay(const Carrier& carrier, const ExactRay& ray, RayMonomials& monomials) {
  if (carrier.sweep) {
    swept_ = on_sweep(*carrier.sweep, ray);
  } else {
    polynomial_ = monomials.restrict(carrier);
  }
}

CarrierOnRay::OnSweep CarrierOnRay::on_sweep(const PlacedSweep& sweep, const ExactRay& ray) {
  const ExactRay local{apply(sweep.to_local, ray.origin),
                       apply_to_direction(sweep.to_local, ray.direction)};
  if (const auto* sphere_sweep = std::get_if<SphereSweep>(&sweep.surface)) {
    auto [in_boundary, t] = sphere_sweep->crossings(local);
    return {false, in_boundary, std::move(t)};
  }
  const auto found = std::get<SweptSurface>(sweep.surface).crossings(local);
  OnSweep result{found.starts_inside, found.in_boundary, {}};
  for (const SweptSurface::Crossing& crossing : found.crossings) {
    result.crossings.push_back(crossing.t);
  }
  return result;
}

bool CarrierOnRay::contains_ray() const {
  return swept_ ? swept_->in_boundary : polynomial_.is_zero();
}

int CarrierOnRay::sign_at_minus_infinity() const {
  if (swept_) {
    return swept_->in_boundary ? 0 : swept_->starts_inside ? -1 : 1;
  }
  return polynomial_.sign_at_minus_infinity();
}

std::vector<Root> CarrierOnRay::crossings() const {
  if (swept_) {
    return swept_->crossings;
  }
  std::vector<Root> roots = number::real_roots(polynomial_);
  std::erase_if(roots, [](const Root& root) { return root.multiplicity() % 2 == 0; });
  return roots;
}

std::vector<Root> CarrierOnRay::touches() const {
  std::vector<Root> roots;
  if (!swept_) {
    roots = number::real_roots(polynomial_);
    std::erase_if(roots, [](const Root& root) { return root.multiplicity() % 2 == 1; });
  }
  return roots;
}

int CarrierOnRay::sign_at(const Root& t) const {
  if (!swept_) {
    return number::sign_at(polynomial_, t);
  }
  int sign = sign_at_minus_infinity();
  for (const Root& crossing : swept_->crossings) {
    const auto order = compare(crossing, t);
    if (order >= 0) {
      return order == 0 ? 0 : sign;
    }
    sign = -sign;
  }
  return sign;
}

int sign_at(const Carrier& carrier, const ExactPoint& point) {
  if (carrier.sweep) {
    return std::visit([local = apply(carrier.sweep->to_local, point)](
                          const auto& sweep) { return sweep.side(local); },
                      carrier.sweep->surface);
  }
  const ExactPoint nowhere{0, 0, 0};
  const IntegerPolynomial value = RayMonomials({point, nowhere}).restrict(carrier);
  return value.is_zero() ? 0 : value[0].sign();
}

ExactPoint gradient_at(const Carrier& carrier, const ExactPoint& point) {
  if (carrier.sweep) {
    const AffineMap& map = carrier.sweep->to_local;
    return std::visit([&map, local = apply(map, point)](
                          const auto& sweep) { return to_world(map, sweep.normal_near(local)); },
                      carrier.sweep->surface);
  }
  const auto slope = [&](const ExactPoint& axis) {
    const IntegerPolynomial along = RayMonomials({point, axis}).restrict(carrier);
    return along.degree() < 1 ? Rational(0) : Rational(along[1]);
  };
  return {slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
}

std::optional<SweptSurface::Facets> facets_at(const PlacedSweep& sweep, const ExactPoint& point) {
  auto facets = std::visit(
      [local = apply(sweep.to_local, point)](const auto& surface) { return surface.facets(local); },
      sweep.surface);
  if (facets) {
    for (ExactPoint& normal : facets->normals) {
      normal = to_world(sweep.to_local, normal);
    }
  }
  return facets;
}

}  // namespace lamina::surface
