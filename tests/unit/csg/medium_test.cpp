// The combination tables of Wyvill and Trotman 1990, section 3.2, as they are printed.
#include "csg/medium.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/random_csg.hpp"

namespace lamina::csg {
namespace {

// A table in the paper's notation: rows are the left node's value, columns the right
// node's, 0 is the empty medium. A cell is one value, or cases of which the first that
// holds counts.
struct Cell {
  std::string left;
  std::string right;
  std::string value;
};
using Table = std::vector<Cell>;

// Table 1: asymmetric addition. The paper leaves BORDER x BORDER blank, since a point is
// on the border of one leaf only; the last line completes it.
const Table kAddition = {
    {"IN l", "IN r", "IN r"},
    {"IN l", "OUT", "IN l"},
    {"IN l", "BORDER c,d", "if c=0 BORDER l,d if d=0 BORDER c,l else BORDER c,d"},
    {"OUT", "IN r", "IN r"},
    {"OUT", "OUT", "OUT"},
    {"OUT", "BORDER c,d", "BORDER c,d"},
    {"BORDER a,b", "IN r", "IN r"},
    {"BORDER a,b", "OUT", "BORDER a,b"},
    {"BORDER a,b", "BORDER c,d", "if c=0 BORDER a,d if d=0 BORDER c,b else BORDER c,d"},
};

// Table 2: subtraction; the last line completes it.
const Table kSubtraction = {
    {"IN l", "IN r", "OUT"},
    {"IN l", "OUT", "IN l"},
    {"IN l", "BORDER c,d", "if c=0 BORDER l,0 if d=0 BORDER 0,l else OUT"},
    {"OUT", "IN r", "OUT"},
    {"OUT", "OUT", "OUT"},
    {"OUT", "BORDER c,d", "OUT"},
    {"BORDER a,b", "IN r", "OUT"},
    {"BORDER a,b", "OUT", "BORDER a,b"},
    {"BORDER a,b", "BORDER c,d", "if c=0 BORDER a,0 if d=0 BORDER 0,b else OUT"},
};

// Intersection, which the paper does not print: a where b is, with a's medium.
const Table kIntersection = {
    {"IN l", "IN r", "IN l"},
    {"IN l", "OUT", "OUT"},
    {"IN l", "BORDER c,d", "if c=0 BORDER 0,l if d=0 BORDER l,0 else IN l"},
    {"OUT", "IN r", "OUT"},
    {"OUT", "OUT", "OUT"},
    {"OUT", "BORDER c,d", "OUT"},
    {"BORDER a,b", "IN r", "BORDER a,b"},
    {"BORDER a,b", "OUT", "OUT"},
    {"BORDER a,b", "BORDER c,d", "if c=0 BORDER 0,b if d=0 BORDER a,0 else BORDER a,b"},
};

using Media = std::map<char, Medium>;  // what l, r, a, b, c, d stand for

// Reads one value, "OUT", "IN m" or "BORDER m,n", from a cell.
Transition read_value(std::istream& text, const Media& media) {
  std::string kind;
  text >> kind;
  if (kind == "OUT") {
    return {kEmpty, kEmpty};
  }
  char from = 0;
  text >> from;
  if (kind == "IN") {
    return {media.at(from), media.at(from)};
  }
  if (kind != "BORDER") {
    throw std::invalid_argument("not a value: " + kind);
  }
  char comma = 0;
  char to = 0;
  text >> comma >> to;
  return {media.at(from), media.at(to)};
}

Transition read_cell(const std::string& cell, const Media& media) {
  std::istringstream text(cell);
  std::string word;
  while (text >> word) {
    if (word != "if" && word != "else") {
      text.seekg(0);
      return read_value(text, media);
    }
    std::string condition;
    const bool holds = word == "else" || (text >> condition && media.at(condition.at(0)) == kEmpty);
    const Transition value = read_value(text, media);
    if (holds) {
      return value;
    }
  }
  throw std::invalid_argument("no case holds: " + cell);
}

// Every way to put the empty medium and three materials into a table: IN has a material;
// BORDER has any pair but (empty, empty), which is OUT.
std::vector<Media> all_media() {
  std::vector<Media> all;
  for (unsigned code = 0; code < 4096; ++code) {
    const auto digit = [code](unsigned place) { return static_cast<Medium>(code >> place & 3U); };
    const Media media{{'0', kEmpty},   {'l', digit(0)}, {'r', digit(2)}, {'a', digit(4)},
                      {'b', digit(6)}, {'c', digit(8)}, {'d', digit(10)}};
    if (media.at('l') != kEmpty && media.at('r') != kEmpty && (code >> 4U & 15U) != 0 &&
        (code >> 8U & 15U) != 0) {
      all.push_back(media);
    }
  }
  return all;
}

void expect_lift_equals(Operator op, const Table& table) {
  const std::vector<Media> assignments = all_media();
  ASSERT_EQ(assignments.size(), 3 * 3 * 15 * 15);
  ASSERT_EQ(table.size(), 9);
  for (const Cell& cell : table) {
    for (const Media& media : assignments) {
      const Transition left = read_cell(cell.left, media);
      const Transition right = read_cell(cell.right, media);
      ASSERT_EQ(lift(op, left, right), read_cell(cell.value, media))
          << cell.left << " with " << cell.right << ": " << left << ", " << right;
    }
  }
}

TEST(MediumTest, LiftOfAdditionIsTable1) { expect_lift_equals(Operator::Add, kAddition); }
TEST(MediumTest, LiftOfDifferenceIsTable2) {
  expect_lift_equals(Operator::Difference, kSubtraction);
}
TEST(MediumTest, LiftOfIntersectionIsItsTable) {
  expect_lift_equals(Operator::Intersection, kIntersection);
}

TEST(MediumTest, OperatorsOnPointsFollowTheirDefinitions) {
  constexpr Medium kSteel = 1;
  constexpr Medium kCopper = 2;
  struct Row {
    Medium left, right, add, difference, intersection;
  };
  constexpr std::array<Row, 5> kRows{{
      {kEmpty, kEmpty, kEmpty, kEmpty, kEmpty},
      {kSteel, kEmpty, kSteel, kSteel, kEmpty},
      {kEmpty, kCopper, kCopper, kEmpty, kEmpty},
      {kSteel, kCopper, kCopper, kEmpty, kSteel},
      {kCopper, kSteel, kSteel, kEmpty, kCopper},
  }};
  for (const Row& row : kRows) {
    SCOPED_TRACE(::testing::Message() << "left " << row.left << ", right " << row.right);
    EXPECT_EQ(combine(Operator::Add, row.left, row.right), row.add);
    EXPECT_EQ(combine(Operator::Difference, row.left, row.right), row.difference);
    EXPECT_EQ(combine(Operator::Intersection, row.left, row.right), row.intersection);
  }
}

}  // namespace
}  // namespace lamina::csg
