#include "surface/contour_curve.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace lamina::surface {
namespace {

using geometry::ContourPiece;
using number::Integer;
using number::Rational;

// A polynomial in u whose coefficients are polynomials in v.
using InU = std::vector<std::vector<Integer>>;

InU multiply(const InU& a, const InU& b) {
  InU product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      surface::add(product[i + j], surface::multiply(a[i], b[j]));
    }
  }
  return product;
}

void add(InU& a, const InU& b, int factor) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) {
    surface::add(a[i], b[i], Integer(factor));
  }
}

// By the first row; at most three rows.
InU determinant(const std::vector<std::vector<InU>>& m) {
  if (m.size() == 1) {
    return m[0][0];
  }
  InU sum;
  for (std::size_t column = 0; column < m.size(); ++column) {
    std::vector<std::vector<InU>> minor;
    for (std::size_t row = 1; row < m.size(); ++row) {
      minor.push_back(m[row]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(column));
    }
    add(sum, multiply(m[0][column], determinant(minor)), column % 2 == 0 ? 1 : -1);
  }
  return sum;
}

// A piece with its coefficients times a common denominator.
struct IntegerPiece {
  std::vector<Integer> u;  // as many as the degree asks for
  std::vector<Integer> v;
  Integer scale = 1;

  [[nodiscard]] std::size_t degree() const { return u.size() - 1; }
  [[nodiscard]] Integer bracket(std::size_t p, std::size_t q) const {
    return u[p] * v[q] - u[q] * v[p];
  }
  [[nodiscard]] bool is_straight() const {
    for (std::size_t p = 2; p <= degree(); ++p) {
      for (std::size_t q = 1; q < p; ++q) {
        if (!bracket(p, q).is_zero()) {
          return false;
        }
      }
    }
    return true;
  }
};

// A straight piece is given by its ends, however it goes from one to the other: its resultant would
// be a power of the line's equation.
IntegerPiece integral(const ContourPiece& piece) {
  IntegerPiece result;
  for (const auto* coefficients : {&piece.u, &piece.v}) {
    for (const Rational& c : *coefficients) {
      result.scale = lcm(result.scale, Integer(denominator(c)));
    }
  }
  for (std::size_t i = 0; i < piece.u.size(); ++i) {
    result.u.push_back(numerator(Rational(piece.u[i] * result.scale)));
    result.v.push_back(numerator(Rational(piece.v[i] * result.scale)));
  }
  while (result.u.back().is_zero() && result.v.back().is_zero()) {
    result.u.pop_back();
    result.v.pop_back();
  }
  if (result.is_straight()) {
    for (std::vector<Integer>* c : {&result.u, &result.v}) {
      *c = {c->front(), std::accumulate(std::next(c->begin()), c->end(), Integer(0))};
    }
  }
  return result;
}

InU resultant(const IntegerPiece& piece) {
  const std::size_t n = piece.degree();
  // [p, q] = u_p v_q - u_q v_p, where the coefficients of s^0 are u_0 - u and v_0 - v.
  const auto bracket = [&piece](std::size_t p, std::size_t q) -> InU {
    const Integer constant = piece.bracket(p, q);
    return q > 0 ? InU{{constant}}
                 : InU{{constant, -piece.u[p] * piece.scale}, {piece.v[p] * piece.scale}};
  };
  std::vector<std::vector<InU>> bezout(n, std::vector<InU>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k <= std::min(i, n - 1 - j); ++k) {
        const std::size_t p = j + k + 1;
        const std::size_t q = i - k;
        if (p != q) {
          add(bezout[i][j], p > q ? bracket(p, q) : bracket(q, p), p > q ? 1 : -1);
        }
      }
    }
  }
  return determinant(bezout);
}

bool is_zero(const InU& f) {
  return std::all_of(f.begin(), f.end(), [](const std::vector<Integer>& c) {
    return std::all_of(c.begin(), c.end(), [](const Integer& x) { return x.is_zero(); });
  });
}

// With coprime coefficients; `power` is that of u whose powers g has.
ContourCurve normalised(const InU& g, int power, int degree) {
  ContourCurve curve{degree, {}};
  Integer common = 0;
  for (int i = 0; i < static_cast<int>(g.size()); ++i) {
    for (int j = 0; j < static_cast<int>(g[i].size()); ++j) {
      if (!g[i][j].is_zero()) {
        common = gcd(common, g[i][j]);
        curve.terms.push_back({{i, j, degree - power * i - j}, g[i][j]});
      }
    }
  }
  common *= curve.terms.front().coefficient.sign();
  for (ContourCurve::Term& term : curve.terms) {
    term.coefficient /= common;
  }
  return curve;
}

}  // namespace

PlaneRayOver<Rational> plane_ray(const SweptSurface& surface, const geometry::ExactRay& local) {
  const auto& [o, d] = local;
  return plane_ray<Rational>(surface, {{{o.x, d.x}, {o.y, d.y}, {o.z, d.z}, {Rational(1)}}});
}

ContourCurve curve_of(Sweep sweep, const ContourPiece& piece) {
  const IntegerPiece reduced = integral(piece);
  const int degree = static_cast<int>(reduced.degree());
  const InU f = resultant(reduced);
  if (sweep != Sweep::Rotational) {
    return normalised(f, 1, degree);
  }
  // even(u^2) + u odd(u^2), times the same of -u.
  InU even;
  InU odd;
  for (std::size_t i = 0; i < f.size(); ++i) {
    (i % 2 == 0 ? even : odd).push_back(f[i]);
  }
  if (is_zero(odd)) {
    return normalised(even, 2, degree);
  }
  InU norm = multiply(even, even);
  add(norm, multiply({{}, {Integer(1)}}, multiply(odd, odd)), -1);
  return normalised(norm, 2, 2 * degree);
}

ContourCurve curve_on_axis(const ContourPiece& piece) {
  const IntegerPiece reduced = integral(piece);
  return normalised({resultant(reduced).front()}, 1, static_cast<int>(reduced.degree()));
}

}  // namespace lamina::surface
