#include "number/rational.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/contract.hpp"

namespace lamina::number {
namespace {

constexpr int kLargestExponent = 10'000;
constexpr unsigned kMostDecimals = 30;

Integer power_of_ten(unsigned exponent) { return pow(Integer(10), exponent); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Reads one number from left to right.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Rational fraction() {
    const bool negative = sign();
    Rational value = decimal();
    if (accept('/')) {
      const Rational divisor = decimal();
      if (divisor.is_zero()) {
        fail("its denominator is zero");
      }
      value /= divisor;
    }
    if (at_ < text_.size()) {
      fail("write an integer, a decimal such as 0.25 or 2.5e-1, or a fraction such as 1/4");
    }
    return negative ? Rational(-value) : value;
  }

 private:
  bool accept(char c) {
    const bool there = at_ < text_.size() && text_[at_] == c;
    at_ += there ? 1 : 0;
    return there;
  }

  // Whether there is a minus sign.
  bool sign() {
    const bool negative = accept('-');
    if (!negative) {
      accept('+');
    }
    return negative;
  }

  std::string_view digits() {
    const std::size_t first = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) {
      ++at_;
    }
    return text_.substr(first, at_ - first);
  }

  Rational decimal() {
    const std::string_view whole = digits();
    const std::string_view decimals = accept('.') ? digits() : std::string_view{};
    if (whole.empty() && decimals.empty()) {
      fail("write an integer, a decimal such as 0.25 or 2.5e-1, or a fraction such as 1/4");
    }
    std::string mantissa = fmt::format("{}{}", whole, decimals);
    // A leading zero would mean octal to GMP.
    mantissa.erase(0, std::min(mantissa.find_first_not_of('0'), mantissa.size() - 1));
    const Rational value{Integer(mantissa)};
    const int shift = exponent();
    return value * power(shift) / power_of_ten(static_cast<unsigned>(decimals.size()));
  }

  int exponent() {
    if (!accept('e') && !accept('E')) {
      return 0;
    }
    const bool negative = sign();
    std::string_view magnitude = digits();
    if (magnitude.empty()) {
      fail("its exponent has no digits");
    }
    magnitude.remove_prefix(std::min(magnitude.find_first_not_of('0'), magnitude.size()));
    int value = 0;
    for (const char c : magnitude) {
      value = 10 * value + (c - '0');
      if (value > kLargestExponent) {
        fail(fmt::format("its exponent exceeds {} in magnitude", kLargestExponent));
      }
    }
    return negative ? -value : value;
  }

  static Rational power(int exponent) {
    const Rational magnitude = power_of_ten(static_cast<unsigned>(std::abs(exponent)));
    return exponent < 0 ? Rational(1 / magnitude) : magnitude;
  }

  [[noreturn]] void fail(std::string_view reason) const {
    constexpr std::size_t kShown = 40;
    const bool cut = text_.size() > kShown;
    throw base::InputError(fmt::format("`{}{}` is not a number that can be read: {}",
                                       text_.substr(0, kShown), cut ? "..." : "", reason));
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

// The least k with value * 10^k an integer, or kMostDecimals + 1 if there is none so small.
unsigned decimals_needed(const Integer& denominator) {
  Integer rest = denominator;
  unsigned twos = 0;
  unsigned fives = 0;
  for (; rest % 2 == 0 && twos <= kMostDecimals; rest /= 2) {
    ++twos;
  }
  for (; rest % 5 == 0 && fives <= kMostDecimals; rest /= 5) {
    ++fives;
  }
  return rest == 1 ? std::max(twos, fives) : kMostDecimals + 1;
}

// value * 2^exponent where the exponent is positive, else the value.
Integer times_power_of_two(const Integer& value, std::int64_t exponent) {
  return exponent > 0 ? Integer(value << exponent) : value;
}

}  // namespace

Rational parse_rational(std::string_view text) { return Reader(text).fraction(); }

std::string to_text(const Rational& value) {
  const unsigned decimals = decimals_needed(denominator(value));
  if (decimals == 0 || decimals > kMostDecimals) {
    return value.str();
  }
  std::string digits = Integer(numerator(Rational(abs(value) * power_of_ten(decimals)))).str();
  if (digits.size() <= decimals) {
    digits.insert(0, decimals + 1 - digits.size(), '0');
  }
  digits.insert(digits.size() - decimals, 1, '.');
  return (value.sign() < 0 ? "-" : "") + digits;
}

namespace {

// The nearest value of a hardware type, ties to even, subnormal numbers and overflow included.
template <typename Float>
Float nearest(const Rational& value) {
  using Limits = std::numeric_limits<Float>;
  if (value.is_zero()) {
    return 0;
  }
  const Integer dividend = abs(numerator(value));
  const Integer divisor = denominator(value);
  // 2^log <= |value| < 2^(log + 1)
  auto log = static_cast<std::int64_t>(msb(dividend)) - static_cast<std::int64_t>(msb(divisor));
  if (times_power_of_two(dividend, -log) < times_power_of_two(divisor, log)) {
    --log;
  }
  const auto sign = static_cast<Float>(value.sign());
  if (log >= Limits::max_exponent) {
    return sign * Limits::infinity();
  }
  // The last place of the result: that of a full significand, or of the subnormal numbers.
  const auto last_place =
      static_cast<int>(std::max<std::int64_t>(log + 1, Limits::min_exponent) - Limits::digits);
  const Integer unit = times_power_of_two(divisor, last_place);
  Integer significand;
  Integer remainder;
  divide_qr(times_power_of_two(dividend, -last_place), unit, significand, remainder);
  const int half = Integer(2 * remainder).compare(unit);
  if (half > 0 || (half == 0 && bit_test(significand, 0))) {
    ++significand;
  }
  return sign * std::ldexp(significand.convert_to<Float>(), last_place);
}

}  // namespace

float nearest_float(const Rational& value) { return nearest<float>(value); }

double nearest_double(const Rational& value) { return nearest<double>(value); }

long double nearest_long_double(const Rational& value) { return nearest<long double>(value); }

}  // namespace lamina::number
