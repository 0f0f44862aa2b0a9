// The census as tables.
#pragma once

#include <string>
#include <vector>

#include "census/census.hpp"
#include "report/table.hpp"

namespace lamina::report {

/// A census and what sets it apart from the others in the table: a scene, a kind of rays; one
/// label for each label column.
struct LabelledCensus {
  std::vector<census::Label> labels;
  census::Census census;
  std::string options{};  ///< of the command line that replay its rays, each behind a blank
};

/// A row for each census, method and number type; artifacts, causes and order as rates of
/// rays, then laminae, errors of right hits, and the worst ray of each cell. Notes count the
/// rays and name one to replay for each method. Rows are never pooled.
Table census_table(const std::vector<LabelledCensus>& censuses,
                   const std::vector<Column>& label_columns, const std::string& title);

/// The same for rays that are spawned: what is judged of them.
Table spawned_table(const std::vector<LabelledCensus>& censuses,
                    const std::vector<Column>& label_columns, const std::string& title);

/// A row for each census, number type and two methods: the rays on which only one of them has
/// its first visible interface wrong, and McNemar's test.
Table paired_table(const std::vector<LabelledCensus>& censuses,
                   const std::vector<Column>& label_columns, const std::string& title);

/// A label as the value of a table.
Value value_of(const census::Label& label);

}  // namespace lamina::report
