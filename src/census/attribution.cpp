#include "census/attribution.hpp"
#include "trace/number_choice.hpp"

namespace lamina::census {
namespace {

std::optional<geometry::ExactPoint> rounded(const geometry::ExactPoint& point,
                                            const scene::Rounding& round) {
  const auto x = round(point.x);
  const auto y = round(point.y);
  const auto z = round(point.z);
  return x && y && z ? std::optional(geometry::ExactPoint{*x, *y, *z}) : std::nullopt;
}

}  // namespace

const std::array<CauseText, kCauseCount>& cause_texts() {
  static const std::array<CauseText, kCauseCount> texts{{
      {"model", "by model",
       "First wrong, and so it is in exact arithmetic on the ideal scene: the method's own error."},
      {"representation", "by representation",
       "First wrong, in exact arithmetic only once the numbers of scene and ray are rounded."},
      {"construction", "by construction",
       "First wrong, in exact arithmetic only once the constants made from them are rounded too."},
      {"computation", "by computation",
       "First wrong, but not in exact arithmetic with the same rounded constants."},
  }};
  return texts;
}

// A scene in exact arithmetic, matched with the truth of the ideal one.
struct Attribution::Level {
  Level(scene::Scene at, const Truth& truth)
      : scene(std::move(at)),
        tracer(method::make_tracer<number::exact>(scene, {})),
        judge(truth, *tracer, scene.leaves.size()) {}

  scene::Scene scene;
  std::unique_ptr<method::Tracer> tracer;
  Judge judge;
  method::Report report;
  std::uint64_t found = 0;  // the ray that the tracer has found; 0 for none
};

struct Attribution::Levels {
  std::unique_ptr<Level> representation;  // none where the scene cannot be represented
  std::unique_ptr<Level> construction;
};

Attribution::Attribution(const scene::Scene& scene, const Truth& truth,
                         const std::vector<method::Method>& methods,
                         const std::vector<trace::NumberChoice>& numbers)
    : scene_(scene), truth_(truth), methods_(methods), numbers_(numbers), levels_(numbers.size()) {}

Attribution::~Attribution() = default;

void Attribution::find(const geometry::ExactRay& ray) {
  ray_ = ray;
  ++ray_number_;
  wrong_on_ideal_.assign(methods_.size(), std::nullopt);
}

// Runs the method on a level; false for a right first interface. The ray is rounded to the
// number type, if one is given.
bool Attribution::wrong(Level& level, std::size_t method, const trace::NumberChoice* number) {
  if (level.found != ray_number_) {
    geometry::ExactRay ray = ray_;
    if (number != nullptr) {
      const auto origin = rounded(ray.origin, number->round);
      const auto direction = rounded(ray.direction, number->round);
      if (!origin || !direction || *direction == geometry::ExactPoint{0, 0, 0}) {
        return true;
      }
      ray = {*origin, *direction};
    }
    level.tracer->find(ray);
    level.judge.match();
    level.found = ray_number_;
  }
  level.tracer->run(methods_[method], level.report);
  return level.judge.judge(level.report, 0)[Artifact::FirstWrong] > 0;
}

Attribution::Levels& Attribution::levels_of(std::size_t number) {
  if (!levels_[number]) {
    levels_[number] = std::make_unique<Levels>();
    const scene::Rounding& round = numbers_[number].round;
    if (auto rounded = scene::rounded_scene(scene_, round)) {
      if (auto constants = scene::scene_of_constants(*rounded, round)) {
        levels_[number]->construction = std::make_unique<Level>(std::move(*constants), truth_);
      }
      levels_[number]->representation = std::make_unique<Level>(std::move(*rounded), truth_);
    }
  }
  return *levels_[number];
}

Attribution::Level& Attribution::ideal() {
  if (!ideal_) {
    ideal_ = std::make_unique<Level>(scene_, truth_);
  }
  return *ideal_;
}

bool Attribution::wrong_on_ideal(std::size_t method) {
  std::optional<bool>& known = wrong_on_ideal_[method];
  if (!known) {
    known = wrong(ideal(), method, nullptr);
  }
  return *known;
}

Cause Attribution::cause(std::size_t method, std::size_t number) {
  if (wrong_on_ideal(method)) {
    return Cause::Model;
  }
  Levels& levels = levels_of(number);
  const trace::NumberChoice* const choice = &numbers_[number];
  if (!levels.representation || wrong(*levels.representation, method, choice)) {
    return Cause::Representation;
  }
  if (!levels.construction || wrong(*levels.construction, method, choice)) {
    return Cause::Construction;
  }
  return Cause::Computation;
}

std::uint32_t Attribution::missed_in_exact(std::size_t method, const std::vector<bool>& reported) {
  static_cast<void>(wrong(ideal(), method, nullptr));
  std::uint32_t missed = 0;
  for (std::size_t c = 0; c < reported.size(); ++c) {
    missed +=
        truth_.classes()[c].is_interface() && !reported[c] && !ideal_->judge.reported_classes()[c]
            ? 1
            : 0;
  }
  return missed;
}

}  // namespace lamina::census
