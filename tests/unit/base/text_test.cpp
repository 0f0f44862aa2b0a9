#include "base/text.hpp"

#include <gtest/gtest.h>

namespace lamina::base {
namespace {

using Parts = std::vector<std::string>;

TEST(TextTest, SplitKeepsEmptyParts) {
  EXPECT_EQ(split("a:bc:d", ':'), (Parts{"a", "bc", "d"}));
  EXPECT_EQ(split(":a::", ':'), (Parts{"", "a", "", ""}));
  EXPECT_EQ(split("a,b", ':'), (Parts{"a,b"}));
  EXPECT_EQ(split("", ':'), (Parts{""}));
}

}  // namespace
}  // namespace lamina::base
