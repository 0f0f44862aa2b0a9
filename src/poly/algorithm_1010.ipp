#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "poly/algorithm_1010.hpp"
#include "poly/cubic.hpp"

namespace lamina::poly {
namespace detail {

// Divisions by zero give infinities or NaN here, and a trial with one of them fits worse than any.

// x^4 + a x^3 + b x^2 + c x + d.
template <RoundedNumber Number>
struct MonicQuartic {
  Number a;
  Number b;
  Number c;
  Number d;
};

// (x^2 + l1 x + l3)^2 + d2 (x + l2)^2: what the paper's L D L^T stands for.
template <RoundedNumber Number>
struct SquareSum {
  Number l1;
  Number l2;
  Number l3;
  Number d2;

  [[nodiscard]] MonicQuartic<Number> expanded() const {
    return {2 * l1, d2 + l1 * l1 + 2 * l3, 2 * (d2 * l2 + l1 * l3), d2 * l2 * l2 + l3 * l3};
  }
};

// x^2 + alpha x + beta.
template <RoundedNumber Number>
struct Factor {
  Number alpha;
  Number beta;

  bool operator==(const Factor&) const = default;
};

template <RoundedNumber Number>
struct FactorPair {
  Factor<Number> first;
  Factor<Number> second;

  [[nodiscard]] MonicQuartic<Number> expanded() const {
    return {first.alpha + second.alpha, first.beta + first.alpha * second.alpha + second.beta,
            first.beta * second.alpha + first.alpha * second.beta, first.beta * second.beta};
  }
};

// What the errors of the coefficients are measured by: their magnitudes, raised to Newton's polygon
// (to within a power of two). A coefficient below that is small by cancellation, and its relative
// error, which the paper takes, would outweigh those that matter.
template <RoundedNumber Number>
MonicQuartic<Number> coefficient_sizes(const MonicQuartic<Number>& quartic) {
  using std::abs;
  const std::array<Number, 5> magnitudes{Number(1), abs(quartic.a), abs(quartic.b), abs(quartic.c),
                                         abs(quartic.d)};
  std::array<Number, 5> sizes = magnitudes;
  for (int i = 1; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      for (int k = i + 1; k < 5; ++k) {
        if (magnitudes[j] != 0 && magnitudes[k] != 0) {
          const std::int64_t exponent =
              ((k - i) * exponent_of(magnitudes[j]) + (i - j) * exponent_of(magnitudes[k])) /
              (k - j);
          sizes[i] = std::max(sizes[i], times_power_of_two(Number(1), exponent));
        }
      }
    }
  }
  return {sizes[1], sizes[2], sizes[3], sizes[4]};
}

// The quartic to be factored. A size is zero where all that a factorisation needs there is zero.
template <RoundedNumber Number>
struct Target : MonicQuartic<Number> {
  MonicQuartic<Number> sizes;

  // The sum of the errors of the trial's coefficients.
  [[nodiscard]] Number misfit(const MonicQuartic<Number>& trial) const {
    using std::abs;
    const auto error = [](const Number& x, const Number& wanted, const Number& size) {
      return size == 0 ? Number(abs(x)) : Number(abs(Number(x - wanted)) / size);
    };
    return error(trial.a, this->a, sizes.a) + error(trial.b, this->b, sizes.b) +
           error(trial.c, this->c, sizes.c) + error(trial.d, this->d, sizes.d);
  }
};

// The root of largest magnitude of phi^3 + g phi + h, the resolvent of the quartic. It is the same
// for x + shift; there g and h lose least if the shift makes b zero, or else a.
template <RoundedNumber Number>
Number dominant_phi(const MonicQuartic<Number>& quartic) {
  using std::sqrt;
  const auto& [a, b, c, d] = quartic;
  const Number radicand = 9 * a * a - 24 * b;
  Number shift = -a / 4;
  if (radicand > 0) {
    const Number root = sqrt(radicand);
    shift = -2 * b / (a < 0 ? Number(3 * a - root) : Number(3 * a + root));
  }
  const Number a_shifted = a + 4 * shift;
  const Number b_shifted = b + 3 * shift * (a + 2 * shift);
  const Number c_shifted = c + shift * (2 * b + shift * (3 * a + 4 * shift));
  const Number d_shifted = d + shift * (c + shift * (b + shift * (a + shift)));
  const Number ac = a_shifted * c_shifted;
  const Number b2 = b_shifted * b_shifted / 9;
  const Number g = ac - 4 * d_shifted - 3 * b2;
  const Number h = (8 * d_shifted + ac - 2 * b2) * b_shifted / 3 - c_shifted * c_shifted -
                   d_shifted * a_shifted * a_shifted;
  if (h == 0) {
    return g < 0 ? Number(sqrt(Number(-g))) : Number(0);
  }
  // The others have the opposite sign and sum up to it: it is the one that is alone.
  const std::array<Number, 4> resolvent{h, g, Number(0), Number(1)};
  const ScaledPolynomial<Number> scaled =
      safely_scaled(Polynomial<Number>(std::span<const Number>(resolvent)));
  return scaled.unscaled(outer_cubic_root(scaled.p));
}

// l1 and l3 follow from phi, d2 and l2 in three ways, of which the best is taken.
template <RoundedNumber Number>
SquareSum<Number> best_square_sum(const Target<Number>& target) {
  const MonicQuartic<Number>& quartic = target;
  const auto& [a, b, c, d] = quartic;
  const Number phi = dominant_phi(quartic);
  const Number l1 = a / 2;
  const Number l3 = b / 6 + phi / 2;
  const Number d2 = 2 * b / 3 - phi - l1 * l1;
  const Number twice_d2_l2 = c - a * l3;
  const Number d2_l2_l2 = d - l3 * l3;

  SquareSum<Number> best{l1, Number(0), l3, Number(0)};
  Number least = target.misfit(best.expanded());
  const auto consider = [&](const Number& l2_trial, const Number& d2_trial) {
    const SquareSum<Number> trial{l1, l2_trial, l3, d2_trial};
    const Number its_misfit = target.misfit(trial.expanded());
    if (its_misfit < least) {
      least = its_misfit;
      best = trial;
    }
  };
  const Number l2 = 2 * d2_l2_l2 / twice_d2_l2;
  consider(Number(twice_d2_l2 / (2 * d2)), d2);
  consider(l2, d2);
  consider(l2, Number(twice_d2_l2 / (2 * l2)));
  return best;
}

// Mends what lost digits: the smaller beta, by the product of both; the smaller alpha, by what the
// rest makes of a, b or c; and both betas, by c and d, for roots so far apart that neither beta
// has a correct digit. The last three are taken where they fit better.
template <RoundedNumber Number>
void mend(FactorPair<Number>& pair, const Target<Number>& target) {
  using std::abs;
  auto& [large, small] = pair;
  if (abs(large.beta) < abs(small.beta)) {
    std::swap(large, small);
  }
  if (large.beta != 0) {
    small.beta = target.d / large.beta;
  }
  if (abs(large.alpha) < abs(small.alpha)) {
    std::swap(large, small);
  }
  Number least = target.misfit(pair.expanded());
  const auto consider = [&](const FactorPair<Number>& trial) {
    const Number its_misfit = target.misfit(trial.expanded());
    if (its_misfit < least) {
      least = its_misfit;
      pair = trial;
    }
  };
  consider({large, {target.a - large.alpha, small.beta}});
  consider({large, {(target.b - large.beta - small.beta) / large.alpha, small.beta}});
  consider({large, {(target.c - large.alpha * small.beta) / large.beta, small.beta}});
  const Number beta = (target.c - small.alpha * large.beta) / large.alpha;
  consider({{large.alpha, target.d / beta}, {small.alpha, beta}});
}

// One of the factors after a step of Newton's method, `excess` being what their product exceeds
// the quartic by. The steps m1, m2 have m1 P2 + m2 P1 = -excess; modulo P1 that is two linear
// equations for m1, whose solution is written out so that what cancels is left out. Infinite or
// NaN where the factors have a common root.
template <RoundedNumber Number>
Factor<Number> stepped(const Factor<Number>& from, const Factor<Number>& other,
                       const MonicQuartic<Number>& excess) {
  const auto& [alpha, beta] = from;
  const Number alpha_gap = other.alpha - alpha;
  const Number beta_gap = other.beta - beta;
  const Number cross = alpha * other.beta - other.alpha * beta;
  const Number resultant = beta_gap * beta_gap - alpha_gap * cross;
  const Number alpha_step = (beta * beta_gap - alpha * cross) * excess.a + cross * excess.b -
                            beta_gap * excess.c + alpha_gap * excess.d;
  const Number beta_step = beta * (beta_gap * excess.b - alpha_gap * excess.c - cross * excess.a) -
                           (beta_gap - alpha * alpha_gap) * excess.d;
  return {alpha + alpha_step / resultant, beta + beta_step / resultant};
}

// Newton's method for the coefficients of the factors, while it lessens the misfit.
template <RoundedNumber Number>
void refine(FactorPair<Number>& pair, const Target<Number>& target) {
  MonicQuartic<Number> product = pair.expanded();
  Number least = target.misfit(product);
  for (int step = 0; step < kPolishSteps && least > 0; ++step) {
    const MonicQuartic<Number> excess{product.a - target.a, product.b - target.b,
                                      product.c - target.c, product.d - target.d};
    FactorPair<Number> next{stepped(pair.first, pair.second, excess),
                            stepped(pair.second, pair.first, excess)};
    mend(next, target);
    product = next.expanded();
    const Number its_misfit = target.misfit(product);
    if (!(its_misfit < least)) {
      return;
    }
    pair = next;
    least = its_misfit;
  }
}

// The quartic as (x^2 + l1 x + l3)^2 - (alpha x + beta)^2.
template <RoundedNumber Number>
FactorPair<Number> split(const SquareSum<Number>& sum, const Number& alpha, const Number& beta,
                         const Target<Number>& target) {
  FactorPair<Number> pair{{sum.l1 + alpha, sum.l3 + beta}, {sum.l1 - alpha, sum.l3 - beta}};
  mend(pair, target);
  return pair;
}

}  // namespace detail

template <RoundedNumber Number>
RealRoots<Number> algorithm_1010_roots(const Polynomial<Number>& p) {
  using std::sqrt;
  const ScaledPolynomial<Number> scaled = safely_scaled(p);
  const std::array<Number, kMostDegree + 1>& c = scaled.p.c;
  const detail::MonicQuartic<Number> quartic{c[3] / c[4], c[2] / c[4], c[1] / c[4], c[0] / c[4]};
  const detail::Target<Number> target{quartic, detail::coefficient_sizes(quartic)};
  const detail::SquareSum<Number> sum = detail::best_square_sum(target);

  // Where d2 > 0 the factors are complex, and have no real root: but for a shift, a quartic that
  // touches the axis is x^2 (x^2 + a x + b), with 2 b / 3 for phi and so -a^2 / 4 for d2.
  bool real = false;
  detail::FactorPair<Number> pair;
  Number least = target.misfit(sum.expanded());
  if (sum.d2 < 0) {
    const Number alpha = sqrt(Number(-sum.d2));
    pair = detail::split(sum, alpha, Number(alpha * sum.l2), target);
    least = target.misfit(pair.expanded());
    real = true;
  }
  // Where d2 is zero but for rounding, this fits better.
  const Number d3 = target.d - sum.l3 * sum.l3;
  if (d3 <= 0) {
    const auto same_alpha = detail::split(sum, Number(0), Number(sqrt(Number(-d3))), target);
    if (target.misfit(same_alpha.expanded()) <= least) {
      pair = same_alpha;
      real = true;
    }
  }
  RealRoots<Number> roots;
  if (!real) {
    return roots;
  }
  detail::refine(pair, target);
  if (pair.first == pair.second) {
    add_quadratic_roots(Number(1), pair.first.alpha, pair.first.beta,
                        [&](const Number& u, int multiplicity) {
                          roots.add(scaled.unscaled(u), multiplicity == 0 ? 2 : 2 * multiplicity);
                        });
    return roots;
  }
  const auto add = [&](const Number& u, int multiplicity) {
    roots.add(scaled.unscaled(u), multiplicity);
  };
  add_quadratic_roots(Number(1), pair.first.alpha, pair.first.beta, add);
  add_quadratic_roots(Number(1), pair.second.alpha, pair.second.beta, add);
  return roots;
}

}  // namespace lamina::poly
