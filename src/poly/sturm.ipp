#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "poly/scaling.hpp"
#include "poly/sturm.hpp"

namespace lamina::poly {
namespace detail {

// A number between the two: half way in the exponent where these differ, else in the value, so
// that halving an interval ends soon even if zero is in it. One of the two if they are neighbours,
// or if no root can be between them.
// Contract: low < high, finite; no root but zero is below 2^least_exponent.
template <RoundedNumber Number>
Number middle(const Number& low, const Number& high, std::int64_t least_exponent) {
  if (low < 0) {
    return high > 0 ? Number(0) : Number(-middle(Number(-high), Number(-low), least_exponent));
  }
  if (low == 0 && exponent_of(high) <= least_exponent) {
    return low;  // nothing is between them
  }
  const std::int64_t low_exponent = low == 0 ? least_exponent - 1 : exponent_of(low);
  const std::int64_t gap = exponent_of(high) - low_exponent;
  if (gap >= 2) {
    return times_power_of_two(Number(0.5), low_exponent + gap / 2);
  }
  return low + (high - low) / 2;
}

// p, its derivative, and the negative remainders of Euclid's division.
template <RoundedNumber Number>
class SturmSequence {
 public:
  explicit SturmSequence(const Polynomial<Number>& p) {
    terms_[0] = p;
    terms_[1] = in_units_of_power_of_two(derivative(p), 0);
    while (terms_[length_ - 1].degree > 0) {
      const Polynomial<Number> rest = negative_remainder(terms_[length_ - 2], terms_[length_ - 1]);
      if (rest.degree < 0) {
        break;
      }
      terms_[length_++] = rest;
    }
  }

  [[nodiscard]] const Polynomial<Number>& front() const { return terms_[0]; }

  [[nodiscard]] Number slope_at(const Number& t) const { return value(terms_[1], t); }

  // The number of roots in low < t <= high is that of the sign changes at low less that at high.
  [[nodiscard]] int sign_changes(const Number& t) const {
    int changes = 0;
    int last = 0;
    for (int i = 0; i < length_; ++i) {
      const Number at = value(terms_[i], t);
      const int sign = at > 0 ? 1 : at < 0 ? -1 : 0;
      changes += sign * last < 0 ? 1 : 0;
      last = sign != 0 ? sign : last;
    }
    return changes;
  }

 private:
  // -(a mod b), but for a positive factor. A step of the division is multiplied by what it divides
  // by, which may be as small as it likes.
  static Polynomial<Number> negative_remainder(const Polynomial<Number>& a,
                                               const Polynomial<Number>& b) {
    Polynomial<Number> rest = a;
    while (rest.degree >= b.degree) {
      Number keep = b.c[b.degree];
      Number take = rest.c[rest.degree];
      const std::int64_t greater = std::max(exponent_of(keep), exponent_of(take));
      keep = times_power_of_two(keep, -greater);
      take = times_power_of_two(take, -greater);
      if (keep < 0) {
        keep = -keep;
        take = -take;
      }
      const int shift = rest.degree - b.degree;
      for (int i = 0; i < rest.degree; ++i) {
        rest.c[i] = keep * rest.c[i] - (i < shift ? Number(0) : Number(take * b.c[i - shift]));
      }
      --rest.degree;
      rest = in_units_of_power_of_two(rest, 0);
    }
    for (int i = 0; i <= rest.degree; ++i) {
      rest.c[i] = -rest.c[i];
    }
    while (rest.degree >= 0 && rest.c[rest.degree] == 0) {
      --rest.degree;
    }
    return rest;
  }

  std::array<Polynomial<Number>, kMostDegree + 1> terms_;
  int length_ = 2;
};

// A point with the sign changes of the sequence there.
template <RoundedNumber Number>
struct SturmPoint {
  Number t;
  int sign_changes;
};

template <RoundedNumber Number>
class SturmSearch {
 public:
  SturmSearch(const Polynomial<Number>& p, RealRoots<Number>& roots)
      : sequence_(p), roots_(roots), least_exponent_(least_root_exponent(p)) {}

  // Adds the roots in low < t <= high. Contract: low < high, finite.
  void run(const Number& low, const Number& high) { search(point(low), point(high)); }

 private:
  using Point = SturmPoint<Number>;

  [[nodiscard]] Point point(const Number& t) const { return {t, sequence_.sign_changes(t)}; }

  // Counts that rounding has made are kept from growing, so that the search ends.
  [[nodiscard]] Point point_between(const Point& low, const Point& high) const {
    Point between = point(middle(low.t, high.t, least_exponent_));
    between.sign_changes = std::clamp(between.sign_changes, high.sign_changes, low.sign_changes);
    return between;
  }

  void search(const Point& low, const Point& high) {
    const int count = low.sign_changes - high.sign_changes;
    if (count == 1) {
      const auto [t, multiplicity] = only_root(low, high);
      roots_.add(t, multiplicity);
    } else if (count > 1) {
      const Point between = point_between(low, high);
      if (!(low.t < between.t && between.t < high.t)) {
        for (int i = 0; i < count; ++i) {
          roots_.add(high.t);
        }
        return;
      }
      search(low, between);
      search(between, high);
    }
  }

  // With the multiplicity: 2 where the value does not change its sign, 0 else, since 3 looks as 1.
  [[nodiscard]] std::pair<Number, int> only_root(Point low, Point high) const {
    while (true) {
      const Number low_value = value(sequence_.front(), low.t);
      const Number high_value = value(sequence_.front(), high.t);
      if (high_value == 0) {
        return {high.t, sequence_.slope_at(high.t) == 0 ? 2 : 0};
      }
      const bool changes = (low_value > 0) != (high_value > 0);
      // An end may be at the root of another interval: its sign is of no use then.
      if (changes && is_certain(low.t, low_value) && is_certain(high.t, high_value)) {
        return {sign_change(low.t, low_value, high.t, high_value), 0};
      }
      const Point between = point_between(low, high);
      if (!(low.t < between.t && between.t < high.t)) {
        return {high.t, changes ? 0 : 2};
      }
      (low.sign_changes > between.sign_changes ? high : low) = between;
    }
  }

  // Is the value beyond its rounding error by Horner's rule?
  [[nodiscard]] bool is_certain(const Number& t, const Number& its_value) const {
    using std::abs;
    const Polynomial<Number>& p = sequence_.front();
    Number terms = abs(p.c[p.degree]);
    for (int i = p.degree - 1; i >= 0; --i) {
      terms = terms * abs(t) + abs(p.c[i]);
    }
    return abs(its_value) > Number(2 * p.degree) * number::unit_roundoff<Number>() * terms;
  }

  // Regula falsi; the value of an end that stays is halved (Dowell and Jarratt 1971), and each
  // third step halves the interval, come what may.
  [[nodiscard]] Number sign_change(Number low, Number low_value, Number high,
                                   Number high_value) const {
    using std::abs;
    Number low_weight = low_value;
    Number high_weight = high_value;
    int last_side = 0;
    for (int step = 1;; ++step) {
      const Number half_way = middle(low, high, least_exponent_);
      if (!(low < half_way && half_way < high)) {
        return abs(low_value) < abs(high_value) ? low : high;
      }
      // Keeps off the ends by a few units in the last place: these come together only if a step
      // falls beyond the root.
      const Number margin =
          4 * number::unit_roundoff<Number>() * std::max(Number(abs(low)), Number(abs(high)));
      Number t = high - (high - low) * (high_weight / (high_weight - low_weight));
      t = std::min(std::max(t, Number(low + margin)), Number(high - margin));
      if (step % 3 == 0 || !(low < t && t < high)) {
        t = half_way;
      }
      const Number at = value(sequence_.front(), t);
      if (at == 0) {
        return t;
      }
      if ((at > 0) == (high_value > 0)) {
        high = t;
        high_value = high_weight = at;
        low_weight = last_side > 0 ? Number(low_weight / 2) : low_weight;
        last_side = 1;
      } else {
        low = t;
        low_value = low_weight = at;
        high_weight = last_side < 0 ? Number(high_weight / 2) : high_weight;
        last_side = -1;
      }
    }
  }

  SturmSequence<Number> sequence_;
  RealRoots<Number>& roots_;
  std::int64_t least_exponent_;
};

}  // namespace detail

template <RoundedNumber Number>
RealRoots<Number> sturm_roots(const Polynomial<Number>& p, const Range<Number>& range) {
  RealRoots<Number> roots;
  const std::int64_t mean = mean_root_exponent(p);
  const Polynomial<Number> scaled = in_units_of_power_of_two(p, mean);
  const Number bound = root_bound(scaled);
  const Number low = std::max(times_power_of_two(range.low, -mean), Number(-bound));
  const Number high = std::min(times_power_of_two(range.high, -mean), bound);
  if (!(low <= high)) {
    return roots;
  }
  RealRoots<Number> found;
  if (value(scaled, low) == 0) {
    found.add(low);
  }
  if (low < high) {
    detail::SturmSearch<Number>(scaled, found).run(low, high);
  }
  for (int i = 0; i < found.count; ++i) {
    roots.add(times_power_of_two(found.t[i], mean), found.multiplicity[i]);
  }
  return roots;
}

}  // namespace lamina::poly
