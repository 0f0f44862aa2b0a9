#include "trace/camera.hpp"

#include <cmath>

#include "base/contract.hpp"

namespace lamina::trace {
namespace {

using Vector = geometry::Vector3<double>;

// Throws if the camera does not say it.
Vector direction_of(const Vector& v) {
  if (!(dot(v, v) > 0)) {
    throw base::InputError(
        "camera: eye and look_at must differ, and up must not point along the view");
  }
  return geometry::normalised(v);
}

geometry::ExactPoint rounded_to_float(const Vector& v) {
  const auto exact = [](double value) { return number::Rational(static_cast<float>(value)); };
  return {exact(v.x), exact(v.y), exact(v.z)};
}

}  // namespace

geometry::ExactRay pixel_ray(const scene::Camera& camera, const ImageSize& size, double x,
                             double y) {
  const Vector eye = geometry::nearest_double(camera.eye);
  const Vector forward = direction_of(geometry::nearest_double(camera.look_at) - eye);
  const Vector right = direction_of(cross(forward, geometry::nearest_double(camera.up)));
  const Vector up = cross(right, forward);
  const double half_height = std::tan(number::nearest_double(camera.fov_degrees) * M_PI / 360);
  const double pixel = 2 * half_height / size.height;
  const double across = (x + 0.5 - 0.5 * size.width) * pixel;
  const double upward = (0.5 * size.height - y - 0.5) * pixel;
  return {rounded_to_float(eye),
          rounded_to_float(direction_of(forward + across * right + upward * up))};
}

std::vector<geometry::ExactRay> camera_rays(const scene::Camera& camera, std::uint64_t count,
                                            base::SeededStream& stream) {
  const ImageSize size;
  std::vector<geometry::ExactRay> rays;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double x = stream.uniform(-0.5, size.width - 0.5);
    rays.push_back(pixel_ray(camera, size, x, stream.uniform(-0.5, size.height - 0.5)));
  }
  return rays;
}

}  // namespace lamina::trace
