#include "report/census_table.hpp"

#include <fmt/format.h>

namespace lamina::report {

std::string ray_text(const geometry::ExactRay& ray) {
  const auto& [o, d] = ray;
  return fmt::format("{} {} {} {} {} {}", number::to_text(o.x), number::to_text(o.y),
                     number::to_text(o.z), number::to_text(d.x), number::to_text(d.y),
                     number::to_text(d.z));
}

namespace {

std::vector<Column> columns(const Column& label_column) {
  std::vector<Column> all{label_column,
                          {"method", "method", ""},
                          {"number", "number", ""},
                          {"bits", "bits", "Significand bits of the number type."},
                          {"rays", "rays", "", true}};
  for (const census::ArtifactText& text : census::artifact_texts()) {
    all.push_back(
        {std::string(text.name), std::string(text.heading), std::string(text.definition)});
  }
  const std::vector<Column> rest{
      {"lamina_front", "lamina front",
       "Laminae that all events enter, seen as a surface, of all such."},
      {"lamina_back", "lamina back",
       "Laminae that all events leave, seen as a surface, of all such."},
      {"wrong_length", "wrong length",
       "Total length of bounded intervals with a wrong medium, world units."},
      {"persistence", "persistence",
       "The longest run of exact intervals with a wrong medium on one ray."},
      {"t_ulps", "t ulps", "Largest error of t of a right first hit, in ulps of the number type."},
      {"point_rel", "point", "Largest relative error of its point.", true},
      {"normal_rad", "normal", "Largest angle between its normal and the exact one, radians.",
       true},
      {"worst_scene", "worst scene", "", true},
      {"worst_ray", "worst ray", "", true}};
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

std::vector<Value> row_of(const std::string& label, const census::Cell& cell) {
  std::vector<Value> row{label, cell.method, cell.number,
                         cell.significand_bits == 0 ? Value(std::string("exact"))
                                                    : Value(std::uint64_t(cell.significand_bits)),
                         cell.rays};
  for (const std::uint64_t count : cell.with) {
    row.emplace_back(Rate{count, cell.rays});
  }
  row.emplace_back(Rate{cell.lamina_fronts_seen, cell.lamina_fronts});
  row.emplace_back(Rate{cell.lamina_backs_seen, cell.lamina_backs});
  row.emplace_back(cell.wrong_length);
  row.emplace_back(std::uint64_t(cell.persistence));
  row.emplace_back(cell.largest.t_ulps);
  row.emplace_back(cell.largest.point_rel);
  row.emplace_back(cell.largest.normal_rad);
  row.emplace_back(cell.worst ? cell.worst->scene : std::string());
  row.emplace_back(cell.worst ? ray_text(cell.worst->ray) : std::string());
  return row;
}

// For each method, a ray of the cell with the most wrong first hits.
std::vector<const census::Cell*> cells_to_replay(const census::Census& census) {
  std::vector<const census::Cell*> chosen;
  for (const census::Cell& cell : census.cells) {
    if (!cell.worst) {
      continue;
    }
    using census::Artifact;
    if (chosen.empty() || chosen.back()->method != cell.method) {
      chosen.push_back(&cell);
    } else if (cell[Artifact::FirstWrong] > (*chosen.back())[Artifact::FirstWrong]) {
      chosen.back() = &cell;
    }
  }
  return chosen;
}

}  // namespace

Table census_table(const std::vector<LabelledCensus>& censuses, const Column& label_column,
                   const std::string& title) {
  Table table{title, columns(label_column), {}, {}};
  for (const auto& [label, census] : censuses) {
    for (const census::Cell& cell : census.cells) {
      table.rows.push_back(row_of(label, cell));
    }
    table.notes.push_back(fmt::format(
        "{}: {} rays; {} of them lie in a carrier, are counted apart and not judged; {} of the "
        "others meet coincident surfaces.",
        label, census.rays, census.in_carrier, census.with_coincidence));
    for (const census::Cell* cell : cells_to_replay(census)) {
      table.notes.push_back(
          fmt::format("To replay: `lamina explain '{}' --ray \"{}\" --methods {} --numbers {}`",
                      cell->worst->scene, ray_text(cell->worst->ray), cell->method, cell->number));
    }
    if (census.interrupted) {
      table.notes.emplace_back("Interrupted: the counts are of the rays that were finished.");
    }
  }
  return table;
}

}  // namespace lamina::report
