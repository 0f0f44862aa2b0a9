#include "report/table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/contract.hpp"
#include "report/run_folder.hpp"

namespace lamina::report {
namespace {

using Json = nlohmann::ordered_json;

// Values of every kind; 5 of 10 has the printed limits 18.71 and 81.29 %.
Table sample() {
  return {"Some \"title\"",
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
  const Table table{"", {{"r", "r", ""}}, {{rate}, {Rate{1, 1}}}, {}};
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
                    {{"a", "", ""}, {"b", "", ""}, {"c", "", ""}, {"d", "", ""}},
                    {{std::string("x, y"), std::string("say \"so\""), std::string("two\nlines"),
                      std::string("plain")}},
                    {}};
  EXPECT_EQ(write(table, Format::Csv),
            "a,b,c,d\n\"x, y\",\"say \"\"so\"\"\",\"two\nlines\",plain\n");
}

TEST(TableTest, CsvWithoutRowsHasAHeader) {
  const Table table{"", {{"a", "", ""}, {"b", "", ""}}, {}, {}};
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
  const Table table{"100 %",
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

TEST(TableTest, FormatsAreSpelledAsOnTheCommandLine) {
  EXPECT_EQ(parse_format("md"), Format::Markdown);
  EXPECT_EQ(parse_format("csv"), Format::Csv);
  EXPECT_EQ(parse_format("json"), Format::Json);
  EXPECT_EQ(parse_format("latex"), Format::Latex);
  EXPECT_THROW(parse_format("MD"), base::InputError);
  EXPECT_THROW(parse_format(""), base::InputError);
}

// A folder of this test alone, gone when it ends.
class RunFolderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              fmt::format("lamina-run-{}-{}", info->name(), static_cast<const void*>(this));
    std::filesystem::remove_all(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  // What read_run says of a tables.json with this text.
  std::string error_of(const std::string& text) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "tables.json") << text;
    try {
      read_run(folder_);
      return "";
    } catch (const base::InputError& error) {
      return error.what();
    }
  }

  std::filesystem::path folder_;
};

TEST_F(RunFolderTest, ReadsBackWhatWasWritten) {
  Table second = sample();
  second.title = "second";
  // The nearest doubles, not their three digits; and an integer that no double holds.
  second.rows[0][2] = 0.1 + 0.2;
  second.rows[0][1] = (std::uint64_t{1} << 53U) + 1;
  write_run(folder_ / "deep", {sample(), second}, {{"version", "1"}}, {{"seed", "7"}});
  const std::vector<Table> read = read_run(folder_ / "deep");
  ASSERT_EQ(read.size(), 2U);
  for (const Format format : {Format::Markdown, Format::Csv, Format::Json, Format::Latex}) {
    EXPECT_EQ(write(read[0], format), write(sample(), format));
    EXPECT_EQ(write(read[1], format), write(second, format));
  }
  EXPECT_EQ(std::get<double>(read[1].rows[0][2]), 0.1 + 0.2);
  EXPECT_EQ(std::get<std::uint64_t>(read[1].rows[0][1]), (std::uint64_t{1} << 53U) + 1);
  const Json environment = Json::parse(std::ifstream(folder_ / "deep" / "environment.json"));
  EXPECT_EQ(environment, (Json{{"version", "1"}, {"settings", {{"seed", "7"}}}}));
}

TEST_F(RunFolderTest, ARealThatIsWholeStaysAReal) {
  write_run(folder_, {{"", {{"a", "a", ""}}, {{2.0}, {std::uint64_t{2}}}, {}}}, {}, {});
  const std::vector<Table> read = read_run(folder_);
  EXPECT_TRUE(std::holds_alternative<double>(read[0].rows[0][0]));
  EXPECT_TRUE(std::holds_alternative<std::uint64_t>(read[0].rows[1][0]));
}

TEST_F(RunFolderTest, WritingAgainReplacesAndLeavesNoParts) {
  write_run(folder_, {sample(), sample()}, {}, {});
  write_run(folder_, {sample()}, {}, {});
  EXPECT_EQ(read_run(folder_).size(), 1U);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    EXPECT_EQ(entry.path().extension(), ".json");
    ++files;
  }
  EXPECT_EQ(files, 2U);
}

TEST_F(RunFolderTest, IsFoundByItsSettings) {
  const Record settings{{"rays", "100"}, {"seed", "7"}};
  EXPECT_EQ(find_run(folder_, settings), Found::Nothing);
  write_run(folder_, {sample()}, {{"version", "1"}}, settings);
  EXPECT_EQ(find_run(folder_, settings), Found::ThisRun);
  EXPECT_EQ(find_run(folder_, {{"rays", "100"}, {"seed", "8"}}), Found::AnotherRun);
  EXPECT_EQ(find_run(folder_, {}), Found::AnotherRun);
  // Without a record of its settings it is no run of these.
  std::ofstream(folder_ / "environment.json") << "{";
  EXPECT_EQ(find_run(folder_, settings), Found::AnotherRun);
  std::filesystem::remove(folder_ / "environment.json");
  EXPECT_EQ(find_run(folder_, settings), Found::AnotherRun);
}

TEST_F(RunFolderTest, NothingThereIsAnInputError) {
  EXPECT_THROW(read_run(folder_), base::InputError);
}

TEST_F(RunFolderTest, BrokenFilesAreInputErrorsThatNameTheFile) {
  for (const char* text :
       {"", "{", "[]", "{}", "null", "{\"tables\": 3}", "{\"tables\": [{}]}",
        R"({"tables": [{"title": 1, "columns": [], "rows": [], "notes": []}]})",
        R"({"tables": [{"title": "", "columns": [], "rows": [[{}]], "notes": []}]})",
        R"({"tables": [{"title": "", "columns": [], "rows": [[null]], "notes": []}]})",
        R"({"tables": [{"title": "", "columns": [], "rows": [[-1]], "notes": []}]})",
        R"({"tables": [{"title": "", "columns": [{}], "rows": [], "notes": []}]})"}) {
    const std::string error = error_of(text);
    EXPECT_NE(error.find("tables.json"), std::string::npos) << text << ": " << error;
  }
}

// A row of another length than the columns cannot be written as a table.
TEST_F(RunFolderTest, ARowThatDoesNotFitItsColumnsIsAnInputError) {
  EXPECT_NE(error_of(R"({"tables": [{"title": "", "columns": [], "rows": [["x"]], "notes": []}]})"),
            "");
}

TEST_F(RunFolderTest, AFolderThatCannotBeMadeIsAnInputError) {
  std::filesystem::create_directories(folder_);
  std::ofstream(folder_ / "file") << "x";
  EXPECT_THROW(write_run(folder_ / "file" / "below", {sample()}, {}, {}), base::InputError);
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
