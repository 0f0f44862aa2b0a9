#include "report/outcome.hpp"
#include "trace/number_choice.hpp"

#include <algorithm>
#include <cmath>

namespace lamina::report {

Lane::Lane(const scene::Scene& scene, const geometry::ExactRay& ray, const census::Truth& truth,
           const trace::NumberChoice& choice, const poly::Solvers& solvers)
    : number(&choice),
      tracer(choice.make_tracer(scene, solvers)),
      judge(truth, *tracer, scene.leaves.size()) {
  tracer->find(ray);
  judge.match();
  exact_of.assign(tracer->crossings().size(), census::kNoCrossing);
  for (std::uint32_t exact = 0; exact < judge.matches().size(); ++exact) {
    if (const std::uint32_t found = judge.matches()[exact]; found != census::kNoCrossing) {
      exact_of[found] = exact;
    }
  }
}

Outcome::Outcome(const scene::Scene& of_scene, const geometry::ExactRay& ray,
                 const census::Truth& of_truth, const method::Method& by_method, Lane& in_lane)
    : scene(&of_scene), truth(&of_truth), method(&by_method), lane(&in_lane) {
  records = in_lane.tracer->explain(by_method, report);
  const double direction_length =
      std::sqrt(number::nearest_double(dot(ray.direction, ray.direction)));
  verdict = in_lane.judge.judge(report, direction_length);
  findings = in_lane.judge.findings();
}

const method::Interface* Outcome::reported(const method::EventRecord& record) const {
  const auto found =
      std::find_if(report.interfaces.begin(), report.interfaces.end(),
                   [&](const method::Interface& i) { return i.crossing == record.crossing; });
  return found == report.interfaces.end() ? nullptr : &*found;
}

bool Outcome::first_state(csg::LeafIndex leaf) const {
  return geometric() ? lane->tracer->inside_at(leaf, method::Tracer::kStart)
                     : lane->tracer->starts_inside(*method, leaf);
}

bool Outcome::state_behind(const method::EventRecord& record, csg::LeafIndex leaf,
                           bool before) const {
  if (leaf == leaf_of(record)) {
    return record.inside;
  }
  return geometric() ? lane->tracer->inside_at(leaf, record.crossing) : before;
}

}  // namespace lamina::report
