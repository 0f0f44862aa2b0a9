// A synthetic method with known wrong answers, at known rates: every artifact is counted as
// what it is, and every interval covers its rate as often as it says.
#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <set>

#include "base/seeded_stream.hpp"
#include "census/census.hpp"
#include "census/statistics.hpp"
#include "report/census_table.hpp"
#include "support/scenes.hpp"
#include "support/synthetic_tracer.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using census::Artifact;
using census::Cause;
using geometry::ExactRay;
using method::Report;
using support::SyntheticTracer;

// A ray down from z = 5 meets, at t = 5 - z:
//   z = 3, 2   the planes of c, which is elsewhere: no interfaces
//   z = 1      from nothing into b; the top of a is in the same plane, and a elsewhere
//   z = 0      from b to nothing, likewise
//   z < 0      a sphere, into d and out of it: two crossings of one leaf
constexpr const char* kScene = R"(
  material("a") cube(1);
  material("b") translate([3, 0, 0]) cube(1);
  material("c") translate([9, 0, 2]) cube(1);
  material("d") translate([7/2, 1/2, -4]) sphere(2);)";
constexpr std::int64_t kRayGrid = 4096;  // rays are so many to a unit

ExactRay ray_of(std::size_t id) {
  return {{number::Rational(13, 4) + number::Rational(static_cast<std::int64_t>(id), kRayGrid),
           number::Rational(1, 2), 5},
          {0, 0, -1}};
}

std::size_t id_of(const ExactRay& ray) {
  return static_cast<std::size_t>(number::nearest_double(
      number::Rational((ray.origin.x - number::Rational(13, 4)) * kRayGrid)));
}

enum class Error {
  None,
  DropFirst,     ///< the first interface is not reported
  Ghost,         ///< c is shown where only its planes are
  OtherLeaf,     ///< the first interface is said to be of a's plane
  OtherMedium,   ///< the first interface is said to lead into a
  WrongFrom,     ///< the second interface is said to come from a
  LoseOwner,     ///< b's top is not found
  LoseOneOfTwo,  ///< the first crossing of the sphere is not found
  LoseBoth,      ///< neither of them
  NotAhead,      ///< b's top is found behind the start
  Inconsistent,  ///< one event is inconsistent
  WrongEnd,      ///< the ray is said to end in b
  DropBoth,      ///< b is not reported at all
};

// By definition of the artifacts: those that a ray with the error shows, and no other.
const std::map<Error, std::set<Artifact>>& shown_by() {
  static const std::map<Error, std::set<Artifact>> all{
      {Error::None, {}},
      {Error::DropFirst, {Artifact::FirstWrong, Artifact::MissedLogic, Artifact::Void}},
      {Error::Ghost, {Artifact::FirstWrong, Artifact::GhostHit, Artifact::GhostMaterial}},
      {Error::OtherLeaf, {Artifact::FirstWrong, Artifact::GhostSurface}},
      {Error::OtherMedium, {Artifact::FirstWrong, Artifact::WrongInterface, Artifact::WrongMedium}},
      {Error::WrongFrom, {Artifact::WrongInterface}},
      {Error::LoseOwner,
       {Artifact::FirstWrong, Artifact::MissedSolver, Artifact::Void, Artifact::WrongCount,
        Artifact::WrongParity}},
      {Error::LoseOneOfTwo,
       {Artifact::MissedSolver, Artifact::Void, Artifact::WrongCount, Artifact::WrongParity}},
      {Error::LoseBoth, {Artifact::MissedSolver, Artifact::Void, Artifact::WrongCount}},
      {Error::NotAhead, {Artifact::FirstWrong, Artifact::MissedRange, Artifact::GhostMaterial}},
      {Error::Inconsistent, {Artifact::Inconsistent}},
      {Error::WrongEnd, {Artifact::Inconsistent}},
      {Error::DropBoth, {Artifact::FirstWrong, Artifact::MissedLogic, Artifact::Void}},
  };
  return all;
}

// Makes the errors that each ray is given.
class Injector {
 public:
  Injector(const scene::Scene& scene, std::vector<Error> errors)
      : scene_(&scene), errors_(std::move(errors)) {}

  [[nodiscard]] SyntheticTracer::Errors errors() const {
    return {[this](const ExactRay& ray, const method::Tracer& right, std::size_t i) {
              return crossing(errors_.at(id_of(ray)), right, i);
            },
            [this](const ExactRay& ray, const SyntheticTracer& tracer, Report& report) {
              change(errors_.at(id_of(ray)), tracer, report);
            }};
  }

  [[nodiscard]] std::size_t rays() const { return errors_.size(); }

  /// So many rays show the artifact.
  [[nodiscard]] std::uint64_t injected(Artifact artifact) const {
    return static_cast<std::uint64_t>(std::count_if(
        errors_.begin(), errors_.end(),
        [artifact](Error error) { return shown_by().at(error).count(artifact) > 0; }));
  }

 private:
  [[nodiscard]] csg::Medium medium(const std::string& name) const {
    for (csg::Medium m = 0; m < scene_->materials.size(); ++m) {
      if (scene_->materials[m].name == name) {
        return m;
      }
    }
    throw std::logic_error("no material " + name);
  }

  [[nodiscard]] bool is_of(const std::string& material, csg::LeafIndex leaf) const {
    return scene_->materials[scene_->leaves[leaf].medium].name == material;
  }

  // The crossing of a material's leaf at a height.
  [[nodiscard]] std::uint32_t find(const SyntheticTracer& tracer, const std::string& material,
                                   double z) const {
    for (std::uint32_t i = 0; i < tracer.crossings().size(); ++i) {
      if (tracer.t(i) == 5 - z && is_of(material, tracer.crossings()[i].leaf)) {
        return i;
      }
    }
    throw std::logic_error("no crossing of " + material);
  }

  [[nodiscard]] std::optional<method::CrossingId> crossing(Error error, const method::Tracer& right,
                                                           std::size_t i) const {
    method::CrossingId id = right.crossings()[i];
    const bool top_of_b = is_of("b", id.leaf) && right.t(i) == 4;
    const bool sphere = is_of("d", id.leaf);
    if ((error == Error::LoseOwner && top_of_b) || (error == Error::LoseBoth && sphere) ||
        (error == Error::LoseOneOfTwo && sphere && id.index == 0)) {
      return std::nullopt;
    }
    if (error == Error::LoseOneOfTwo && sphere) {
      id.index = 0;
    }
    if (error == Error::NotAhead && top_of_b) {
      id.ahead = false;
    }
    return id;
  }

  void change(Error error, const SyntheticTracer& tracer, Report& report) const {
    auto& interfaces = report.interfaces;
    switch (error) {
      case Error::None:
      case Error::LoseOwner:
      case Error::LoseOneOfTwo:
      case Error::LoseBoth:
        break;
      case Error::DropFirst:
        interfaces.erase(interfaces.begin());
        break;
      case Error::DropBoth:
        interfaces.erase(interfaces.begin(), interfaces.begin() + 2);
        break;
      case Error::Ghost: {
        const csg::Medium c = medium("c");
        interfaces.insert(interfaces.begin(), {{find(tracer, "c", 3), {csg::kEmpty, c}},
                                               {find(tracer, "c", 2), {c, csg::kEmpty}}});
        break;
      }
      case Error::OtherLeaf:
        interfaces.front().crossing = find(tracer, "a", 1);
        break;
      case Error::OtherMedium:
        interfaces[0].transition.to = medium("a");
        break;
      case Error::WrongFrom:
        interfaces[1].transition.from = medium("a");
        break;
      case Error::NotAhead:
        interfaces.erase(interfaces.begin());
        report.start = medium("b");
        break;
      case Error::Inconsistent:
        ++report.inconsistent;
        break;
      case Error::WrongEnd:
        report.end = medium("b");
        break;
    }
  }

  const scene::Scene* scene_;
  std::vector<Error> errors_;
};

census::Census census_of(const Injector& injector, const std::string& text,
                         const std::string& method) {
  constexpr std::size_t kRaysOfATask = 16;
  census::Plan plan;
  plan.methods = {method::parse_method(method)};
  plan.numbers = {support::synthetic_number(injector.errors())};
  return census::run_census(
      plan, (injector.rays() + kRaysOfATask - 1) / kRaysOfATask,
      [&](std::size_t i) {
        census::Task task{support::scene_of(text), {}};
        for (std::size_t id = i * kRaysOfATask;
             id < std::min((i + 1) * kRaysOfATask, injector.rays()); ++id) {
          task.rays.push_back(ray_of(id));
        }
        return task;
      },
      [](auto, auto) { return true; });
}

void check_counts(const census::Cell& cell, const Injector& injector) {
  CHECK(cell.rays == injector.rays());
  for (std::size_t a = 0; a < census::kArtifactCount; ++a) {
    INFO(census::artifact_texts()[a].name);
    CHECK(cell.with[a] == injector.injected(static_cast<Artifact>(a)));
  }
  // The ideal scene in exact numbers is right, and nothing is rounded: it is the computation.
  for (std::size_t c = 0; c < census::kCauseCount; ++c) {
    INFO(census::cause_texts()[c].name);
    CHECK(cell.caused[c] == (static_cast<Cause>(c) == Cause::Computation
                                 ? injector.injected(Artifact::FirstWrong)
                                 : 0));
  }
}

TEST_CASE("Every artifact that is injected is counted as what it is", "[synthetic]") {
  const scene::Scene scene = support::scene_of(kScene);
  std::set<Artifact> reached;
  for (const auto& [error, artifacts] : shown_by()) {
    INFO("error " << static_cast<int>(error));
    SeededStream stream("synthetic/one", 1, static_cast<std::uint64_t>(error));
    std::vector<Error> errors(40);
    for (Error& of_ray : errors) {
      of_ray = stream.chance(0.3) ? error : Error::None;
    }
    const Injector injector(scene, errors);
    const census::Census census = census_of(injector, kScene, "regularized");
    CHECK(census.with_coincidence == errors.size());
    check_counts(census.cells[0], injector);
    reached.insert(artifacts.begin(), artifacts.end());
  }
  // All but the one that depends on the method (see below) and the one of spawned rays.
  CHECK(reached.size() == census::kArtifactCount - 2);
  CHECK(reached.count(Artifact::EpsilonHole) == 0);
}

TEST_CASE("Artifacts are counted apart where errors of all kinds are mixed", "[synthetic]") {
  const scene::Scene scene = support::scene_of(kScene);
  SeededStream stream("synthetic/mixed", 1, 0);
  std::vector<Error> errors(600);
  for (Error& error : errors) {
    error = static_cast<Error>(stream.below(shown_by().size()));
  }
  const Injector injector(scene, errors);
  check_counts(census_of(injector, kScene, "regularized").cells[0], injector);
}

// An epsilon of 3/2 takes both faces of b for one, and loses them in exact numbers; it keeps the
// sphere. What the synthetic method loses of b is then epsilon's, and of d its own.
TEST_CASE("A miss is an epsilon hole where exact arithmetic misses it too", "[synthetic]") {
  const scene::Scene scene = support::scene_of(kScene);
  SeededStream stream("synthetic/holes", 1, 0);
  const std::vector<Error> kinds{Error::None, Error::DropFirst, Error::DropBoth, Error::LoseOwner,
                                 Error::LoseBoth};
  std::vector<Error> errors(100);
  std::uint64_t holes = 0;
  for (Error& error : errors) {
    error = kinds[stream.below(kinds.size())];
    holes += error != Error::None && error != Error::LoseBoth ? 1 : 0;
  }
  const Injector injector(scene, errors);
  const census::Cell cell = census_of(injector, kScene, "epsilon:3/2").cells[0];
  CHECK(cell[Artifact::EpsilonHole] == holes);
  CHECK(cell[Artifact::FirstWrong] == injector.injected(Artifact::FirstWrong));
  CHECK(cell[Artifact::MissedLogic] == injector.injected(Artifact::MissedLogic));
  CHECK(cell[Artifact::MissedSolver] == injector.injected(Artifact::MissedSolver));
  CHECK(cell.caused[static_cast<std::size_t>(Cause::Model)] ==
        injector.injected(Artifact::FirstWrong));
}

report::Value value(const census::Census& census, const std::string& column) {
  const report::Table table = report::census_table({{{}, census}}, {}, "");
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].name == column) {
      return table.rows.at(0).at(c);
    }
  }
  throw std::logic_error("no column " + column);
}

// A cheap scene, and many small censuses of it.
TEST_CASE("Intervals cover the rate of an artifact at least 95 times in 100", "[synthetic]") {
  constexpr const char* kCube = "material(\"b\") translate([3, 0, 0]) cube(1);";
  constexpr std::uint64_t kRepetitions = 400;
  constexpr std::size_t kRays = 15;
  const scene::Scene scene = support::scene_of(kCube);
  const double rate = GENERATE(0.04, 0.3);
  std::uint64_t covered = 0;
  std::set<std::uint64_t> counts;
  for (std::uint64_t repetition = 0; repetition < kRepetitions; ++repetition) {
    SeededStream stream("synthetic/coverage", static_cast<std::uint64_t>(1000 * rate), repetition);
    std::vector<Error> errors(kRays);
    for (Error& error : errors) {
      error = stream.chance(rate) ? Error::DropFirst : Error::None;
    }
    const Injector injector(scene, errors);
    const census::Census census = census_of(injector, kCube, "regularized");
    const auto counted = std::get<report::Rate>(value(census, "missed_logic"));
    REQUIRE(counted.count == injector.injected(Artifact::MissedLogic));
    REQUIRE(counted.n == kRays);
    const census::Interval interval = census::clopper_pearson(counted.count, counted.n);
    covered += interval.lower <= rate && rate <= interval.upper ? 1 : 0;
    counts.insert(counted.count);
  }
  INFO(covered << " of " << kRepetitions << " cover " << rate);
  const auto n = static_cast<double>(kRepetitions);
  CHECK(static_cast<double>(covered) >= 0.95 * n - 3 * std::sqrt(0.95 * 0.05 * n));
  CHECK(counts.size() >= 3);
}

// A half-space less itself: the ray enters both at once, and nothing is there. The synthetic
// method shows the front of this lamina with probability p.
TEST_CASE("Speckle of a lamina that is seen with probability p is 4p(1-p)", "[synthetic]") {
  constexpr const char* kLamina =
      "difference() { halfspace([0, 0, 1], 0); halfspace([0, 0, 1], 0); }";
  constexpr std::size_t kRays = 600;
  const double p = GENERATE(0.0, 0.1, 0.5, 0.8, 1.0);
  SeededStream stream("synthetic/lamina", 1, static_cast<std::uint64_t>(100 * p));
  std::vector<bool> shows(kRays);
  std::uint64_t shown = 0;
  for (std::size_t i = 0; i < kRays; ++i) {
    shows[i] = stream.chance(p);
    shown += shows[i] ? 1 : 0;
  }
  SyntheticTracer::Errors errors;
  errors.report = [&shows](const ExactRay& ray, const SyntheticTracer&, Report& report) {
    if (shows[id_of(ray)]) {
      report.interfaces = {{0, {csg::kEmpty, 1}}, {1, {1, csg::kEmpty}}};
    }
  };
  census::Plan plan;
  plan.methods = {method::regularized()};
  plan.numbers = {support::synthetic_number(errors)};
  const census::Census census = census::run_census(
      plan, 1,
      [](std::size_t) {
        census::Task task{support::scene_of(kLamina), {}};
        for (std::size_t id = 0; id < kRays; ++id) {
          task.rays.push_back(ray_of(id));
        }
        return task;
      },
      [](auto, auto) { return true; });
  const auto front = std::get<report::Rate>(value(census, "lamina_front"));
  CHECK(front.n == kRays);
  CHECK(front.count == shown);
  CHECK(census.cells[0].lamina_backs == 0);
  CHECK(census.cells[0][Artifact::GhostHit] == shown);
  const double part = static_cast<double>(shown) / static_cast<double>(kRays);
  const double speckle = std::get<double>(value(census, "speckle"));
  CHECK(speckle == Approx(4 * part * (1 - part)).margin(1e-15));
  // Four standard errors of p: the slope of 4p(1-p) is 4 - 8p, its curvature -8.
  const double error = 4 * std::sqrt(p * (1 - p) / kRays);
  CHECK(std::abs(speckle - 4 * p * (1 - p)) <= std::abs(4 - 8 * p) * error + 4 * error * error);
}

}  // namespace
}  // namespace lamina
