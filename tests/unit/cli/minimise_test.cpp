// Rays of real models on which something is wrong, and the small cases that are made of them.
#include <gtest/gtest.h>

#include "support/corpus.hpp"
#include "unit/cli/program.hpp"

namespace lamina::test {
namespace {

std::string after(const std::string& text, const std::string& mark, char end) {
  const std::size_t begin = text.find(mark);
  return begin == std::string::npos
             ? ""
             : text.substr(begin + mark.size(),
                           text.find(end, begin + mark.size()) - begin - mark.size());
}

// The number of leaves that `lamina explain` reads from a scene.
int leaves_of(const std::string& scene, const std::string& ray) {
  const Outcome outcome = lamina("explain " + scene + " --ray \"" + ray + "\"");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  return std::stoi(after(outcome.out, "(leaves ", ','));
}

// Does the method see another thing along the ray than is there?
bool wrong(const std::string& scene, const std::string& ray, const std::string& method,
           const std::string& number) {
  const Scratch scratch;
  const std::string common = "trace " + scene + " --rays " + scratch.write("rays", ray + "\n");
  const Outcome seen = lamina(common + " --method " + method + " --number " + number);
  const Outcome truth = lamina(common + " --truth");
  EXPECT_EQ(seen.status, 0) << seen.error;
  EXPECT_EQ(truth.status, 0) << truth.error;
  // Leaf and media tell; t is rounded.
  const auto summary = [](const Outcome& outcome) {
    nlohmann::json line = json_lines(outcome.out).at(0);
    for (nlohmann::json& transition : line.at("transitions")) {
      transition.erase("t");
    }
    return line;
  };
  return summary(seen) != summary(truth);
}

struct FailingRay {
  const char* model;
  int leaves;
  const char* method;
  const char* number;
  const char* artifact;  // by `lamina census --rays-file`, whose row has a count of 1
  const char* ray;
};
constexpr std::array kFailingRays{
    FailingRay{"koen_lee_thermostat_housing", 126, "roth", "float", "ghost_surface",
               "45.78253173828125 354.843048095703125 77.3119659423828125 "
               "0.06718371808528900146484375 -0.985765755176544189453125 "
               "-0.15411750972270965576171875"},
    FailingRay{"koen_lee_drill_centerer", 42, "wyvill-sharp", "double", "missed_logic",
               "-86.2413482666015625 -239.00286865234375 -282.141143798828125 "
               "0.3399483859539031982421875 0.576173484325408935546875 "
               "0.74327600002288818359375"},
    FailingRay{"jbazant_bed_socket", 30, "regularized", "float", "ghost_hit",
               "44.914775848388671875 -45.109020233154296875 133.96160888671875 "
               "-0.302805244922637939453125 0.265309035778045654296875 "
               "-0.9153797626495361328125"}};

class MinimiseRealModelTest : public ::testing::TestWithParam<FailingRay> {};

TEST_P(MinimiseRealModelTest, LeavesFourLeavesAtMostWithTheSameArtifact) {
  const auto folder = support::corpus_folder();
  if (!folder) {
    GTEST_SKIP() << support::kNoCorpus;
  }
  const FailingRay& given = GetParam();
  const std::string model = (*folder / (std::string(given.model) + ".csg")).string();
  const std::string how = std::string(" --method ") + given.method + " --number " + given.number;
  ASSERT_EQ(leaves_of(model, given.ray), given.leaves);

  const Scratch scratch;
  const std::string small = scratch.path("small.csg");
  const Outcome outcome =
      lamina("minimise " + model + " --ray \"" + given.ray + "\"" + how + " -o " + small);
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(read(small), outcome.out);
  const std::string small_ray = after(outcome.out, "--ray \"", '"');
  EXPECT_LE(leaves_of(small, small_ray), 4) << outcome.out;
  EXPECT_LT(small_ray.size(), std::string(given.ray).size());
  EXPECT_TRUE(wrong(small, small_ray, given.method, given.number)) << outcome.out;
  const auto count = [&](const std::string& scene, const std::string& of_ray) {
    const Outcome census =
        lamina("census " + scene + " --methods " + given.method + " --numbers " + given.number +
               " --format json --rays-file " + scratch.write("ray", of_ray + "\n"));
    EXPECT_EQ(census.status, 0) << census.error;
    const nlohmann::json row = nlohmann::json::parse(census.out).at("rows").at(0);
    EXPECT_EQ(row.at("rays"), 1);
    return row.at(std::string(given.artifact) + "_count").get<int>();
  };
  EXPECT_EQ(count(model, given.ray), 1);
  EXPECT_EQ(count(small, small_ray), 1) << outcome.out;

  // The replay line is a command, and the comments are what it prints.
  const Outcome replay = lamina(after(outcome.out, "// lamina ", '\n'));
  ASSERT_EQ(replay.status, 0) << replay.error;
  std::string comments;
  std::istringstream lines(replay.out);
  for (std::string line; std::getline(lines, line);) {
    comments += line.empty() ? "//\n" : "// " + line + "\n";
  }
  EXPECT_TRUE(outcome.out.ends_with(comments)) << outcome.out << replay.out;
}

INSTANTIATE_TEST_SUITE_P(RealModels, MinimiseRealModelTest, ::testing::ValuesIn(kFailingRays),
                         [](const auto& ray) { return std::string(ray.param.model); });

constexpr const char* kGhostSurface = R"(
  material("A") cylinder(h=1, r=1);
  translate([3, 0, 0]) material("B") cylinder(h=1, r=1);
)";

TEST(MinimiseCommandTest, PrintsASceneFileThatSaysWhatItShows) {
  const Scratch scratch;
  const std::string scene = scratch.write("scene.csg", kGhostSurface);
  const Outcome outcome = lamina("minimise " + scene +
                                 " --ray \"3.25 0 9 0 0.0078125 -1\" --method roth --number double"
                                 " --solver textbook");
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_TRUE(outcome.out.starts_with(
      "// roth in double: first wrong, ghost surface; in exact numbers too\n// leaves: "))
      << outcome.out;
  EXPECT_NE(outcome.out.find(" of the 6 of " + scene + "\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("--methods roth --numbers double --solver textbook\n"),
            std::string::npos);
  EXPECT_NE(outcome.out.find("// => "), std::string::npos);
  const std::string ray = after(outcome.out, "--ray \"", '"');
  EXPECT_TRUE(wrong(scratch.write("small.csg", outcome.out), ray, "roth", "double"));
  EXPECT_EQ(outcome.error, "");
}

TEST(MinimiseCommandTest, RefusesARayOnWhichNothingIsWrong) {
  const Scratch scratch;
  const std::string scene = scratch.write("scene.csg", kGhostSurface);
  const Outcome outcome = lamina("minimise " + scene +
                                 " --ray \"3.25 0 9 0 0 -1\" --method regularized --number exact");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.error.find("nothing is wrong"), std::string::npos) << outcome.error;
}

TEST(MinimiseCommandTest, RefusesAFileThatCannotBeWritten) {
  const Scratch scratch;
  const std::string scene = scratch.write("scene.csg", kGhostSurface);
  const Outcome outcome = lamina("minimise " + scene +
                                 " --ray \"3.25 0 9 0 0.0078125 -1\" --method roth --number double "
                                 "-o /nonexistent/small.csg");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.error.find("'/nonexistent/small.csg' cannot be written"), std::string::npos);
}

}  // namespace
}  // namespace lamina::test
