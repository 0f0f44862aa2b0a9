// What Wyvill and Trotman 1990 say of their figures with spawned rays: every ray of the ray trees
// of a coarse picture against the truth.
#include <catch2/catch.hpp>
#include <string>

#include "census/artifact_map.hpp"
#include "trace/number_choice.hpp"
#include "trace/render.hpp"

namespace lamina {
namespace {

using census::Fault;

constexpr trace::ImageSize kSize{24, 18};
constexpr int kDepth = 4;

struct Picture {
  trace::Image image{kSize};
  census::FaultCounts faults;
  std::uint64_t wrong_pixels = 0;

  [[nodiscard]] std::uint64_t operator[](Fault fault) const {
    std::uint64_t sum = 0;
    for (const auto& kind : faults.with) {
      sum += kind[static_cast<std::size_t>(fault)];
    }
    return sum;
  }
  [[nodiscard]] std::uint64_t primary(Fault fault) const {
    return faults.with[0][static_cast<std::size_t>(fault)];
  }
  [[nodiscard]] std::uint64_t rays() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : faults.rays) {
      sum += count;
    }
    return sum;
  }
};

Picture picture_of(const std::string& figure, const std::string& method,
                   const std::string& spawn = "none", int threads = 0) {
  const scene::Scene scene =
      scene::read_scene(std::string(LAMINA_SOURCE_DIR) + "/data/scenes/" + figure + ".csg");
  Picture made;
  std::vector<census::FaultCounts> faults(kSize.width * kSize.height);
  trace::each_pixel(
      kSize, threads,
      [&]() -> trace::PixelWork {
        const auto finder = std::make_shared<census::FaultFinder>(scene);
        const auto whitted = std::make_shared<trace::Whitted>(
            scene, trace::make_ray_path<double>(scene, {}),
            trace::RenderOptions{method::parse_method(method), trace::parse_spawn(spawn), kDepth},
            finder.get());
        return [&, finder, whitted](int x, int y) {
          made.image.set(x, y, whitted->color(trace::pixel_ray(*scene.camera, kSize, x, y)));
          faults[y * kSize.width + x] = finder->counts();
        };
      },
      [](std::uint64_t, std::uint64_t) { return true; });
  for (const census::FaultCounts& pixel : faults) {
    made.faults.add(pixel);
    made.wrong_pixels += pixel.first ? 1 : 0;
  }
  return made;
}

TEST_CASE("Figures 8 and 16: carried states make no mistake outside, inside and through glass") {
  for (const char* figure : {"figure08_outside", "figure08_inside", "figure16"}) {
    INFO(figure);
    const Picture carried = picture_of(figure, "wyvill-trotman");
    CHECK(carried.rays() > 2 * kSize.width * kSize.height);
    CHECK(carried.wrong_pixels == 0);
    // "The ray appears to intersect the surface again": each ray for itself does.
    CHECK(picture_of(figure, "regularized")[Fault::SelfIntersection] > 0);
    CHECK(picture_of(figure, "regularized", "error-bound").wrong_pixels == 0);
    CHECK(picture_of(figure, "regularized", "leaf-state").wrong_pixels == 0);
  }
}

// "We look ahead at the next intersection": less is wrong with it than without, and nothing where
// what coincides is known.
TEST_CASE("Figure 13: coincident transparent layers are right where their class is seen whole") {
  for (const char* figure : {"figure13_2", "figure13_3", "figure13_4", "figure13_5"}) {
    INFO(figure);
    const Picture none = picture_of(figure, "wyvill-trotman:no-look-ahead");
    const Picture literal = picture_of(figure, "wyvill-trotman");
    CHECK(literal.wrong_pixels > 0);
    CHECK(literal.wrong_pixels <= none.wrong_pixels);
    CHECK(picture_of(figure, "wyvill-trotman:look-ahead-class:secondary:cluster").wrong_pixels ==
          0);
  }
}

TEST_CASE("Figure 14: the surface's shadow on itself is gone with carried states") {
  for (const char* solid : {"box", "sphere", "cylinder", "cone", "torus"}) {
    INFO(solid);
    const std::string figure = std::string("figure14_") + solid;
    CHECK(picture_of(figure, "roth")[Fault::SelfIntersection] > 0);
    const Picture right = picture_of(figure, "wyvill-trotman");
    CHECK(right[Fault::SelfIntersection] == 0);
    CHECK(right[Fault::MissedHit] == 0);
    CHECK(right[Fault::GhostHit] == 0);
  }
}

// "The object is invisible from the inside", but "it is visible in the reflective backplane".
TEST_CASE("Figure 15: the backplane reflects the lamina, which the exact answer has not") {
  const Picture lamina = picture_of("figure15", "wyvill-trotman");
  CHECK(lamina.primary(Fault::GhostHit) > 0);
  const auto reflected = 1 + static_cast<std::size_t>(trace::Branch::Reflection);
  CHECK(lamina.faults.with[reflected][static_cast<std::size_t>(Fault::GhostHit)] > 0);
  CHECK(lamina[Fault::MissedHit] == 0);
  CHECK(picture_of("figure15", "regularized", "error-bound").wrong_pixels == 0);
}

TEST_CASE("Figures 10: carried states make no mistake in layers that touch") {
  for (const char* figure : {"figure10_add", "figure10_difference"}) {
    INFO(figure);
    const Picture carried = picture_of(figure, "wyvill-trotman");
    CHECK(carried[Fault::SelfIntersection] == 0);
    CHECK(carried.primary(Fault::MissedHit) == 0);
  }
}

TEST_CASE("A picture and its faults do not depend on threads") {
  const Picture one = picture_of("figure08_outside", "regularized", "none", 1);
  const Picture three = picture_of("figure08_outside", "regularized", "none", 3);
  CHECK(one.image == three.image);
  CHECK(one.faults.with == three.faults.with);
  CHECK(one.wrong_pixels > 0);
}

}  // namespace
}  // namespace lamina
