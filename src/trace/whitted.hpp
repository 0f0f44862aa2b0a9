// Whitted's model: the ray tree of a pixel, and its colour.
#pragma once

#include <memory>

#include "method/method.hpp"
#include "trace/image.hpp"
#include "trace/ray_path.hpp"

namespace lamina::trace {

/// Told of each ray of a tree when the method has run on it, depth first.
class TreeObserver {
 public:
  virtual ~TreeObserver() = default;

  virtual void primary(const geometry::ExactRay& ray, const RayPath& path,
                       const method::Report& report) = 0;
  /// A ray spawned from the one before it on the path.
  virtual void spawned(Branch branch, const geometry::ExactPoint& direction, const RayPath& path,
                       const method::Report& report) = 0;
  /// The spawned ray that is last on the path is done.
  virtual void back() = 0;
};

struct RenderOptions {
  method::Method method;
  SpawnPolicy policy;
  int depth = 5;  ///< of the tree: 0 for primary rays, and their shadow rays, only
};

/// Colours of pixels by Whitted's model (1980), as van Wijk 1984, 6, and W&T use it: at an
/// interface ambient light, and of each light that is not in shadow the diffuse light and the
/// highlight (Phong's); a reflected ray where the material mirrors; a transmitted one where it is
/// transparent, by Snell's law, and reflected at total internal reflection. The surface is that
/// of the material that the ray enters, or else of the one that it leaves (W&T 3.1). Shadow rays
/// go straight through transparent surfaces, which weaken the light. No Fresnel term.
///
/// The light that comes from a surface with colour C, opacity a and mirror factor m is
///   (1 - m) (a (ambient C + sum of diffuse C cos) + (1 - a) transmitted) + m reflected
/// and the highlights, where a material is entered; where one is left and none entered, a is 0 and
/// there are no highlights. Geometry is in the path's number type, light in double.
class Whitted {
 public:
  /// `observer` may be null.
  Whitted(const scene::Scene& scene, std::unique_ptr<RayPath> path, const RenderOptions& options,
          TreeObserver* observer)
      : scene_(scene), path_(std::move(path)), options_(options), observer_(observer) {
    spawn_.policy = options.policy;
  }

  /// The light that a primary ray brings; black beyond the tree's depth.
  [[nodiscard]] Color color(const geometry::ExactRay& primary);

 private:
  struct Surface;

  Color seen(const geometry::Vector3<double>& direction, int depth);
  Color lit(const Surface& surface);
  double light_from(const scene::Light& lamp);
  std::optional<Color> spawned(Branch branch, int depth);

  const scene::Scene& scene_;
  std::unique_ptr<RayPath> path_;
  RenderOptions options_;
  TreeObserver* observer_;
  Spawn spawn_;  // of the ray that is spawned next
  method::Report report_;
  method::Report shadow_report_;
};

/// The colour of a material at a point: its texture's.
Color texture_color(const scene::Material& material, const geometry::Vector3<double>& point);

}  // namespace lamina::trace
