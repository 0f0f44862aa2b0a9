
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/contract.hpp"
#include "census/truth.hpp"
#include "experiments/all_experiments.hpp"
#include "experiments/real-models/corpus.hpp"
#include "scene/rays.hpp"

namespace lamina::experiments {
namespace {

enum class Aim : std::uint8_t { Coincident, Uniform };

std::string name_of(Aim aim) { return aim == Aim::Uniform ? "uniform" : "coincident"; }

struct Model {
  std::string name;
  std::shared_ptr<const scene::Scene> scene;
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

std::vector<Model> read_models(const Settings& settings) {
  std::vector<Model> models;
  for (const auto& path : corpus_models()) {
    try {
      auto scene = std::make_shared<scene::Scene>(scene::read_scene(path.string(), settings.read));
      if (scene->bounds) {
        models.push_back({path.stem().string(), std::move(scene)});
      }
    } catch (const base::InputError& error) {
      const std::string message = error.what();
      settings.warn("not read: " + message.substr(0, message.find('\n')));
    }
  }
  if (models.empty()) {
    throw base::InputError(fmt::format("no model in '{}' could be read", corpus_folder().string()));
  }
  return models;
}

constexpr std::uint64_t kRaysPerTask = 50;

std::vector<Series> series(const Settings& settings) {
  const std::vector<Model> models = read_models(settings);
  const std::uint64_t rays = std::max<std::uint64_t>(1, settings.rays / (2 * models.size()));
  std::vector<Series> all;
  for (const Aim aim : {Aim::Coincident, Aim::Uniform}) {
    for (const Model& model : models) {
      const auto& carriers = model.scene->leaves_of_carrier;
      const auto shared = std::count_if(carriers.begin(), carriers.end(),
                                        [](const auto& leaves) { return leaves.size() > 1; });
      const auto task = [model, aim, rays, seed = settings.seed](std::size_t index) {
        base::SeededStream stream(fmt::format("real-models/{}/{}", model.name, name_of(aim)), seed,
                                  index);
        const std::uint64_t count = std::min(kRaysPerTask, rays - index * kRaysPerTask);
        return census::Task{*model.scene, draw_rays(*model.scene, aim, count, stream)};
      };
      all.push_back({{name_of(aim), model.name, std::uint64_t(model.scene->leaves.size()),
                      static_cast<std::uint64_t>(shared)},
                     settings.plan,
                     static_cast<std::size_t>((rays + kRaysPerTask - 1) / kRaysPerTask),
                     task});
    }
  }
  return all;
}

// First visible interface wrong: a row for each model, a column for each method and number type.
report::Table model_table(const Experiment& experiment, const std::string& aim,
                          const std::vector<report::LabelledCensus>& counted) {
  report::Table table{"models-" + aim,
                      fmt::format("real-models: first visible interface wrong, {} rays", aim),
                      {experiment.labels.begin() + 1, experiment.labels.end()},
                      {},
                      {}};
  table.columns.push_back({"rays", "rays", ""});
  for (const auto& [labels, census, options] : counted) {
    if (labels[0] != census::Label(aim)) {
      continue;
    }
    std::vector<report::Value> row;
    std::transform(labels.begin() + 1, labels.end(), std::back_inserter(row), report::value_of);
    row.emplace_back(census.rays);
    for (const census::Cell& cell : census.cells) {
      if (table.rows.empty()) {
        table.columns.push_back({fmt::format("{}_{}", cell.method, cell.number),
                                 fmt::format("{} {}", cell.method, cell.number), ""});
      }
      row.emplace_back(report::Rate{cell[census::Artifact::FirstWrong], cell.rays});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

// All models together: one census for each kind of rays.
std::vector<report::LabelledCensus> over_models(
    const std::vector<report::LabelledCensus>& counted) {
  std::vector<report::LabelledCensus> sums;
  for (const auto& [labels, census, options] : counted) {
    if (sums.empty() || sums.back().labels[0] != labels[0]) {
      sums.push_back({{labels[0]}, census, options});
    } else {
      sums.back().census.merge(census);
    }
  }
  return sums;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<report::LabelledCensus>& counted) {
  return {report::census_table(over_models(counted), {experiment.labels[0]}, experiment.name),
          model_table(experiment, name_of(Aim::Coincident), counted),
          model_table(experiment, name_of(Aim::Uniform), counted)};
}

}  // namespace

Experiment real_models() {
  return {.name = "real-models",
          .question = "How often does each method see something else on real OpenSCAD models?",
          .source = "Wyvill and Trotman 1990, section 2, on models that people made",
          .labels = {{"aim", "aim",
                      "Where rays go: uniform, at a random point of the bounding box; coincident, "
                      "those of them on which coincident faces matter."},
                     {"model", "model", ""},
                     {"leaves", "leaves", "Half-spaces of the model."},
                     {"shared", "shared", "Carriers that two leaves or more have."}},
          .default_rays = 17'600,
          .default_numbers = "float,double,exact",
          .series = series,
          .tables = tables};
}

}  // namespace lamina::experiments
