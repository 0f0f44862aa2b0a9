// The exact real roots against FLINT and Arb, on polynomials whose roots are hard to tell apart.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "base/seeded_stream.hpp"
#include "number/algebraic.hpp"
#include "support/class_tally.hpp"
#include "support/reference_roots.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using number::Enclosure;
using number::Integer;
using number::IntegerPolynomial;
using number::Rational;
using number::Root;
using reference::RealRoot;

constexpr std::uint64_t kSeed = 1;
constexpr int kBits = 200;         // of the oracle's enclosures
constexpr int kHeld = 53;          // bits of a coefficient, where a class does not say more
constexpr std::size_t kMost = 12;  // the highest degree

using Coefficients = std::vector<Integer>;  // ascending

struct Known {
  Rational root;
  unsigned multiplicity;  ///< at least
};

// A polynomial and what its construction tells of its roots.
struct Case {
  Coefficients coefficients;
  std::vector<Known> known = {};
  std::optional<std::size_t> real_count = {};  ///< with multiplicity
};

Integer power_of_two(std::uint64_t exponent) { return Integer(1) << exponent; }

Integer draw(SeededStream& stream, int bits) {
  const std::int64_t largest = (std::int64_t{1} << bits) - 1;
  return stream.integer(-largest, largest);
}

Integer draw_positive(SeededStream& stream, int bits) {
  return stream.integer(1, (std::int64_t{1} << bits) - 1);
}

int draw_side(SeededStream& stream) { return stream.chance(0.5) ? 1 : -1; }

std::size_t draw_degree(SeededStream& stream, std::size_t least = 2, std::size_t most = kMost) {
  return least + stream.below(most - least + 1);
}

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients result(a.size() + b.size() - 1, Integer(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      result[i + j] += a[i] * b[j];
    }
  }
  return result;
}

// Random coefficients, the first and the last not zero: all of the same size, or each of its own.
Coefficients dense(SeededStream& stream, std::size_t degree, int bits) {
  const bool uneven = stream.chance(0.5);
  Coefficients result;
  while (result.size() <= degree) {
    const int size = uneven ? 1 + static_cast<int>(stream.below(bits)) : bits;
    const Integer c = draw(stream, size);
    if (c != 0 || (!result.empty() && result.size() != degree)) {
      result.push_back(c);
    }
  }
  return result;
}

// q t - p: the magnitudes of its coefficients add up to less than 2^(bits + 1).
Coefficients linear(SeededStream& stream, int bits) {
  return {draw(stream, bits), draw_positive(stream, bits)};
}

Rational root_of(const Coefficients& factor) { return {-factor[0], factor[1]}; }

Coefficients linear_product(SeededStream& stream, std::size_t degree, int bits) {
  Coefficients result{1};
  for (std::size_t i = 0; i < degree; ++i) {
    result = product(result, linear(stream, bits));
  }
  return result;
}

Coefficients derivative(const Coefficients& p) {
  Coefficients result;
  for (std::size_t i = 1; i < p.size(); ++i) {
    result.push_back(p[i] * i);
  }
  return result;
}

// The roots times 2^shift, with integer coefficients.
Coefficients stretched(Coefficients p, std::int64_t shift) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    p[i] *= shift < 0 ? power_of_two(-shift * i) : power_of_two(shift * (p.size() - 1 - i));
  }
  return p;
}

Case generic(SeededStream& stream) { return {dense(stream, draw_degree(stream), kHeld)}; }

// Up to two of the factors repeated, and a cofactor that leaves the product within the bits.
Case repeated_from(SeededStream& stream, const std::vector<unsigned>& multiplicities,
                   int factor_bits, int cofactor_bits) {
  Case result{{1}};
  for (const unsigned multiplicity : multiplicities) {
    const Coefficients factor = linear(stream, factor_bits);
    for (unsigned i = 0; i < multiplicity; ++i) {
      result.coefficients = product(result.coefficients, factor);
    }
    result.known.push_back({root_of(factor), multiplicity});
  }
  const std::size_t rest = stream.below(kMost + 2 - result.coefficients.size());
  result.coefficients = product(result.coefficients, dense(stream, rest, cofactor_bits));
  return result;
}

const std::array<std::vector<unsigned>, 5> kMultiplicities{{{2}, {3}, {2, 2}, {2, 3}, {3, 3}}};

Case repeated(SeededStream& stream) {
  const auto& multiplicities = kMultiplicities[stream.below(kMultiplicities.size())];
  int total = 0;
  for (const unsigned multiplicity : multiplicities) {
    total += static_cast<int>(multiplicity);
  }
  const int bits = 1 + static_cast<int>(stream.below(48 / total - 1));
  return repeated_from(stream, multiplicities, bits, kHeld - total * (bits + 1));
}

// Coefficients of some hundreds of bits.
Case repeated_wide(SeededStream& stream) {
  return repeated_from(stream, kMultiplicities[stream.below(kMultiplicities.size())], kHeld, kHeld);
}

// (a t^2 + b t - c)^2 or ^3, times a cofactor.
Case repeated_irrational(SeededStream& stream) {
  const std::size_t multiplicity = 2 + stream.below(2);
  const int total = static_cast<int>(multiplicity);
  const int bits = 1 + static_cast<int>(stream.below(48 / total - 2));
  const Coefficients factor{-draw_positive(stream, bits), draw(stream, bits),
                            draw_positive(stream, bits)};
  const std::size_t rest = stream.below(kMost + 1 - 2 * multiplicity);
  Case result{dense(stream, rest, kHeld - total * (bits + 2))};
  for (std::size_t i = 0; i < multiplicity; ++i) {
    result.coefficients = product(result.coefficients, factor);
  }
  return result;
}

// t^n -+ 2 (a t - 1)^2, mirrored or reversed. With minus, two roots beside 1/a are about
// 2^(1/2) a^-(n/2 + 1) apart (Mignotte); with plus, a pair of complex ones is as close to it.
Coefficients mignotte(SeededStream& stream, int side) {
  const std::size_t degree = draw_degree(stream, 3);
  const Integer a = draw_positive(stream, 3 + static_cast<int>(stream.below(23)));
  Coefficients p(degree + 1, Integer(0));
  p[degree] = 1;
  p[0] += side * 2;
  p[1] -= side * 4 * a;
  p[2] += side * 2 * a * a;
  if (stream.chance(0.5)) {
    for (std::size_t i = 1; i <= degree; i += 2) {
      p[i] = -p[i];
    }
  }
  if (stream.chance(0.5)) {
    std::reverse(p.begin(), p.end());
  }
  return p;
}

Case close(SeededStream& stream) { return {mignotte(stream, -1)}; }
Case nearly_touching(SeededStream& stream) { return {mignotte(stream, 1)}; }

// (q t - p)^n with one coefficient one off.
Case perturbed(SeededStream& stream) {
  const std::size_t degree = draw_degree(stream);
  const auto bits = static_cast<int>(52 / degree) - 1;
  const Coefficients factor = linear(stream, 1 + static_cast<int>(stream.below(bits)));
  Coefficients p{1};
  for (std::size_t i = 0; i < degree; ++i) {
    p = product(p, factor);
  }
  const std::size_t power = stream.below(degree);
  p[power] += draw_side(stream);
  return {p};
}

Case all_real(SeededStream& stream) {
  const std::size_t degree = draw_degree(stream);
  const auto bits = static_cast<int>(kHeld / degree) - 1;
  const int size = 1 + static_cast<int>(stream.below(bits));
  return {linear_product(stream, degree, size), {}, degree};
}

// By Rolle, the derivative of such a product; it is up to 13 times as large.
Case all_real_irrational(SeededStream& stream) {
  const std::size_t degree = draw_degree(stream);
  const auto bits = static_cast<int>((kHeld - 4) / (degree + 1)) - 1;
  const int size = 1 + static_cast<int>(stream.below(bits));
  return {derivative(linear_product(stream, degree + 1, size)), {}, degree};
}

// A product of quadratics a t^2 + b t + c with b^2 < 4 a c, some of them repeated.
Case no_real(SeededStream& stream) {
  const std::size_t count = 1 + stream.below(kMost / 2);
  const int bits = static_cast<int>(kHeld / count) - 2;
  Coefficients p{1};
  Coefficients factor;
  for (std::size_t i = 0; i < count; ++i) {
    if (factor.empty() || stream.chance(0.7)) {
      const Integer a = draw_positive(stream, bits);
      const Integer c = draw_positive(stream, bits);
      const auto largest = static_cast<std::int64_t>(sqrt(Integer(4 * a * c - 1)));
      factor = {c, stream.integer(-largest, largest), a};
    }
    p = product(p, factor);
  }
  return {p, {}, 0};
}

// t^k times anything, t^n among them.
Case zero_low(SeededStream& stream) {
  const std::size_t degree = draw_degree(stream);
  const std::size_t low = 1 + stream.below(degree);
  Coefficients p = dense(stream, degree - low, kHeld);
  p.insert(p.begin(), low, Integer(0));
  return {p, {{Rational(0), static_cast<unsigned>(low)}}};
}

// Most coefficients zero, or a polynomial in t^2, t^3 or t^4.
Case sparse(SeededStream& stream) {
  if (stream.chance(0.5)) {
    Coefficients p = dense(stream, draw_degree(stream), kHeld);
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
      if (stream.chance(0.7)) {
        p[i] = 0;
      }
    }
    return {p};
  }
  const std::size_t step = 2 + stream.below(3);
  const Coefficients inner = dense(stream, 1 + stream.below(kMost / step), kHeld);
  Coefficients p((inner.size() - 1) * step + 1, Integer(0));
  for (std::size_t i = 0; i < inner.size(); ++i) {
    p[i * step] = inner[i];
  }
  return {p};
}

// A common factor, and roots times a power of two: significands of 53 bits, with exponents.
Case scaled(SeededStream& stream, std::size_t most, std::int64_t shift) {
  constexpr int kContentBits = 21;
  const std::size_t degree = draw_degree(stream, 2, most);
  Case result;
  if (stream.chance(0.5)) {
    const auto bits = static_cast<int>((kHeld - kContentBits) / degree) - 1;
    result = {linear_product(stream, degree, bits), {}, degree};
  } else {
    result = {dense(stream, degree, kHeld - kContentBits)};
  }
  result.coefficients = stretched(result.coefficients, shift);
  const Integer content = draw(stream, kContentBits - 1) * 2 + 1;
  for (Integer& c : result.coefficients) {
    c *= content;
  }
  return result;
}

Case scaled(SeededStream& stream) { return scaled(stream, kMost, stream.integer(-150, 150)); }

// Roots that are infinite or zero in double.
Case beyond_double(SeededStream& stream) {
  const int side = draw_side(stream);
  return scaled(stream, 6, side * stream.integer(1150, 1300));
}

std::string text_of(const Coefficients& p) {
  std::ostringstream out;
  for (const Integer& c : p) {
    out << ' ' << c;
  }
  return out.str();
}

bool at_most(double bound, const Rational& value) {
  return std::isinf(bound) ? bound < 0 : Rational(bound) <= value;
}

bool at_least(double bound, const Rational& value) {
  return std::isinf(bound) ? bound > 0 : Rational(bound) >= value;
}

// What is wrong with a root, given the true one; nothing if nothing is.
std::string fault(const Root& root, const RealRoot& truth, int bits) {
  if (root.multiplicity() != truth.multiplicity) {
    return "its multiplicity is " + std::to_string(root.multiplicity()) + ", not " +
           std::to_string(truth.multiplicity);
  }
  if (!at_most(root.lower(), truth.upper) || !at_least(root.upper(), truth.lower)) {
    return "it is not between its doubles";
  }
  const Enclosure own = enclosure(root, bits);
  if (own.lower > own.upper || own.lower > truth.upper || own.upper < truth.lower) {
    return "its enclosure is elsewhere";
  }
  const Rational tiny(1, power_of_two(bits));
  const Rational size = std::max({Rational(abs(truth.lower)), Rational(abs(truth.upper)), tiny});
  if (own.upper - own.lower > tiny * size) {
    return "its enclosure is wide";
  }
  const double nearest = number::nearest_double(truth.lower);
  if (nearest == number::nearest_double(truth.upper) && nearest != nearest_double(root)) {
    return "its nearest double is another";
  }
  return "";
}

std::string disagreement(const std::vector<Root>& roots, const std::vector<RealRoot>& truth,
                         int bits) {
  if (roots.size() != truth.size()) {
    return std::to_string(roots.size()) + " roots, not " + std::to_string(truth.size());
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (i > 0 && compare(roots[i - 1], roots[i]) >= 0) {
      return "root " + std::to_string(i) + " is not above the one before it";
    }
    if (const std::string why = fault(roots[i], truth[i], bits); !why.empty()) {
      return "root " + std::to_string(i) + ": " + why;
    }
  }
  return "";
}

// What the construction tells otherwise.
std::string contradiction(const Case& made, const std::vector<Root>& roots) {
  std::size_t count = 0;
  for (const Root& root : roots) {
    count += root.multiplicity();
  }
  if (made.real_count && *made.real_count != count) {
    return std::to_string(count) + " roots with multiplicity are not those of the factors";
  }
  for (const Known& known : made.known) {
    const auto found = std::find_if(roots.begin(), roots.end(), [&known](const Root& root) {
      return compare(root, known.root) == 0;
    });
    if (found == roots.end() || found->multiplicity() < known.multiplicity) {
      return "the repeated root " + number::to_text(known.root) + " is missing";
    }
  }
  return "";
}

// Nearer to each other than doubles are.
bool have_neighbours(const std::vector<RealRoot>& roots) {
  for (std::size_t i = 1; i < roots.size(); ++i) {
    if ((roots[i].lower - roots[i - 1].upper) * Rational(power_of_two(kHeld)) <
        abs(roots[i].lower)) {
      return true;
    }
  }
  return false;
}

bool is_held(const Coefficients& p) {
  return std::all_of(p.begin(), p.end(),
                     [](const Integer& c) { return abs(c) < power_of_two(kHeld); });
}

support::ClassTally hard_classes() {
  return {"no root",     "one root",       "three roots or more", "zero",     "double root",
          "triple root", "double, triple", "neighbours",          "overflow", "underflow"};
}

void count_classes(const std::vector<RealRoot>& roots, support::ClassTally& tally) {
  const auto any = [&roots](auto fits) { return std::any_of(roots.begin(), roots.end(), fits); };
  const auto rounded = [](const RealRoot& root) { return number::nearest_double(root.lower); };
  const bool twice = any([](const RealRoot& root) { return root.multiplicity == 2; });
  const bool thrice = any([](const RealRoot& root) { return root.multiplicity == 3; });
  tally.add("no root", roots.empty());
  tally.add("one root", roots.size() == 1);
  tally.add("three roots or more", roots.size() >= 3);
  tally.add("zero", any([](const RealRoot& root) { return root.lower == 0 && root.upper == 0; }));
  tally.add("double root", twice);
  tally.add("triple root", thrice);
  tally.add("double, triple", twice && thrice);
  tally.add("neighbours", have_neighbours(roots));
  tally.add("overflow", any([&](const RealRoot& root) { return std::isinf(rounded(root)); }));
  tally.add("underflow",
            any([&](const RealRoot& root) { return rounded(root) == 0 && root.lower != 0; }));
}

struct Class {
  const char* name;
  Case (*make)(SeededStream& stream);
  std::uint64_t cases;
  bool held = true;  ///< in 53 bits
};

// Goes through all cases of the classes; each hard class must be met in a twentieth of them, and
// each degree in a hundredth.
void compare_roots(const std::vector<Class>& classes, const std::vector<const char*>& hard) {
  support::ClassTally tally = hard_classes();
  std::array<std::uint64_t, kMost + 1> of_degree{};
  std::uint64_t cases = 0;
  for (const Class& cls : classes) {
    for (std::uint64_t case_id = 0; case_id < cls.cases; ++case_id, ++cases) {
      const std::string name = std::string("roots/") + cls.name;
      SeededStream stream(name, kSeed, case_id);
      const Case made = cls.make(stream);
      const IntegerPolynomial polynomial(made.coefficients);
      INFO(name << " " << kSeed << " " << case_id
                << ", from the lowest coefficient:" << text_of(made.coefficients));
      REQUIRE(polynomial.degree() >= 2);
      REQUIRE(polynomial.degree() <= static_cast<int>(kMost));
      REQUIRE((!cls.held || is_held(made.coefficients)));
      // Enclosures take most of the time, and that grows with the square of the bits.
      const int bits = case_id % 8 == 0 ? kBits : 10 + static_cast<int>(stream.below(80));
      const std::vector<RealRoot> truth = reference::real_roots(made.coefficients, kBits);
      const std::vector<Root> roots = real_roots(polynomial);
      std::string why = disagreement(roots, truth, bits);
      if (why.empty()) {
        why = contradiction(made, roots);
      }
      if (!why.empty()) {
        FAIL(why);
      }
      count_classes(truth, tally);
      ++of_degree[made.coefficients.size() - 1];
    }
  }
  INFO(cases << " cases; " << tally);
  for (const char* name : hard) {
    INFO(name);
    CHECK(tally.count(name) >= cases / 20);
  }
  CHECK(*std::min_element(of_degree.begin() + 2, of_degree.end()) >= cases / 100);
}

}  // namespace

// 10 400 polynomials in all, in tests that can run side by side.
TEST_CASE("The exact roots of random polynomials are those of FLINT and Arb", "[oracle]") {
  compare_roots({{"generic", generic, 1000},
                 {"all real", all_real, 800},
                 {"all real, irrational", all_real_irrational, 800},
                 {"no real", no_real, 800},
                 {"zero low", zero_low, 800},
                 {"sparse", sparse, 800}},
                {"no root", "one root", "three roots or more", "zero"});
}

TEST_CASE("The exact roots of repeated factors are those of FLINT and Arb", "[oracle]") {
  compare_roots({{"repeated", repeated, 900},
                 {"repeated, wide", repeated_wide, 900, false},
                 {"repeated, irrational", repeated_irrational, 900}},
                {"double root", "triple root", "double, triple", "three roots or more"});
}

TEST_CASE("Exact roots next to each other are those of FLINT and Arb", "[oracle]") {
  compare_roots({{"close", close, 500},
                 {"nearly touching", nearly_touching, 400},
                 {"perturbed", perturbed, 800}},
                {"neighbours", "no root", "three roots or more"});
}

TEST_CASE("Exact roots of any magnitude are those of FLINT and Arb", "[oracle]") {
  compare_roots({{"scaled", scaled, 800, false}, {"beyond double", beyond_double, 200, false}},
                {"overflow", "underflow", "three roots or more"});
}

TEST_CASE("FLINT and Arb find the roots that are known", "[oracle]") {
  const auto found = [](const Coefficients& p) { return reference::real_roots(p, kBits); };
  const auto is_at = [](const RealRoot& root, const Rational& value) {
    return root.lower <= value && value <= root.upper;
  };
  SECTION("none") {
    CHECK(found({7}).empty());
    CHECK(found({1, 0, 1, 0, 0}).empty());
    CHECK(found({4, 0, 4, 0, 1}).empty());
    CHECK_THROWS_AS(found({0, 0}), std::invalid_argument);
  }
  SECTION("Wilkinson's 1 .. 10") {
    const auto roots = found(
        {3628800, -10628640, 12753576, -8409500, 3416930, -902055, 157773, -18150, 1320, -55, 1});
    REQUIRE(roots.size() == 10);
    for (std::size_t i = 0; i < 10; ++i) {
      CHECK(is_at(roots[i], Rational(i + 1)));
      CHECK(roots[i].multiplicity == 1);
    }
  }
  SECTION("-3 (t - 1)^2 (t - 2)^3") {
    const auto roots = found({24, -84, 114, -75, 24, -3});
    REQUIRE(roots.size() == 2);
    CHECK(is_at(roots[0], 1));
    CHECK(roots[0].multiplicity == 2);
    CHECK(is_at(roots[1], 2));
    CHECK(roots[1].multiplicity == 3);
  }
  SECTION("t^5 (2^2000 t - 1)") {
    const auto roots = found({0, 0, 0, 0, 0, -1, power_of_two(2000)});
    REQUIRE(roots.size() == 2);
    CHECK(is_at(roots[0], 0));
    CHECK(roots[0].multiplicity == 5);
    CHECK(is_at(roots[1], Rational(1, power_of_two(2000))));
    CHECK(roots[1].multiplicity == 1);
  }
  SECTION("(t^2 - 2)^2 (t^2 - 3)") {
    const auto roots = found({-12, 0, 16, 0, -7, 0, 1});
    REQUIRE(roots.size() == 4);
    CHECK(roots[0].multiplicity == 1);
    CHECK(roots[1].multiplicity == 2);
    CHECK(roots[2].lower > number::parse_rational("1.41421356237309504880168872420969807856"));
    CHECK(roots[2].upper < number::parse_rational("1.41421356237309504880168872420969807857"));
    CHECK(roots[3].lower > number::parse_rational("1.73205080756887729352744634150587236694"));
    CHECK(roots[3].upper < number::parse_rational("1.73205080756887729352744634150587236695"));
  }
  // With a = 1000: four real roots, since by Descartes' rule one is negative and at most three
  // are positive. At 1/a -+ h is 2 (a t - 1)^2 = 2 (a h)^2, and t^10 is nearly a^-10: the value
  // is positive for h = a^-6 / 2 and negative for h = 2 a^-6.
  SECTION("Mignotte's t^10 - 2 (1000 t - 1)^2") {
    const auto roots = found({-2, 4000, -2000000, 0, 0, 0, 0, 0, 0, 0, 1});
    REQUIRE(roots.size() == 4);
    const Rational middle(1, 1000);
    const Rational h = middle * middle * middle * middle * middle * middle;
    CHECK(roots[0].upper < -6);
    CHECK(roots[1].lower > middle - 2 * h);
    CHECK(roots[1].upper < middle - h / 2);
    CHECK(roots[2].lower > middle + h / 2);
    CHECK(roots[2].upper < middle + 2 * h);
    CHECK(roots[3].lower > 6);
  }
}

TEST_CASE("Each kind of disagreement with FLINT and Arb is noticed", "[oracle]") {
  const Coefficients p{-12, 0, 16, 0, -7, 0, 1};  // (t^2 - 2)^2 (t^2 - 3)
  const std::vector<RealRoot> truth = reference::real_roots(p, kBits);
  const std::vector<Root> roots = real_roots(IntegerPolynomial(p));
  REQUIRE(disagreement(roots, truth, kBits).empty());
  SECTION("count") {
    CHECK(!disagreement({roots.begin() + 1, roots.end()}, truth, kBits).empty());
    CHECK(!disagreement(roots, {truth.begin(), truth.end() - 1}, kBits).empty());
  }
  SECTION("multiplicity") {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      std::vector<RealRoot> other = truth;
      other[i].multiplicity = 3 - other[i].multiplicity;
      CHECK(!disagreement(roots, other, kBits).empty());
    }
  }
  SECTION("place") {
    const Rational step(1, power_of_two(kBits - 4));
    for (std::size_t i = 0; i < truth.size(); ++i) {
      std::vector<RealRoot> below = truth;
      below[i] = {truth[i].lower - step, truth[i].upper - step, truth[i].multiplicity};
      CHECK(!disagreement(roots, below, kBits).empty());
      std::vector<RealRoot> above = truth;
      above[i] = {truth[i].lower + step, truth[i].upper + step, truth[i].multiplicity};
      CHECK(!disagreement(roots, above, kBits).empty());
    }
  }
  SECTION("order") {
    const std::vector<Root> swapped{roots[0], roots[2], roots[1], roots[3]};
    const std::vector<RealRoot> also{truth[0], truth[2], truth[1], truth[3]};
    CHECK(!disagreement(swapped, also, kBits).empty());
  }
}

}  // namespace lamina
