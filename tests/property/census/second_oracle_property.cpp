// The truth against an oracle that shares no code with it, on scenes full of coincidences.
#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>

#include "census/truth.hpp"
#include "geometry/ray_text.hpp"
#include "method/tracer.hpp"
#include "scene/scene.hpp"
#include "support/class_tally.hpp"
#include "support/reference_random.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using census::Truth;
using census::TruthClass;
using number::Rational;
using reference::Ray;
using reference::Vector;

constexpr std::uint64_t kSeed = 1;

geometry::ExactRay exact(const Ray& ray) {
  const auto& [o, d] = ray;
  return {{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
}

Vector point_on(const Ray& ray, const Rational& t) {
  Vector point;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = ray.origin[i] + t * ray.direction[i];
  }
  return point;
}

// A scene in all three forms, and what rays through it say.
class Bench {
 public:
  explicit Bench(const reference::RandomScene& data)
      : data_(data.root),
        text_(reference::text_of(data.root)),
        scene_(scene::parse_scene(text_, "random")),
        truth_(scene_),
        tracer_(method::make_tracer<number::exact>(scene_, {})),
        torus_(has_torus(data.root)) {}

  // Whether everything agrees on the ray; if not, `why` says what does not.
  bool agrees(const Ray& ray) {
    why_.str("");
    truth_.find(exact(ray));
    check_regularized(ray);
    if (torus_) {
      check_points(ray, reference::in_carriers(data_, ray));
    } else {
      answer_ = reference::answer(data_, ray);
      check_answer();
      check_points(ray, answer_.in_carriers);
    }
    return why_.str().empty();
  }

  [[nodiscard]] std::string why(const Ray& ray) const {
    return "ray \"" + geometry::to_text(exact(ray)) + "\":" + why_.str() + "\nscene\n" + text_;
  }

  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  [[nodiscard]] const Truth& truth() const { return truth_; }
  [[nodiscard]] const reference::RayAnswer& answer() const { return answer_; }
  [[nodiscard]] std::size_t face_count() const { return reference::face_count(data_); }

 private:
  [[nodiscard]] const std::string& name(csg::Medium medium) const {
    return scene_.materials[medium].name;
  }

  template <typename A, typename B>
  void same(const char* what, std::size_t place, const A& truth, const B& other) {
    if (truth != other) {
      why_ << ' ' << what << " at " << place << ": " << truth << " is said to be " << other << ';';
    }
  }

  // The method `regularized` on exact numbers is the truth.
  void check_regularized(const Ray& ray) {
    tracer_->find(exact(ray));
    tracer_->run(method::regularized(), report_);
    same("start of regularized", 0, name(truth_.start()), name(report_.start));
    same("end of regularized", 0, name(truth_.end()), name(report_.end));
    std::size_t next = 0;
    for (std::size_t c = 0; c < truth_.classes().size(); ++c) {
      const TruthClass& cls = truth_.classes()[c];
      if (!cls.is_interface()) {
        continue;
      }
      if (next == report_.interfaces.size()) {
        why_ << " regularized has no interface at class " << c << ';';
        return;
      }
      const method::Interface& seen = report_.interfaces[next++];
      same("crossing of regularized", c, true,
           seen.crossing >= cls.first_crossing &&
               seen.crossing < cls.first_crossing + cls.leaves.size());
      same("from of regularized", c, name(cls.effect.transition.from), name(seen.transition.from));
      same("to of regularized", c, name(cls.effect.transition.to), name(seen.transition.to));
    }
    same("interfaces of regularized", 0, next, report_.interfaces.size());
  }

  // A rational strictly between the places of two neighbouring classes: behind the start for
  // the first, at any distance for the last.
  [[nodiscard]] Rational between(std::size_t c, const Rational& part) const {
    const auto& classes = truth_.classes();
    if (classes.empty()) {
      return part;
    }
    for (int bits = 64;; bits *= 2) {
      const Rational low = c == 0 ? Rational(0) : enclosure(truth_.t(classes[c - 1]), bits).upper;
      const Rational high =
          c == classes.size() ? Rational(low + 2) : enclosure(truth_.t(classes[c]), bits).lower;
      if (low < high) {
        return low + part * (high - low);
      }
    }
  }

  // Leaves that hold the ray are outside by convention, and so are surfaces of `membership`.
  void check_points(const Ray& ray, std::size_t in_carriers) {
    same("in a carrier", 0, truth_.in_some_carrier(), in_carriers > 0);
    for (std::size_t c = 0; c <= truth_.classes().size(); ++c) {
      const csg::Medium medium =
          c == 0 ? truth_.start() : truth_.classes()[c - 1].effect.transition.to;
      check_point(ray, c, between(c, Rational(1) / 2), medium, in_carriers);
      if (c == 0) {
        check_point(ray, c, between(c, Rational(1) / 1'000'000'007), medium, in_carriers);
      }
    }
  }

  void check_point(const Ray& ray, std::size_t c, Rational t, csg::Medium medium,
                   std::size_t in_carriers) {
    reference::Membership there = membership(data_, point_on(ray, t));
    for (int tries = 0; tries < 9 && there.surfaces != in_carriers; ++tries) {
      // A touch: no crossing, but the point is on the surface. Another one is not.
      t = between(c, Rational(3 + tries) / 17);
      there = membership(data_, point_on(ray, t));
    }
    same("surfaces between classes", c, in_carriers, there.surfaces);
    same("medium behind class", c, name(medium), reference::name_of(there.medium));
  }

  void check_answer() {
    same("start", 0, name(truth_.start()), reference::name_of(answer_.start));
    same("end", 0, name(truth_.end()), reference::name_of(answer_.end));
    const csg::Medium before = csg::evaluate(scene_.tree, [this](csg::LeafIndex leaf) {
      return truth_.starts_inside(leaf) ? scene_.tree.medium_of(leaf) : csg::kEmpty;
    });
    same("medium towards -infinity", 0, name(before), reference::name_of(answer_.before));
    same("number of classes", 0, truth_.classes().size(), answer_.classes.size());
    for (std::size_t c = 0; c < std::min(truth_.classes().size(), answer_.classes.size()); ++c) {
      const TruthClass& truth = truth_.classes()[c];
      const reference::RayClass& other = answer_.classes[c];
      const std::vector<std::size_t> leaves(truth.leaves.begin(), truth.leaves.end());
      same("leaves of class", c, true, leaves == other.leaves);
      same("from of class", c, name(truth.effect.transition.from), reference::name_of(other.from));
      same("to of class", c, name(truth.effect.transition.to), reference::name_of(other.to));
      const number::Root& t = truth_.t(truth);
      const double off = std::abs(t.lower() - other.t.approximation());
      same("place of class", c, true, off <= other.t.error() + (t.upper() - t.lower()));
      if (leaves.size() <= reference::RayClass::kMostLeaves) {
        const auto& owners = truth.effect.owners;
        same("owners of class", c, true,
             std::vector<std::size_t>(owners.begin(), owners.end()) == other.owners);
        same("lamina of class", c, truth.effect.lamina, other.lamina);
      }
    }
  }

  const reference::Node data_;
  std::string text_;
  scene::Scene scene_;
  Truth truth_;
  std::unique_ptr<method::Tracer> tracer_;
  method::Report report_;
  bool torus_;
  reference::RayAnswer answer_;
  std::ostringstream why_;
};

bool crosses_several_carriers(const scene::Scene& scene, const TruthClass& cls) {
  return std::any_of(cls.leaves.begin(), cls.leaves.end(), [&](csg::LeafIndex leaf) {
    return scene.leaves[leaf].carrier != scene.leaves[cls.leaves.front()].carrier;
  });
}

support::ClassTally hard_classes() {
  return {"coincident",     "coincident, rational", "coincident, irrational",
          "edge",           "edge, irrational",     "lamina",
          "several owners", "in a carrier",         "starts inside",
          "touch"};
}

void count_classes(const Bench& bench, support::ClassTally& tally) {
  const auto& classes = bench.truth().classes();
  const auto any = [&classes](auto what) {
    return std::any_of(classes.begin(), classes.end(), what);
  };
  const auto& answers = bench.answer().classes;
  const auto any_root = [&](bool edge, bool rational) {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const bool coincident =
          edge ? crosses_several_carriers(bench.scene(), classes[i]) : answers[i].leaves.size() > 1;
      if (coincident && answers[i].t.is_rational() == rational) {
        return true;
      }
    }
    return false;
  };
  tally.add("coincident", any([](const auto& c) { return c.leaves.size() > 1; }));
  tally.add("lamina", any([](const auto& c) { return c.effect.lamina; }));
  tally.add("several owners", any([](const auto& c) { return c.effect.owners.size() > 1; }));
  tally.add("edge", any([&](const auto& c) { return crosses_several_carriers(bench.scene(), c); }));
  tally.add("in a carrier", bench.truth().in_some_carrier());
  tally.add("starts inside", bench.truth().start() != csg::kEmpty);
  tally.add("touch", bench.answer().touches > 0);
  tally.add("coincident, rational", any_root(false, true));
  tally.add("coincident, irrational", any_root(false, false));
  tally.add("edge, irrational", any_root(true, false));
}

struct Run {
  std::uint64_t scenes;
  std::uint64_t rays_each;
  bool tori;
};

// Compares rays of a run; returns how many, with the hard classes in the tally.
std::uint64_t compare_oracles(const Run& run, support::ClassTally& tally) {
  std::uint64_t rays = 0;
  for (std::uint64_t case_id = 0; case_id < run.scenes; ++case_id) {
    const char* const name = run.tori ? "oracle/tori" : "oracle/quadrics";
    SeededStream stream(name, kSeed, case_id);
    const auto data = reference::random_scene(
        stream, {.tori = run.tori, .touching = !run.tori && case_id % 8 == 0});
    Bench bench(data);
    if (bench.scene().leaves.size() != bench.face_count()) {
      FAIL(name << ", case " << case_id << " has " << bench.scene().leaves.size() << " leaves");
    }
    for (std::uint64_t i = 0; i < run.rays_each; ++i, ++rays) {
      const bool special = i % 2 == 1;
      const Ray ray = special ? special_ray(stream, data) : float_ray(stream, data);
      if (!bench.agrees(ray)) {
        FAIL(name << ", case " << case_id << ", " << bench.why(ray));
      }
      count_classes(bench, tally);
    }
  }
  return rays;
}

TEST_CASE("The truth and the second oracle agree on planes and quadrics", "[oracle]") {
  support::ClassTally tally = hard_classes();
  const std::uint64_t rays =
      compare_oracles({.scenes = 220, .rays_each = 46, .tori = false}, tally);
  INFO(rays << " rays; " << tally);
  CHECK(rays >= 10'000);
  CHECK(tally.each_at_least(rays / 400));
  for (const char* name : {"coincident, rational", "coincident, irrational", "edge", "lamina",
                           "several owners", "in a carrier", "starts inside", "touch"}) {
    CHECK(tally.count(name) >= rays / 100);
  }
  CHECK(tally.count("coincident") >= rays / 20);
}

TEST_CASE("The truth and the second oracle agree on points of scenes with tori", "[oracle]") {
  support::ClassTally tally = hard_classes();
  const std::uint64_t rays = compare_oracles({.scenes = 40, .rays_each = 20, .tori = true}, tally);
  INFO(rays << " rays; " << tally);
  CHECK(tally.count("coincident") >= rays / 20);
  CHECK(tally.count("edge") >= rays / 100);
}

}  // namespace
}  // namespace lamina
