#include "census/minimise.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <compare>
#include <map>
#include <set>
#include <unordered_set>

#include "base/contract.hpp"
#include "scene/writer.hpp"

namespace lamina::census {
namespace {

using geometry::AffineMap;
using geometry::ExactPoint;
using geometry::ExactRay;
using number::Integer;
using number::Rational;
using scene::Node;
using scene::Scene;
using scene::Value;

std::array<Rational*, 6> coordinates(ExactRay& ray) {
  auto& [o, d] = ray;
  return {&o.x, &o.y, &o.z, &d.x, &d.y, &d.z};
}

// The multiple of a positive step that is nearest.
Rational nearest_multiple(const Rational& value, const Rational& step) {
  const Rational twice = 2 * abs(value) / step + 1;
  const Rational magnitude = Integer(numerator(twice) / (2 * denominator(twice))) * step;
  return value < 0 ? Rational(-magnitude) : magnitude;
}

ExactPoint nearest_multiple(const ExactPoint& point, const Rational& step) {
  return {nearest_multiple(point.x, step), nearest_multiple(point.y, step),
          nearest_multiple(point.z, step)};
}

// 2^exponent
Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << std::abs(exponent);
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

// 2^(result - 1) < |value| < 2^(result + 1).
int exponent_of(const Rational& value) {
  return static_cast<int>(msb(Integer(abs(numerator(value))))) -
         static_cast<int>(msb(Integer(denominator(value))));
}

// The value to so many significand bits, or one less.
Rational rounded(const Rational& value, int bits) {
  return value == 0 ? value : nearest_multiple(value, power_of_two(exponent_of(value) - bits + 1));
}

// The significand bits of the shortest binary float that holds the value; INT_MAX if none does.
int significand_bits(const Rational& value) {
  if (value == 0) {
    return 0;
  }
  const Integer magnitude = abs(numerator(value));
  return Integer(denominator(value) & (denominator(value) - 1)) == 0
             ? static_cast<int>(msb(magnitude) - lsb(magnitude)) + 1
             : INT_MAX;
}

constexpr int kBitsOfFloat = 24;
constexpr int kBitsOfAll = 8;  // no number type has fewer

Rational largest_coordinate(const ExactPoint& point) {
  return std::max({Rational(abs(point.x)), Rational(abs(point.y)), Rational(abs(point.z))});
}

// Without repetitions, the shortest text first; of equally short ones the nearest to the value.
std::vector<Rational> shortest_first(std::vector<Rational> candidates, const Rational& value) {
  const auto key = [&value](const Rational& candidate) {
    return std::tuple(number::to_text(candidate).size(), Rational(abs(candidate - value)),
                      candidate);
  };
  std::sort(candidates.begin(), candidates.end(),
            [&key](const Rational& a, const Rational& b) { return key(a) < key(b); });
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::erase(candidates, value);
  return candidates;
}

// Rationals that could stand for a positive one: small ones, and near ones with a small
// denominator or few digits. What holds the value holds them too: no error of representation
// comes in.
std::vector<Rational> simpler_numbers(const Rational& value) {
  std::vector<Rational> candidates{0, 1, 2, Rational(1, 10), Rational(1, 3)};
  for (const int denominator : {1, 3, 7}) {
    candidates.push_back(nearest_multiple(value, Rational(1, denominator)));
  }
  Rational unit = 1;  // the first decimal place of the value, and those behind it
  while (unit <= value) {
    unit *= 10;
  }
  while (unit > value) {
    unit /= 10;
  }
  constexpr int kDigits = 17;
  for (int digit = 0; digit < kDigits; ++digit, unit /= 10) {
    candidates.push_back(nearest_multiple(value, unit));
  }
  // The convergents p / q of the continued fraction.
  Integer p = 1;
  Integer q = 0;
  Integer earlier_p = 0;
  Integer earlier_q = 1;
  for (Rational rest = value; p * denominator(value) != q * numerator(value);) {
    const Integer whole = numerator(rest) / denominator(rest);
    earlier_p += whole * p;
    earlier_q += whole * q;
    swap(p, earlier_p);
    swap(q, earlier_q);
    candidates.emplace_back(p, q);
    if (rest != whole) {
      rest = 1 / Rational(rest - whole);
    }
  }
  const int bits = std::max(significand_bits(value), kBitsOfAll);
  std::erase_if(candidates, [bits](const Rational& c) { return significand_bits(c) > bits; });
  return shortest_first(std::move(candidates), value);
}

// Coordinates with fewer significand bits: number types hold what they held of the ray.
std::vector<Rational> shorter_coordinates(const Rational& value) {
  std::vector<Rational> candidates{0, 1, -1};
  constexpr int kBits = 53;
  for (int bits = 0; bits < kBits; ++bits) {
    candidates.push_back(rounded(value, bits));
  }
  return shortest_first(std::move(candidates), value);
}

template <typename Visit>
void visit_nodes(Node& node, Visit&& visit) {
  visit(node);
  for (Node& child : node.children) {
    visit_nodes(child, visit);
  }
}

std::vector<Node*> nodes_of(Node& root) {
  std::vector<Node*> nodes;
  visit_nodes(root, [&nodes](Node& node) { nodes.push_back(&node); });
  return nodes;
}

template <typename Content>
void append_contents(Value& value, std::vector<Content*>& contents) {
  if (auto* content = std::get_if<Content>(&value.content)) {
    contents.push_back(content);
  } else if (auto* list = std::get_if<Value::List>(&value.content)) {
    for (Value& item : *list) {
      append_contents(item, contents);
    }
  }
}

// The numbers, or the strings, in the order of the text.
template <typename Content>
std::vector<Content*> contents_of(Node& root) {
  std::vector<Content*> contents;
  visit_nodes(root, [&contents](Node& node) {
    for (scene::Argument& argument : node.arguments) {
      append_contents(argument.value, contents);
    }
  });
  return contents;
}

// A map or a material around one child.
bool is_wrapper(const Node& node) { return !node.arguments.empty() && node.children.size() == 1; }

// The node as it is written, without its children.
std::string head_of(const Node& node) {
  Node alone = node;
  alone.children.clear();
  Node root;
  root.children.push_back(std::move(alone));
  return scene::text_of(root);
}

// f of a plane in world coordinates.
surface::LocalSurface in_world(const surface::LocalSurface& plane, const AffineMap& to_local) {
  surface::LocalSurface result = plane;
  for (std::size_t column = 0; column < 4; ++column) {
    Rational sum = column == 3 ? plane.coefficients[3] : Rational(0);
    for (std::size_t row = 0; row < 3; ++row) {
      sum += plane.coefficients[row] * to_local.rows[row][column];
    }
    result.coefficients[column] = sum;
  }
  return result;
}

// Of a cone with the axis z, unless it is at the origin.
std::optional<Rational> apex_of(const surface::LocalSurface& surface) {
  const auto& c = surface.coefficients;
  if (surface.kind != surface::Kind::Quadric || c[2] == 0 || c[8] == 0) {
    return std::nullopt;
  }
  const Rational apex = -c[8] / (2 * c[2]);
  return c[9] == c[2] * apex * apex ? std::optional(apex) : std::nullopt;
}

// Does the ray start on no surface, touch none, lie in none, and cross no two different ones at
// the same place?
bool is_generic(const Scene& scene, const ExactRay& ray) {
  surface::RayMonomials monomials(ray);
  std::vector<number::Root> roots;
  for (const surface::Carrier& carrier : scene.carriers) {
    const surface::CarrierOnRay on_ray(carrier, ray, monomials);
    // Whether a ray touches a sweep is not known.
    if (carrier.sweep || on_ray.contains_ray() || !on_ray.touches().empty()) {
      return false;
    }
    for (number::Root& root : on_ray.crossings()) {
      if (root.multiplicity() > 1 || compare(root, Rational(0)) == 0) {
        return false;
      }
      roots.push_back(std::move(root));
    }
  }
  std::sort(roots.begin(), roots.end(),
            [](const auto& a, const auto& b) { return compare(a, b) < 0; });
  return std::adjacent_find(roots.begin(), roots.end(), [](const auto& a, const auto& b) {
           return compare(a, b) == 0;
         }) == roots.end();
}

struct Size {
  std::size_t leaves = 0;
  std::size_t characters = 0;
  std::size_t digits = 0;  // their sum: 1 is simpler than 9

  friend auto operator<=>(const Size&, const Size&) = default;
};

constexpr const char* kName = "scene";
constexpr const char* kLeftOut = "*";  // the modifier

class Reducer {
 public:
  Reducer(const Scene& scene, const ExactRay& ray, const Shows& shows, const Progress& progress)
      : shows_(shows), progress_(progress), all_leaves_(scene.leaves.size()) {
    best_.text = scene::text_of(scene::syntax_of(scene));
    best_.ray = ray;
    ray_bits_ = bits_of(ray);
    read_best();
    is_generic_ = is_generic(best_.scene, ray);
    LAMINA_REQUIRE(shows_(best_.scene, ray), "the case shows what is to stay");
  }

  Case run() {
    for (Size before; before != size_ && !stopped_;) {
      before = size_;
      drop_operands();
      drop_pairs();
      drop_wrappers();
      choose_coordinates();
      restate_leaves();
      shorten_names();
      shorten_numbers();
      shorten_sums();
      shorten_ray();
      aim_ray();
    }
    progress_(all_leaves_, all_leaves_);
    LAMINA_REQUIRE(shows_(best_.scene, best_.ray), "the text reads back as what was tested");
    return std::move(best_);
  }

 private:
  static Size size_of(const Scene& scene, const std::string& text, ExactRay ray) {
    Size size{scene.leaves.size(), 0, 0};
    const auto add = [&size](const std::string& written) {
      size.characters += written.size();
      for (const char c : written) {
        size.digits += c >= '0' && c <= '9' ? static_cast<std::size_t>(c - '0') : 0;
      }
    };
    add(text);
    for (const Rational* coordinate : coordinates(ray)) {
      add(number::to_text(*coordinate));
    }
    return size;
  }

  void read_best() {
    best_.scene = scene::parse_scene(best_.text, kName);
    root_ = scene::syntax_of(best_.scene);
    size_ = size_of(best_.scene, best_.text, best_.ray);
  }

  static int bits_of(ExactRay ray) {
    int bits = kBitsOfAll;
    for (const Rational* coordinate : coordinates(ray)) {
      bits = std::max(bits, significand_bits(*coordinate));
    }
    return bits;
  }

  // Does the new candidate show what is to stay? A number type that holds the given ray holds
  // all others, and they are generic if it is: both are difficulties of their own.
  bool shows(const Scene& scene, const std::string& text, ExactRay ray) {
    if (stopped_ || ray.direction == ExactPoint{} || bits_of(ray) > ray_bits_) {
      return false;
    }
    std::string key = text;
    for (const Rational* coordinate : coordinates(ray)) {
      key += ' ' + coordinate->str();
    }
    stopped_ = !progress_(all_leaves_ - size_.leaves, all_leaves_);
    return !stopped_ && tried_.insert(std::hash<std::string>{}(key)).second && shows_(scene, ray) &&
           (!is_generic_ || is_generic(scene, ray));
  }

  // Goes on with the candidate if it is smaller and shows what is to stay.
  bool accept(const Node& root, const ExactRay& ray) {
    if (stopped_) {
      return false;
    }
    try {
      const Scene scene = scene::parse_scene(scene::text_of(root), kName);
      const std::string text = scene::text_of(scene::syntax_of(scene));
      if (size_of(scene, text, ray) >= size_ || !shows(scene, text, ray)) {
        return false;
      }
      best_.text = text;
    } catch (const base::InputError&) {
      return false;  // a singular map, say
    }
    best_.ray = ray;
    read_best();
    return true;
  }
  bool accept(const Node& root) { return accept(root, best_.ray); }

  bool accept(const ExactRay& ray) {
    if (stopped_ || size_of(best_.scene, best_.text, ray) >= size_ ||
        !shows(best_.scene, best_.text, ray)) {
      return false;
    }
    best_.ray = ray;
    size_ = size_of(best_.scene, best_.text, ray);
    return true;
  }

  // Of each node's children, halves and smaller parts, the outermost nodes first.
  void drop_operands() {
    const auto count = [this](std::size_t index) {
      const auto nodes = nodes_of(root_);
      return index < nodes.size() ? nodes[index]->children.size() : 0;
    };
    for (std::size_t index = 0; index < nodes_of(root_).size(); ++index) {
      for (std::size_t part = count(index) / 2; part > 0; part /= 2) {
        for (std::size_t first = 0; first < count(index);) {
          Node edited = root_;
          std::vector<Node>& operands = nodes_of(edited)[index]->children;
          for (std::size_t i = first; i < std::min(first + part, operands.size()); ++i) {
            operands[i].modifiers = kLeftOut;
          }
          first += accept(edited) ? 0 : part;
        }
      }
    }
  }

  // What single operands cannot be dropped without.
  void drop_pairs() {
    constexpr std::size_t kNodes = 40;
    const std::size_t count = nodes_of(root_).size();
    for (std::size_t i = 1; i < count && count <= kNodes; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        Node edited = root_;
        const auto nodes = nodes_of(edited);
        nodes[i]->modifiers = nodes[j]->modifiers = kLeftOut;
        if (accept(edited)) {
          return drop_pairs();
        }
      }
    }
  }

  // Maps and materials: all of a kind, all that are equal, each.
  void drop_wrappers() {
    const auto drop_if = [this](const auto& dropped) {
      Node edited = root_;
      visit_nodes(edited, [&dropped](Node& node) {
        while (is_wrapper(node) && dropped(node)) {
          node = Node(std::move(node.children.front()));
        }
      });
      accept(edited);
    };
    std::set<std::string> names;
    std::set<std::string> heads;
    for (const Node* node : nodes_of(root_)) {
      if (is_wrapper(*node)) {
        names.insert(node->name);
        heads.insert(head_of(*node));
      }
    }
    for (const std::string& name : names) {
      drop_if([&name](const Node& node) { return node.name == name; });
    }
    for (const std::string& head : heads) {
      drop_if([&head](const Node& node) { return head_of(node) == head; });
    }
    for (std::size_t index = 0; index < nodes_of(root_).size(); ++index) {
      Node edited = root_;
      Node* node = nodes_of(edited)[index];
      if (is_wrapper(*node)) {
        *node = Node(std::move(node->children.front()));
        accept(edited);
      }
    }
  }

  // Makes the coordinates of some leaf those of the world.
  void choose_coordinates() {
    for (std::size_t f = 0; f < best_.scene.frames.size(); ++f) {
      const AffineMap to_local = best_.scene.frames[f];
      const AffineMap to_world = inverse(to_local).value();
      Scene moved = best_.scene;
      for (AffineMap& frame : moved.frames) {
        frame = compose(frame, to_world);
      }
      ExactRay ray{apply(to_local, best_.ray.origin),
                   apply_to_direction(to_local, best_.ray.direction)};
      for (Rational* coordinate : coordinates(ray)) {
        *coordinate = rounded(*coordinate, std::min(ray_bits_, kBitsOfFloat));
      }
      accept(scene::syntax_of(moved), ray);
    }
  }

  // Planes in world coordinates, and cones with the apex at the origin of theirs: all, then each.
  void restate_leaves() {
    const auto restate = [](Scene& scene, std::size_t index) {
      scene::Leaf& leaf = scene.leaves[index];
      const AffineMap to_local = scene.frames[leaf.frame];
      if (leaf.surface.kind == surface::Kind::Plane) {
        leaf.surface = in_world(leaf.surface, to_local);
        scene.frames.emplace_back();
      } else if (const auto apex = apex_of(leaf.surface)) {
        leaf.surface.coefficients[8] = leaf.surface.coefficients[9] = 0;
        scene.frames.push_back(compose(geometry::translation({0, 0, -*apex}), to_local));
      } else {
        return;
      }
      leaf.frame = static_cast<std::uint32_t>(scene.frames.size() - 1);
    };
    Scene edited = best_.scene;
    for (std::size_t leaf = 0; leaf < edited.leaves.size(); ++leaf) {
      restate(edited, leaf);
    }
    accept(scene::syntax_of(edited));
    for (std::size_t leaf = 0; leaf < best_.scene.leaves.size(); ++leaf) {
      edited = best_.scene;
      restate(edited, leaf);
      accept(scene::syntax_of(edited));
    }
  }

  void shorten_names() {
    std::vector<std::string> names;
    for (const std::string* name : contents_of<std::string>(root_)) {
      if (std::find(names.begin(), names.end(), *name) == names.end()) {
        names.push_back(*name);
      }
    }
    for (std::size_t i = 0; i < names.size() && i < 26; ++i) {
      Node edited = root_;
      for (std::string* name : contents_of<std::string>(edited)) {
        if (*name == names[i]) {
          *name = static_cast<char>('a' + i);
        }
      }
      accept(edited);
    }
  }

  // The magnitudes of the numbers, the longest first.
  std::vector<Rational> magnitudes() {
    std::vector<Rational> values;
    for (const Rational* number : contents_of<Rational>(root_)) {
      values.emplace_back(abs(*number));
    }
    values = shortest_first(std::move(values), 0);
    std::reverse(values.begin(), values.end());
    return values;
  }

  // Puts other magnitudes for those that have a new one, wherever they stand.
  bool accept_numbers(const std::map<Rational, Rational>& new_magnitude) {
    Node edited = root_;
    for (Rational* number : contents_of<Rational>(edited)) {
      if (const auto found = new_magnitude.find(abs(*number)); found != new_magnitude.end()) {
        *number = *number < 0 ? Rational(-found->second) : found->second;
      }
    }
    return accept(edited);
  }

  // The same number everywhere at once, so that what coincides by it still does; then one by one.
  void shorten_numbers() {
    for (const Rational& value : magnitudes()) {
      for (const Rational& simpler : simpler_numbers(value)) {
        if (accept_numbers({{value, simpler}})) {
          break;
        }
      }
    }
    for (std::size_t i = 0; i < contents_of<Rational>(root_).size(); ++i) {
      const Rational value = *contents_of<Rational>(root_)[i];
      if (value == 0) {
        continue;
      }
      for (const Rational& simpler : simpler_numbers(abs(value))) {
        Node edited = root_;
        *contents_of<Rational>(edited)[i] = value < 0 ? Rational(-simpler) : simpler;
        if (accept(edited)) {
          break;
        }
      }
    }
  }

  // Numbers one of which is the sum of the others, together: surfaces in different frames
  // coincide by such sums.
  void shorten_sums() {
    static constexpr std::size_t kTried = 12;
    const auto first_few = [](const Rational& value) {
      std::vector<Rational> few = simpler_numbers(value);
      few.resize(std::min(few.size(), kTried));
      few.push_back(value);
      return few;
    };
    const std::vector<Rational> values = magnitudes();
    for (auto a = values.begin(); a != values.end(); ++a) {
      for (auto b = a; b != values.end(); ++b) {
        const Rational sum = *a + *b;
        if (std::find(values.begin(), values.end(), sum) == values.end()) {
          continue;
        }
        const auto shorten = [&] {
          for (const Rational& x : first_few(*a)) {
            for (const Rational& y : a == b ? std::vector{x} : first_few(*b)) {
              if (accept_numbers({{*a, x}, {*b, y}, {sum, x + y}})) {
                return;
              }
            }
          }
        };
        shorten();
      }
    }
  }

  void shorten_ray() {
    for (std::size_t i = 0; i < 6; ++i) {
      const Rational value = *coordinates(best_.ray)[i];
      if (value == 0) {
        continue;
      }
      for (const Rational& shorter : shorter_coordinates(value)) {
        ExactRay ray = best_.ray;
        *coordinates(ray)[i] = shorter;
        if (accept(ray)) {
          break;
        }
      }
    }
  }

  // Rays of few bits near one of the events, from near by and from as far as now.
  void aim_ray() {
    Truth truth(best_.scene);
    truth.find(best_.ray);
    const auto [origin, direction] = best_.ray;
    const ExactPoint unit = Rational(1 / largest_coordinate(direction)) * direction;
    for (const TruthClass& cls : truth.classes()) {
      const double nearest = number::nearest_double(truth.t(cls));
      if (nearest == 0 || !std::isfinite(nearest)) {
        continue;
      }
      const Rational t(nearest);
      const ExactPoint event = origin + t * direction;
      const Rational distance = t * largest_coordinate(direction);
      for (const Rational& away : {Rational(1), power_of_two(exponent_of(distance))}) {
        for (int bits = 0; bits < kBitsOfFloat; ++bits) {
          ExactRay ray;
          ray.direction = nearest_multiple(unit, power_of_two(-bits));
          ray.origin = nearest_multiple(event - away * ray.direction, away * power_of_two(-bits));
          if (accept(ray)) {
            return;
          }
        }
      }
    }
  }

  const Shows& shows_;
  const Progress& progress_;
  std::size_t all_leaves_;
  Case best_;
  Node root_;  // of best_
  Size size_;  // of best_
  int ray_bits_ = 0;
  bool is_generic_ = false;
  std::unordered_set<std::size_t> tried_;  // hashes
  bool stopped_ = false;
};

}  // namespace

Case minimise(const Scene& scene, const ExactRay& ray, const Shows& shows,
              const Progress& progress) {
  return Reducer(scene, ray, shows, progress).run();
}

}  // namespace lamina::census
