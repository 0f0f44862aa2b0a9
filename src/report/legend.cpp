#include "report/legend.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/page.hpp"

namespace lamina::report {
namespace {

constexpr std::size_t kPathWidth = 44;
constexpr std::size_t kMediumWidth = 16;

}  // namespace

Legend::Legend(const scene::Scene& scene, std::vector<csg::LeafIndex> shown)
    : scene_(scene), shown_(std::move(shown)) {
  std::sort(shown_.begin(), shown_.end());
  shown_.erase(std::unique(shown_.begin(), shown_.end()), shown_.end());
}

bool Legend::shows(csg::LeafIndex leaf) const {
  return std::binary_search(shown_.begin(), shown_.end(), leaf);
}

std::string Legend::name(csg::LeafIndex leaf) const {
  if (!shows(leaf)) {
    return fmt::format("#{} ({})", leaf, shortened(scene_.leaves[leaf].path, kPathWidth));
  }
  if (!has_letters()) {
    return fmt::format("#{}", leaf);
  }
  const auto place = std::lower_bound(shown_.begin(), shown_.end(), leaf) - shown_.begin();
  return std::string(1, static_cast<char>('A' + place));
}

std::string Legend::text() const {
  Columns columns;
  for (const csg::LeafIndex index : shown_) {
    const scene::Leaf& leaf = scene_.leaves[index];
    std::string sharing;
    for (const csg::LeafIndex other : scene_.leaves_of_carrier[leaf.carrier]) {
      if (other < index && shows(other)) {
        const bool same_side = scene_.leaves[other].side == leaf.side;
        sharing = fmt::format("same carrier as {}{}", name(other), same_side ? "" : ", other side");
        break;
      }
    }
    columns.add({name(index), fmt::format("leaf {}", index), shortened(leaf.path, kPathWidth),
                 medium_name(scene_, leaf.medium), sharing});
  }
  return columns.text(2);
}

std::string medium_name(const scene::Scene& scene, csg::Medium medium) {
  if (medium == csg::kEmpty) {
    return "empty";
  }
  std::string name = scene.materials[medium].name;
  std::erase(name, ' ');  // colours are named `[0, 0, 1, 1]`
  return shortened(name, kMediumWidth);
}

}  // namespace lamina::report
