#include "support/reference_random.hpp"

#include <algorithm>

namespace lamina::reference {
namespace {

using base::SeededStream;
using Form = std::array<Rational, 4>;  // a linear form of x, y, z, 1

// Of either sign, and mostly no binary fraction.
Rational random_rational(SeededStream& stream) {
  const Rational numerator = stream.integer(1, 9);
  const Rational value = numerator / stream.integer(1, 9);
  return stream.chance(0.5) ? value : Rational(-value);
}

Rational random_positive(SeededStream& stream) { return abs(random_rational(stream)); }

std::vector<Rational> random_rationals(SeededStream& stream, std::size_t count) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(random_rational(stream));
  }
  return result;
}

// w, x, y, z in -3 .. 3 with w != 0.
std::vector<Rational> random_quaternion(SeededStream& stream) {
  std::vector<Rational> q{Rational(stream.integer(1, 3))};
  for (int i = 0; i < 3; ++i) {
    q.emplace_back(stream.integer(-3, 3));
  }
  return q;
}

std::vector<Rational> random_normal(SeededStream& stream) {
  return {stream.integer(-2, 2), stream.integer(-2, 2), stream.integer(1, 3)};
}

Step translate(const Vector& by) { return {Step::Kind::Translate, {by[0], by[1], by[2]}}; }

// Maps that cancel one another.
Chain detour(SeededStream& stream) {
  const std::vector<Rational> v = random_rationals(stream, 3);
  const Rational factor = random_rational(stream);
  switch (stream.below(5)) {
    case 0:
      return {{Step::Kind::Translate, v}, {Step::Kind::Translate, {-v[0], -v[1], -v[2]}}};
    case 1:
      return {{Step::Kind::Scale, v}, {Step::Kind::Scale, {1 / v[0], 1 / v[1], 1 / v[2]}}};
    case 2: {
      const auto q = random_quaternion(stream);
      return {
          {Step::Kind::Rotate, q},
          {Step::Kind::Rotate, {factor * q[0], -factor * q[1], -factor * q[2], -factor * q[3]}}};
    }
    case 3: {
      const auto n = random_normal(stream);
      return {{Step::Kind::Mirror, n},
              {Step::Kind::Mirror, {factor * n[0], factor * n[1], factor * n[2]}}};
    }
    default:
      return {};
  }
}

void append(Chain& chain, const Chain& steps) {
  chain.insert(chain.end(), steps.begin(), steps.end());
}

// Maps that leave the primitive where it is.
Chain symmetry(SeededStream& stream, const Primitive& primitive) {
  switch (primitive.kind) {
    case Primitive::Kind::Sphere:
      return {{Step::Kind::Rotate, random_quaternion(stream)}};
    case Primitive::Kind::Cylinder:
    case Primitive::Kind::Torus:
      return {{Step::Kind::Rotate, {stream.integer(1, 3), 0, 0, stream.integer(-3, 3)}}};
    case Primitive::Kind::Box:
    case Primitive::Kind::HalfSpace:
    case Primitive::Kind::Quadric:
      return {};
  }
  return {};
}

// What draws a scene's solids.
class Lattice {
 public:
  Lattice(SeededStream& stream, Rational step) : stream_(stream), step_(std::move(step)) {}

  Node solid() {
    Node node;
    const Vector place{at(0, 2), at(0, 2), at(0, 2)};
    node.chain.push_back(translate(place));
    switch (stream_.below(8)) {
      case 0:
      case 1:
      case 2:
        node.primitive = box();
        break;
      case 3:
      case 4:
        append(node.chain, axis());
        node.primitive = cylinder();
        break;
      case 5:
        return sphere();
      case 6:
        node.primitive = half_space();
        break;
      default:
        node.primitive = quadric();
        break;
    }
    return node;
  }

  Node sphere() {
    Node node;
    node.chain.push_back(translate({at(0, 2), at(0, 2), at(0, 2)}));
    node.primitive = {Primitive::Kind::Sphere, {at(1, 2)}};
    return node;
  }

  Node torus() {
    Node node;
    node.chain.push_back(translate({at(0, 2), at(0, 2), at(0, 2)}));
    append(node.chain, axis());
    const Rational major = at(1, 2);
    const Rational minor = at(1, 2);
    node.primitive = {Primitive::Kind::Torus, {major, minor / stream_.integer(1, 2)}};
    return node;
  }

  // The same half-spaces, written in another way, or others that touch them.
  Node again(const Node& node) {
    if ((node.primitive.kind == Primitive::Kind::Sphere ||
         node.primitive.kind == Primitive::Kind::Cylinder) &&
        stream_.chance(0.4)) {
      return companion(node);
    }
    Node other = node;
    Primitive& primitive = other.primitive;
    append(other.chain, symmetry(stream_, primitive));
    if (primitive.kind == Primitive::Kind::HalfSpace ||
        primitive.kind == Primitive::Kind::Quadric) {
      const Rational factor = random_positive(stream_);
      // The complement shares the surface too.
      const Rational sign = stream_.chance(0.3) ? -1 : 1;
      for (Rational& number : primitive.numbers) {
        number *= sign * factor;
      }
    } else if (primitive.kind == Primitive::Kind::Sphere && stream_.chance(0.5)) {
      const Rational r = primitive.numbers[0];
      primitive = {Primitive::Kind::Quadric, std::vector<Rational>(16)};
      add_square(primitive, 1, {1, 0, 0, 0});
      add_square(primitive, 1, {0, 1, 0, 0});
      add_square(primitive, 1, {0, 0, 1, 0});
      add_square(primitive, -r * r, {0, 0, 0, 1});
    }
    return other;
  }

  // Another surface that touches that of a sphere or a cylinder all along a circle.
  Node companion(const Node& node) {
    Node other = node;
    const auto& n = node.primitive.numbers;
    if (node.primitive.kind == Primitive::Kind::Sphere) {
      append(other.chain, axis());
      other.primitive = {Primitive::Kind::Cylinder, {4 * n[0], n[0], n[0]}, true};
    } else {
      const Rational low = node.primitive.center ? Rational(-n[0] / 2) : Rational(0);
      other.chain.push_back(translate({0, 0, low}));
      other.primitive = {Primitive::Kind::Sphere, {std::max(n[1], n[2])}};
    }
    return other;
  }

 private:
  Rational at(int low, int high) { return step_ * stream_.integer(low, high); }

  // Turns z into one of the three axes.
  Chain axis() {
    switch (stream_.below(3)) {
      case 0:
        return {{Step::Kind::Rotate, {1, 1, 1, 1}}};
      case 1:
        return {{Step::Kind::Rotate, {1, 1, 0, 0}}};
      default:
        return {};
    }
  }

  Primitive box() {
    const bool center = stream_.chance(0.3);
    const Rational unit = center ? 2 * step_ : step_;
    return {
        Primitive::Kind::Box,
        {unit * stream_.integer(1, 2), unit * stream_.integer(1, 2), unit * stream_.integer(1, 2)},
        center};
  }

  Primitive cylinder() {
    const bool center = stream_.chance(0.3);
    const Rational height = (center ? 2 : 1) * at(1, 2);
    const Rational r1 = at(1, 2);
    if (stream_.chance(0.6)) {
      return {Primitive::Kind::Cylinder, {height, r1, r1}, center};
    }
    const Rational r2 = stream_.chance(0.5) ? Rational(0) : Rational(r1 / 2);
    return stream_.chance(0.5) ? Primitive{Primitive::Kind::Cylinder, {height, r1, r2}, center}
                               : Primitive{Primitive::Kind::Cylinder, {height, r2, r1}, center};
  }

  Primitive half_space() {
    std::vector<Rational> numbers{stream_.integer(-1, 1), stream_.integer(-1, 1), 0, at(0, 1)};
    if (numbers[0] == 0 && numbers[1] == 0) {
      numbers[2] = stream_.chance(0.5) ? 1 : -1;
    }
    const Rational factor = random_positive(stream_);
    for (Rational& number : numbers) {
      number *= factor;
    }
    return {Primitive::Kind::HalfSpace, numbers};
  }

  // The matrix of a product of two linear forms is not symmetric.
  static void add_product(Primitive& quadric, const Rational& factor, const Form& a,
                          const Form& b) {
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        quadric.numbers[4 * row + column] += factor * a[row] * b[column];
      }
    }
  }
  static void add_square(Primitive& quadric, const Rational& factor, const Form& a) {
    add_product(quadric, factor, a, a);
  }

  Primitive quadric() {
    Primitive result{Primitive::Kind::Quadric, std::vector<Rational>(16)};
    const Rational h = step_;
    const Form one{0, 0, 0, 1};
    switch (stream_.below(7)) {
      case 0:  // an ellipsoid that touches planes of the lattice
        add_square(result, 1, {1, 0, 0, 0});
        add_square(result, Rational(1) / 4, {0, 1, 0, 0});
        add_square(result, stream_.integer(1, 2), {0, 0, 1, 0});
        add_square(result, -h * h, one);
        break;
      case 1:  // a hyperboloid of one or two sheets, or the cone between them
        add_square(result, 1, {1, 0, 0, 0});
        add_square(result, 1, {0, 1, 0, 0});
        add_square(result, -1, {0, 0, 1, 0});
        add_square(result, h * h * stream_.integer(-1, 1), one);
        break;
      case 2:  // a paraboloid
        add_square(result, 1, {1, 0, 0, 0});
        add_square(result, 1, {0, 1, 0, 0});
        add_product(result, -h, {0, 0, 1, 0}, one);
        break;
      case 3:  // a slab between two planes of the lattice, or a plane twice
        add_product(result, 1, {1, 0, 0, 0}, {1, 0, 0, -at(0, 2)});
        break;
      case 4:  // two planes through a line
        add_product(result, 1, {1, 0, 0, -at(0, 1)}, {0, 1, 0, 0});
        break;
      case 5:  // one plane
        add_product(result, 1, {0, 1, 0, -at(0, 1)}, one);
        break;
      default:  // a parabolic cylinder
        add_square(result, 1, {0, 1, 0, 0});
        add_product(result, -h, {0, 0, 1, 0}, one);
        break;
    }
    const Rational factor = random_rational(stream_);
    for (Rational& number : result.numbers) {
      number *= factor;
    }
    return result;
  }

  SeededStream& stream_;
  Rational step_;
};

// A vertex of the lattice, or a point of an edge, a face, a cell or a circle.
Vector special_point(SeededStream& stream, const Rational& step) {
  Vector point;
  const std::uint64_t free = stream.below(5);  // coordinates off the lattice; 4: on a circle
  for (std::size_t i = 0; i < 3; ++i) {
    const bool off = i < free && free < 4;
    point[i] = off ? Rational(stream.integer(0, 24)) / 8 : Rational(stream.integer(0, 3));
  }
  if (free == 4) {
    const std::int64_t radius = stream.integer(1, 2);
    point[0] += Rational(3 * radius) / 5;
    point[1] += Rational(4 * radius) / 5;
  }
  std::rotate(point.begin(), point.begin() + static_cast<std::ptrdiff_t>(stream.below(3)),
              point.end());
  for (Rational& coordinate : point) {
    coordinate *= step;
  }
  return point;
}

// In the plane z = 0 of some solid's own coordinates: through the middle of those that have
// one, where surfaces touch along circles.
Ray middle_ray(SeededStream& stream, const RandomScene& scene) {
  const Node* solid = &scene.root;
  while (!solid->is_solid()) {
    solid = &solid->operands[stream.below(solid->operands.size())];
  }
  Ray ray;
  for (std::size_t i = 0; i < 2; ++i) {
    ray.origin[i] = scene.step * stream.integer(-12, 12) / 4;
    ray.direction[i] = scene.step * stream.integer(1, 9) / 4;
  }
  return mapped(solid->chain, ray);
}

Vector random_direction(SeededStream& stream, const Vector& from, const Rational& step) {
  Vector direction{};
  while (std::all_of(direction.begin(), direction.end(), [](const auto& c) { return c == 0; })) {
    const Vector to = special_point(stream, step);
    const bool along_lattice = stream.chance(0.4);
    for (std::size_t i = 0; i < 3; ++i) {
      direction[i] = along_lattice ? Rational(stream.integer(-1, 1)) : Rational(to[i] - from[i]);
    }
  }
  return direction;
}

}  // namespace

Node random_tree(SeededStream& stream, const std::vector<Node>& solids) {
  if (solids.size() == 1) {
    return solids.front();
  }
  Node node;
  node.operation = static_cast<Operation>(stream.below(3));
  for (std::size_t first = 0; first < solids.size();) {
    // The first operand leaves something to the others.
    const std::size_t most = solids.size() - first - (first == 0 ? 1 : 0);
    const std::size_t last = first + 1 + stream.below(most);
    node.operands.push_back(
        random_tree(stream, std::vector<Node>(solids.begin() + static_cast<std::ptrdiff_t>(first),
                                              solids.begin() + static_cast<std::ptrdiff_t>(last))));
    first = last;
  }
  return node;
}

Chain random_frame(SeededStream& stream) {
  Chain chain;
  chain.push_back({Step::Kind::Rotate, random_quaternion(stream)});
  chain.push_back({Step::Kind::Translate, random_rationals(stream, 3)});
  if (stream.chance(0.3)) {
    chain.push_back({Step::Kind::Mirror, random_normal(stream)});
  }
  if (stream.chance(0.5)) {
    const Rational s = random_rational(stream);
    chain.push_back({Step::Kind::Scale, stream.chance(0.5) ? std::vector<Rational>{s, s, s}
                                                           : random_rationals(stream, 3)});
  }
  return chain;
}

RandomScene random_scene(SeededStream& stream, const SceneChoices& choices) {
  RandomScene scene;
  scene.step = random_positive(stream);
  if (!stream.chance(0.125)) {
    scene.frame = random_frame(stream);
  }
  Lattice lattice(stream, scene.step);
  const std::size_t count = 2 + stream.below(3);
  std::vector<Node> solids;
  while (solids.size() < count) {
    const bool first = solids.empty();
    Node solid = choices.touching && first                ? lattice.sphere()
                 : choices.touching && solids.size() == 1 ? lattice.companion(solids.back())
                 : choices.tori && first                  ? lattice.torus()
                 : !first && stream.chance(0.3)           ? lattice.again(solids.back())
                                                          : lattice.solid();
    solid.material = choices.one_material ? 1 : static_cast<Medium>(stream.integer(1, 3));
    solids.push_back(std::move(solid));
  }
  for (Node& solid : solids) {
    Chain chain = scene.frame;
    append(chain, detour(stream));
    append(chain, solid.chain);
    solid.chain = std::move(chain);
  }
  scene.root = random_tree(stream, solids);
  return scene;
}

Ray float_ray(SeededStream& stream, const RandomScene& scene) {
  const auto point = [&](std::int64_t low, std::int64_t high) {
    Vector p;
    for (Rational& coordinate : p) {
      coordinate = scene.step * stream.integer(1000 * low, 1000 * high) / 1000;
    }
    return to_world(scene.frame, p, Kind::Point);
  };
  const auto rounded = [](Rational& value) {
    value = Rational(static_cast<float>(value.convert_to<double>()));
  };
  Ray ray;
  do {
    ray.origin = stream.chance(0.3) ? point(0, 3) : point(-6, 9);
    ray.direction = point(0, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      rounded(ray.origin[i]);
      ray.direction[i] -= ray.origin[i];
      rounded(ray.direction[i]);
    }
  } while (ray.direction == Vector{});
  return ray;
}

Ray special_ray(SeededStream& stream, const RandomScene& scene) {
  if (stream.chance(0.2)) {
    return middle_ray(stream, scene);
  }
  Ray ray;
  ray.origin = special_point(stream, scene.step);
  ray.direction = random_direction(stream, ray.origin, scene.step);
  const Rational factor = random_positive(stream);
  // From the point itself, or from elsewhere on the line.
  const Rational back = stream.chance(0.2) ? Rational(0) : Rational(stream.integer(-4, 24)) / 4;
  for (std::size_t i = 0; i < 3; ++i) {
    ray.origin[i] -= back * ray.direction[i];
    ray.direction[i] *= factor;
  }
  return mapped(scene.frame, ray);
}

Ray mapped(const Chain& chain, const Ray& ray) {
  return {to_world(chain, ray.origin, Kind::Point),
          to_world(chain, ray.direction, Kind::Direction)};
}

}  // namespace lamina::reference
