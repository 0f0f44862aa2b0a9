#include "poly/certified_roots.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "poly/sign_changes.hpp"

namespace lamina::poly {
namespace {

using number::Enclosure;
using number::Integer;
using number::Interval;
using number::Rational;

using Coefficients = std::vector<Interval>;

// Where an interval is cut, in sixteenths: the middle, or else where no root is near.
constexpr std::array<unsigned, 5> kCuts{8, 7, 9, 5, 11};

// Is the sign of an end of the interval known, and not zero?
bool is_certain(const Interval& end) {
  const auto sign = end.sign();
  return sign && *sign != 0;
}

int most_sign_changes(const Coefficients& b) {
  std::vector<std::optional<int>> signs;
  signs.reserve(b.size());
  for (const Interval& coefficient : b) {
    signs.push_back(coefficient.sign());
  }
  return poly::most_sign_changes(signs);
}

struct Halves {
  Coefficients left;
  Coefficients right;
};

// De Casteljau's algorithm at the part cut / whole of the interval.
Halves split(Coefficients b, const Integer& cut, const Integer& whole) {
  Halves halves;
  halves.left.reserve(b.size());
  halves.right.reserve(b.size());
  const Integer rest = whole - cut;
  while (!b.empty()) {
    halves.left.push_back(b.front());
    halves.right.push_back(b.back());
    for (std::size_t i = 0; i + 1 < b.size(); ++i) {
      b[i] = (rest * b[i] + cut * b[i + 1]) / whole;
    }
    b.pop_back();
  }
  std::reverse(halves.right.begin(), halves.right.end());
  return halves;
}

Halves split(Coefficients b, unsigned sixteenths) { return split(std::move(b), sixteenths, 16); }

Rational cut_point(const Enclosure& bounds, unsigned cut) {
  return bounds.lower + (bounds.upper - bounds.lower) * Rational(cut, 16);
}

}  // namespace

struct IsolatedRoot::Isolation {
  std::vector<IsolatedRoot> roots;

  // The signs at both ends are certain. Returns false if the bits do not suffice.
  bool isolate(Coefficients b, const Enclosure& bounds, int depth) {
    const int most = most_sign_changes(b);
    const bool changes = b.front().sign() != b.back().sign();
    if (most == 0) {
      return true;
    }
    if (most == 1 && changes) {
      roots.push_back(IsolatedRoot(std::move(b), bounds));
      return true;
    }
    if (depth == 0) {
      return false;
    }
    for (const unsigned cut : kCuts) {
      Halves halves = split(b, cut);
      if (is_certain(halves.left.back())) {
        const Rational middle = cut_point(bounds, cut);
        return isolate(std::move(halves.left), {bounds.lower, middle}, depth - 1) &&
               isolate(std::move(halves.right), {middle, bounds.upper}, depth - 1);
      }
    }
    return false;
  }
};

bool IsolatedRoot::refine() {
  // Coefficients of few bits could be cut for ever; what is equal would never be given up.
  const Integer finest = Integer(1) << bernstein_.front().bits();
  if ((bounds_.upper - bounds_.lower) * finest < 1) {
    return false;
  }
  return newton_step() || bisection_step();
}

bool IsolatedRoot::bisection_step() {
  for (const unsigned cut : kCuts) {
    Halves halves = split(bernstein_, cut);
    if (!is_certain(halves.left.back())) {
      continue;
    }
    const Rational middle = cut_point(bounds_, cut);
    const bool on_the_left = halves.left.front().sign() != halves.left.back().sign();
    bernstein_ = std::move(on_the_left ? halves.left : halves.right);
    (on_the_left ? bounds_.upper : bounds_.lower) = middle;
    return true;
  }
  return false;
}

// With v in 0 .. 1 on the interval, the root is in 1/2 - f(1/2) / f'(0 .. 1), and the derivative
// in the hull of its coefficients.
bool IsolatedRoot::newton_step() {
  const Coefficients& b = bernstein_;
  Interval slope = b[1] - b[0];
  for (std::size_t i = 1; i + 1 < b.size(); ++i) {
    slope = hull(slope, b[i + 1] - b[i]);
  }
  if (!is_certain(slope)) {
    return false;
  }
  const Integer degree(b.size() - 1);
  const Interval step = split(b, 8).left.back() / (degree * slope);
  const Rational lower = std::max(Rational(Rational(1, 2) - step.upper()), Rational(0));
  const Rational upper = std::min(Rational(Rational(1, 2) - step.lower()), Rational(1));
  const Rational width = upper - lower;
  // The ends go on a grid about as fine as the step is certain, one place beyond it: there the
  // signs are known if the coefficients allow.
  int places = b.front().bits();
  if (width > 0) {
    const auto magnitude = [](const Integer& value) { return static_cast<int>(msb(value)); };
    places = std::clamp(magnitude(denominator(width)) - magnitude(numerator(width)), 4, places);
  }
  const Integer whole = Integer(1) << places;
  const Rational low = lower * whole;
  const Rational high = upper * whole;
  const Integer from = std::max(Integer(numerator(low) / denominator(low) - 1), Integer(0));
  const Integer to = std::min(Integer(numerator(high) / denominator(high) + 2), whole);
  if (4 * (to - from) > whole) {
    return false;
  }
  Coefficients inner = b;
  if (to < whole) {
    inner = split(std::move(inner), to, whole).left;
  }
  if (from > 0) {
    inner = split(std::move(inner), from, to).right;
  }
  if (!is_certain(inner.front()) || !is_certain(inner.back())) {
    return false;
  }
  const Rational size = bounds_.upper - bounds_.lower;
  bounds_ = {bounds_.lower + size * Rational(from, whole),
             bounds_.lower + size * Rational(to, whole)};
  bernstein_ = std::move(inner);
  return true;
}

std::optional<std::vector<IsolatedRoot>> positive_roots(std::vector<Interval> ascending) {
  if (ascending.empty() || !is_certain(ascending.front()) || !is_certain(ascending.back())) {
    return std::nullopt;
  }
  // With s = u / (1 - u), c_i s^i (1-u)^n is c_i / binomial(n, i) times a Bernstein polynomial.
  const std::size_t n = ascending.size() - 1;
  unsigned long binomial = 1;
  for (std::size_t i = 0; i <= n; ++i) {
    ascending[i] = ascending[i] / Integer(binomial);
    binomial = binomial * (n - i) / (i + 1);
  }
  const int depth = ascending.front().bits() / 2;
  IsolatedRoot::Isolation isolation;
  if (!isolation.isolate(std::move(ascending), {0, 1}, depth)) {
    return std::nullopt;
  }
  return std::move(isolation.roots);
}

std::optional<std::strong_ordering> compare(IsolatedRoot& a, IsolatedRoot& b) {
  while (true) {
    if (a.bounds().upper <= b.bounds().lower) {
      return std::strong_ordering::less;
    }
    if (b.bounds().upper <= a.bounds().lower) {
      return std::strong_ordering::greater;
    }
    const auto width = [](const IsolatedRoot& root) {
      return Rational(root.bounds().upper - root.bounds().lower);
    };
    const bool a_is_wider = width(a) >= width(b);
    if (!(a_is_wider ? a : b).refine() && !(a_is_wider ? b : a).refine()) {
      return std::nullopt;
    }
  }
}

std::optional<Enclosure> enclosure(IsolatedRoot root, int bits) {
  const Integer scale = Integer(1) << bits;
  while (true) {
    // s = u / (1 - u), so s.upper - s.lower = (u.upper - u.lower) / ((1 - u.lower) (1 - u.upper)).
    const auto& [lower, upper] = root.bounds();
    if (upper < 1 &&
        (upper - lower) * scale <= std::max(Rational(1 - lower), lower) * (1 - upper)) {
      return Enclosure{Rational(lower / (1 - lower)), Rational(upper / (1 - upper))};
    }
    if (!root.refine()) {
      return std::nullopt;
    }
  }
}

}  // namespace lamina::poly
