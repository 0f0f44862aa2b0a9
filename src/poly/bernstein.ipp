#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "poly/bernstein.hpp"
#include "poly/newton.hpp"
#include "poly/scaling.hpp"
#include "poly/sign_changes.hpp"

namespace lamina::poly {
namespace detail {

// The search for t = length u with 0 < u <= 1; the length may be negative. The loops are unrolled
// where the degree is known when it is compiled.
template <typename Degree, RoundedNumber Number>
class BernsteinSearch {
 public:
  BernsteinSearch(const Polynomial<Number>& p, Degree degree, const Number& length,
                  RealRoots<Number>& roots)
      : p_(p), n_(degree), length_(length), roots_(roots) {
    set_local_coefficients();
    whole_ = {local_, Number(0), Number(1)};
    // By additions only, times C(n, j): most that have no root need no more.
    Coefficients& b = whole_.b;
    for (int level = 1; level <= n_; ++level) {
      for (int j = level; j > 0; --j) {
        b[j] = b[j] + b[j - 1];
      }
    }
  }

  // Is there none for certain? A first coefficient that has underflowed says nothing.
  [[nodiscard]] bool finds_none() const {
    return whole_.b[0] != 0 && whole_.b[n_] != 0 && sign_changes(negatives(whole_.b)) == 0;
  }

  // Is no root but zero nearer to zero than 2^-widest_range() of the length? Says no where it takes
  // more than a glance to see.
  [[nodiscard]] bool has_no_root_near_zero() const {
    using std::abs;
    using std::ldexp;
    return abs(local_[0]) >= ldexp(Number(2), -widest_range()) * most_;
  }

  // No coefficient underflows beside the others, if no root but zero is nearer to zero than 2^-this
  // of the length. Software floats take the exponents of double for that.
  [[nodiscard]] int widest_range() const {
    constexpr long kExponents = 1024;
    return static_cast<int>(std::min<long>(std::numeric_limits<Number>::max_exponent, kExponents) /
                            (2 * n_));
  }

  // Adds the roots with u > 0 and start <= u <= 1, at the start only if it is `included`.
  // Contract: 0 <= start < 1.
  void run(const Number& start, bool included) {
    Coefficients& b = whole_.b;
    const int sign_at_end = sign_of(b[n_]);
    for (int j = 1; j < n_; ++j) {
      b[j] = b[j] / Number(kBinomials[n_][j]);
    }
    if (start > 0) {
      whole_ = split(whole_, start);
      if (included) {
        add_zeros_at_start(whole_);
      }
    }
    sign_before_ = sign_of(b[0]);
    search(whole_, most_halvings());
    close_cluster(sign_at_end);
    if (sign_at_end == 0) {
      roots_.add(length_, leading_zeros(b.rend() - n_ - 1, b.rend()));
    }
    halley_roots(p_, n_, std::span(brackets_).first(brackets_count_));
    for (int i = 0; i < brackets_count_; ++i) {
      roots_.add(brackets_[i].t, multiplicities_[i]);
    }
  }

 private:
  using Coefficients = std::array<Number, kMostOf<Degree> + 1>;

  struct Piece {
    Coefficients b;
    Number low;  // in u
    Number high;
  };

  // Beyond this the ends of an interval of u in 0 .. 1 need not be different numbers; near 0 they
  // are as far down as roots are.
  [[nodiscard]] int most_halvings() const {
    return number::number_traits<Number>::kSignificandBits + widest_range();
  }
  // Before this no interval is so narrow that rounding decides; saves time only.
  static constexpr int kHalvingsWithoutDoubt = 4;

  static int sign_of(const Number& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

  // c_i length^i, all times one power of two where that is needed to keep them in range.
  void set_local_coefficients() {
    using std::abs;
    using std::frexp;
    using std::ldexp;
    Number power = 1;
    most_ = 0;
    for (int i = 0; i <= n_; ++i) {
      local_[i] = p_.c[i] * power;
      power = power * length_;
      most_ = std::max(most_, Number(abs(local_[i])));
    }
    const Number small = ldexp(Number(1), std::numeric_limits<Number>::min_exponent / 2);
    if (most_ > small && most_ < 1 / small) {
      return;
    }
    most_ = 1;
    int length_exponent = 0;
    const Number length_fraction = frexp(length_, &length_exponent);
    std::array<int, kMostOf<Degree> + 1> exponents{};
    int most_exponent = std::numeric_limits<int>::min();
    power = 1;
    for (int i = 0; i <= n_; ++i) {
      local_[i] = frexp(p_.c[i], &exponents[i]) * power;
      power = power * length_fraction;
      exponents[i] += i * length_exponent;
      if (local_[i] != 0) {
        most_exponent = std::max(most_exponent, exponents[i]);
      }
    }
    for (int i = 0; i <= n_; ++i) {
      local_[i] = ldexp(local_[i], exponents[i] - most_exponent);
    }
  }

  // A bit for each negative coefficient; zeros take the sign of the one before them, those in front
  // that of the first which is not zero.
  [[nodiscard]] unsigned negatives(const Coefficients& b) const {
    unsigned negative = 0;
    bool any_zero = false;
    for (int j = n_; j >= 0; --j) {
      negative = negative << 1 | static_cast<unsigned>(b[j] < 0);
      any_zero |= b[j] == 0;
    }
    if (!any_zero) {
      return negative;
    }
    const int first = leading_zeros(b.begin(), b.begin() + n_ + 1);
    for (int j = first + 1; j <= n_; ++j) {
      negative |= (b[j] == 0 ? negative >> (j - 1) & 1U : 0U) << j;
    }
    return first <= n_ && b[first] < 0 ? negative | ((1U << first) - 1) : negative;
  }

  // A bit for each j where the coefficients j and j + 1 differ in sign.
  [[nodiscard]] unsigned sign_changes(unsigned negative) const {
    const unsigned neighbours = (1U << n_) - 1;
    return (negative ^ (negative >> 1)) & neighbours;
  }

  template <typename Iterator>
  static int leading_zeros(Iterator first, Iterator last) {
    return static_cast<int>(std::find_if(first, last, [](const Number& b) { return b != 0; }) -
                            first);
  }

  void add_zeros_at_start(const Piece& piece) {
    if (piece.b[0] == 0) {
      roots_.add(length_ * piece.low, leading_zeros(piece.b.begin(), piece.b.begin() + n_ + 1));
    }
  }

  // Cuts the piece at the part `u` of it (de Casteljau); leaves the left one, returns the other.
  Piece split(Piece& piece, const Number& u) const {
    const Number middle = piece.low + (piece.high - piece.low) * u;
    Piece right{piece.b, middle, piece.high};
    piece.high = middle;
    for (int level = 1; level <= n_; ++level) {
      for (int j = 0; j <= n_ - level; ++j) {
        right.b[j] = right.b[j] + (right.b[j + 1] - right.b[j]) * u;
      }
      piece.b[level] = right.b[0];
    }
    return right;
  }

  // The same in the middle: sums, and the powers of two at the end.
  Piece halve(Piece& piece) const {
    const Number middle = piece.low + (piece.high - piece.low) / 2;
    Piece right{piece.b, middle, piece.high};
    piece.high = middle;
    Number power = 1;
    for (int level = 1; level <= n_; ++level) {
      power = power / 2;
      for (int j = 0; j <= n_ - level; ++j) {
        right.b[j] = right.b[j] + right.b[j + 1];
      }
      piece.b[level] = right.b[0] * power;
    }
    for (int j = 0; j < n_; ++j) {
      right.b[j] = right.b[j] * power;
      power = power * 2;
    }
    return right;
  }

  // From left to right, without the ends.
  void search(Piece& piece, int halvings_left) {
    const unsigned negative = negatives(piece.b);
    const unsigned changes = sign_changes(negative);
    if (changes == 0) {
      pass(negative);
    } else if ((changes & (changes - 1)) == 0) {
      add_simple(piece, std::countr_zero(changes), (negative & 1U) != 0);
      pass(negative);
    } else if (halvings_left == 0 || (most_halvings() - halvings_left > kHalvingsWithoutDoubt &&
                                      is_lost_in_rounding(piece))) {
      if (!in_cluster_) {
        cluster_low_ = piece.low;
      }
      in_cluster_ = true;
      cluster_high_ = piece.high;
    } else {
      Piece right = halve(piece);
      search(piece, halvings_left - 1);
      add_zeros_at_start(right);
      search(right, halvings_left - 1);
    }
  }

  // An interval with certain signs ends a cluster, and tells the sign before the next.
  void pass(unsigned negative) {
    close_cluster((negative & 1U) != 0 ? -1 : 1);
    sign_before_ = (negative >> n_ & 1U) != 0 ? -1 : 1;
  }

  // The coefficients are weighted sums of the c_i u^i, off by 2 n u times the sum of |c_i u^i| from
  // the change of basis; each halving adds n u times the largest one, which becomes smaller with
  // the interval: as much again is allowed for them all. No simple root depends on this bound.
  [[nodiscard]] bool is_lost_in_rounding(const Piece& piece) const {
    using std::abs;
    Number terms = abs(local_[n_]);
    for (int i = n_ - 1; i >= 0; --i) {
      terms = terms * piece.high + abs(local_[i]);
    }
    const Number rounding = Number(4 * n_) * number::unit_roundoff<Number>() * terms;
    return std::all_of(piece.b.begin(), piece.b.begin() + n_ + 1,
                       [&](const Number& b) { return abs(b) <= rounding; });
  }

  // From where the control polygon crosses zero, between the coefficients j and j + 1.
  void add_simple(const Piece& piece, int j, bool rising) {
    const Number part = piece.b[j] / (piece.b[j] - piece.b[j + 1]);
    const Number u = (Number(j) + part) / Number(n_);
    add_bracketed(piece.low, piece.high, piece.low + (piece.high - piece.low) * u, rising, 1);
  }

  // The sign change of p between two u, rising with u: left to the end, when all are searched. No
  // more than n are there, as halving adds none; of more, which there is no room for, none is kept.
  void add_bracketed(const Number& low, const Number& high, const Number& start, bool rising,
                     int multiplicity) {
    if (brackets_count_ == n_) {
      return;
    }
    const Number near = length_ * low;
    const Number far = length_ * high;
    const bool forward = length_ > 0;
    multiplicities_[brackets_count_] = multiplicity;
    brackets_[brackets_count_++] = {forward ? near : far, forward ? far : near, length_ * start,
                                    forward == rising};
  }

  void close_cluster(int sign_after) {
    if (!in_cluster_) {
      return;
    }
    in_cluster_ = false;
    const Number u = cluster_low_ + (cluster_high_ - cluster_low_) / 2;
    if (sign_before_ * sign_after < 0) {
      add_bracketed(cluster_low_, cluster_high_, u, sign_after > 0, 0);
    } else {
      roots_.add(double_root(u), 2);
    }
  }

  // A double root is a simple one of the derivative: far better placed by that.
  [[nodiscard]] Number double_root(const Number& u) const {
    const Polynomial<Number> slope = derivative(p_);
    Number t = length_ * u;
    constexpr int kSteps = 4;  // from half of the digits on two are enough
    for (int step = 0; step < kSteps; ++step) {
      const ValueAndSlope<Number> at = value_and_slope(slope, t);
      const Number next = t - at.value / at.slope;
      const Number next_u = next / length_;
      if (!(cluster_low_ <= next_u && next_u <= cluster_high_)) {
        break;
      }
      t = next;
    }
    return t;
  }

  const Polynomial<Number>& p_;
  [[no_unique_address]] Degree n_;
  Number length_;
  RealRoots<Number>& roots_;
  Coefficients local_;
  Number most_;  // no coefficient is greater in magnitude
  Piece whole_;
  int sign_before_ = 0;  // of what was passed last
  bool in_cluster_ = false;
  Number cluster_low_;  // in u
  Number cluster_high_;
  std::array<Bracket<Number>, kMostOf<Degree>> brackets_;
  std::array<int, kMostOf<Degree>> multiplicities_;
  int brackets_count_ = 0;
};

}  // namespace detail

namespace detail {

// The roots from near to far, which is not zero and on the same side; near is zero or `included`. A
// range that is too wide for the exponents is cut in the middle of these, so many times at most.
template <typename Degree, RoundedNumber Number>
void bernstein_search_one_side(const Polynomial<Number>& p, Degree degree, const Number& near,
                               const Number& far, bool included, int cuts_left,
                               RealRoots<Number>& roots) {
  BernsteinSearch<Degree, Number> search(p, degree, far, roots);
  if (search.finds_none()) {
    return;
  }
  std::int64_t least = exponent_of(far) - search.widest_range();
  if (near != 0) {
    least = exponent_of(near);
  } else if (!search.has_no_root_near_zero()) {
    least = least_root_exponent(p);
  }
  const std::int64_t gap = exponent_of(far) - least;
  if (gap <= search.widest_range() || cuts_left == 0) {
    search.run(Number(near / far), included);
    return;
  }
  const Number half = far > 0 ? Number(0.5) : Number(-0.5);
  const Number cut = times_power_of_two(half, least + gap / 2);
  bernstein_search_one_side(p, degree, near, cut, included, cuts_left - 1, roots);
  bernstein_search_one_side(p, degree, cut, far, false, cuts_left - 1, roots);
}

template <typename Degree, RoundedNumber Number>
void bernstein_search(const Polynomial<Number>& p, Degree degree, const Number& low,
                      const Number& high, RealRoots<Number>& roots) {
  constexpr int kMostCuts = 6;  // enough for the exponents of double, and of long double
  if (low < 0) {
    const Number near = std::min(high, Number(0));
    bernstein_search_one_side(p, degree, near, low, near != 0, kMostCuts, roots);
  }
  if (high > 0) {
    const Number near = std::max(low, Number(0));
    bernstein_search_one_side(p, degree, near, high, near != 0, kMostCuts, roots);
  }
}

// With the degree as a constant, so that the loops over it are unrolled: for the numbers of
// hardware, since each degree is code of its own to compile.
template <int kDegree, RoundedNumber Number>
void bernstein_search_unrolled(const Polynomial<Number>& p, const Number& low, const Number& high,
                               RealRoots<Number>& roots) {
  if (p.degree == kDegree) {
    bernstein_search(p, std::integral_constant<int, kDegree>(), low, high, roots);
  } else if constexpr (kDegree > 1) {
    bernstein_search_unrolled<kDegree - 1>(p, low, high, roots);
  }
}

}  // namespace detail

template <RoundedNumber Number>
RealRoots<Number> bernstein_roots(const Polynomial<Number>& p, const Range<Number>& range) {
  using std::abs;
  if (is_tiny(p)) {
    return bernstein_roots(in_units_of_power_of_two(p, 0), range);
  }
  RealRoots<Number> roots;
  Number low = range.low;
  Number high = range.high;
  if (!(abs(low) <= std::numeric_limits<Number>::max() &&
        abs(high) <= std::numeric_limits<Number>::max())) {
    const Number bound = root_bound(p);
    low = std::max(low, Number(-bound));
    high = std::min(high, bound);
  }
  if (!(low <= high)) {
    return roots;
  }
  if (low <= 0 && high >= 0 && p.c[0] == 0) {
    int zeros = 1;
    while (p.c[zeros] == 0) {
      ++zeros;
    }
    roots.add(Number(0), zeros);
  }
  if (low == high) {
    if (low != 0 && value(p, low) == 0) {
      roots.add(low);
    }
    return roots;
  }
  if constexpr (std::is_floating_point_v<Number>) {
    detail::bernstein_search_unrolled<kMostDegree>(p, low, high, roots);
  } else {
    detail::bernstein_search(p, p.degree, low, high, roots);
  }
  return roots;
}

}  // namespace lamina::poly
