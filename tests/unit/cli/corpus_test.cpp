// The 22 real models that need only what is built, against their independent answers: every
// point through `lamina locate`, every ray through `lamina trace --truth`, with --facets.
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>

#include "support/corpus.hpp"
#include "unit/cli/program.hpp"

namespace lamina::test {
namespace {

using Json = nlohmann::json;

std::string numbers_text(const Json& row, std::size_t count) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (std::size_t i = 0; i < count; ++i) {
    text << row.at(i).get<double>() << ' ';
  }
  return text.str();
}

class CorpusTest : public ::testing::TestWithParam<const char*> {};

TEST_P(CorpusTest, AgreesWithEveryAnswer) {
  const auto folder = support::corpus_folder();
  if (!folder) {
    GTEST_SKIP() << support::kNoCorpus;
  }
  const std::string model = (*folder / GetParam()).string();
  const Json answers = Json::parse(read(model + ".json"));
  const Scratch scratch;

  std::string points;
  for (const Json& point : answers.at("points")) {
    points += numbers_text(point, 3) + "\n";
  }
  const Outcome located =
      lamina("locate " + model + ".csg --facets --points " + scratch.write("points", points));
  ASSERT_EQ(located.status, 0) << located.error;
  const auto locations = json_lines(located.out);
  ASSERT_EQ(locations.size(), answers.at("points").size());
  for (std::size_t i = 0; i < locations.size(); ++i) {
    const bool inside = answers["points"][i].at(3).get<int>() != 0;
    EXPECT_EQ(!locations[i].at("medium").is_null(), inside) << answers["points"][i];
    EXPECT_FALSE(locations[i].contains("boundary")) << answers["points"][i];
    EXPECT_FALSE(locations[i].contains("undecided")) << answers["points"][i];
  }

  std::string rays;
  for (const Json& ray : answers.at("rays")) {
    rays += numbers_text(ray, 6) + "\n";
  }
  const Outcome traced =
      lamina("trace " + model + ".csg --facets --truth --rays " + scratch.write("rays", rays));
  ASSERT_EQ(traced.status, 0) << traced.error;
  const auto traces = json_lines(traced.out);
  ASSERT_EQ(traces.size(), answers.at("rays").size());
  // The answers come from a mesh of 6 significant digits; its margin keeps rays that far from
  // every edge, and a crossing moves by some times that on an oblique face.
  const double allowed = 10 * answers.at("margin").get<double>();
  for (std::size_t i = 0; i < traces.size(); ++i) {
    std::vector<double> seen;
    for (const Json& transition : traces[i].at("transitions")) {
      if (transition.at("from").is_null() != transition.at("to").is_null()) {
        seen.push_back(transition.at("t"));
      }
    }
    const auto expected = answers["rays"][i].at(6).get<std::vector<double>>();
    EXPECT_TRUE(traces[i].at("start").is_null());
    ASSERT_EQ(seen.size(), expected.size()) << answers["rays"][i];
    for (std::size_t k = 0; k < seen.size(); ++k) {
      EXPECT_NEAR(seen[k], expected[k], allowed) << answers["rays"][i];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RealModels, CorpusTest, ::testing::ValuesIn(support::kReadableModels),
                         [](const auto& model) { return std::string(model.param); });

}  // namespace
}  // namespace lamina::test
