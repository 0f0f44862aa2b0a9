#include "trace/spawn.hpp"

#include <gtest/gtest.h>

#include "base/contract.hpp"

namespace lamina::trace {
namespace {

using number::Rational;

TEST(SpawnTest, ReadsEveryPolicy) {
  EXPECT_EQ(parse_spawn("none").kind, SpawnPolicy::Kind::None);
  const SpawnPolicy offset = parse_spawn("offset:1e-6");
  EXPECT_EQ(offset.kind, SpawnPolicy::Kind::Offset);
  EXPECT_EQ(offset.epsilon, Rational(1, 1000000));
  EXPECT_FALSE(offset.relative_epsilon);
  EXPECT_EQ(offset.name, "offset:1e-6");
  const SpawnPolicy normal = parse_spawn("normal-offset:1/8:relative");
  EXPECT_EQ(normal.kind, SpawnPolicy::Kind::NormalOffset);
  EXPECT_EQ(normal.epsilon, Rational(1, 8));
  EXPECT_TRUE(normal.relative_epsilon);
  EXPECT_EQ(parse_spawn("ulp-offset").ulps, 256);
  EXPECT_EQ(parse_spawn("ulp-offset:7").ulps, 7);
  EXPECT_EQ(parse_spawn("error-bound").kind, SpawnPolicy::Kind::ErrorBound);
  EXPECT_EQ(parse_spawn("leaf-state").kind, SpawnPolicy::Kind::LeafState);
  EXPECT_EQ(parse_spawn("divide-out").kind, SpawnPolicy::Kind::DivideOut);
  const auto several = parse_spawns("none,ulp-offset:8");
  ASSERT_EQ(several.size(), 2U);
  EXPECT_EQ(several[1].ulps, 8);
}

TEST(SpawnTest, RefusesWhatItDoesNotKnowAndListsWhatItDoes) {
  for (const char* text :
       {"", "offset", "offset:-1", "offset:1:absolute", "normal-offset", "ulp-offset:0",
        "ulp-offset:x", "ulp-offset:1:2", "none:1", "error-bound:2", "teleport"}) {
    try {
      parse_spawn(text);
      FAIL() << text;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("ulp-offset:N"), std::string::npos) << text;
    }
  }
}

}  // namespace
}  // namespace lamina::trace
