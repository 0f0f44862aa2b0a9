#include "scene/families.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/seeded_stream.hpp"
#include "method/locate.hpp"
#include "scene/rays.hpp"
#include "support/scenes.hpp"

namespace lamina::scene {
namespace {

using number::Rational;
using Point = geometry::Vector3<double>;

const std::vector<std::string> kFamilies{"coincident-faces",
                                         "ghost-cylinders",
                                         "self-sum:box:same",
                                         "self-sum:box:scaled",
                                         "self-sum:cylinder:same",
                                         "self-sum:cylinder:scaled",
                                         "self-sum:cone:same",
                                         "self-sum:cone:scaled",
                                         "self-sum:sphere:same",
                                         "self-sum:sphere:scaled",
                                         "self-sum:torus:same",
                                         "self-sum:torus:scaled",
                                         "self-difference:box:same",
                                         "self-difference:cylinder:same",
                                         "self-difference:cone:same",
                                         "self-difference:sphere:same",
                                         "self-difference:box:scaled",
                                         "self-difference:cylinder:scaled",
                                         "self-difference:cone:scaled",
                                         "self-difference:sphere:scaled",
                                         "touching-stack:5",
                                         "thin-wall",
                                         "slab:1e-3",
                                         "gap:1/7",
                                         "four-cases:i:1e-3",
                                         "four-cases:ii:1e-3",
                                         "four-cases:iii:1e-3",
                                         "four-cases:iv:1e-3",
                                         "far-origin:translated:6",
                                         "far-origin:scaled:-3",
                                         "cleared-face",
                                         "glass-stack:3",
                                         "unclosed:cylinder",
                                         "unclosed:cone",
                                         "unclosed:slab",
                                         "same-medium:left:3",
                                         "same-medium:right:3",
                                         "same-medium:flat:3",
                                         "single:box:0",
                                         "single:cylinder:3",
                                         "single:cone:-2",
                                         "single:ball:6",
                                         "single:ring:0",
                                         "distant-ball:0",
                                         "distant-ball:3",
                                         "bubble:plain",
                                         "bubble:doubled",
                                         "well:plain",
                                         "well:doubled",
                                         "cube-corner:plain",
                                         "cube-corner:doubled",
                                         "plates:3",
                                         "onion:3",
                                         "round:ball",
                                         "round:ring",
                                         "round:cut-ring",
                                         "sweep-sum:translational:same",
                                         "sweep-sum:conic:mirrored",
                                         "sweep-sum:rotational:scaled",
                                         "sweep-difference:translational:scaled",
                                         "sweep-difference:conic:same",
                                         "sweep-difference:rotational:mirrored",
                                         "sweep-halves:translational",
                                         "sweep-halves:conic",
                                         "sweep-halves:rotational",
                                         "jointed-glass"};

// The material at a point, "" for none, `boundary` on the boundary.
std::string material_at(const Scene& scene, const Point& p) {
  const method::Location location =
      method::locate_exact(scene, {Rational(p.x), Rational(p.y), Rational(p.z)});
  return location.boundary ? "boundary" : scene.materials[location.medium].name;
}

Point point_between(base::SeededStream& stream, const Point& low, const Point& high) {
  const double x = stream.uniform(low.x, high.x);
  const double y = stream.uniform(low.y, high.y);
  return {x, y, stream.uniform(low.z, high.z)};
}

TEST(FamiliesTest, EveryFamilyIsTriedHere) {
  std::set<std::string> known;
  for (const Family& family : families()) {
    EXPECT_FALSE(family.about.empty()) << family.name;
    EXPECT_TRUE(known.insert(family.name).second) << family.name;
  }
  std::set<std::string> tried;
  for (const std::string& family : kFamilies) {
    tried.insert(family.substr(0, family.find(':')));
  }
  EXPECT_EQ(tried, known);
}

TEST(FamiliesTest, MembersAreReadByTheirSpelling) {
  for (const std::string& family : kFamilies) {
    const std::string spelling = family_spelling(family, 3, 4);
    EXPECT_EQ(spelling, "family:" + family + ":3:4");
    const Scene opened = open_scene(spelling);
    EXPECT_EQ(opened.name, spelling);
    EXPECT_FALSE(opened.leaves.empty()) << spelling;
    EXPECT_TRUE(opened.warnings.empty()) << spelling;
    const Scene read = support::scene_of(family_member(family, 3, 4).text);
    EXPECT_EQ(opened.carriers, read.carriers) << spelling;
  }
}

TEST(FamiliesTest, MembersAreTheSameForTheSameSeedAndDifferBetweenCases) {
  constexpr std::uint64_t kCases = 12;
  for (const std::string& family : kFamilies) {
    std::set<std::string> by_case;
    std::set<std::string> by_seed;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      const FamilyMember member = family_member(family, 1, i);
      const FamilyMember again = family_member(family, 1, i);
      EXPECT_EQ(member.text, again.text) << family;
      EXPECT_EQ(member.place({1, 2, 3}), again.place({1, 2, 3})) << family;
      EXPECT_EQ(member.patches.size(), again.patches.size()) << family;
      by_case.insert(member.text);
      by_seed.insert(family_member(family, i, 1).text);
    }
    EXPECT_GE(by_case.size(), kCases - 2) << family;
    EXPECT_GE(by_seed.size(), kCases - 2) << family;
  }
}

// Of the families on the plane n.p = 7, n = (1, 2, 3): leaves that share it, and what is `up`
// times n above a point of it.
std::size_t leaves_on_the_plane(const Scene& scene) {
  std::size_t most = 0;
  for (std::size_t c = 0; c < scene.carriers.size(); ++c) {
    if (scene.carriers[c].coefficients == std::vector<number::Integer>{1, 2, 3, -7}) {
      most = scene.leaves_of_carrier[c].size();
    }
  }
  return most;
}

std::string above_the_plane(const Scene& scene, const Point& on_plane, double up) {
  return material_at(scene, on_plane + up * Point{1, 2, 3});
}

TEST(FamiliesTest, AClearedFaceHasNothingAboveIt) {
  for (std::uint64_t i = 0; i < 8; ++i) {
    const Scene scene = open_scene(family_spelling("cleared-face", 1, i));
    EXPECT_EQ(leaves_on_the_plane(scene), 2u);
    // In the plane under the ball, and aside of it.
    for (const Point& p : {Point{0.5, 1, 1.5}, Point{2.5, 0, 1.5}}) {
      EXPECT_EQ(above_the_plane(scene, p, -0.01), "A");
      for (const double up : {0.01, 0.2, 0.25, 0.3, 0.9}) {
        EXPECT_EQ(above_the_plane(scene, p, up), "");
      }
    }
  }
}

TEST(FamiliesTest, AGlassStackHasItsTopsInOnePlane) {
  const Scene scene = open_scene(family_spelling("glass-stack:4", 1, 2));
  EXPECT_EQ(leaves_on_the_plane(scene), 4u);
  EXPECT_EQ(above_the_plane(scene, {0.5, 1, 1.5}, 0.01), "");
  EXPECT_EQ(above_the_plane(scene, {0.5, 1, 1.5}, -0.01), "glass4");
  std::set<std::string> met;
  for (int i = 1; i < 64; ++i) {
    met.insert(above_the_plane(scene, {0.5, 1, 1.5}, -i / 64.0));
  }
  EXPECT_TRUE(met.count("glass4") == 1 && met.count("") == 1);
  for (const Material& material : scene.materials) {
    EXPECT_TRUE(material.name.empty() || !material.opaque());
  }
}

std::string error_of(const std::string& spelling) {
  try {
    open_scene(spelling);
    return "";
  } catch (const base::InputError& error) {
    return error.what();
  }
}

TEST(FamiliesTest, ErrorsListWhatThereIs) {
  const auto expect_error = [](const std::string& spelling, const std::vector<std::string>& parts) {
    const std::string error = error_of(spelling);
    EXPECT_TRUE(error.starts_with("scene '" + spelling + "': ")) << error;
    for (const std::string& part : parts) {
      EXPECT_NE(error.find(part), std::string::npos) << part << " is not in\n" << error;
    }
  };
  std::vector<std::string> names;
  for (const Family& family : families()) {
    names.push_back("\n  " + family.name + family.parameters + " ");
    names.push_back(family.about);
  }
  expect_error("family:nothing:1:2", names);
  expect_error("family:slab:1:2", names);
  expect_error("family:thin-wall:1:1:2", names);
  expect_error("family:self-difference:box:1:2", names);
  for (const char* spelling :
       {"family:", "family:thin-wall", "family:thin-wall:1", "family:thin-wall:x:1",
        "family:thin-wall:1:-1", "family:thin-wall:1:1.5",
        "family:thin-wall:1:", "family:thin-wall:1:99999999999999999999"}) {
    expect_error(spelling, {"family:FAMILY:SEED:CASE"});
  }
  expect_error("family:self-sum:pyramid:same:1:0",
               {"'pyramid'", "box, cylinder, cone, sphere, torus"});
  expect_error("family:self-sum:box:other:1:0", {"'other'", "same, scaled"});
  expect_error("family:round:cube:1:0", {"'cube'", "ball, ring"});
  expect_error("family:self-difference:torus:same:1:0", {"box, cylinder, cone, sphere"});
  expect_error("family:self-difference:box:other:1:0", {"'other'", "same, scaled"});
  expect_error("family:four-cases:v:1/9:1:0", {"'v'", "i, ii, iii, iv"});
  expect_error("family:unclosed:sphere:1:0", {"cylinder, cone, slab"});
  expect_error("family:far-origin:turned:1:1:0", {"translated, scaled"});
  expect_error("family:far-origin:scaled:31:1:0", {"'31'", "from -30 to 30"});
  expect_error("family:sweep-sum:cubic:same:1:0", {"translational, conic, rotational"});
  expect_error("family:sweep-sum:conic:other:1:0", {"same, mirrored, scaled"});
  expect_error("family:slab:0:1:0", {"'0'", "above 0"});
  expect_error("family:gap:-1:1:0", {"'-1'", "above 0"});
  expect_error("family:slab:thick:1:0", {"thick"});
  for (const char* count : {"0", "1.5", "100001"}) {
    expect_error("family:touching-stack:" + std::string(count) + ":1:0",
                 {"'" + std::string(count) + "'", "a whole number from 1 to 100000"});
  }
}

// A family whose solid is known in its own coordinates.
struct Known {
  std::string family;
  Point low;
  Point high;
  std::function<std::string(const Point&)> material;
};

double squared(const Point& p) { return dot(p, p); }

bool in_box(const Point& p, const Point& low, const Point& high) {
  return low.x < p.x && p.x < high.x && low.y < p.y && p.y < high.y && low.z < p.z && p.z < high.z;
}

std::vector<Known> known_families() {
  const auto plain = [](auto inside) {
    return [inside](const Point& p) -> std::string { return inside(p) ? "default" : ""; };
  };
  std::vector<Known> all{
      {"round:ring", {-1.4, -1.4, -0.4}, {1.4, 1.4, 0.4}, plain([](const Point& p) {
         const double off = std::hypot(p.x, p.y) - 1;
         return off * off + p.z * p.z < 0.0625;
       })},
      {"round:cut-ring",
       {-1.3, -1.3, -0.2},
       {1.3, 1.3, 0.5},
       [](const Point& p) -> std::string {
         const double off = std::hypot(p.x, p.y) - 1;
         if (off * off + p.z * p.z < 0.0625) {
           return p.x + 2 * p.y + 3 * p.z < 1.0 / 7 ? "" : "steel";
         }
         return squared(p) < 1 ? "glass" : "";
       }},
      {"round:ball", {-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}, plain([](const Point& p) {
         return squared(p) < 1;
       })},
      {"thin-wall", {-2.2, -2.2, -2.2}, {2.2, 2.2, 2.2}, plain([](const Point& p) {
         return squared(p) < 4 && squared(p - Point{0, 0, 0.5}) > 2.25;
       })},
      {"slab:1/8", {-55, -55, -0.1}, {55, 55, 0.2}, plain([](const Point& p) {
         return in_box(p, {-50, -50, 0}, {50, 50, 0.125});
       })},
      {"gap:1/8",
       {-55, -55, -1.2},
       {55, 55, 1.4},
       [](const Point& p) -> std::string {
         return in_box(p, {-50, -50, -1}, {50, 50, 0})          ? "lower"
                : in_box(p, {-50, -50, 0.125}, {50, 50, 1.125}) ? "upper"
                                                                : "";
       }},
      {"unclosed:slab", {-9, -9, -1.5}, {9, 9, 1.5}, plain([](const Point& p) {
         return -1 < p.z && p.z < 1;
       })},
      {"unclosed:cylinder", {-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}, plain([](const Point& p) {
         return p.x * p.x + p.y * p.y < 1 && -1 < p.z && p.z < 1;
       })},
      {"unclosed:cone", {-2.2, -2.2, -1.2}, {2.2, 2.2, 1.2}, plain([](const Point& p) {
         return std::hypot(p.x, p.y) < 1 - p.z && -1 < p.z && p.z < 1;
       })},
      {"touching-stack:5", {-0.1, -0.1, -0.5}, {1.1, 1.1, 5.5}, [](const Point& p) -> std::string {
         return !in_box(p, {0, 0, 0}, {1, 1, 5})             ? ""
                : static_cast<int>(std::floor(p.z)) % 2 == 0 ? "even"
                                                             : "odd";
       }}};
  const auto beside = [&](const std::string& name, const Point& reach, auto inside) {
    all.push_back({name, {-reach.x, -reach.y, -reach.z}, reach, plain(inside)});
  };
  const auto ball = [](const Point& p) { return squared(p) < 1; };
  beside("single:ball:1", {1.2, 1.2, 1.2}, ball);
  beside("single:box:-1", {1.2, 1.2, 1.2}, [](const Point& p) {
    return in_box(p, {-1, -1, -1}, {1, 1, 1});
  });
  beside("single:cylinder:0", {1.2, 1.2, 1.2},
         [](const Point& p) { return std::hypot(p.x, p.y) < 1 && -1 < p.z && p.z < 1; });
  beside("single:cone:0", {1.2, 1.2, 1.2},
         [](const Point& p) { return std::hypot(p.x, p.y) < (1 - p.z) / 2 && -1 < p.z; });
  beside("single:ring:0", {1.4, 1.4, 0.4}, [](const Point& p) {
    const double off = std::hypot(p.x, p.y) - 1;
    return off * off + p.z * p.z < 0.0625;
  });
  beside("distant-ball:0", {1.2, 1.2, 1.2}, ball);
  beside("distant-ball:4", {1.2, 1.2, 1.2}, ball);
  for (const std::string how : {"plain", "doubled"}) {
    beside("bubble:" + how, {2.2, 2.2, 2.2}, [ball](const Point& p) {
      return in_box(p, {-2, -2, -2}, {2, 2, 2}) && !ball(p);
    });
    beside("well:" + how, {2, 2, 44}, [](const Point& p) {
      return in_box(p, {-1.5, -1.5, -1}, {1.5, 1.5, 40}) &&
             !in_box(p, {-0.5, -0.5, 0}, {0.5, 0.5, 50});
    });
    beside("cube-corner:" + how, {2, 2, 2}, [](const Point& p) {
      return in_box(p, {-1, -1, -1}, {5, 5, 5}) && !in_box(p, {0, 0, 0}, {9, 9, 9});
    });
  }
  all.push_back({"plates:3", {-3, -3, -0.5}, {3, 3, 3.5}, [](const Point& p) -> std::string {
                   return p.z < 0 || p.z > 3 ? ""
                                             : "glass" + std::to_string(1 + static_cast<int>(p.z));
                 }});
  all.push_back({"onion:2", {-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}, [](const Point& p) -> std::string {
                   const double radius = std::sqrt(squared(p));
                   return radius > 2 ? "" : radius > 1 ? "glass1" : "glass2";
                 }});
  // B's lowest and highest z for surfaces 1/8 apart; what is above A does not matter.
  const std::map<std::string, std::pair<double, double>> cut{
      {"i", {1.125, 2}}, {"ii", {0.875, 2}}, {"iii", {0.4, 2}}, {"iv", {0.4, 0.875}}};
  for (const auto& [which, range] : cut) {
    all.push_back(
        {"four-cases:" + which + ":1/8",
         {-0.1, -0.1, -0.1},
         {2.1, 2.1, 1.9},
         [range = range](const Point& p) -> std::string {
           const bool in_b = in_box(p, {1.0 / 3, 0.5, range.first}, {5.0 / 3, 1.5, range.second});
           return in_box(p, {0, 0, 0}, {2, 2, 1}) && !in_b ? "A" : "";
         }});
  }
  return all;
}

TEST(FamiliesTest, PlaceTakesTheSolidWhereTheTextPutsIt) {
  constexpr double kNear = 1e-6;
  for (const Known& known : known_families()) {
    std::map<std::string, int> met;
    for (std::uint64_t case_id = 0; case_id < 6; ++case_id) {
      const FamilyMember member = family_member(known.family, 2, case_id);
      const Scene scene = support::scene_of(member.text);
      base::SeededStream stream("families_test/" + known.family, 1, case_id);
      for (int i = 0; i < 40; ++i) {
        const Point p = point_between(stream, known.low, known.high);
        const std::string material = known.material(p);
        const auto same = [&](const Point& off) { return known.material(p + off) == material; };
        if (same({kNear, 0, 0}) && same({-kNear, 0, 0}) && same({0, kNear, 0}) &&
            same({0, -kNear, 0}) && same({0, 0, kNear}) && same({0, 0, -kNear})) {
          EXPECT_EQ(material_at(scene, member.place(p)), material)
              << known.family << " " << case_id << ": " << p.x << " " << p.y << " " << p.z;
          ++met[material];
        }
      }
    }
    EXPECT_GE(met.size(), 2U) << known.family;
    for (const auto& [material, times] : met) {
      EXPECT_GE(times, 10) << known.family << " " << material;
    }
  }
}

// Between two points of different materials there is a surface: found by halving to a
// millionth, it is there in the scene, too.
TEST(FamiliesTest, SurfacesAreWherePlaceSays) {
  for (const Known& known : known_families()) {
    int found = 0;
    for (std::uint64_t case_id = 0; case_id < 6; ++case_id) {
      const FamilyMember member = family_member(known.family, 3, case_id);
      const Scene scene = support::scene_of(member.text);
      base::SeededStream stream("families_test/surface/" + known.family, 1, case_id);
      for (int i = 0; i < 20; ++i) {
        Point a = point_between(stream, known.low, known.high);
        Point b = point_between(stream, known.low, known.high);
        if (known.material(a) == known.material(b)) {
          continue;
        }
        while (squared(a - b) > 1e-12) {
          const Point middle = 0.5 * (a + b);
          (known.material(middle) == known.material(a) ? a : b) = middle;
        }
        EXPECT_EQ(material_at(scene, member.place(a)), known.material(a)) << known.family;
        EXPECT_EQ(material_at(scene, member.place(b)), known.material(b)) << known.family;
        ++found;
      }
    }
    EXPECT_GE(found, 20) << known.family;
  }
}

// Moved or scaled, a point is in what it was in before.
TEST(FamiliesTest, PlaceGoesWithWhatIsFarFromTheOrigin) {
  for (const char* how : {"translated:3", "scaled:3", "scaled:-3"}) {
    std::map<std::string, int> met;
    for (std::uint64_t case_id = 0; case_id < 10; ++case_id) {
      const FamilyMember near = coincident_faces(5, case_id);
      const FamilyMember far = family_member(std::string("far-origin:") + how, 5, case_id);
      const Scene near_scene = support::scene_of(near.text);
      const Scene far_scene = support::scene_of(far.text);
      base::SeededStream stream("families_test/far", 1, case_id);
      for (int i = 0; i < 20; ++i) {
        const Point p = point_between(stream, {-3, -3, -3}, {3, 3, 3});
        const std::string material = material_at(near_scene, near.place(p));
        EXPECT_EQ(material_at(far_scene, far.place(p)), material) << how << " " << case_id;
        ++met[material];
      }
      // What is in the middle of a patch near the origin is there far from it, too.
      ASSERT_EQ(far.patches.size(), near.patches.size());
      for (std::size_t i = 0; i < near.patches.size(); ++i) {
        const auto beside = [](const FamilyMember& member, const FamilyMember::Patch& patch,
                               double z) {
          return patch.corner + 0.5 * patch.side1 + 0.5 * patch.side2 +
                 z * (member.place({0, 0, 1}) - member.place({0, 0, 0}));
        };
        for (const double z : {-0.01, 0.01}) {
          EXPECT_EQ(material_at(far_scene, beside(far, far.patches[i], z)),
                    material_at(near_scene, beside(near, near.patches[i], z)))
              << how << " " << case_id;
        }
      }
    }
    EXPECT_GE(met.size(), 3U) << how;
  }
}

TEST(FamiliesTest, TheTopsOfGhostCylindersAreTheirPatches) {
  for (std::uint64_t case_id = 0; case_id < 20; ++case_id) {
    const FamilyMember member = ghost_cylinders(4, case_id);
    const Scene scene = support::scene_of(member.text);
    ASSERT_EQ(member.patches.size(), 2U);
    const Point up = 1e-6 * (member.place({0, 0, 1}) - member.place({0, 0, 0}));
    base::SeededStream stream("families_test/ghost", 1, case_id);
    const std::array<std::string, 2> owners{"a", "b"};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& patch = member.patches[i];
      for (int k = 0; k < 5; ++k) {
        const double u = stream.uniform(0.01, 0.99);
        const double v = stream.uniform(0.01, 0.99);
        const Point p = patch.corner + u * patch.side1 + v * patch.side2;
        EXPECT_EQ(material_at(scene, p - up), owners[i]) << case_id;
        EXPECT_EQ(material_at(scene, p + up), "") << case_id;
      }
    }
  }
}

TEST(FamiliesTest, ThePatchOfTheFourCasesIsTheTopOfAOverB) {
  for (std::uint64_t case_id = 0; case_id < 6; ++case_id) {
    const auto expect_around = [case_id](const char* family, const char* below, const char* above) {
      const FamilyMember member = family_member(family, 4, case_id);
      const Scene scene = support::scene_of(member.text);
      ASSERT_EQ(member.patches.size(), 1U);
      const auto& patch = member.patches[0];
      const Point up = 1e-6 * (member.place({0, 0, 1}) - member.place({0, 0, 0}));
      for (const auto& [u, v] : {std::pair{0.01, 0.01}, {0.99, 0.01}, {0.5, 0.5}, {0.01, 0.99}}) {
        const Point p = patch.corner + u * patch.side1 + v * patch.side2;
        EXPECT_EQ(material_at(scene, p - up), below) << family;
        EXPECT_EQ(material_at(scene, p + up), above) << family;
      }
    };
    expect_around("four-cases:i:1/8", "A", "");
    expect_around("four-cases:iv:1/8", "A", "");
    expect_around("four-cases:ii:1/8", "", "");
    expect_around("four-cases:iii:1/8", "", "");
  }
}

// The second solid is where the first is, from other numbers, and covers it.
TEST(FamiliesTest, OfASelfSumTheFirstIsNeverSeen) {
  for (const char* solid : {"box", "cylinder", "cone", "sphere", "torus"}) {
    for (const char* second : {":same", ":scaled"}) {
      const std::string family = std::string("self-sum:") + solid + second;
      std::map<std::string, int> met;
      for (std::uint64_t case_id = 0; case_id < 8; ++case_id) {
        const Scene scene = open_scene(family_spelling(family, 6, case_id));
        EXPECT_EQ(scene.carriers.size() * 2, scene.leaves.size()) << family;
        base::SeededStream stream("families_test/self-sum", 1, case_id);
        for (int i = 0; i < 20; ++i) {
          ++met[material_at(scene, point_in(*scene.bounds, stream))];
        }
      }
      EXPECT_EQ(met.count("first"), 0U) << family;
      EXPECT_GE(met["second"], 5) << family;
      EXPECT_GE(met[""], 5) << family;
    }
  }
}

TEST(FamiliesTest, OfASelfDifferenceNothingIsLeft) {
  for (const char* solid : {"box", "cylinder", "cone", "sphere"}) {
    for (const char* equation : {":same", ":scaled"}) {
      const std::string family = std::string("self-difference:") + solid + equation;
      int both = 0;
      for (std::uint64_t case_id = 0; case_id < 6; ++case_id) {
        const FamilyMember member = family_member(family, 6, case_id);
        const Scene scene = support::scene_of(member.text);
        EXPECT_EQ(scene.carriers.size() * 2, scene.leaves.size()) << family;
        std::string sum = member.text;
        sum.replace(sum.find("difference"), std::string("difference").size(), "add");
        const Scene added = support::scene_of(sum);
        base::SeededStream stream("families_test/self-difference", 1, case_id);
        for (int i = 0; i < 20; ++i) {
          const Point p = member.place(point_between(stream, {-2, -2, -2}, {2, 2, 2}));
          EXPECT_EQ(material_at(scene, p), "") << family;
          both += material_at(added, p) == "default" ? 1 : 0;
        }
      }
      EXPECT_GE(both, 10) << family;
    }
  }
}

}  // namespace
}  // namespace lamina::scene
