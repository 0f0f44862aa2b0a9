#include "report/census_table.hpp"

#include <fmt/format.h>

#include <map>

namespace lamina::report {

std::string ray_text(const geometry::ExactRay& ray) {
  const auto& [o, d] = ray;
  return fmt::format("{} {} {} {} {} {}", number::to_text(o.x), number::to_text(o.y),
                     number::to_text(o.z), number::to_text(d.x), number::to_text(d.y),
                     number::to_text(d.z));
}

Table census_table(const census::Census& census, const std::string& title) {
  Table table;
  table.title = title;
  table.columns = {{"method", "method", ""},
                   {"number", "number", ""},
                   {"bits", "bits", "Significand bits of the number type."},
                   {"rays", "rays", "", true}};
  for (const census::ArtifactText& text : census::artifact_texts()) {
    table.columns.push_back(
        {std::string(text.name), std::string(text.heading), std::string(text.definition)});
  }
  const auto column = [&table](std::string name, std::string heading, std::string definition,
                               bool only_for_programs = false) {
    table.columns.push_back(
        {std::move(name), std::move(heading), std::move(definition), only_for_programs});
  };
  column("lamina_front", "lamina front",
         "Laminae that all events enter, seen as a surface, of all such.");
  column("lamina_back", "lamina back",
         "Laminae that all events leave, seen as a surface, of all such.");
  column("wrong_length", "wrong length",
         "Total length of bounded intervals with a wrong medium, world units.");
  column("persistence", "persistence",
         "The longest run of exact intervals with a wrong medium on one ray.");
  column("t_ulps", "t ulps", "Largest error of t of a right first hit, in ulps of the number type.");
  column("point_rel", "point", "Largest relative error of its point.", true);
  column("normal_rad", "normal", "Largest angle between its normal and the exact one, radians.",
         true);
  column("worst_scene", "worst scene", "", true);
  column("worst_ray", "worst ray", "", true);

  std::map<std::string, const census::Cell*> worst_of_method;
  std::vector<std::string> methods;
  for (const census::Cell& cell : census.cells) {
    std::vector<Value> row{cell.method, cell.number,
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
    table.rows.push_back(std::move(row));

    // The cell with the most wrong first hits stands for its method.
    auto [found, added] = worst_of_method.try_emplace(cell.method, nullptr);
    if (added) {
      methods.push_back(cell.method);
    }
    using census::Artifact;
    if (cell.worst && (found->second == nullptr ||
                       cell[Artifact::FirstWrong] > (*found->second)[Artifact::FirstWrong])) {
      found->second = &cell;
    }
  }
  table.notes.push_back(fmt::format(
      "{} rays; {} of them lie in a carrier, are counted apart and not judged; {} of the others "
      "meet coincident surfaces.",
      census.rays, census.in_carrier, census.with_coincidence));
  for (const std::string& method : methods) {
    if (const census::Cell* cell = worst_of_method[method]; cell != nullptr) {
      table.notes.push_back(fmt::format(
          "A ray to replay: `lamina explain '{}' --ray \"{}\" --methods {} --numbers {}`",
          cell->worst->scene, ray_text(cell->worst->ray), cell->method, cell->number));
    }
  }
  if (census.interrupted) {
    table.notes.emplace_back("Interrupted: the counts are of the rays that were finished.");
  }
  return table;
}

}  // namespace lamina::report
