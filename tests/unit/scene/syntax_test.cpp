#include "scene/syntax.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace lamina::scene {
namespace {

using support::error_of;
using support::fails_at;

Node parse(const std::string& text) { return parse_syntax(Source("scene", text)); }

Value value_of(const std::string& text) {
  return parse("cube(" + text + ");").children.at(0).arguments.at(0).value;
}

number::Rational number_of(const std::string& text) {
  return std::get<number::Rational>(value_of(text).content);
}

TEST(SyntaxTest, ReadsNodesArgumentsAndChildren) {
  const Node root = parse("difference() { cube([1, 2], center = true); sphere(); }\ncube(4);");
  ASSERT_EQ(root.children.size(), 2U);
  const Node& difference = root.children[0];
  EXPECT_EQ(difference.name, "difference");
  EXPECT_EQ(difference.offset, 0U);
  EXPECT_FALSE(difference.ended_by_semicolon);
  ASSERT_EQ(difference.children.size(), 2U);
  const Node& cube = difference.children[0];
  EXPECT_TRUE(cube.ended_by_semicolon);
  ASSERT_EQ(cube.arguments.size(), 2U);
  EXPECT_EQ(cube.arguments[0].name, "");
  EXPECT_EQ(std::get<Value::List>(cube.arguments[0].value.content).size(), 2U);
  EXPECT_EQ(cube.arguments[1].name, "center");
  EXPECT_TRUE(std::get<bool>(cube.arguments[1].value.content));
  EXPECT_TRUE(difference.children[1].arguments.empty());
  EXPECT_EQ(root.children[1].offset, 56U);
}

TEST(SyntaxTest, AChildNeedsNoBraces) {
  const Node root = parse("translate([1, 2, 3]) color(\"red\") cube(1);");
  EXPECT_EQ(root.children.at(0).children.at(0).children.at(0).name, "cube");
}

TEST(SyntaxTest, ReadsNumbersExactly) {
  EXPECT_EQ(number_of("0.1"), number::Rational(1) / 10);
  EXPECT_EQ(number_of("-1/3"), number::Rational(-1) / 3);
  EXPECT_EQ(number_of("+1.5 / 2"), number::Rational(3) / 4);
  EXPECT_EQ(number_of("-.5e1"), -5);
  EXPECT_EQ(number_of("5."), 5);
}

TEST(SyntaxTest, ReadsOtherValues) {
  EXPECT_FALSE(std::get<bool>(value_of("false").content));
  EXPECT_TRUE(value_of("undef").undefined());
  EXPECT_EQ(std::get<std::string>(value_of("\"a \\\"b\\\" \\\\ \xC3\xA4\"").content),
            "a \"b\" \\ \xC3\xA4");
  EXPECT_EQ(std::get<std::string>(value_of("\"\\t\\n\"").content), "\t\n");
  EXPECT_TRUE(std::get<Value::List>(value_of("[]").content).empty());
  const Value nested = value_of("[[1, 2,], [true, [3]], ]");
  const auto& rows = std::get<Value::List>(nested.content);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(std::get<Value::List>(rows[0].content).size(), 2U);
  EXPECT_EQ(rows[1].offset, 15U);
}

TEST(SyntaxTest, SkipsCommentsBlanksAndEmptyStatements) {
  const Node root = parse(
      "\xEF\xBB\xBF// first\r\n/* a * b / ** */ cube /* name */ ( /**/ 1 // one\n ) ; ;; "
      "group(){;} // end");
  ASSERT_EQ(root.children.size(), 2U);
  EXPECT_EQ(root.children[0].arguments.size(), 1U);
  EXPECT_TRUE(root.children[1].children.empty());
  EXPECT_TRUE(parse("").children.empty());
}

TEST(SyntaxTest, KeepsModifiers) {
  const Node root = parse("%cube(); # ! sphere(); *\n\tgroup() { %cube(); }");
  EXPECT_EQ(root.children.at(0).modifiers, "%");
  EXPECT_EQ(root.children.at(1).modifiers, "#!");
  EXPECT_EQ(root.children.at(2).modifiers, "*");
  EXPECT_EQ(root.children.at(2).children.at(0).modifiers, "%");
}

TEST(SyntaxTest, AnAssignmentIsAnArgumentOfItsBlock) {
  const Node root = parse("$fn = 50; group() { $fa = 3; sphere(); }");
  ASSERT_EQ(root.arguments.size(), 1U);
  EXPECT_EQ(root.arguments[0].name, "$fn");
  EXPECT_EQ(root.children.at(0).arguments.at(0).name, "$fa");
}

TEST(SyntaxErrorTest, PointsAtTheFault) {
  EXPECT_EQ(error_of("cube(1);\n\tcube(1;\n"),
            "scene:2:8: `,` or `)` is expected; `openscad -o model.csg model.scad` flattens "
            "programs\n\tcube(1;\n\t      ^");
}

TEST(SyntaxErrorTest, NamesWhatIsExpected) {
  EXPECT_TRUE(fails_at("cube", "1:5", "`(` is expected"));
  EXPECT_TRUE(fails_at("cube(1)", "1:8", "`cube` in line 1 is not complete"));
  EXPECT_TRUE(fails_at("cube(1) 2", "1:9", "`;`, a child or `{` is expected"));
  EXPECT_TRUE(fails_at("cube(,)", "1:6", "a value is expected"));
  EXPECT_TRUE(fails_at("cube(1,,2)", "1:8", "a value is expected"));
  EXPECT_TRUE(fails_at("cube(size=)", "1:11", "a value is expected"));
  EXPECT_TRUE(fails_at("cube([1 2])", "1:9", "`,` or `]` is expected"));
  EXPECT_TRUE(fails_at("cube([0:1:2])", "1:8", "`,` or `]` is expected"));
  EXPECT_TRUE(fails_at("cube(1 + 2);", "1:8", "`,` or `)` is expected"));
  EXPECT_TRUE(fails_at("cube(1) }", "1:9", "`;`, a child or `{` is expected"));
  EXPECT_TRUE(fails_at("cube(1); }", "1:10", "a node such as"));
  EXPECT_TRUE(fails_at("\n\nunion() {\n cube();", "4:9", "`union` in line 3 is not complete"));
  EXPECT_TRUE(fails_at("union() { cube(); 3", "1:19", "a node or `}` is expected"));
  EXPECT_TRUE(fails_at("% 3", "1:3", "a node is expected after the modifier"));
  EXPECT_TRUE(fails_at("$fn = 3", "1:8", "`;` is expected"));
}

TEST(SyntaxErrorTest, RefusesValuesThatAreNone) {
  EXPECT_TRUE(fails_at("cube(a);", "1:6", "`a` is no value"));
  EXPECT_TRUE(fails_at("cube([1, -width]);", "1:10", "`-width` is no value"));
  EXPECT_TRUE(fails_at("cube(-inf);", "1:6", "`-inf` is no finite number"));
  EXPECT_TRUE(fails_at("cube([1, nan]);", "1:10", "`nan` is no finite number"));
  EXPECT_TRUE(fails_at("cube(1/0);", "1:6", "its denominator is zero"));
  EXPECT_TRUE(fails_at("cube(1e10001);", "1:6", "its exponent exceeds 10000"));
  EXPECT_TRUE(fails_at("cube(1e);", "1:7", "the number ends here"));
  EXPECT_TRUE(fails_at("cube(1.2.3);", "1:9", "the number ends here"));
  EXPECT_TRUE(fails_at("cube(2mm);", "1:7", "the number ends here"));
}

TEST(SyntaxErrorTest, RefusesOtherAssignments) {
  EXPECT_TRUE(fails_at("width = 3;", "1:1", "`width` cannot be set, only $fn, $fa and $fs"));
}

TEST(SyntaxErrorTest, PointsAtWhatIsNotClosed) {
  EXPECT_TRUE(fails_at("cube();\n /* a\n", "2:2", "this comment has no `*/`"));
  EXPECT_TRUE(fails_at("material(\"a);\ncube(\"b\");", "1:10", "this string has no"));
  EXPECT_TRUE(fails_at("material(\"\xFF\");", "1:10", "or is not UTF-8"));
}

TEST(SyntaxErrorTest, CountsCharactersNotBytes) {
  EXPECT_EQ(error_of("material(\"\xC3\xA4\xE2\x82\xAC\" 1);").substr(0, 12), "scene:1:15: ");
}

TEST(SyntaxErrorTest, ShortensLongLines) {
  const std::string error = error_of("cube(" + std::string(100'000, ' ') + "?);");
  EXPECT_TRUE(error.starts_with("scene:1:100006: "));
  EXPECT_LT(error.size(), 1000U);
}

TEST(SyntaxDepthTest, RefusesToNestTooDeep) {
  constexpr std::size_t kMany = 100'000;
  const auto many = [](const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < kMany; ++i) {
      result += text;
    }
    return result;
  };
  const std::string too_deep = "nodes and lists nest more than 500 deep";
  EXPECT_NE(error_of(many("group(){")).find(too_deep), std::string::npos);
  EXPECT_NE(error_of(many("group()")).find(too_deep), std::string::npos);
  EXPECT_NE(error_of("cube(" + many("[")).find(too_deep), std::string::npos);
  EXPECT_TRUE(fails_at("cube(" + many("("), "1:6", "a value is expected"));
  EXPECT_TRUE(fails_at(many("{"), "1:1", "a node such as"));
  EXPECT_TRUE(fails_at(many("!"), "1:100001", "a node is expected"));
  EXPECT_TRUE(parse(many(";") + many("/**/")).children.empty());
}

TEST(SyntaxDepthTest, ReadsWhatIsDeepEnough) {
  std::string text;
  for (std::size_t i = 0; i + 1 < kMaxDepth; ++i) {
    text = "group() {" + text + "}";
  }
  EXPECT_EQ(error_of(text), "");
  EXPECT_TRUE(fails_at("group() {" + text + "}", "1:4492", "nest more than 500 deep"));
}

}  // namespace
}  // namespace lamina::scene
