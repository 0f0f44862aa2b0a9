// A scene: exact leaves and carriers, one CSG tree, materials, camera and lights.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "csg/tree.hpp"
#include "geometry/affine.hpp"
#include "surface/carrier.hpp"
#include "surface/half_space.hpp"

namespace lamina::scene {

/// A pattern in space, of a material's colour and its second one.
enum class Texture : std::uint8_t {
  None,
  Wood,    ///< rings around the z axis
  Marble,  ///< wavy bands across x
  Checker,
};

/// What Whitted's model of shading asks of a material. Factors are in 0 .. 1.
struct Material {
  std::string name;
  std::array<double, 4> color{0.8, 0.8, 0.8, 1};  ///< red, green, blue, alpha in 0 .. 1
  number::Rational refractive_index{1};
  double ambient = 0.2;
  double diffuse = 0.8;
  double specular = 0.2;
  double shininess = 30;  ///< exponent of the highlight's cosine
  double mirror = 0;      ///< part of the light that is reflected
  Texture texture = Texture::None;
  std::array<double, 3> second_color{0, 0, 0};
  double grain = 1;  ///< length of one period of the texture, in the world

  [[nodiscard]] bool opaque() const { return color[3] >= 1; }

  friend bool operator==(const Material&, const Material&) = default;
};

/// One half-space of the tree.
struct Leaf {
  surface::LocalSurface surface;      ///< f in the coordinates of its frame
  std::uint32_t frame = 0;            ///< index into Scene::frames
  surface::CarrierIndex carrier = 0;  ///< index into Scene::carriers
  int side = 1;                       ///< inside is side * f <= 0 for the carrier's f
  csg::Medium medium = csg::kEmpty;
  std::string path;  ///< for people: `difference.cube[2].+x`
};

struct Camera {
  geometry::ExactPoint eye{0, -10, 0};
  geometry::ExactPoint look_at{0, 0, 0};
  geometry::ExactPoint up{0, 0, 1};
  number::Rational fov_degrees{30};  ///< vertical
};

struct Light {
  geometry::ExactPoint position;
  std::array<double, 3> color{1, 1, 1};
};

/// Axis-aligned box around what can be inside, from the scene's bounded solids.
struct Bounds {
  geometry::ExactPoint lower;
  geometry::ExactPoint upper;
};

struct Scene {
  std::string name;  ///< file name, or the family's spelling
  std::vector<geometry::AffineMap>
      frames;  ///< world to local, exact; shared by the leaves of a solid
  std::vector<surface::Carrier> carriers;  ///< distinct
  std::vector<Leaf> leaves;
  csg::Tree tree;
  std::vector<Material> materials;  ///< [0] is the empty medium, named ""
  std::optional<Camera> camera;
  std::vector<Light> lights;
  std::array<double, 3> background{0, 0, 0};
  std::optional<Bounds> bounds;       ///< none if no solid is bounded
  std::vector<std::string> warnings;  ///< `file:line:column: warning: ...`

  /// Leaves by carrier: leaves_of_carrier[c] ascending.
  std::vector<std::vector<csg::LeafIndex>> leaves_of_carrier;
};

/// How curved primitives are read.
struct ReadOptions {
  bool facets = false;  ///< spheres, cylinders and cones as OpenSCAD facets them
};

/// Returns the scene that the text states, exact. `name` stands in messages.
/// Throws base::InputError: `name:line:column: message`, then the line and a caret.
Scene parse_scene(const std::string& text, const std::string& name,
                  const ReadOptions& options = {});

/// Reads a file. Throws base::InputError if it cannot be read.
Scene read_scene(const std::string& path, const ReadOptions& options = {});

}  // namespace lamina::scene
