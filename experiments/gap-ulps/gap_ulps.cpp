#include <fmt/format.h>

#include <cmath>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

// At the gap from outside, within 64 degrees of head-on.
Aim at_the_gap() {
  return {"at the gap",
          [](const scene::FamilyMember& member, const scene::Scene&, base::SeededStream& stream) {
            constexpr double kDistance = 10;
            const geometry::Vector3<double> target{stream.uniform(-1, 1), stream.uniform(-1, 1), 0};
            geometry::Vector3<double> towards = scene::random_direction(stream);
            towards.z = 0.5 + 0.5 * std::abs(towards.z);
            return scene::ray_from(member.place(target + kDistance * towards), member.place(target),
                                   scene::Held::Float);
          }};
}

std::vector<Series> series(const Settings& settings) {
  constexpr int kLeast = -2;
  constexpr int kMost = 20;
  constexpr int kStep = 2;
  constexpr int kUlp = -52;  // of numbers between 1 and 2 in double
  constexpr std::uint64_t kSeries = (kMost - kLeast) / kStep + 1;
  std::vector<Series> all;
  for (int k = kLeast; k <= kMost; k += kStep) {
    const number::Rational gap(number::Integer(1), number::Integer(1) << -(k + kUlp));
    all.push_back(family_series({fmt::format("2^{}", k)}, "gap:" + number::to_text(gap),
                                at_the_gap(), settings.rays / kSeries, settings));
  }
  return all;
}

}  // namespace

Experiment gap_ulps() {
  return {.name = "gap-ulps",
          .question = "Is what is seen of a gap of a few ulps what some scene nearby has?",
          .source = "Wyvill and Trotman 1990, sections 3.3 and 4, Figure 12",
          .labels = {{"gap", "gap", "Between two slabs, in units of 2^-52."}},
          .default_rays = 24'000,
          .default_methods =
              "roth,wyvill-sharp,epsilon:1e-12,regularized,wyvill-trotman,wyvill-trotman:parity",
          .default_numbers = "bin11,float,double,longdouble,bin113,bin237,exact",
          .series = series};
}

}  // namespace lamina::experiments
