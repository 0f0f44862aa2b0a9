// The only file that compiles these templates, and that computes with intervals of doubles.
#include "poly/certified_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "number/all_numbers.hpp"
#include "number/double_interval.hpp"
#include "poly/certified_roots.hpp"
#include "poly/sign_changes.hpp"

namespace lamina::poly {
namespace {

using number::DoubleInterval;
using number::middle_of;

// c[0] + c[1] t + ... + c[degree] t^degree, each coefficient somewhere in its interval.
struct IntervalPolynomial {
  std::array<DoubleInterval, kMostDegree + 1> c;
  int degree = 0;
};

// The search for t = length u with 0 < u <= 1; the length may be negative.
class IntervalSearch {
 public:
  IntervalSearch(const IntervalPolynomial& p, double length)
      : p_(p), n_(p.degree), length_(length) {}

  // Finds the roots from the part `start` on, and maybe some before; false if something is
  // undecided. Contract: this thread rounds upwards.
  bool run(double start) {
    Piece whole{{}, DoubleInterval(0), DoubleInterval(1)};
    Coefficients& b = whole.b;
    DoubleInterval power = 1;
    for (int i = 0; i <= n_; ++i) {
      b[i] = p_.c[i] * power;
      power *= DoubleInterval(length_);
    }
    for (int level = 1; level <= n_; ++level) {
      for (int j = level; j > 0; --j) {
        b[j] += b[j - 1];
      }
    }
    for (int j = 1; j < n_; ++j) {
      b[j] /= DoubleInterval(kBinomials[n_][j]);
    }
    if (start > 0) {
      whole = split(whole, start);
    }
    return is_certain(b[0]) && is_certain(b[n_]) && search(whole, kMostHalvings);
  }

  // Each in an interval of its own, from the start on.
  [[nodiscard]] std::span<const DoubleInterval> found() const {
    return std::span(roots_).first(count_);
  }

 private:
  using Coefficients = std::array<DoubleInterval, kMostDegree + 1>;

  struct Piece {
    Coefficients b;
    DoubleInterval low;  // in u
    DoubleInterval high;
  };

  // An interval of doubles is not cut much narrower than this many times.
  static constexpr int kMostHalvings = 60;
  // Where an interval is cut: in the middle, or else where no root is near.
  static constexpr std::array<double, 5> kCuts{8. / 16, 7. / 16, 9. / 16, 5. / 16, 11. / 16};

  static bool is_certain(const DoubleInterval& x) { return number::sign(x).value_or(0) != 0; }

  [[nodiscard]] int most_changes(const Coefficients& b) const {
    int changes = 0;
    int last = 0;
    for (int j = 0; j <= n_; ++j) {
      const int sign = b[j].inf() > 0 ? 1 : b[j].sup() < 0 ? -1 : 0;
      if (sign == 0) {
        return most_changes_in_doubt(b);
      }
      changes += sign * last < 0 ? 1 : 0;
      last = sign;
    }
    return changes;
  }
  [[nodiscard]] int most_changes_in_doubt(const Coefficients& b) const {
    std::array<std::optional<int>, kMostDegree + 1> signs;
    for (int j = 0; j <= n_; ++j) {
      signs[j] = number::sign(b[j]);
    }
    return most_sign_changes(std::span(signs).first(n_ + 1));
  }

  // Cuts the piece at the part `u` of it (de Casteljau); leaves the left one, returns the other.
  Piece split(Piece& piece, double u) const {
    const DoubleInterval weight(u);
    const DoubleInterval rest = DoubleInterval(1) - weight;
    const DoubleInterval middle = rest * piece.low + weight * piece.high;
    Piece right{piece.b, middle, piece.high};
    piece.high = middle;
    for (int level = 1; level <= n_; ++level) {
      for (int j = 0; j <= n_ - level; ++j) {
        right.b[j] = rest * right.b[j] + weight * right.b[j + 1];
      }
      piece.b[level] = right.b[0];
    }
    return right;
  }

  // Both ends have certain signs. Returns false if something is undecided.
  bool search(const Piece& piece, int halvings_left) {
    const int most = most_changes(piece.b);
    if (most == 0) {
      return true;
    }
    if (most == 1 && number::sign(piece.b[0]) != number::sign(piece.b[n_])) {
      add(piece);
      return true;
    }
    for (const double cut : kCuts) {
      if (halvings_left == 0) {
        break;
      }
      Piece left = piece;
      const Piece right = split(left, cut);
      if (is_certain(right.b[0])) {
        return search(left, halvings_left - 1) && search(right, halvings_left - 1);
      }
    }
    return false;
  }

  // The one root of the piece.
  void add(const Piece& piece) {
    const DoubleInterval one_end = DoubleInterval(length_) * piece.low;
    const DoubleInterval other_end = DoubleInterval(length_) * piece.high;
    const bool rising = (length_ > 0) == (number::sign(piece.b[n_]) == 1);
    roots_[count_++] = narrowed(
        {std::min(one_end.inf(), other_end.inf()), std::max(one_end.sup(), other_end.sup())},
        rising);
  }

  // What remains of an interval with one root in it after interval Newton steps, and halving
  // where they do not help.
  [[nodiscard]] DoubleInterval narrowed(DoubleInterval t, bool rising) const {
    while (true) {
      const double middle = middle_of(t);
      if (!(t.inf() < middle && middle < t.sup())) {
        return t;
      }
      const DoubleInterval here = value_at(DoubleInterval(middle));
      const DoubleInterval slope = slope_at(t);
      DoubleInterval next = t;
      if (is_certain(slope)) {
        const DoubleInterval newton = DoubleInterval(middle) - here / slope;
        next = {std::max(t.inf(), newton.inf()), std::min(t.sup(), newton.sup())};
      }
      const double width = t.sup() - t.inf();
      if (next.sup() - next.inf() > width / 2 && is_certain(here)) {
        const bool left = (number::sign(here) == 1) == rising;
        next = left ? DoubleInterval(next.inf(), std::min(next.sup(), middle))
                    : DoubleInterval(std::max(next.inf(), middle), next.sup());
      }
      if (!(next.sup() - next.inf() < width)) {
        return t;
      }
      t = next;
    }
  }

  [[nodiscard]] DoubleInterval value_at(const DoubleInterval& t) const {
    DoubleInterval sum = p_.c[n_];
    for (int i = n_ - 1; i >= 0; --i) {
      sum = sum * t + p_.c[i];
    }
    return sum;
  }
  [[nodiscard]] DoubleInterval slope_at(const DoubleInterval& t) const {
    DoubleInterval value = p_.c[n_];
    DoubleInterval slope = 0;
    for (int i = n_ - 1; i >= 0; --i) {
      slope = slope * t + value;
      value = value * t + p_.c[i];
    }
    return slope;
  }

  const IntervalPolynomial& p_;
  int n_;
  double length_;
  std::array<DoubleInterval, kMostDegree> roots_;
  int count_ = 0;
};

// p without its roots at zero, which are certain.
template <RoundedNumber Number>
Polynomial<Number> without_zeros(const Polynomial<Number>& p, const Range<Number>& range,
                                 RealRoots<Number>& roots) {
  int zeros = 0;
  while (p.c[zeros] == 0) {
    ++zeros;
  }
  if (zeros > 0 && range.contains(Number(0))) {
    roots.add(Number(0), zeros);
  }
  return Polynomial<Number>(std::span(p.c).subspan(zeros, p.degree + 1 - zeros));
}

RealRoots<double> by_double_intervals(const Polynomial<double>& given, Range<double> range) {
  RealRoots<double> roots;
  const Polynomial<double> p = without_zeros(given, range, roots);
  if (p.degree == 0) {
    return roots;
  }
  const double bound = 2 * root_bound(p);  // no root is as large
  range.low = std::max(range.low, -bound);
  range.high = std::min(range.high, bound);
  if (!(range.low <= range.high)) {
    return roots;
  }
  const number::RoundingUpwards upwards;
  IntervalPolynomial intervals;
  intervals.degree = p.degree;
  std::copy_n(p.c.begin(), p.degree + 1, intervals.c.begin());
  // Adds the roots of the range from near to far; false if something is undecided.
  const auto add_side = [&](double near, double far) {
    // The part is rounded down, so that the search starts at or before the range does.
    const double part = near / far > 0 ? std::nextafter(near / far, 0) : 0;
    IntervalSearch search(intervals, far);
    if (!search.run(part)) {
      return false;
    }
    for (const DoubleInterval& root : search.found()) {
      if (root.sup() < range.low || range.high < root.inf()) {
        continue;
      }
      if (root.inf() < range.low || range.high < root.sup()) {
        return false;
      }
      roots.add(middle_of(root), 1);
    }
    return true;
  };
  if ((range.low < 0 && !add_side(std::min(range.high, 0.0), range.low)) ||
      (range.high > 0 && !add_side(std::max(range.low, 0.0), range.high))) {
    roots.count = 0;
    roots.outcome = Outcome::Undecided;
  }
  return roots;
}

template <RoundedNumber Number>
RealRoots<Number> undecided() {
  RealRoots<Number> none;
  none.outcome = Outcome::Undecided;
  return none;
}

template <RoundedNumber Number>
RealRoots<Number> by_many_bits(const Polynomial<Number>& given, const Range<Number>& range) {
  using Traits = number::number_traits<Number>;
  constexpr int kBits = Traits::kSignificandBits;
  RealRoots<Number> roots;
  const Polynomial<Number> p = without_zeros(given, range, roots);
  for (const int side : {-1, 1}) {
    std::vector<number::Interval> ascending;
    for (int i = 0; i <= p.degree; ++i) {
      const number::Rational c = Traits::to_exact(p.c[i]);
      ascending.emplace_back(side < 0 && i % 2 == 1 ? number::Rational(-c) : c, kBits);
    }
    const auto positive = positive_roots(std::move(ascending));
    if (!positive) {
      return undecided<Number>();
    }
    for (const IsolatedRoot& root : *positive) {
      // The bits that the coefficients have may not do for as many of the root.
      for (int bits = kBits;; bits -= 4) {
        if (bits <= 0) {
          return undecided<Number>();
        }
        const auto bounds = enclosure(root, bits);
        if (!bounds) {
          continue;
        }
        const Number low = Traits::from_exact(side < 0 ? -bounds->upper : bounds->lower);
        const Number high = Traits::from_exact(side < 0 ? -bounds->lower : bounds->upper);
        const bool inside = range.contains(low);
        if (inside != range.contains(high) || low == range.low || high == range.high) {
          return undecided<Number>();
        }
        if (inside) {
          roots.add(Number(low + (high - low) / 2), 1);
        }
        break;
      }
    }
  }
  return roots;
}

}  // namespace

template <RoundedNumber Number>
RealRoots<Number> certified_real_roots(const Polynomial<Number>& p, const Range<Number>& range) {
  if constexpr (number::number_traits<Number>::kSignificandBits <= 53) {
    Polynomial<double> narrow;
    narrow.degree = p.degree;
    for (int i = 0; i <= p.degree; ++i) {
      narrow.c[i] = static_cast<double>(p.c[i]);
      if (Number(narrow.c[i]) != p.c[i]) {
        return undecided<Number>();
      }
    }
    const RealRoots<double> found = by_double_intervals(
        narrow, {static_cast<double>(range.low), static_cast<double>(range.high)});
    RealRoots<Number> roots;
    for (int i = 0; i < found.count; ++i) {
      if constexpr (std::is_floating_point_v<Number>) {
        roots.add(static_cast<Number>(found.t[i]), found.multiplicity[i]);
      } else {  // Boost cuts off what it takes from a double, and rounds what it takes from itself
        roots.add(Number(number::bin<53>(found.t[i])), found.multiplicity[i]);
      }
    }
    roots.outcome = found.outcome;
    return roots;
  } else {
    return by_many_bits(p, range);
  }
}

CertifiedRoots certified_roots(std::span<const Bounds> ascending, double high) {
  const number::RoundingUpwards upwards;
  IntervalPolynomial p;
  p.degree = static_cast<int>(ascending.size()) - 1;
  std::transform(ascending.begin(), ascending.end(), p.c.begin(),
                 [](const Bounds& c) { return DoubleInterval(c.low, c.high); });
  IntervalSearch search(p, high);
  CertifiedRoots roots;
  if (!search.run(0)) {
    roots.outcome = Outcome::Undecided;
    return roots;
  }
  for (const DoubleInterval& root : search.found()) {
    roots.t[roots.count++] = {root.inf(), root.sup()};
  }
  return roots;
}

#define LAMINA_INSTANTIATE(Number)                                                   \
  template RealRoots<Number> certified_real_roots<Number>(const Polynomial<Number>&, \
                                                          const Range<Number>&);
LAMINA_FOR_EACH_ROUNDED_NUMBER(LAMINA_INSTANTIATE)
#undef LAMINA_INSTANTIATE

}  // namespace lamina::poly
