#include "report/table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/contract.hpp"

namespace lamina::report {
namespace {

using Json = nlohmann::ordered_json;

// Values of every kind; 5 of 10 has the printed limits 18.71 and 81.29 %.
Table sample() {
  return {"some",
          "Some \"title\"",
          {{"name", "name", ""},
           {"bits", "bits", "Significand bits."},
           {"length", "wrong length", ""},
           {"ghost", "ghost hit", "A ghost."},
           {"void", "void", "A void."},
           {"secret", "secret", "", true}},
          {{std::string("one"), std::uint64_t{24}, 0.5, Rate{5, 10}, Rate{0, 10}, std::string("x")},
           {std::string("two"), std::uint64_t{53}, 1234567.0, Rate{0, 2000}, Rate{0, 0},
            std::string("y")}},
          {"A note."}};
}

TEST(TableTest, MarkdownIsForPeople) {
  EXPECT_EQ(write(sample(), Format::Markdown),
            "### Some \"title\"\n"
            "\n"
            "| name | bits | wrong length | ghost hit         |\n"
            "|------|------|--------------|-------------------|\n"
            "| one  | 24   | 0.5          | 50.0 [18.7, 81.3] |\n"
            "| two  | 53   | 1.23e+06     | < 0.150           |\n"
            "\n"
            "- Rates are percentages of rays with at least one of the artifact, with 95 % "
            "Clopper-Pearson intervals; `< x` is 3/n where none was seen in n rays.\n"
            "- Zero in every row, not shown: void.\n"
            "- bits: Significand bits.\n"
            "- ghost hit: A ghost.\n"
            "- A note.\n");
}

TEST(TableTest, MarkdownOfNothingHasItsColumns) {
  Table table = sample();
  table.title.clear();
  table.rows.clear();
  table.notes.clear();
  EXPECT_EQ(write(table, Format::Markdown),
            "| name | bits | wrong length | ghost hit | void |\n"
            "|------|------|--------------|-----------|------|\n"
            "\n"
            "- bits: Significand bits.\n"
            "- ghost hit: A ghost.\n"
            "- void: A void.\n");
}

// One rate of a table of one cell, as Markdown has it.
std::string markdown(const Rate& rate) {
  // The second row keeps the column from being zero throughout.
  const Table table{"", "", {{"r", "r", ""}}, {{rate}, {Rate{1, 1}}}, {}};
  const std::string text = write(table, Format::Markdown);
  const std::size_t row = text.find("\n", text.find("|--")) + 1;
  std::string cell = text.substr(row + 2, text.find(" |", row) - row - 2);
  cell.erase(cell.find_last_not_of(' ') + 1);
  return cell;
}

TEST(TableTest, RatesHaveThreeDigitsAndIntervals) {
  EXPECT_EQ(markdown({0, 0}), "-");
  EXPECT_EQ(markdown({0, 1}), "< 100.0");
  EXPECT_EQ(markdown({0, 2}), "< 100.0");
  EXPECT_EQ(markdown({0, 100}), "< 3.00");
  EXPECT_EQ(markdown({0, 3000}), "< 0.100");
  EXPECT_EQ(markdown({0, 30'000'000}), "< 1.0e-05");
  // 1 - 0.025^(1/10) = 0.3085 and its mirror image.
  EXPECT_EQ(markdown({10, 10}), "100.0 [69.2, 100.0]");
  EXPECT_EQ(markdown({1, 10}), "10.0 [0.253, 44.5]");
  EXPECT_EQ(markdown({10, 100}), "10.0 [4.90, 17.6]");
}

TEST(TableTest, AColumnIsShownAsSoonAsOneRowIsNotZero) {
  Table table = sample();
  table.rows[1][4] = Rate{1, 9};
  const std::string text = write(table, Format::Markdown);
  EXPECT_NE(text.find("| void"), std::string::npos);
  EXPECT_EQ(text.find("not shown"), std::string::npos);
  // A number that is zero is no rate.
  table.rows[0][2] = table.rows[1][2] = 0.0;
  EXPECT_NE(write(table, Format::Markdown).find("| wrong length"), std::string::npos);
}

TEST(TableTest, CsvHasEveryColumnAndRatesInFull) {
  const std::string text = write(sample(), Format::Csv);
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0],
            "name,bits,length,ghost_count,ghost_n,ghost_rate,ghost_lower,ghost_upper,"
            "void_count,void_n,void_rate,void_lower,void_upper,secret");
  EXPECT_TRUE(lines[1].starts_with("one,24,0.5,5,10,0.5,0.187"));
  EXPECT_TRUE(lines[1].ends_with(",x"));
  // No trials have no rate; the interval is everything.
  EXPECT_NE(lines[2].find(",0,0,,0.0,1.0,y"), std::string::npos) << lines[2];
}

TEST(TableTest, CsvQuotesWhatWouldBreakIt) {
  const Table table{"",
                    "",
                    {{"a", "", ""}, {"b", "", ""}, {"c", "", ""}, {"d", "", ""}},
                    {{std::string("x, y"), std::string("say \"so\""), std::string("two\nlines"),
                      std::string("plain")}},
                    {}};
  EXPECT_EQ(write(table, Format::Csv),
            "a,b,c,d\n\"x, y\",\"say \"\"so\"\"\",\"two\nlines\",plain\n");
}

TEST(TableTest, CsvWithoutRowsHasAHeader) {
  const Table table{"", "", {{"a", "", ""}, {"b", "", ""}}, {}, {}};
  EXPECT_EQ(write(table, Format::Csv), "a,b\n");
}

TEST(TableTest, JsonHasTheSameNamesAsCsv) {
  const Json json = Json::parse(write(sample(), Format::Json));
  EXPECT_EQ(json.at("title"), "Some \"title\"");
  EXPECT_EQ(json.at("notes"), Json::array({"A note."}));
  ASSERT_EQ(json.at("rows").size(), 2U);
  const Json& row = json.at("rows")[0];
  EXPECT_EQ(row.at("name"), "one");
  EXPECT_EQ(row.at("bits"), 24);
  EXPECT_EQ(row.at("length"), 0.5);
  EXPECT_EQ(row.at("ghost_count"), 5);
  EXPECT_EQ(row.at("ghost_n"), 10);
  EXPECT_EQ(row.at("ghost_rate"), 0.5);
  EXPECT_NEAR(row.at("ghost_lower").get<double>(), 0.1871, 5e-5);
  EXPECT_NEAR(row.at("ghost_upper").get<double>(), 0.8129, 5e-5);
  EXPECT_TRUE(json.at("rows")[1].at("void_rate").is_null());
  EXPECT_EQ(row.at("secret"), "x");
}

TEST(TableTest, LatexEscapesWhatLatexReads) {
  const Table table{"",
                    "100 %",
                    {{"a", "50 % & more_less", ""}, {"b", "b", ""}},
                    {{std::string("a_b^c~d\\e#f$g{h}"), std::string("1 < 2 > 0")}},
                    {"Below."}};
  EXPECT_EQ(write(table, Format::Latex),
            "% 100 %\n"
            "\\begin{tabular}{ll}\n"
            "\\toprule\n"
            "50 \\% \\& more\\_less & b \\\\\n"
            "\\midrule\n"
            "a\\_b\\textasciicircum{}c\\textasciitilde{}d\\textbackslash{}e\\#f\\$g\\{h\\} & "
            "1 $<$ 2 $>$ 0 \\\\\n"
            "\\bottomrule\n"
            "\\end{tabular}\n"
            "% Below.\n");
}

TEST(TableTest, LatexLeavesOutWhatMarkdownDoes) {
  const std::string text = write(sample(), Format::Latex);
  EXPECT_NE(text.find("\\begin{tabular}{llll}"), std::string::npos);
  EXPECT_NE(text.find("two & 53 & 1.23e+06 & $<$ 0.150 \\\\"), std::string::npos) << text;
  EXPECT_NE(text.find("% Zero in every row, not shown: void."), std::string::npos);
  EXPECT_EQ(text.find("secret"), std::string::npos);
}

// What LaTeX would stumble over: braces that do not balance, rows of the wrong length, special
// characters that are not escaped.
TEST(TableTest, LatexIsWellFormed) {
  Table table = sample();
  table.rows[0][0] = std::string(R"(50% & #1_{a} $x$ \ ~^ <b>)");
  const std::string text = write(table, Format::Latex);
  std::size_t rows = 0;
  int depth = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("%")) {
      continue;
    }
    std::size_t ampersands = 0;
    bool math = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '\\') {
        ++i;  // a command, or an escaped character
        continue;
      }
      ampersands += line[i] == '&' ? 1 : 0;
      depth += line[i] == '{' ? 1 : line[i] == '}' ? -1 : 0;
      math = line[i] == '$' ? !math : math;
      EXPECT_GE(depth, 0) << line;
      EXPECT_EQ(std::string("#_~^%").find(line[i]), std::string::npos) << line;
      EXPECT_TRUE(math || (line[i] != '<' && line[i] != '>')) << line;
    }
    EXPECT_FALSE(math) << line;
    if (line.ends_with(R"(\\)")) {
      EXPECT_EQ(ampersands, 3U) << line;
      ++rows;
    }
  }
  EXPECT_EQ(depth, 0);
  EXPECT_EQ(rows, 3U);  // heading and two rows
  EXPECT_NE(text.find("\\begin{tabular}{llll}"), std::string::npos);
  EXPECT_NE(text.find("\\end{tabular}"), std::string::npos);
}

TEST(TableTest, FormatsAreSpelledAsOnTheCommandLine) {
  EXPECT_EQ(parse_format("md"), Format::Markdown);
  EXPECT_EQ(parse_format("csv"), Format::Csv);
  EXPECT_EQ(parse_format("json"), Format::Json);
  EXPECT_EQ(parse_format("latex"), Format::Latex);
  EXPECT_THROW(parse_format("MD"), base::InputError);
  EXPECT_THROW(parse_format(""), base::InputError);
}

TEST(TableTest, WhatIsNoNumberIsNoValue) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Table table{"t", "", {{"a", "a", ""}, {"b", "b", ""}}, {{none, 1.5}, {none, none}}, {}};
  EXPECT_EQ(write(table, Format::Markdown), "| b   |\n|-----|\n| 1.5 |\n| -   |\n\n");
  EXPECT_EQ(write(table, Format::Csv), "a,b\n,1.5\n,\n");
  EXPECT_TRUE(Json::parse(write(table, Format::Json)).at("rows")[1].at("b").is_null());
}

TEST(RunTest, TablesFollowOneAnother) {
  Table second = sample();
  second.title = "second";
  EXPECT_EQ(write(std::vector<Table>{sample(), second}, Format::Csv),
            write(sample(), Format::Csv) + "\n" + write(second, Format::Csv));
  const Json json = Json::parse(write(std::vector<Table>{sample(), second}, Format::Json));
  ASSERT_EQ(json.at("tables").size(), 2U);
  EXPECT_EQ(json.at("tables")[1].at("title"), "second");
  EXPECT_EQ(write(std::vector<Table>{}, Format::Markdown), "");
}

}  // namespace
}  // namespace lamina::report
