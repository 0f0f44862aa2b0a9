#include "experiments/real-models/corpus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "base/contract.hpp"

namespace lamina::experiments {

std::filesystem::path corpus_folder() {
  const char* const named = std::getenv("LAMINA_CORPUS");
  const std::filesystem::path folder = named != nullptr ? named : "../shared/corpus";
  if (!std::filesystem::is_directory(folder)) {
    throw base::InputError(fmt::format(
        "the corpus of real models is not at '{}': set LAMINA_CORPUS to the folder that has it",
        folder.string()));
  }
  return folder;
}

std::vector<std::filesystem::path> corpus_models() {
  std::vector<std::filesystem::path> models;
  for (const auto& entry : std::filesystem::directory_iterator(corpus_folder())) {
    if (entry.path().extension() == ".csg") {
      models.push_back(entry.path());
    }
  }
  std::sort(models.begin(), models.end());
  return models;
}

}  // namespace lamina::experiments
