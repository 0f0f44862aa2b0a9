#include "trace/whitted.hpp"

#include <algorithm>
#include <cmath>

namespace lamina::trace {
namespace {

using geometry::nearest_double;
using geometry::normalised;
using Vector = geometry::Vector3<double>;

Color mixed(const Color& a, const Color& b, double part_of_b) {
  return (1 - part_of_b) * a + part_of_b * b;
}

Color product(const Color& a, const Color& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

Color color_of(const std::array<double, 3>& rgb) { return {rgb[0], rgb[1], rgb[2]}; }

}  // namespace

Color texture_color(const scene::Material& material, const Vector& point) {
  const Color first{material.color[0], material.color[1], material.color[2]};
  const Color second = color_of(material.second_color);
  const Vector p = (1 / material.grain) * point;
  switch (material.texture) {
    case scene::Texture::None:
      break;
    case scene::Texture::Wood: {
      // Rings that are neither round nor straight along the axis; each darkens slowly and ends.
      const double wobble = 0.15 * std::sin(3 * std::atan2(p.y, p.x)) + 0.2 * std::sin(0.7 * p.z);
      const double ring = std::hypot(p.x, p.y) + wobble;
      const double part = ring - std::floor(ring);
      return mixed(first, second, part * part);
    }
    case scene::Texture::Marble: {
      const double bent = p.x + 0.35 * std::sin(2.1 * p.y + std::sin(1.7 * p.z)) +
                          0.15 * std::sin(4.3 * p.z + 2 * std::sin(3.1 * p.y));
      const double wave = 0.5 + 0.5 * std::sin(2 * M_PI * bent);
      return mixed(first, second, wave * wave * wave);
    }
    case scene::Texture::Checker: {
      const double sum = std::floor(p.x) + std::floor(p.y) + std::floor(p.z);
      return sum == 2 * std::floor(sum / 2) ? first : second;
    }
  }
  return first;
}

/// What shading asks of a hit.
struct Whitted::Surface {
  const scene::Material& material;
  Vector point;
  Vector normal;   // unit, on the side that the ray comes from
  Vector towards;  // unit, where the ray goes
  Color color;
};

Color Whitted::color(const geometry::ExactRay& primary) {
  path_->start(primary);
  path_->run(options_.method, report_);
  if (observer_ != nullptr) {
    observer_->primary(primary, *path_, report_);
  }
  return seen(nearest_double(primary.direction), 0);
}

// What the present ray, which the method has just run on, brings.
Color Whitted::seen(const Vector& direction, int depth) {
  const std::optional<PathHit> hit = path_->hit();
  if (!hit) {
    return color_of(scene_.background);
  }
  const csg::Transition transition = report_.interfaces.front().transition;
  const bool enters = transition.to != csg::kEmpty;
  const scene::Material& material = scene_.materials[enters ? transition.to : transition.from];
  const Vector towards = normalised(direction);
  Vector normal = normalised(hit->gradient);
  normal = dot(normal, towards) > 0 ? -1.0 * normal : normal;

  // Behind a surface that is left there is nothing of its own to see.
  const double opacity = enters ? material.color[3] : 0;
  Color light{0, 0, 0};
  if (enters) {
    const Surface surface{material, hit->point, normal, towards,
                          texture_color(material, hit->point)};
    light = lit(surface);
  }
  double mirror = material.mirror;
  if (opacity < 1 && mirror < 1) {
    if (const auto through = spawned(Branch::Transmission, depth)) {
      light = light + (1 - mirror) * (1 - opacity) * *through;
    } else {
      mirror += (1 - mirror) * (1 - opacity);
    }
  }
  if (mirror > 0) {
    if (const auto reflected = spawned(Branch::Reflection, depth)) {
      light = light + mirror * *reflected;
    }
  }
  return light;
}

// Ambient, diffuse light and highlights.
Color Whitted::lit(const Surface& surface) {
  const scene::Material& material = surface.material;
  const double matt = (1 - material.mirror) * material.color[3];
  Color light = matt * material.ambient * surface.color;
  for (const scene::Light& lamp : scene_.lights) {
    const Vector to_lamp = normalised(nearest_double(lamp.position) - surface.point);
    const double cosine = dot(surface.normal, to_lamp);
    if (cosine <= 0) {
      continue;
    }
    const double brightness = light_from(lamp);
    if (brightness == 0) {
      continue;
    }
    const Vector mirrored =
        surface.towards - 2 * dot(surface.towards, surface.normal) * surface.normal;
    const double highlight =
        std::pow(std::max(0.0, dot(mirrored, to_lamp)), material.shininess) * material.specular;
    const Color of_lamp = brightness * color_of(lamp.color);
    light = light + matt * material.diffuse * cosine * product(of_lamp, surface.color) +
            highlight * of_lamp;
  }
  return light;
}

// The part of a lamp's light that reaches the present ray's hit.
double Whitted::light_from(const scene::Light& lamp) {
  spawn_.branch = Branch::Shadow;
  spawn_.light = lamp.position;
  const auto direction = path_->spawn(options_.method, spawn_);
  if (!direction) {
    return 0;
  }
  path_->run(options_.method, shadow_report_, Extent::WholeRay);
  if (observer_ != nullptr) {
    observer_->spawned(Branch::Shadow, *direction, *path_, shadow_report_);
    observer_->back();
  }
  double brightness = 1;
  for (const method::Interface& interface : shadow_report_.interfaces) {
    const auto& [from, to] = interface.transition;
    if (path_->t(interface.crossing) < 1) {
      // What is left counts if nothing goes through it: then the ray was in it, and hit it.
      const bool left_opaque = from != csg::kEmpty && scene_.materials[from].opaque();
      const double opacity = to != csg::kEmpty ? scene_.materials[to].color[3] : 0;
      brightness *= left_opaque ? 0 : 1 - opacity;
    }
  }
  path_->back();
  return brightness;
}

// What a spawned ray brings; none at total internal reflection, black beyond the tree's depth.
std::optional<Color> Whitted::spawned(Branch branch, int depth) {
  if (depth == options_.depth) {
    return Color{0, 0, 0};
  }
  spawn_.branch = branch;
  const auto direction = path_->spawn(options_.method, spawn_);
  if (!direction) {
    return std::nullopt;
  }
  path_->run(options_.method, report_);
  if (observer_ != nullptr) {
    observer_->spawned(branch, *direction, *path_, report_);
  }
  const Color light = seen(nearest_double(*direction), depth + 1);
  if (observer_ != nullptr) {
    observer_->back();
  }
  path_->back();
  return light;
}

}  // namespace lamina::trace
