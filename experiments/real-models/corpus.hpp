// The corpus of real OpenSCAD models, which is not part of the project.
#pragma once

#include <filesystem>
#include <vector>

namespace lamina::experiments {

/// The folder that LAMINA_CORPUS names, else ../shared/corpus beside the working directory.
/// Throws base::InputError, which says how to name it, if there is no such folder.
std::filesystem::path corpus_folder();

/// Its `.csg` files, by name.
std::vector<std::filesystem::path> corpus_models();

}  // namespace lamina::experiments
