// Which step makes a method's answer wrong.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "census/verdict.hpp"
#include "trace/number_choice.hpp"

namespace lamina::census {

/// The first step, from the ideal scene to the answer in a number type, with which a method's
/// first visible interface is wrong. The steps before the last are taken in exact arithmetic.
enum class Cause : std::uint8_t {
  Model,           ///< on the ideal scene: what the method gets wrong without any rounding
  Representation,  ///< with the numbers of scene and ray rounded to the number type
  Construction,    ///< with the constants derived from them rounded, too: the inverse maps
  Computation,     ///< only in the number type's own arithmetic
};

inline constexpr std::size_t kCauseCount = 4;

struct CauseText {
  std::string_view name;        ///< as in CSV and JSON
  std::string_view heading;     ///< as in tables
  std::string_view definition;  ///< one sentence
};

const std::array<CauseText, kCauseCount>& cause_texts();

/// Finds causes on the rays of one scene. Work is done for wrong answers only: scenes as
/// number types hold them are made when first asked for. Not for two threads at once.
class Attribution {
 public:
  Attribution(const scene::Scene& scene, const Truth& truth,
              const std::vector<method::Method>& methods,
              const std::vector<trace::NumberChoice>& numbers);
  ~Attribution();
  Attribution(const Attribution&) = delete;
  Attribution& operator=(const Attribution&) = delete;

  /// Goes on to the ray that the truth has found.
  void find(const geometry::ExactRay& ray);

  /// Why the first visible interface of a method is wrong in a number type, by their indices.
  Cause cause(std::size_t method, std::size_t number);

  /// Of the interfaces that are not in `reported`, by the truth's classes, the number that the
  /// method misses on the ideal scene in exact arithmetic too.
  std::uint32_t missed_in_exact(std::size_t method, const std::vector<bool>& reported);

 private:
  struct Level;
  struct Levels;

  Level& ideal();
  bool wrong_on_ideal(std::size_t method);
  bool wrong(Level& level, std::size_t method, const trace::NumberChoice* number);
  Levels& levels_of(std::size_t number);

  const scene::Scene& scene_;
  const Truth& truth_;
  const std::vector<method::Method>& methods_;
  const std::vector<trace::NumberChoice>& numbers_;
  geometry::ExactRay ray_;
  std::uint64_t ray_number_ = 0;
  std::unique_ptr<Level> ideal_;
  std::vector<std::optional<bool>> wrong_on_ideal_;  // by method; the same for all number types
  std::vector<std::unique_ptr<Levels>> levels_;      // by number type
};

}  // namespace lamina::census
