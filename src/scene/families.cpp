#include "scene/families.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/contract.hpp"
#include "base/text.hpp"
#include "scene/ray_tree_families.hpp"
#include "scene/stress_families.hpp"
#include "scene/sweep_families.hpp"

namespace lamina::scene {
const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"coincident-faces", "", "two or three solids that share faces, under all operators",
       [](const Parameters&, auto seed, auto id) { return coincident_faces(seed, id); }},
      {"ghost-cylinders", "", "two cylinders whose tops lie in one plane (W&T Figure 4)",
       [](const Parameters&, auto seed, auto id) { return ghost_cylinders(seed, id); }},
      {"self-sum", ":SOLID:same|scaled",
       "a box, cylinder, cone, sphere or torus added to itself, or to its triple at scale 1/3",
       self_sum},
      {"self-difference", ":SOLID:same|scaled",
       "a box, cylinder, cone or sphere less itself, its equations times 1 or 3", self_difference},
      {"touching-stack", ":N", "N cubes, one on the other", touching_stack},
      {"thin-wall", "", "a sphere less one that touches it from inside (W&T Figure 9)", thin_wall},
      {"slab", ":G", "a slab of thickness G", slab},
      {"gap", ":G", "two slabs that are G apart", gap},
      {"four-cases", ":i|ii|iii|iv:G", "A - B with surfaces G apart (W&T Figure 12)", four_cases},
      {"far-origin", ":translated|scaled:K", "coincident-faces, moved by or times 10^K",
       far_origin},
      {"cleared-face", "", "a face that a slab on it and a ball in the slab are cleared from",
       cleared_face},
      {"glass-stack", ":K", "K transparent slabs whose tops lie in one plane", glass_stack},
      {"same-medium", ":left|right|flat:N", "N slabs of two materials, their tops in one plane",
       same_medium},
      {"single", ":SOLID:K", "a box, cylinder, cone, ball or ring, times 10^K", single},
      {"distant-ball", ":K", "a unit ball 10^K from the origin", distant_ball},
      {"bubble", ":plain|doubled", "a block less a ball, once or twice (W&T Figure 8)", bubble},
      {"well", ":plain|doubled", "a deep square well", well},
      {"cube-corner", ":plain|doubled", "three faces that meet in a corner", cube_corner},
      {"plates", ":N", "N plates of different glasses, one on the other", plates},
      {"onion", ":N", "N balls of different glasses around one centre", onion},
      {"unclosed", ":cylinder|cone|slab", "solids of half-spaces that are not closed", unclosed},
      {"round", ":ball|ring|cut-ring",
       "a unit sphere, a torus of radii 1 and 1/4, or half of it and a ball less it", round_solid},
      {"sweep-sum", ":SWEEP:same|mirrored|scaled",
       "a translational, conic or rotational sweep added to itself", sweep_sum},
      {"sweep-difference", ":SWEEP:same|mirrored|scaled", "such a sweep less itself",
       sweep_difference},
      {"sweep-halves", ":SWEEP", "such a sweep in two parts, divided by a plane", sweep_halves},
      {"jointed-glass", "", "a wine glass of 25 quadrics and a torus between slab planes",
       jointed_glass},
  };
  return all;
}

FamilyMember family_member(const std::string& family, std::uint64_t seed, std::uint64_t case_id) {
  std::vector<std::string> parts = base::split(family, ':');
  const std::string name = parts.front();
  parts.erase(parts.begin());
  for (const Family& known : families()) {
    const auto wanted = std::count(known.parameters.begin(), known.parameters.end(), ':');
    if (known.name == name && static_cast<std::size_t>(wanted) == parts.size()) {
      return known.member(parts, seed, case_id);
    }
  }
  std::string names;
  for (const Family& known : families()) {
    names += fmt::format("\n  {:<42} {}", known.name + known.parameters, known.about);
  }
  throw base::InputError(fmt::format("no family '{}'; there are:{}", family, names));
}

std::string family_spelling(const std::string& family, std::uint64_t seed, std::uint64_t case_id) {
  return fmt::format("family:{}:{}:{}", family, seed, case_id);
}

Scene open_scene(const std::string& spelling, const ReadOptions& options) {
  constexpr std::string_view kPrefix = "family:";
  if (!spelling.starts_with(kPrefix)) {
    return read_scene(spelling, options);
  }
  std::vector<std::string> parts =
      base::split(std::string_view(spelling).substr(kPrefix.size()), ':');
  std::array<std::uint64_t, 2> numbers{};  // the last two: seed and case
  bool good = parts.size() > numbers.size();
  for (std::size_t i = 0; good && i < numbers.size(); ++i) {
    const std::string& text = parts[parts.size() - numbers.size() + i];
    const auto result = std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
    good = result.ec == std::errc{} && result.ptr == text.data() + text.size();
  }
  if (!good) {
    throw base::InputError(
        fmt::format("scene '{}': a member of a family is family:FAMILY:SEED:CASE, as in "
                    "family:coincident-faces:1:49",
                    spelling));
  }
  parts.resize(parts.size() - numbers.size());
  try {
    const std::string family = fmt::format("{}", fmt::join(parts, ":"));
    return parse_scene(family_member(family, numbers[0], numbers[1]).text, spelling, options);
  } catch (const base::InputError& error) {
    throw base::InputError(fmt::format("scene '{}': {}", spelling, error.what()));
  }
}

}  // namespace lamina::scene
