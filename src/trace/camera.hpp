// Rays through the pixels of a scene's camera.
#pragma once

#include <cstdint>
#include <vector>

#include "base/seeded_stream.hpp"
#include "geometry/vector.hpp"
#include "scene/scene.hpp"

namespace lamina::trace {

struct ImageSize {
  int width = 640;
  int height = 480;
};

/// The ray from the eye through the middle of a pixel; (0, 0) is at the top left. Computed in
/// double and rounded to float, so that every number type holds it exactly. Throws
/// base::InputError if the camera's directions do not span an image.
geometry::ExactRay pixel_ray(const scene::Camera& camera, const ImageSize& size, double x,
                             double y);

/// Rays through uniformly random points of the camera's image, which is 4 by 3.
std::vector<geometry::ExactRay> camera_rays(const scene::Camera& camera, std::uint64_t count,
                                            base::SeededStream& stream);

}  // namespace lamina::trace
