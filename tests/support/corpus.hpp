// The corpus of real models, which is beside the project and not in it.
#pragma once

#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace lamina::support {

inline constexpr const char* kNoCorpus =
    "the corpus of real models is absent: set LAMINA_CORPUS to its folder";

/// LAMINA_CORPUS, else ../shared/corpus beside the project; none if there is no such folder.
inline std::optional<std::filesystem::path> corpus_folder() {
  const char* const stated = std::getenv("LAMINA_CORPUS");
  std::filesystem::path folder =
      stated != nullptr ? std::filesystem::path(stated)
                        : std::filesystem::path(LAMINA_SOURCE_DIR) / ".." / "shared" / "corpus";
  if (!std::filesystem::is_directory(folder)) {
    return std::nullopt;
  }
  return folder;
}

/// Its models of cubes, spheres, cylinders, extruded polygons, maps, colours and the three
/// operators alone.
inline constexpr std::array kReadableModels{"bosl2_attachments_ex068",
                                            "bosl2_distributors_ex036",
                                            "bosl2_shapes3d_ex022",
                                            "dankamongmen_lga2011_narrow",
                                            "dankamongmen_sataplugs",
                                            "dankamongmen_twitchpiece",
                                            "jbazant_bed_socket",
                                            "jbazant_clock_stand",
                                            "jbazant_hook",
                                            "jbazant_mosaic",
                                            "jbazant_paka_koule",
                                            "jsconan_sample_sample",
                                            "jsconan_samples_honeycombed",
                                            "koen_lee_drill_centerer",
                                            "koen_lee_peaucellier",
                                            "koen_lee_pillenbakje_deksel",
                                            "koen_lee_stoelpootdopje",
                                            "koen_lee_thermostat_housing",
                                            "martmaiste_apollo_air_1_wall_mount",
                                            "martmaiste_pole_mount_round",
                                            "martmaiste_usb_cap",
                                            "oscex_csg",
                                            "oscex_example001",
                                            "oscex_example003",
                                            "oscex_example004",
                                            "oscex_example005",
                                            "oscex_example019"};

}  // namespace lamina::support
