#include "experiments/real-models/real_models.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/contract.hpp"
#include "census/truth.hpp"
#include "experiments/family_census.hpp"
#include "experiments/real-models/corpus.hpp"
#include "report/census_table.hpp"
#include "scene/rays.hpp"

namespace lamina::experiments {
namespace {

struct Model {
  std::string path;
  std::string name;
  scene::Scene scene;
};

// Does the order of coincident events matter on this ray: do two leaves own an interface, or
// is there a lamina?
bool meets_coincident_faces(const census::Truth& truth) {
  const auto& classes = truth.classes();
  return !truth.in_some_carrier() &&
         std::any_of(classes.begin(), classes.end(), [](const census::TruthClass& cls) {
           return cls.effect.owners.size() > 1 || cls.effect.lamina;
         });
}

std::vector<geometry::ExactRay> draw_rays(const scene::Scene& scene, Aim aim, std::uint64_t count,
                                          base::SeededStream& stream) {
  constexpr std::uint64_t kTriesPerRay = 20;
  const double distance = scene::distance_outside(*scene.bounds);
  std::vector<geometry::ExactRay> rays;
  census::Truth truth(scene);
  for (std::uint64_t tries = 0; rays.size() < count && tries < count * kTriesPerRay; ++tries) {
    geometry::ExactRay ray =
        scene::ray_through(scene::point_in(*scene.bounds, stream), distance, stream);
    if (aim == Aim::Coincident) {
      truth.find(ray);
      if (!meets_coincident_faces(truth)) {
        continue;
      }
    }
    rays.push_back(std::move(ray));
  }
  return rays;
}

census::Census model_census(const Model& model, Aim aim, std::uint64_t rays,
                            const Settings& settings) {
  constexpr std::uint64_t kRaysPerTask = 50;
  const std::size_t tasks = (rays + kRaysPerTask - 1) / kRaysPerTask;
  return census::run_census(
      settings.plan, tasks,
      [&](std::size_t index) {
        base::SeededStream stream(fmt::format("real-models/{}/{}", model.name, aim_name(aim)),
                                  settings.seed, index);
        const std::uint64_t count = std::min(kRaysPerTask, rays - index * kRaysPerTask);
        return census::Task{model.scene, draw_rays(model.scene, aim, count, stream)};
      },
      [](auto, auto) { return true; });
}

report::Table model_table(Aim aim) {
  report::Table table;
  table.title =
      fmt::format("real-models: first visible interface wrong, by model, {}",
                  aim == Aim::Uniform ? "uniform rays" : "rays that meet coincident faces");
  table.columns = {{"model", "model", ""},
                   {"leaves", "leaves", "Half-spaces of the model."},
                   {"shared", "shared", "Carriers that two leaves or more have."},
                   {"rays", "rays", ""}};
  return table;
}

void add_model_row(report::Table& table, const Model& model, const census::Census& census) {
  const auto shared =
      std::count_if(model.scene.leaves_of_carrier.begin(), model.scene.leaves_of_carrier.end(),
                    [](const auto& leaves) { return leaves.size() > 1; });
  std::vector<report::Value> row{model.name, std::uint64_t(model.scene.leaves.size()),
                                 static_cast<std::uint64_t>(shared), census.rays};
  const bool first = table.rows.empty();
  for (const census::Cell& cell : census.cells) {
    if (first) {
      table.columns.push_back({fmt::format("{}_{}", cell.method, cell.number),
                               fmt::format("{} {}", cell.method, cell.number), ""});
    }
    row.emplace_back(report::Rate{cell[census::Artifact::FirstWrong], cell.rays});
  }
  table.rows.push_back(std::move(row));
}

Result run(const Settings& settings) {
  std::vector<Model> models;
  std::vector<std::string> unread;
  for (const auto& path : corpus_models()) {
    try {
      models.push_back(
          {path.string(), path.stem().string(), scene::read_scene(path.string(), settings.read)});
    } catch (const base::InputError& error) {
      const std::string message = error.what();
      unread.push_back(
          path.filename().string() +
          message.substr(path.string().size(), message.find('\n') - path.string().size()));
    }
  }
  if (models.empty()) {
    throw base::InputError(fmt::format("no model in '{}' could be read", corpus_folder().string()));
  }
  const std::uint64_t rays_per_model =
      std::max<std::uint64_t>(1, settings.rays / (2 * models.size()));
  Result result;
  std::vector<report::LabelledCensus> censuses;
  std::vector<report::Table> by_model_tables;
  std::size_t done = 0;
  for (const Aim aim : {Aim::Coincident, Aim::Uniform}) {
    census::Census sum;
    report::Table by_model = model_table(aim);
    for (const Model& model : models) {
      if (!model.scene.bounds) {
        continue;
      }
      const census::Census census = model_census(model, aim, rays_per_model, settings);
      if (sum.cells.empty()) {
        sum = census;
      } else {
        sum.merge(census);
      }
      add_model_row(by_model, model, census);
      if (!settings.progress(++done, 2 * models.size())) {
        result.interrupted = sum.interrupted = true;
        break;
      }
    }
    censuses.push_back({aim_name(aim), std::move(sum)});
    by_model_tables.push_back(std::move(by_model));
    if (result.interrupted) {
      break;
    }
  }
  result.tables.push_back(report::census_table(censuses, aim_column(), "real-models"));
  std::move(by_model_tables.begin(), by_model_tables.end(), std::back_inserter(result.tables));
  for (const std::string& message : unread) {
    result.tables.back().notes.push_back("Not read: " + message);
  }
  return result;
}

}  // namespace

Experiment real_models() {
  return {"real-models",
          "How often does each method see something else on real OpenSCAD models?",
          "Wyvill and Trotman 1990, section 2, on models that people made",
          22'000,
          {"float", "double", "exact"},
          run};
}

}  // namespace lamina::experiments
