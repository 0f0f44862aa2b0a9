#include "report/page.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace lamina::report {
namespace {

TEST(PageTest, CountsCharactersAndNotBytes) {
  EXPECT_EQ(width_of(""), 0);
  EXPECT_EQ(width_of("steel"), 5);
  EXPECT_EQ(width_of("Stahlträger∅"), 12);
}

TEST(PageTest, ShortensInTheMiddle) {
  EXPECT_EQ(shortened("difference.cube", 20), "difference.cube");
  EXPECT_EQ(shortened("difference.cube", 15), "difference.cube");
  EXPECT_EQ(shortened("difference.cube", 10), "diff..cube");
  EXPECT_EQ(shortened("äöüäöüäöü", 6), "äö..öü");
}

TEST(PageTest, BreaksParagraphsBetweenWords) {
  EXPECT_EQ(paragraph("one two", "", 2), "  one two\n");
  EXPECT_EQ(paragraph("one two", "=>", 4), "=>  one two\n");
  EXPECT_EQ(paragraph("", "", 2), "\n");
  const std::string word(60, 'x');
  EXPECT_EQ(paragraph(word + " " + word, "a", 2), "a " + word + "\n  " + word + "\n");
  EXPECT_EQ(paragraph(std::string(150, 'x'), "", 0),
            std::string(100, 'x') + "\n" + std::string(50, 'x') + "\n");
}

TEST(PageTest, AlignsColumnsAndBreaksTheLast) {
  Columns columns;
  columns.add({"a", "bb", "c"});
  columns.add({"aaa", "", ""});
  EXPECT_EQ(columns.text(1), " a    bb  c\n aaa\n");
  const std::string word(60, 'x');
  columns.add({"a", "b", word + " " + word});
  EXPECT_TRUE(columns.text(0).ends_with("a    b   " + word + "\n         " + word + "\n"));
}

TEST(PageTest, SaysHowMany) {
  EXPECT_EQ(counted(0, "event"), "0 events");
  EXPECT_EQ(counted(1, "event"), "1 event");
  EXPECT_EQ(counted(2, "event"), "2 events");
}

TEST(PageTest, NumbersHaveNoMoreDigitsThanTheirTypeTells) {
  EXPECT_EQ(shortest_text(0.1, 53), "0.1");
  EXPECT_EQ(shortest_text(0.1F, 24), "0.1");
  EXPECT_EQ(shortest_text(0.1F, 53), "0.10000000149011612");
  EXPECT_EQ(shortest_text(20, 24), "20");
  EXPECT_EQ(shortest_text(-1.0F / 3, 24), "-0.33333334");
  EXPECT_EQ(shortest_text(1365.0 / 4096, 11), "0.3333");
  EXPECT_EQ(shortest_text(0, 11), "0");
  EXPECT_EQ(shortest_text(1e300, 0), "1e+300");
  EXPECT_EQ(shortest_text(-std::numeric_limits<double>::infinity(), 24), "-inf");
}

}  // namespace
}  // namespace lamina::report
