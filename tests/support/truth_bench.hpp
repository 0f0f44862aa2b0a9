// One scene in exact numbers: what is true of its rays, in a form that two scenes share.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "census/verdict.hpp"
#include "method/tracer.hpp"
#include "scene/scene.hpp"
#include "support/reference_ray.hpp"

namespace lamina::support {

inline geometry::ExactRay exact_ray(const reference::Ray& ray) {
  const auto& [o, d] = ray;
  return {{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
}

inline reference::Ray reference_ray(const geometry::ExactRay& ray) {
  const auto& [o, d] = ray;
  return {{o.x, o.y, o.z}, {d.x, d.y, d.z}};
}

/// The media along one ray, by name; "" for none.
struct MediaAlongRay {
  struct Change {
    number::Root t;
    std::string from;
    std::string to;
  };
  std::string start;
  std::vector<Change> changes;

  /// At exactly the same places.
  friend bool operator==(const MediaAlongRay& a, const MediaAlongRay& b) {
    if (a.start != b.start || a.changes.size() != b.changes.size()) {
      return false;
    }
    for (std::size_t i = 0; i < a.changes.size(); ++i) {
      const Change& x = a.changes[i];
      const Change& y = b.changes[i];
      if (x.from != y.from || x.to != y.to || compare(x.t, y.t) != 0) {
        return false;
      }
    }
    return true;
  }

  friend std::ostream& operator<<(std::ostream& out, const MediaAlongRay& media) {
    out << '"' << media.start << '"';
    for (const Change& change : media.changes) {
      out << ' ' << change.t.lower() << " \"" << change.to << '"';
    }
    return out;
  }

  /// With one name for all materials.
  [[nodiscard]] MediaAlongRay solid() const {
    const auto one = [](const std::string& name) { return name.empty() ? "" : "solid"; };
    MediaAlongRay result{one(start), {}};
    for (const Change& change : changes) {
      if (change.from.empty() != change.to.empty()) {
        result.changes.push_back({change.t, one(change.from), one(change.to)});
      }
    }
    return result;
  }
};

class TruthBench {
 public:
  explicit TruthBench(const std::string& text)
      : text_(text),
        scene_(scene::parse_scene(text, "scene")),
        truth_(scene_),
        tracer_(method::make_tracer<number::exact>(scene_, {})),
        judge_(truth_, *tracer_, scene_.leaves.size()) {}

  void find(const geometry::ExactRay& ray) {
    truth_.find(ray);
    tracer_->find(ray);
    judge_.match();
  }

  /// Of the ray last found.
  [[nodiscard]] MediaAlongRay media() const {
    const auto name = [this](csg::Medium medium) { return scene_.materials[medium].name; };
    MediaAlongRay result{name(truth_.start()), {}};
    for (const census::TruthClass& cls : truth_.classes()) {
      if (cls.is_interface()) {
        const auto [from, to] = cls.effect.transition;
        result.changes.push_back({truth_.t(cls), name(from), name(to)});
      }
    }
    return result;
  }

  [[nodiscard]] MediaAlongRay media(const geometry::ExactRay& ray) {
    find(ray);
    return media();
  }

  [[nodiscard]] method::Report report(const method::Method& method) {
    method::Report report;
    tracer_->run(method, report);
    return report;
  }

  /// What the census finds wrong with a method on the ray last found.
  [[nodiscard]] census::Verdict verdict(const method::Method& method) {
    return judge_.judge(report(method), 1);
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  [[nodiscard]] const census::Truth& truth() const { return truth_; }
  [[nodiscard]] method::Tracer& tracer() { return *tracer_; }

 private:
  std::string text_;
  scene::Scene scene_;
  census::Truth truth_;
  std::unique_ptr<method::Tracer> tracer_;
  census::Judge judge_;
};

}  // namespace lamina::support
