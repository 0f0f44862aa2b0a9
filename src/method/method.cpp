#include "method/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/contract.hpp"
#include "base/text.hpp"

namespace lamina::method {

Method roth() { return {.name = "roth", .surface = Surface::FirstOfGroup}; }

Method wyvill_sharp() {
  return {.name = "wyvill-sharp",
          .grouping = Grouping::Single,
          .status = Status::Geometric,
          .sense = Sense::Normal};
}

Method epsilon(const number::Rational& epsilon, bool relative) {
  return {
      .name = fmt::format("epsilon:{}{}", number::to_text(epsilon), relative ? ":relative" : ""),
      .grouping = Grouping::WithinEpsilon,
      .epsilon = epsilon,
      .relative_epsilon = relative};
}

Method regularized() { return {.name = "regularized"}; }

Method wyvill_trotman() {
  return {.name = "wyvill-trotman",
          .grouping = Grouping::Single,
          .status = Status::Carried,
          .check = Check::Validity,
          .sense = Sense::Normal,
          .look_ahead = LookAhead::Literal,
          .secondary = Secondary::Inherit};
}

std::vector<MethodHelp> method_help() {
  return {
      {"roth", "equal t at once, the surface is the first (Roth 1982)"},
      {"wyvill-sharp", "one at a time, others by inside test (Wyvill and Sharp 1988)"},
      {"epsilon:E", "within the length E at once (Amanatides and Mitchell 1990)"},
      {"epsilon:E:relative", "the same, within E times |t|"},
      {"regularized", "equal t at once, only volumes count (Tilove 1980)"},
      {"wyvill-trotman", "one at a time, state carried and checked (Wyvill and Trotman 1990)"},
      {"wyvill-trotman:parity", "the same, entering and leaving from root parity"},
      {"wyvill-trotman:no-look-ahead", "the same, without their section 3.6"},
      {"wyvill-trotman:look-ahead-all", "the same, their 3.6 for all later surfaces"},
      {"wyvill-trotman:look-ahead-class", "the same, their 3.6 for what coincides exactly"},
      {"wyvill-trotman:reference:D", "the same, started a length D before a leaf (section 3.7)"},
      {"wyvill-trotman:secondary:S", "spawned rays' states: inherit, parity, hybrid, cluster"},
      {"wyvill-trotman:keeps-hit-leaf", "the same, 3.4's hit leaf not set back for reflection"},
  };
}

namespace {

constexpr std::array<std::pair<std::string_view, Secondary>, 4> kSecondaries{
    {{"inherit", Secondary::Inherit},
     {"parity", Secondary::Parity},
     {"hybrid", Secondary::Hybrid},
     {"cluster", Secondary::Cluster}}};

}  // namespace

Method parse_method(std::string_view text) {
  const std::vector<std::string> parts = base::split(text, ':');
  const auto fail = [&text](std::string_view why) {
    std::string message = fmt::format("method '{}': {}; methods are:", text, why);
    for (const MethodHelp& help : method_help()) {
      message += fmt::format("\n  {:<29} {}", help.spelling, help.meaning);
    }
    throw base::InputError(message);
  };

  if (parts[0] == "epsilon") {
    if (parts.size() < 2 || parts.size() > 3 || (parts.size() == 3 && parts[2] != "relative")) {
      fail("state the tolerance, as in epsilon:1e-6 or epsilon:1e-9:relative");
    }
    const number::Rational value = number::parse_rational(parts[1]);
    const bool relative = parts.size() == 3;
    if (value.sign() < 0 || (relative && value >= 1)) {
      fail(relative ? "a relative tolerance is at least 0 and below 1"
                    : "the tolerance is negative");
    }
    Method result = epsilon(value, relative);
    result.name = std::string(text);  // 1e-6 stays 1e-6
    return result;
  }
  Method result;
  if (parts[0] == "roth") {
    result = roth();
  } else if (parts[0] == "wyvill-sharp") {
    result = wyvill_sharp();
  } else if (parts[0] == "regularized") {
    result = regularized();
  } else if (parts[0] == "wyvill-trotman") {
    result = wyvill_trotman();
  } else {
    fail("unknown");
  }
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::string& part = parts[i];
    if (result.check != Check::Validity) {
      fail(fmt::format("unknown variant '{}'", part));
    } else if (part == "parity") {
      result.sense = Sense::Parity;
    } else if (part == "no-look-ahead") {
      result.look_ahead = LookAhead::None;
    } else if (part == "look-ahead-all") {
      result.look_ahead = LookAhead::All;
    } else if (part == "look-ahead-class") {
      result.look_ahead = LookAhead::Class;
    } else if (part == "keeps-hit-leaf") {
      result.keeps_hit_leaf = true;
    } else if (part == "reference") {
      result.reference = ++i < parts.size() ? number::parse_rational(parts[i]) : 0;
      if (result.reference.sign() <= 0) {
        fail("state the reference point's distance, as in wyvill-trotman:reference:1e6");
      }
    } else if (part == "secondary") {
      const std::string_view source = ++i < parts.size() ? parts[i] : std::string_view();
      const auto found =
          std::find_if(kSecondaries.begin(), kSecondaries.end(),
                       [source](const auto& known) { return known.first == source; });
      if (found == kSecondaries.end()) {
        fail("state where the states come from, as in wyvill-trotman:secondary:cluster");
      }
      result.secondary = found->second;
    } else {
      fail(fmt::format("unknown variant '{}'", part));
    }
  }
  result.name = std::string(text);
  return result;
}

}  // namespace lamina::method
