// The census as a table.
#pragma once

#include <string>

#include "census/census.hpp"
#include "geometry/vector.hpp"
#include "report/table.hpp"

namespace lamina::report {

/// A row for each method and number type; artifacts as rates, then laminae, errors of right
/// hits, and the worst ray of each cell. Notes name, for each method, a ray to replay.
Table census_table(const census::Census& census, const std::string& title);

/// The six numbers of a ray as `--ray` takes them, exact.
std::string ray_text(const geometry::ExactRay& ray);

}  // namespace lamina::report
