#include "trace/spawn.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <utility>

#include "base/contract.hpp"
#include "base/text.hpp"

namespace lamina::trace {

std::vector<SpawnHelp> spawn_help() {
  return {
      {"none", "at the rounded hit point"},
      {"offset:E", "the length E farther along the ray (W&T 2)"},
      {"normal-offset:E", "the length E along the normal, to the side the ray goes to"},
      {"offset:E:relative", "E times the largest coordinate; so with normal-offset"},
      {"ulp-offset:N", "N units in the last place along the normal (Ray Tracing Gems 6: 256)"},
      {"error-bound", "a bound of the point's error along the normal, the next float (pbrt 6.8)"},
      {"leaf-state",
       "at the hit point; the hit leaf's contradicting events are rejected (W&T 3.5)"},
      {"divide-out", "at the hit point; the surface's root s = 0 is divided out"},
  };
}

SpawnPolicy parse_spawn(std::string_view text) {
  const std::vector<std::string> parts = base::split(text, ':');
  const auto fail = [&text](std::string_view why) {
    std::string message = fmt::format("spawn policy '{}': {}; policies are:", text, why);
    for (const SpawnHelp& help : spawn_help()) {
      message += fmt::format("\n  {:<18} {}", help.spelling, help.meaning);
    }
    throw base::InputError(message);
  };

  SpawnPolicy policy;
  policy.name = std::string(text);
  using Kind = SpawnPolicy::Kind;
  constexpr std::array kPlain{
      std::pair{"none", Kind::None}, std::pair{"error-bound", Kind::ErrorBound},
      std::pair{"leaf-state", Kind::LeafState}, std::pair{"divide-out", Kind::DivideOut}};
  for (const auto& [name, kind] : kPlain) {
    if (text == name) {
      policy.kind = kind;
      return policy;
    }
  }
  if (parts[0] == "offset" || parts[0] == "normal-offset") {
    policy.kind = parts[0] == "offset" ? Kind::Offset : Kind::NormalOffset;
    policy.relative_epsilon = parts.size() == 3 && parts[2] == "relative";
    if (parts.size() != (policy.relative_epsilon ? 3u : 2u)) {
      fail("state the length, as in offset:1e-6 or offset:1e-6:relative");
    }
    policy.epsilon = number::parse_rational(parts[1]);
    if (policy.epsilon.sign() < 0) {
      fail("the length is negative");
    }
    return policy;
  }
  if (parts[0] != "ulp-offset" || parts.size() > 2) {
    fail("unknown");
  }
  policy.kind = Kind::UlpOffset;
  if (parts.size() == 2) {
    const char* end = parts[1].data() + parts[1].size();
    const auto [stop, error] = std::from_chars(parts[1].data(), end, policy.ulps);
    constexpr int kMost = 1 << 20;
    if (error != std::errc() || stop != end || policy.ulps < 1 || policy.ulps > kMost) {
      fail("the number of units is a whole number from 1 to 2^20");
    }
  }
  return policy;
}

std::vector<SpawnPolicy> parse_spawns(std::string_view text) {
  std::vector<SpawnPolicy> policies;
  for (const std::string& name : base::split(text, ',')) {
    policies.push_back(parse_spawn(name));
  }
  return policies;
}

}  // namespace lamina::trace
