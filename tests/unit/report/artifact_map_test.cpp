#include "report/artifact_map.hpp"

#include <gtest/gtest.h>

namespace lamina::report {
namespace {

using census::Fault;

TEST(ArtifactMapTest, CountsThePixelsThatAreDone) {
  ArtifactMap map({3, 2});
  map.set(0, 0, Fault::GhostHit);
  map.set(2, 1, Fault::GhostHit);
  map.set(1, 1, std::nullopt);
  const auto pixels = map.pixels();
  EXPECT_EQ(pixels[static_cast<std::size_t>(Fault::GhostHit)], 2U);
  EXPECT_EQ(pixels[census::kFaultCount], 1U);
  EXPECT_EQ(pixels[static_cast<std::size_t>(Fault::MissedHit)], 0U);
}

TEST(ArtifactMapTest, PaintsFaultsRightPixelsAndTheLegend) {
  constexpr trace::ImageSize kSize{120, 2};
  ArtifactMap map(kSize);
  map.set(0, 0, Fault::MissedHit);
  map.set(1, 0, std::nullopt);
  trace::Image picture(kSize);
  picture.set(1, 0, {1, 1, 1});
  const trace::Image painted = map.over(picture);
  trace::Image expected({1, 1});
  expected.set(0, 0, census::fault_texts()[0].color);
  EXPECT_EQ(painted.at(0, 0), expected.at(0, 0));
  const auto right = painted.at(1, 0);
  EXPECT_EQ(right[0], right[1]);
  EXPECT_GT(right[0], 0);
  EXPECT_EQ(painted.at(2, 0), (std::array<std::uint8_t, 3>{0, 0, 0}));
  // One square after the other, in the order of the faults.
  for (std::size_t fault = 0; fault < census::kFaultCount; ++fault) {
    expected.set(0, 0, census::fault_texts()[fault].color);
    EXPECT_EQ(painted.at(14 * static_cast<int>(fault) + 7, kSize.height + 7), expected.at(0, 0));
  }
}

TEST(ArtifactMapTest, TheTableHasARowForEachFault) {
  ArtifactMap map({2, 1});
  map.set(0, 0, Fault::SelfIntersection);
  census::FaultCounts counts;
  counts.rays = {1, 2, 0, 0};
  counts.unjudged = {0, 1, 0, 0};
  counts.with[1][static_cast<std::size_t>(Fault::SelfIntersection)] = 1;
  const Table table = fault_table(map, counts);
  ASSERT_EQ(table.rows.size(), census::kFaultCount);
  const auto& row = table.rows[static_cast<std::size_t>(Fault::SelfIntersection)];
  EXPECT_EQ(std::get<std::string>(row[0]), "self-intersection");
  EXPECT_EQ(std::get<Rate>(row[2]).count, 1U);
  EXPECT_EQ(std::get<Rate>(row[2]).n, 1U);
  EXPECT_EQ(std::get<Rate>(row[4]).count, 1U);
  EXPECT_EQ(std::get<Rate>(row[4]).n, 1U);
}

}  // namespace
}  // namespace lamina::report
