// The contract of the command line: what other programs rely on.
#include "unit/cli/program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "number/rational.hpp"

namespace lamina::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kBox = R"(material("steel") cube([1, 1, 1]);)";

TEST(ProgramTest, TraceTruthIsExactOnRationalCoordinates) {
  const Scratch scratch;
  // Two faces at 978/997 and a third closer to it than any double: one class, then another.
  const std::string scene = scratch.write("scene.csg", R"(
    difference() {
      material("a") translate([0, -1, -1]) cube([978/997, 2, 2]);
      material("b") translate([978/997, -2, -2]) cube([1, 4, 4]);
    }
    material("c") translate([978/997, -1, -1]) cube([1/3, 2, 2]);
  )");
  const std::string rays =
      scratch.write("rays.txt", "# along x\n-1 1/7 1/11 1 0 0\n-1,0.5,5,1,0,0 # misses\n");
  const Outcome outcome = lamina("trace " + scene + " --rays " + rays + " --truth");
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const auto lines = json_lines(outcome.out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].at("ray"), 0);
  EXPECT_TRUE(lines[0].at("start").is_null());
  const auto& seen = lines[0].at("transitions");
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_EQ(seen[0].at("t"), 1.0);
  EXPECT_TRUE(seen[0].at("from").is_null());
  EXPECT_EQ(seen[0].at("to"), "a");
  EXPECT_EQ(seen[1].at("from"), "a");
  EXPECT_EQ(seen[1].at("to"), "c");
  EXPECT_EQ(seen[1].at("t"), 1975.0 / 997.0);
  EXPECT_TRUE(seen[1].at("leaf").is_number_unsigned());
  EXPECT_EQ(seen[2].at("t").get<double>(), 1 + 978.0 / 997.0 + 1.0 / 3.0);
  EXPECT_TRUE(lines[1].at("transitions").empty());
}

TEST(ProgramTest, TruthIsRegularizedInExact) {
  const std::string scene = LAMINA_SOURCE_DIR "/data/scenes/figure04.csg";
  const Scratch scratch;
  const std::string rays =
      scratch.write("rays", "0.1 0.1 9 0 0 -1\n3 0.1 9 0.01 0 -1\n0 0 0 1 1 1\n");
  const std::string common = "trace " + scene + " --rays " + rays;
  const Outcome truth = lamina(common + " --truth");
  ASSERT_EQ(truth.status, 0) << truth.error;
  EXPECT_EQ(truth.out, lamina(common + " --method regularized --number exact").out);
}

TEST(ProgramTest, TraceRunsEveryMethodInEveryNumber) {
  const Scratch scratch;
  const std::string scene = scratch.write("box.csg", kBox);
  const std::string rays = scratch.write("rays", "0.5 0.25 -2 0 0 1\n");
  for (const char* method : {"roth", "wyvill-sharp", "epsilon:1e-6", "epsilon:1e-9:relative",
                             "epsilon", "regularized", "wyvill-trotman", "wyvill-trotman:parity"}) {
    for (const char* number : {"float", "double", "longdouble", "bin11", "bin24", "bin53", "bin64",
                               "bin113", "bin237", "'bin<24>'", "mpfr16", "mpfr50", "exact"}) {
      const Outcome outcome = lamina("trace " + scene + " --rays " + rays + " --method " + method +
                                     " --number " + number);
      ASSERT_EQ(outcome.status, 0) << outcome.error;
      EXPECT_EQ(json_lines(outcome.out).at(0), Json::parse(R"({"ray":0,"start":null,"transitions":[
                  {"t":2.0,"from":null,"to":"steel","leaf":4},
                  {"t":3.0,"from":"steel","to":null,"leaf":5}]})"))
          << method << " " << number;
    }
  }
}

TEST(ProgramTest, StartIsTheMediumBehindZero) {
  const Scratch scratch;
  const std::string scene = scratch.write("box.csg", kBox);
  const std::string rays =
      scratch.write("rays", "1/2 1/2 1/2 1 0 0\n0 1/2 1/2 1 0 0\n1 1/2 1/2 1 0 0\n");
  const auto lines = json_lines(lamina("trace " + scene + " --rays " + rays + " --truth").out);
  EXPECT_EQ(lines.at(0).at("start"), "steel");
  EXPECT_EQ(lines.at(0).at("transitions").size(), 1U);
  EXPECT_EQ(lines.at(1).at("start"), "steel");  // t = 0 is behind t = 0+
  EXPECT_TRUE(lines.at(2).at("start").is_null());
  EXPECT_TRUE(lines.at(2).at("transitions").empty());
}

TEST(ProgramTest, LocateSeesTheWholeNeighbourhood) {
  const Scratch scratch;
  const std::string scene = scratch.write("boxes.csg", R"(material("steel") {
    cube([1, 1, 1]);
    translate([1, 0, 0]) cube([1, 1, 1]);
  })");
  const std::string points = scratch.write("points", "0.5 0.5 0.5\n1 0.5 0.5\n0 0.5 0.5\n3 0 0\n");
  const auto lines = json_lines(lamina("locate " + scene + " --points " + points).out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], Json::parse(R"({"point":0,"medium":"steel"})"));
  EXPECT_EQ(lines[1], Json::parse(R"({"point":1,"medium":"steel"})"));
  EXPECT_EQ(lines[2].at("boundary"), true);
  EXPECT_EQ(lines[3], Json::parse(R"({"point":3,"medium":null})"));
}

TEST(ProgramTest, CensusIsTheSameForAnyThreads) {
  const std::string scene = LAMINA_SOURCE_DIR "/data/scenes/figure07.csg";
  const std::string common =
      "census " + scene + " --rays 400 --numbers float,double,exact --format csv --threads ";
  const Outcome one = lamina(common + "1");
  ASSERT_EQ(one.status, 0) << one.error;
  EXPECT_EQ(one.out, lamina(common + "2").out);
  EXPECT_EQ(one.out, lamina(common + "7").out);
  EXPECT_NE(one.out.find("regularized,exact"), std::string::npos);
}

TEST(ProgramTest, RunsKeepTheirTables) {
  const Scratch scratch;
  const std::string folder = scratch.path("run");
  const Outcome run =
      lamina("run ghost-cylinders --rays 200 --numbers double,exact --out " + folder);
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_TRUE(run.error.empty()) << run.error;  // no progress bar in a pipe
  EXPECT_EQ(run.out, lamina("table " + folder).out);
  // The same run is not made twice, and another one does not overwrite it.
  const std::string again = "run ghost-cylinders --rays 200 --numbers double,exact --out " + folder;
  EXPECT_EQ(lamina(again).status, 2);
  EXPECT_EQ(lamina(again + " --resume").out, run.out);
  EXPECT_EQ(lamina(again + " --resume --seed 2").status, 2);
  const Json tables = Json::parse(lamina("table " + folder + " --format json").out);
  const Json& rows = tables.at("tables").at(0).at("rows");
  ASSERT_EQ(rows.size(), 10U);
  for (const Json& row : rows) {
    if (row.at("number") == "exact" && row.at("method") == "roth") {
      EXPECT_GT(row.at("ghost_surface_count"), 0);
    }
    if (row.at("number") == "exact" && row.at("method") == "regularized") {
      EXPECT_EQ(row.at("first_wrong_count"), 0);
      EXPECT_EQ(row.at("ghost_hit_count"), 0);
    }
  }
  EXPECT_NE(lamina("table " + folder + " --format latex").out.find("\\toprule"), std::string::npos);
}

TEST(ProgramTest, BadInputIsExitStatusTwoAndSaysWhere) {
  const Scratch scratch;
  const std::string scene = scratch.write("box.csg", kBox);
  const std::string rays = scratch.write("rays", "0 0 0 1 0 0\n1 2 3 4 5\n");
  const std::string good_rays = scratch.write("good", "0 0 0 1 0 0\n");
  const std::string broken = scratch.write("broken.csg", "cube([1, 1, 1]);\nsphere(r=);\n");
  const auto expect = [](const std::string& arguments, const std::string& part) {
    const Outcome outcome = lamina(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE((outcome.error + outcome.out).find(part), std::string::npos)
        << arguments << "\n"
        << outcome.error << outcome.out;
  };
  expect("trace " + scene + " --rays " + rays, rays + ":2:");
  expect("trace " + scene + " --rays nowhere", "nowhere");
  expect("trace " + broken + " --rays " + rays, broken + ":2:10:");
  expect("trace " + scene + " --rays " + good_rays + " --method odd", "wyvill-trotman");
  expect("trace " + scene + " --rays " + good_rays + " --number odd", "double");
  expect("explain " + scene + " --ray '0 0 0 0 0 0'", "direction");
  expect("explain " + scene + " --pixel 1,1", "camera");
  expect("explain " + scene, "--ray");
  expect("run nothing", "coincident-faces");
  expect("table " + scratch.path("empty"), "lamina run");
  expect("census " + scene + " --format odd", "latex");
  expect("solve --coefficients 1,x,2", "number 2");
  expect("solve --coefficients 1,2,1 --interval 1,0", "a <= b");
  expect("solve --coefficients 1,2,1 --solvers odd", "bernstein");
  expect("solve --coefficients 1,2,1 --solvers ferrari", "degree 2");
  expect("solve --coefficients 1,2,1 --format odd", "json");
  expect("odd", "");
  expect("trace", "");
}

TEST(ProgramTest, SolvePutsAPolynomialThroughEverything) {
  const Outcome outcome = lamina("solve --coefficients=1/4,-1,1 --interval 0,1 --format json");
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const Json all = Json::parse(outcome.out);
  std::set<std::pair<std::string, std::string>> seen;
  for (const Json& result : all.at("results")) {
    const auto solver = result.at("solver").get<std::string>();
    const auto number = result.at("number").get<std::string>();
    seen.emplace(solver, number);
    for (const Json& root : result.at("roots")) {
      EXPECT_NEAR(root.at("value").get<double>(), 0.5, 0.1) << solver << " " << number;
      EXPECT_TRUE(root.at("multiplicity").is_null() || root.at("multiplicity").is_number());
    }
    if (solver == "exact" || solver == "kahan") {
      ASSERT_EQ(result.at("roots").size(), 1U) << solver << " " << number;
      EXPECT_EQ(result.at("roots")[0].at("value"), 0.5);
      EXPECT_EQ(result.at("roots")[0].at("multiplicity"), 2);
    }
    if (solver == "certified") {
      EXPECT_EQ(result.at("outcome"), "undecided");
    }
  }
  EXPECT_TRUE(seen.contains({"exact", "exact"}));
  EXPECT_TRUE(seen.contains({"sturm", "bin237"}));
  EXPECT_FALSE(seen.contains({"ferrari", "double"}));

  // The square root of two is alone in the bounds that are given for it.
  const Json surd = Json::parse(
      lamina("solve --coefficients=-2,0,1 --solvers exact --numbers exact --format json").out);
  const Json& roots = surd.at("results").at(0).at("roots");
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_EQ(roots[1].at("value"), std::sqrt(2.0));
  const auto end = [&roots](std::size_t i) {
    return number::parse_rational(roots[1].at("isolating")[i].get<std::string>());
  };
  EXPECT_LT(end(0) * end(0), 2);
  EXPECT_GT(end(1) * end(1), 2);
  EXPECT_GT(end(0), 0);

  const Outcome everywhere = lamina("solve --coefficients 0,0,0 --format json");
  const Json each = Json::parse(everywhere.out);
  for (const Json& result : each.at("results")) {
    EXPECT_EQ(result.at("outcome"), "everywhere");
  }
  EXPECT_NE(lamina("solve --coefficients=-6,11,-6,1 --numbers double").out.find("kahan-cubic"),
            std::string::npos);
}

TEST(ProgramTest, HelpTeachesAndListsAreComplete) {
  for (const char* command :
       {"trace", "locate", "explain", "census", "run", "solve", "table", "list"}) {
    const Outcome help = lamina(std::string(command) + " --help");
    EXPECT_EQ(help.status, 0);
    EXPECT_GT(help.out.size(), 100U) << command;
  }
  EXPECT_EQ(lamina("--version").status, 0);
  EXPECT_NE(lamina("--version").out.find("lamina 0."), std::string::npos);
  EXPECT_NE(lamina("list numbers").out.find("mpfr50"), std::string::npos);
  EXPECT_NE(lamina("list methods").out.find("wyvill-trotman"), std::string::npos);
  EXPECT_NE(lamina("list experiments").out.find("coincident-faces"), std::string::npos);
  EXPECT_NE(lamina("list solvers").out.find("ferrari"), std::string::npos);
}

TEST(ProgramTest, RenderWritesAPictureAndTheMapOfItsArtifacts) {
  const Scratch scratch;
  const std::string scene = LAMINA_SOURCE_DIR "/data/scenes/figure14_sphere.csg";
  const auto render = [&](const std::string& name, const std::string& options) {
    return lamina("render " + scene + " -o " + scratch.path(name) + " --size 40x30 " + options);
  };
  const Outcome one = render("one.png", "--threads 1 --method roth");
  ASSERT_EQ(one.status, 0) << one.error;
  EXPECT_EQ(one.out, "");
  const Outcome three = render("three.png", "--threads 3 --method roth --format json --artifacts " +
                                                scratch.path("map.png"));
  ASSERT_EQ(three.status, 0) << three.error;
  EXPECT_EQ(read(scratch.path("one.png")), read(scratch.path("three.png")));
  EXPECT_TRUE(read(scratch.path("map.png")).starts_with("\x89PNG"));
  EXPECT_NE(read(scratch.path("map.png")), read(scratch.path("one.png")));
  const Json table = Json::parse(three.out);
  const auto& rows = table.contains("tables") ? table["tables"][0]["rows"] : table["rows"];
  EXPECT_EQ(rows.size(), 7U);
}

TEST(ProgramTest, ConvertWritesTheSameScene) {
  const Scratch scratch;
  const std::string glass = LAMINA_SOURCE_DIR "/data/scenes/hashimoto_figure2.csg";
  const Outcome printed = lamina("convert " + glass);
  ASSERT_EQ(printed.status, 0) << printed.error;
  // 25 quadrics and a torus, of a paper; the table and the wall are planes.
  const auto count = [&printed](const std::string& node) {
    std::size_t found = 0;
    for (auto at = printed.out.find(node); at != std::string::npos;
         at = printed.out.find(node, at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("quadric(") + count("infinite_cylinder("), 25U);
  EXPECT_EQ(count("torus("), 1U);
  ASSERT_EQ(lamina("convert " + glass + " -o " + scratch.path("glass.csg")).status, 0);
  EXPECT_EQ(read(scratch.path("glass.csg")), printed.out);
  const std::string rays = scratch.write("rays", "4 -38 18 -4 38 -10\n0 -9 8 1/100 1 0\n");
  const Outcome traced = lamina("trace " + scratch.path("glass.csg") + " --truth --rays " + rays);
  EXPECT_EQ(traced.status, 0) << traced.error;
  EXPECT_EQ(traced.out, lamina("trace " + glass + " --truth --rays " + rays).out);
  EXPECT_EQ(lamina("convert " + glass + " -o /nowhere/x.csg").status, 2);
}

TEST(ProgramTest, RenderSaysWhatItCannotDo) {
  const Scratch scratch;
  const std::string figure = LAMINA_SOURCE_DIR "/data/scenes/figure14_box.csg";
  const std::string out = " -o " + scratch.path("x.png");
  const auto expect = [&](const std::string& arguments, const std::string& message) {
    const Outcome outcome = lamina("render " + arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.error.find(message), std::string::npos) << outcome.error;
  };
  expect(scratch.write("bare.csg", "sphere(1);") + out, "camera(eye=");
  expect(figure + out + " --number exact", "rounded number type");
  expect(figure + out + " --spawn far", "leaf-state");
  expect(figure + out + " --size 0x5", "WxH");
  expect(figure + " -o /nowhere/x.png", "/nowhere/x.png");
}

}  // namespace
}  // namespace lamina::test
