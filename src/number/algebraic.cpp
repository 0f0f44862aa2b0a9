// The only file that includes CGAL: its algebraic kernel takes ten seconds to compile.
#include "number/algebraic.hpp"

#include <mpfi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/contract.hpp"

#define CGAL_USE_MPFI 1
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#endif
#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Sqrt_extension.h>
#if defined(__clang__)
#pragma clang diagnostic pop
#endif

namespace lamina::number {
namespace {

using Kernel = CGAL::Algebraic_kernel_d_1<CGAL::Gmpz>;
using KernelRoot = Kernel::Algebraic_real_1;
using Surd = CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq>;

std::strong_ordering ordering(int sign) { return sign <=> 0; }

CGAL::Gmpz to_cgal(const Integer& value) { return CGAL::Gmpz(value.backend().data()); }

CGAL::Gmpq to_cgal(const Rational& value) {
  return {to_cgal(Integer(numerator(value))), to_cgal(Integer(denominator(value)))};
}

Rational from_cgal(const CGAL::Gmpq& value) {
  Rational result;
  mpq_set(result.backend().data(), value.mpq());
  return result;
}

Kernel::Polynomial_1 to_cgal(const IntegerPolynomial& polynomial) {
  std::vector<CGAL::Gmpz> coefficients;
  for (const Integer& c : polynomial.coefficients()) {
    coefficients.push_back(to_cgal(c));
  }
  return Kernel::Polynomial_1(coefficients.begin(), coefficients.end());
}

// The sum over i of coefficient[i] * numerator^i * denominator^(degree - i): the value at
// the rational times a positive power of its denominator.
Integer scaled_value(const IntegerPolynomial& polynomial, const Rational& t) {
  const Integer n = numerator(t);
  const Integer d = denominator(t);
  Integer value = 0;
  Integer power = 1;
  for (auto c = polynomial.coefficients().rbegin(); c != polynomial.coefficients().rend(); ++c) {
    value = value * n + *c * power;
    power *= d;
  }
  return value;
}

// An interval of MPFR numbers, outward rounded.
class Interval {
 public:
  explicit Interval(mpfr_prec_t bits) { mpfi_init2(value_, bits); }
  Interval(const Interval&) = delete;
  Interval& operator=(const Interval&) = delete;
  ~Interval() { mpfi_clear(value_); }
  operator mpfi_ptr() { return value_; }

  double lower() { return mpfr_get_d(&value_->left, MPFR_RNDD); }
  double upper() { return mpfr_get_d(&value_->right, MPFR_RNDU); }
  [[nodiscard]] Enclosure rationals() {
    Enclosure result;
    mpfr_get_q(result.lower.backend().data(), &value_->left);
    mpfr_get_q(result.upper.backend().data(), &value_->right);
    return result;
  }

 private:
  mpfi_t value_;
};

// Scratch of one thread for the 53-bit enclosures that every root gets; 96 bits leave them
// at most an ulp wide but for extreme cancellation.
struct Scratch {
  static constexpr mpfr_prec_t kBits = 96;
  Interval a{kBits}, b{kBits}, c{kBits}, discriminant{kBits}, q{kBits};
};

// q = -(b + sign(b) sqrt(b^2 - 4ac)) / 2; the roots are q/a and c/q: no cancellation.
void set_stable_q(const IntegerPolynomial& p, const Integer& discriminant, Scratch& s) {
  mpfi_set_z(s.a, p[2].backend().data());
  mpfi_set_z(s.b, p[1].backend().data());
  mpfi_set_z(s.c, p[0].backend().data());
  mpfi_set_z(s.discriminant, discriminant.backend().data());
  mpfi_sqrt(s.q, s.discriminant);
  if (p[1].sign() >= 0) {
    mpfi_neg(s.q, s.q);
  }
  mpfi_sub(s.q, s.q, s.b);
  mpfi_div_2ui(s.q, s.q, 1);
}

}  // namespace

struct Root::Representation {
  // By the degree of what it is a root of: a rational; the smaller or larger root of an
  // irreducible quadratic with positive leading coefficient; a root of CGAL's kernel.
  enum class Kind { Linear, Quadratic, Higher } kind = Kind::Linear;
  Rational rational;
  IntegerPolynomial quadratic;
  Integer discriminant;
  bool larger = false;
  std::optional<KernelRoot> kernel;

  [[nodiscard]] Surd surd() const {
    const Rational twice_a = 2 * quadratic[2];
    const Rational part = 1 / twice_a;
    return Surd(to_cgal(Rational(-quadratic[1] / twice_a)),
                to_cgal(larger ? part : Rational(-part)), CGAL::Gmpq(to_cgal(discriminant)));
  }

  [[nodiscard]] KernelRoot kernel_root() const {
    switch (kind) {
      case Kind::Linear:
        return Kernel().construct_algebraic_real_1_object()(to_cgal(rational));
      case Kind::Quadratic: {
        std::vector<KernelRoot> both;
        Kernel().solve_1_object()(to_cgal(quadratic), true, std::back_inserter(both));
        return both.at(larger ? 1 : 0);
      }
      case Kind::Higher:
        break;
    }
    return *kernel;
  }
};

struct RootAccess {
  using Representation = Root::Representation;

  static const Representation& representation(const Root& root) { return *root.representation_; }
  static bool same(const Root& a, const Root& b) { return a.representation_ == b.representation_; }

  static Root make(Representation representation, double lower, double upper,
                   unsigned multiplicity) {
    Root root;
    root.representation_ = std::make_shared<const Representation>(std::move(representation));
    root.lower_ = lower;
    root.upper_ = upper;
    root.multiplicity_ = multiplicity;
    return root;
  }

  static Root rational(const Rational& value, unsigned multiplicity) {
    Scratch& s = scratch();
    mpfi_set_q(s.a, value.backend().data());
    Representation r;
    r.rational = value;
    return make(std::move(r), s.a.lower(), s.a.upper(), multiplicity);
  }

  static Root quadratic(const IntegerPolynomial& p, const Integer& discriminant, bool larger,
                        double lower, double upper) {
    Representation r;
    r.kind = Representation::Kind::Quadratic;
    r.quadratic = p;
    r.discriminant = discriminant;
    r.larger = larger;
    return make(std::move(r), lower, upper, 1);
  }

  static Root kernel(const KernelRoot& value, unsigned multiplicity) {
    if (value.is_rational()) {
      return rational(from_cgal(value.rational()), multiplicity);
    }
    Representation r;
    r.kind = Representation::Kind::Higher;
    const auto [lower, upper] = double_bounds(value);
    r.kernel = value;
    return make(std::move(r), lower, upper, multiplicity);
  }

  static Scratch& scratch() {
    thread_local Scratch instance;
    return instance;
  }

 private:
  // Guesses the root in double (bisection inside the isolating interval), and certifies a
  // few ulps around the guess by exact comparison: far cheaper than the kernel's own
  // approximation.
  static std::pair<double, double> double_bounds(const KernelRoot& value) {
    const auto polynomial = value.polynomial();
    std::vector<double> c;
    for (int i = 0; i <= CGAL::degree(polynomial); ++i) {
      c.push_back(CGAL::to_double(polynomial[i]));
    }
    const auto at = [&c](double t) {
      double sum = 0;
      for (auto k = c.rbegin(); k != c.rend(); ++k) {
        sum = sum * t + *k;
      }
      return sum;
    };
    double lower = CGAL::to_interval(value.low()).first;
    double upper = CGAL::to_interval(value.high()).second;
    if (std::isfinite(lower) && std::isfinite(upper)) {
      double a = lower;
      double b = upper;
      const bool rising = at(b) > at(a);
      for (double m = a + (b - a) / 2; a < m && m < b; m = a + (b - a) / 2) {
        ((at(m) > 0) == rising ? b : a) = m;
      }
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      double below = std::nextafter(a, -kInfinity);
      double above = std::nextafter(b, kInfinity);
      for (double step = 4 * (above - below); below > lower || above < upper; step *= 16) {
        const bool root_above = below > lower && compare_bound(value, below) > 0;
        const bool root_below = above < upper && compare_bound(value, above) < 0;
        if ((root_above || below <= lower) && (root_below || above >= upper)) {
          break;
        }
        below = root_above ? below : below - step;
        above = root_below ? above : above + step;
      }
      lower = std::max(lower, below);
      upper = std::min(upper, above);
      // Where roots are close, double's guess is poor: halve what is left exactly.
      while (upper - lower > 8 * std::numeric_limits<double>::epsilon() *
                                 std::max(std::abs(lower), std::abs(upper))) {
        const double middle = lower + (upper - lower) / 2;
        if (!(lower < middle && middle < upper)) {
          break;
        }
        (compare_bound(value, middle) < 0 ? upper : lower) = middle;
      }
    }
    return {lower, upper};
  }

  static int compare_bound(const KernelRoot& value, double bound) {
    return Kernel().compare_1_object()(value, Kernel::Bound(bound));
  }
};

namespace {

using Kind = Root::Representation::Kind;

// Position of the quadratic's root: the sign of root - t.
int sign_of_difference(const Root::Representation& root, const Rational& t) {
  // twice the leading coefficient times (vertex - t), up to a positive factor
  const Integer to_vertex =
      -(root.quadratic[1] * denominator(t) + 2 * root.quadratic[2] * numerator(t));
  const int vertex_side = to_vertex.sign();
  if (root.larger ? vertex_side >= 0 : vertex_side <= 0) {
    return root.larger ? 1 : -1;  // irrational, so never at the vertex
  }
  const int value = scaled_value(root.quadratic, t).sign();
  return root.larger ? -value : value;
}

int compare_exactly(const Root::Representation& a, const Root::Representation& b) {
  if (a.kind == Kind::Linear && b.kind == Kind::Linear) {
    return a.rational.compare(b.rational);
  }
  if (a.kind == Kind::Quadratic && b.kind == Kind::Linear) {
    return sign_of_difference(a, b.rational);
  }
  if (a.kind == Kind::Linear && b.kind == Kind::Quadratic) {
    return -sign_of_difference(b, a.rational);
  }
  if (a.kind == Kind::Quadratic && b.kind == Kind::Quadratic) {
    return a.surd().compare(b.surd(), false);
  }
  return Kernel().compare_1_object()(a.kernel_root(), b.kernel_root());
}

std::vector<Root> quadratic_roots(const IntegerPolynomial& polynomial) {
  const Integer discriminant = polynomial[1] * polynomial[1] - 4 * polynomial[2] * polynomial[0];
  if (discriminant.sign() < 0) {
    return {};
  }
  const Integer twice_a = 2 * polynomial[2];
  if (discriminant.is_zero()) {
    return {RootAccess::rational(Rational(-polynomial[1], twice_a), 2)};
  }
  if (mpz_perfect_square_p(discriminant.backend().data()) != 0) {
    const Integer root = sqrt(discriminant);
    Rational first(-polynomial[1] - root, twice_a);
    Rational second(-polynomial[1] + root, twice_a);
    if (second < first) {
      first.swap(second);
    }
    return {RootAccess::rational(first, 1), RootAccess::rational(second, 1)};
  }
  const IntegerPolynomial rising =
      polynomial[2].sign() > 0
          ? polynomial
          : IntegerPolynomial({-polynomial[0], -polynomial[1], -polynomial[2]});
  Scratch& s = RootAccess::scratch();
  set_stable_q(rising, discriminant, s);
  mpfi_div(s.a, s.q, s.a);  // q / a
  mpfi_div(s.c, s.c, s.q);  // c / q
  const bool q_over_a_is_larger = rising[1].sign() < 0;
  Interval& smaller = q_over_a_is_larger ? s.c : s.a;
  Interval& larger = q_over_a_is_larger ? s.a : s.c;
  return {RootAccess::quadratic(rising, discriminant, false, smaller.lower(), smaller.upper()),
          RootAccess::quadratic(rising, discriminant, true, larger.lower(), larger.upper())};
}

std::vector<Root> kernel_roots(const IntegerPolynomial& polynomial) {
  std::vector<std::pair<KernelRoot, Kernel::Multiplicity_type>> found;
  Kernel().solve_1_object()(to_cgal(polynomial), std::back_inserter(found));
  std::vector<Root> roots;
  for (const auto& [value, multiplicity] : found) {
    roots.push_back(RootAccess::kernel(value, static_cast<unsigned>(multiplicity)));
  }
  return roots;
}

// The remainder of `polynomial` modulo a monic multiple of the root's quadratic: u t + v.
std::pair<Rational, Rational> linear_remainder(const IntegerPolynomial& polynomial,
                                               const IntegerPolynomial& quadratic) {
  const Rational p1(quadratic[1], quadratic[2]);  // t^2 = -p1 t - p0
  const Rational p0(quadratic[0], quadratic[2]);
  Rational u = 0;
  Rational v = 0;
  for (auto c = polynomial.coefficients().rbegin(); c != polynomial.coefficients().rend(); ++c) {
    const Rational next_u = v - u * p1;
    v = Rational(*c) - u * p0;
    u = next_u;
  }
  return {u, v};
}

// -1 or 1 where the enclosure decides, 0 where it does not.
int filtered_sign(const IntegerPolynomial& polynomial, const Root& root) {
  Scratch& s = RootAccess::scratch();
  mpfi_interv_d(s.a, root.lower(), root.upper());
  mpfi_set_ui(s.b, 0);
  for (auto c = polynomial.coefficients().rbegin(); c != polynomial.coefficients().rend(); ++c) {
    mpfi_mul(s.b, s.b, s.a);
    mpfi_add_z(s.b, s.b, c->backend().data());
  }
  if (mpfi_is_strictly_pos(s.b) > 0) {
    return 1;
  }
  return mpfi_is_strictly_neg(s.b) > 0 ? -1 : 0;
}

}  // namespace

IntegerPolynomial::IntegerPolynomial(std::vector<Integer> ascending)
    : coefficients_(std::move(ascending)) {
  while (!coefficients_.empty() && coefficients_.back().is_zero()) {
    coefficients_.pop_back();
  }
}

int IntegerPolynomial::sign_at(const Rational& t) const { return scaled_value(*this, t).sign(); }

int IntegerPolynomial::sign_at_minus_infinity() const {
  if (is_zero()) {
    return 0;
  }
  return degree() % 2 == 0 ? coefficients_.back().sign() : -coefficients_.back().sign();
}

IntegerPolynomial with_cleared_denominators(const std::vector<Rational>& ascending) {
  Integer common = 1;
  for (const Rational& c : ascending) {
    common = lcm(common, Integer(denominator(c)));
  }
  std::vector<Integer> integers;
  for (const Rational& c : ascending) {
    integers.push_back(numerator(c) * (common / denominator(c)));
  }
  return IntegerPolynomial(std::move(integers));
}

Root::Root(const Rational& value) { *this = RootAccess::rational(value, 1); }

std::vector<Root> real_roots(const IntegerPolynomial& polynomial) {
  LAMINA_REQUIRE(!polynomial.is_zero(), "the zero polynomial has every number as a root");
  switch (polynomial.degree()) {
    case 0:
      return {};
    case 1:
      return {RootAccess::rational(Rational(-polynomial[0], polynomial[1]), 1)};
    case 2:
      return quadratic_roots(polynomial);
    default:
      return kernel_roots(polynomial);
  }
}

std::strong_ordering compare(const Root& a, const Root& b) {
  if (a.upper() < b.lower()) {
    return std::strong_ordering::less;
  }
  if (b.upper() < a.lower()) {
    return std::strong_ordering::greater;
  }
  if (RootAccess::same(a, b)) {
    return std::strong_ordering::equal;
  }
  return ordering(compare_exactly(RootAccess::representation(a), RootAccess::representation(b)));
}

std::strong_ordering compare(const Root& a, const Rational& b) {
  const auto& root = RootAccess::representation(a);
  switch (root.kind) {
    case Kind::Linear:
      return ordering(root.rational.compare(b));
    case Kind::Quadratic:
      return ordering(sign_of_difference(root, b));
    case Kind::Higher:
      break;
  }
  return ordering(Kernel().compare_1_object()(*root.kernel, to_cgal(b)));
}

int sign_at(const IntegerPolynomial& polynomial, const Root& root) {
  if (polynomial.is_zero()) {
    return 0;
  }
  if (const int sign = filtered_sign(polynomial, root); sign != 0) {
    return sign;
  }
  const auto& r = RootAccess::representation(root);
  switch (r.kind) {
    case Kind::Linear:
      return polynomial.sign_at(r.rational);
    case Kind::Quadratic: {
      const auto [u, v] = linear_remainder(polynomial, r.quadratic);
      return u.is_zero() ? v.sign() : u.sign() * sign_of_difference(r, Rational(-v / u));
    }
    case Kind::Higher:
      break;
  }
  return Kernel().sign_at_1_object()(to_cgal(polynomial), *r.kernel);
}

namespace {

bool is_as_narrow(const Enclosure& bounds, int bits) {
  const Rational least(Integer(1), Integer(1) << static_cast<unsigned>(bits));
  const Rational size = std::min(Rational(abs(bounds.lower)), Rational(abs(bounds.upper)));
  return bounds.upper - bounds.lower <= least * std::max(size, least);
}

// The root's bounds made narrower by interval Newton steps (Moore 1966); none where the derivative
// may be zero between them, so that there could be other roots. A hundred times as fast as the
// kernel's own approximation, which halves.
std::optional<Enclosure> narrowed(const Kernel::Polynomial_1& p, const Root& root, int bits) {
  if (!std::isfinite(root.lower()) || !std::isfinite(root.upper())) {
    return std::nullopt;
  }
  Enclosure bounds{Rational(root.lower()), Rational(root.upper())};
  constexpr int kMoreBits = 64;  // than asked for; more again where the terms cancel
  constexpr int kMostBits = 16;  // times as many
  for (int precision = bits + kMoreBits; precision <= kMostBits * (bits + kMoreBits);
       precision *= 2) {
    Interval x(precision);
    Interval middle(precision);
    Interval value(precision);
    Interval slope(precision);
    Interval coefficient(precision);
    for (bool halved = true; halved;) {
      if (is_as_narrow(bounds, bits)) {
        return bounds;
      }
      mpfi_interv_q(x, bounds.lower.backend().data(), bounds.upper.backend().data());
      mpfi_set_q(middle, Rational((bounds.lower + bounds.upper) / 2).backend().data());
      mpfi_set_ui(value, 0);
      mpfi_set_ui(slope, 0);
      for (int i = CGAL::degree(p); i >= 0; --i) {
        mpfi_set_z(coefficient, p[i].mpz());
        mpfi_mul(value, value, middle);
        mpfi_add(value, value, coefficient);
        if (i > 0) {
          mpfi_mul_ui(coefficient, coefficient, static_cast<unsigned>(i));
          mpfi_mul(slope, slope, x);
          mpfi_add(slope, slope, coefficient);
        }
      }
      if (mpfi_has_zero(slope) != 0) {
        return std::nullopt;
      }
      mpfi_div(value, value, slope);
      mpfi_sub(middle, middle, value);
      const Enclosure step = middle.rationals();
      const Enclosure next{std::max(bounds.lower, step.lower), std::min(bounds.upper, step.upper)};
      halved = 2 * (next.upper - next.lower) <= bounds.upper - bounds.lower;
      bounds = next;
    }
  }
  return std::nullopt;
}

}  // namespace

Enclosure enclosure(const Root& root, int bits) {
  const auto& r = RootAccess::representation(root);
  if (r.kind == Kind::Linear) {
    return {r.rational, r.rational};
  }
  if (r.kind == Kind::Higher) {
    if (const auto found = narrowed(r.kernel->polynomial(), root, bits)) {
      return *found;
    }
    const auto [lower, upper] = root.lower() > 0 || root.upper() < 0
                                    ? Kernel().approximate_relative_1_object()(*r.kernel, bits)
                                    : Kernel().approximate_absolute_1_object()(*r.kernel, 2 * bits);
    return {from_cgal(lower), from_cgal(upper)};
  }
  // The stable formula loses a few bits of its precision; more where the discriminant is
  // tiny beside b^2, which only a retry tells.
  for (mpfr_prec_t precision = bits + 16;; precision *= 2) {
    Interval a(precision), b(precision), q(precision), result(precision);
    mpfi_set_z(a, r.discriminant.backend().data());
    mpfi_sqrt(q, a);
    const bool add = r.quadratic[1].sign() >= 0;
    if (add) {
      mpfi_neg(q, q);
    }
    mpfi_set_z(b, r.quadratic[1].backend().data());
    mpfi_sub(q, q, b);
    mpfi_div_2ui(q, q, 1);
    const bool q_over_a = add != r.larger;
    if (q_over_a) {
      mpfi_set_z(a, r.quadratic[2].backend().data());
      mpfi_div(result, q, a);
    } else {
      mpfi_set_z(a, r.quadratic[0].backend().data());
      mpfi_div(result, a, q);
    }
    const Enclosure found = result.rationals();
    const Rational magnitude = std::min(Rational(abs(found.lower)), Rational(abs(found.upper)));
    if ((found.upper - found.lower) * Rational(Integer(1) << static_cast<unsigned>(bits)) <=
        magnitude) {
      return found;
    }
  }
}

double nearest_double(const Root& root) {
  const auto& r = RootAccess::representation(root);
  if (r.kind == Kind::Linear) {
    return nearest_double(r.rational);
  }
  double lower = root.lower();
  double upper = root.upper();
  constexpr double kLargest = std::numeric_limits<double>::max();
  if (!std::isfinite(lower) || !std::isfinite(upper)) {
    const Enclosure wide = enclosure(root, 128);  // the midpoint is right beyond double's range
    return nearest_double(Rational((wide.lower + wide.upper) / 2));
  }
  while (lower < upper) {
    const double above = std::nextafter(lower, kLargest);
    if (above == upper) {
      const Rational middle = (Rational(lower) + Rational(upper)) / 2;
      return compare(root, middle) < 0 ? lower : upper;  // irrational: never the middle
    }
    const double middle = lower + (upper - lower) / 2;
    (compare(root, Rational(middle)) < 0 ? upper : lower) = middle;
  }
  return lower;
}

Root affine_image(const Root& root, const Rational& scale, const Rational& shift) {
  LAMINA_REQUIRE(scale > 0, "the order of roots is kept");
  const auto& r = RootAccess::representation(root);
  if (r.kind == Kind::Linear) {
    return Root(scale * r.rational + shift);
  }
  IntegerPolynomial polynomial;
  std::size_t index = 0;
  if (r.kind == Kind::Quadratic) {
    polynomial = r.quadratic;
    index = r.larger ? 1 : 0;
  } else {
    const auto source = r.kernel->polynomial();
    std::vector<Integer> coefficients;
    for (int i = 0; i <= CGAL::degree(source); ++i) {
      Integer c;
      mpz_set(c.backend().data(), source[i].mpz());
      coefficients.push_back(c);
    }
    polynomial = IntegerPolynomial(std::move(coefficients));
    const std::vector<Root> all = real_roots(polynomial);
    const auto found = std::find_if(all.begin(), all.end(), [&root](const Root& candidate) {
      return compare(candidate, root) == 0;
    });
    index = static_cast<std::size_t>(found - all.begin());
  }
  // p((t - shift) / scale) by Horner's rule on polynomials.
  std::vector<Rational> image;
  for (auto c = polynomial.coefficients().rbegin(); c != polynomial.coefficients().rend(); ++c) {
    std::vector<Rational> next(image.empty() ? 1 : image.size() + 1, Rational(0));
    for (std::size_t i = 0; i < image.size(); ++i) {
      next[i] -= image[i] * shift / scale;
      next[i + 1] += image[i] / scale;
    }
    next[0] += *c;
    image = std::move(next);
  }
  return real_roots(with_cleared_denominators(image)).at(index);
}

}  // namespace lamina::number
