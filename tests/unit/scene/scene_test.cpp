// Whole scenes: the figures, real OpenSCAD models with their answers, and damaged texts.
#include "scene/scene.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/seeded_stream.hpp"
#include "support/corpus.hpp"
#include "support/scenes.hpp"

namespace lamina::scene {
namespace {

using support::material_at;

std::string file_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".csg") {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::filesystem::path figures_folder() {
  return std::filesystem::path(LAMINA_SOURCE_DIR) / "data" / "scenes";
}

struct Refused {
  const char* model;
  const char* place;
  const char* node;
};
constexpr std::array kRefused{Refused{"bosl2_masks_ex145", "387:79", "polyhedron"},
                              Refused{"dankamongmen_face", "5:4", "linear_extrude"},
                              Refused{"dankamongmen_protium_holder", "7:6", "multmatrix"},
                              Refused{"oscex_example017", "6:6", "difference"},
                              Refused{"scottbez1_pcb", "5:5", "difference"}};

class CorpusTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto folder = support::corpus_folder();
    if (!folder) {
      GTEST_SKIP() << support::kNoCorpus;
    }
    folder_ = *folder;
  }

  [[nodiscard]] std::filesystem::path file(const std::string& model, const char* extension) const {
    return folder_ / (model + extension);
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(CorpusTest, ReadsItsModels) {
  for (const char* model : support::kReadableModels) {
    const Scene scene = read_scene(file(model, ".csg").string());
    EXPECT_FALSE(scene.tree.empty()) << model;
    // One of them has a cube of size zero.
    EXPECT_EQ(scene.warnings.size(), model == std::string("jsconan_sample_sample") ? 1U : 0U)
        << model;
    EXPECT_EQ(scene.tree.leaf_count(), scene.leaves.size()) << model;
  }
}

TEST_F(CorpusTest, NamesTheFirstNodeThatIsNotSupported) {
  for (const Refused& refused : kRefused) {
    const std::string path = file(refused.model, ".csg").string();
    try {
      read_scene(path);
      ADD_FAILURE() << "read " << path;
    } catch (const base::InputError& error) {
      const std::string start = path + ":" + refused.place + ": `" + refused.node + "`: ";
      EXPECT_TRUE(std::string(error.what()).starts_with(start)) << error.what();
    }
  }
}

// Points of the faceted models, inside or outside by a computation that shares nothing with
// this program. Points on a plane of the model are left to the tests of regularization.
TEST_F(CorpusTest, FacetsAsOpenScadDoes) {
  constexpr std::size_t kPointsOfAModel = 25;
  std::size_t points = 0;
  for (const char* model : support::kReadableModels) {
    const Scene scene = read_scene(file(model, ".csg").string(), {.facets = true});
    const nlohmann::json truth = nlohmann::json::parse(file_text(file(model, ".json")));
    const nlohmann::json& listed = truth.at("points");
    const std::size_t step = std::max<std::size_t>(1, listed.size() / kPointsOfAModel);
    for (std::size_t i = 0; i < listed.size(); i += step) {
      const nlohmann::json& point = listed[i];
      const auto coordinate = [&](std::size_t k) {
        return number::parse_rational(point[k].dump());  // the decimals as they are written
      };
      const auto material = material_at(scene, {coordinate(0), coordinate(1), coordinate(2)});
      if (material) {
        EXPECT_EQ(!material->empty(), point[3] != 0) << model << " " << point;
        ++points;
      }
    }
  }
  EXPECT_GT(points, kPointsOfAModel * support::kReadableModels.size() * 9 / 10);
}

TEST(FigureTest, AllAreReadWithoutWarnings) {
  const auto figures = scenes_in(figures_folder());
  EXPECT_GE(figures.size(), 28U);
  for (const auto& path : figures) {
    const Scene scene = read_scene(path.string());
    EXPECT_FALSE(scene.leaves.empty()) << path;
    EXPECT_TRUE(scene.camera.has_value()) << path;
    EXPECT_FALSE(scene.lights.empty()) << path;
    EXPECT_TRUE(scene.warnings.empty()) << path;
    const std::string text = file_text(path);
    EXPECT_TRUE(text.starts_with("// Wyvill and Trotman 1990, Figure ") ||
                text.starts_with("// van Wijk 1984, section ") ||
                text.starts_with("// Van Wijk 1984, Figure ") ||
                text.starts_with("// Hashimoto and Suenaga, Figure "))
        << path;
  }
}

TEST(FigureTest, CoincidentFacesShareACarrier) {
  const auto shared = [](const std::string& figure) {
    const Scene scene = read_scene((figures_folder() / (figure + ".csg")).string());
    return std::count_if(scene.leaves_of_carrier.begin(), scene.leaves_of_carrier.end(),
                         [](const auto& leaves) { return leaves.size() > 1; });
  };
  EXPECT_EQ(shared("figure02"), 6);
  EXPECT_EQ(shared("figure03"), 6);
  EXPECT_EQ(shared("figure04"), 1);
  EXPECT_EQ(shared("figure06"), 1);
  EXPECT_EQ(shared("figure07"), 1);
  EXPECT_EQ(shared("figure09"), 0);
  EXPECT_EQ(shared("figure12a") + shared("figure12b") + shared("figure12c") + shared("figure12d"),
            0);
  EXPECT_EQ(shared("figure14_box"), 6);
  EXPECT_EQ(shared("figure14_sphere"), 1);
  EXPECT_EQ(shared("figure14_cylinder"), 3);
  EXPECT_EQ(shared("figure14_cone"), 3);
  EXPECT_EQ(shared("figure14_torus"), 1);
  EXPECT_EQ(shared("figure15"), 1);
}

TEST(ReadSceneTest, NamesAFileThatCannotBeRead) {
  for (const std::string path : {"/nonexistent/scene.csg", "/"}) {
    try {
      read_scene(path);
      ADD_FAILURE() << "read " << path;
    } catch (const base::InputError& error) {
      EXPECT_EQ(std::string(error.what()), path + ": the file cannot be read");
    }
  }
}

// One to four places of the text changed: bytes replaced, dropped, repeated or made syntax.
std::string damaged(std::string text, base::SeededStream& stream) {
  using namespace std::string_view_literals;
  constexpr std::string_view kSyntax = "(){}[]\"/*%!#;,.=-e0123456789\\\n\t\0\xFF"sv;
  const std::uint64_t changes = 1 + stream.below(4);
  for (std::uint64_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = stream.below(text.size());
    switch (stream.below(4)) {
      case 0:
        text[at] = static_cast<char>(stream.below(256));
        break;
      case 1:
        text.erase(at, 1 + stream.below(5));
        break;
      case 2: {
        const std::size_t from = stream.below(text.size());
        text.insert(at, text.substr(from, stream.below(30)));
      } break;
      default:
        text[at] = kSyntax[stream.below(kSyntax.size())];
    }
  }
  return text;
}

TEST(DamagedSceneTest, IsReadOrRefusedButNeverBreaksTheProgram) {
  std::vector<std::string> texts;
  for (const auto& path : scenes_in(figures_folder())) {
    texts.push_back(file_text(path));
  }
  std::size_t read = 0;
  std::size_t refused = 0;
  for (std::uint64_t case_id = 0; case_id < 1000; ++case_id) {
    base::SeededStream stream("scene/damaged", 1, case_id);
    const std::string text = damaged(texts[stream.below(texts.size())], stream);
    try {
      parse_scene(text, "damaged", {.facets = stream.chance(0.1)});
      ++read;
    } catch (const base::InputError&) {
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "case " << case_id << ": " << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(read, 100U);
  EXPECT_GT(refused, 100U);
}

}  // namespace
}  // namespace lamina::scene
