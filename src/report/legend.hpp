// The leaves that an explanation speaks of, by letters.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace lamina::report {

/// Names a scene's leaves in a text about one ray.
class Legend {
 public:
  /// More leaves than this go by their numbers.
  static constexpr std::size_t kLetters = 26;

  /// `shown`: the leaves to speak of.
  Legend(const scene::Scene& scene, std::vector<csg::LeafIndex> shown);

  [[nodiscard]] const std::vector<csg::LeafIndex>& leaves() const { return shown_; }
  [[nodiscard]] bool shows(csg::LeafIndex leaf) const;
  [[nodiscard]] bool has_letters() const { return shown_.size() <= kLetters; }
  /// `B`, or `#12` where there are too many leaves; with its path where it is not shown.
  [[nodiscard]] std::string name(csg::LeafIndex leaf) const;

  /// A row for each leaf: name, index, path, material, and what it shares its carrier with.
  [[nodiscard]] std::string text() const;

 private:
  const scene::Scene& scene_;
  std::vector<csg::LeafIndex> shown_;  // ascending
};

/// `empty`, or the material's name, shortened.
std::string medium_name(const scene::Scene& scene, csg::Medium medium);

}  // namespace lamina::report
