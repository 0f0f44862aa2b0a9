// The census as a table.
#pragma once

#include <string>
#include <vector>

#include "census/census.hpp"
#include "geometry/vector.hpp"
#include "report/table.hpp"

namespace lamina::report {

/// A census and what sets it apart from the others in the table: a scene, a kind of rays.
struct LabelledCensus {
  std::string label;
  census::Census census;
};

/// A row for each census, method and number type; artifacts as rates, then laminae, errors of
/// right hits, and the worst ray of each cell. Notes name, for each method of each census, a
/// ray to replay. `label_column` says what the labels are; rows are never pooled.
Table census_table(const std::vector<LabelledCensus>& censuses, const Column& label_column,
                   const std::string& title);

/// The six numbers of a ray as `--ray` takes them, exact.
std::string ray_text(const geometry::ExactRay& ray);

}  // namespace lamina::report
