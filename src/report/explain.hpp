// Why a ray sees what it sees: the truth, and where each method departs from it.
#pragma once

#include <span>
#include <string>

#include "geometry/vector.hpp"
#include "method/method.hpp"
#include "method/tracer.hpp"
#include "poly/solver.hpp"
#include "scene/scene.hpp"
#include "trace/number_choice.hpp"

namespace lamina::report {

/// Returns a text of lines of at most 100 columns: the ray and the leaves that it crosses, by
/// letters; the exact events; the methods that are right, by number types; and each different
/// way of being wrong, once: the artifacts, the events as they were processed, an arrow at the
/// first one that makes a difference, and its cause. A single method in a single number type
/// is shown event by event even if it is right.
std::string explain(const scene::Scene& scene, const geometry::ExactRay& ray,
                    std::span<const method::Method> methods,
                    std::span<const trace::NumberChoice> numbers, const poly::Solvers& solvers);

}  // namespace lamina::report
