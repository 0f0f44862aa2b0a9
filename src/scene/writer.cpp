#include "scene/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "scene/materials.hpp"

namespace lamina::scene {

using csg::LeafIndex;
using csg::NodeIndex;
using csg::Operator;
using geometry::AffineMap;
using geometry::ExactPoint;
using number::Integer;
using number::Rational;
using surface::Kind;
using surface::LocalSurface;

namespace {

Value list(const std::vector<Rational>& numbers) {
  Value::List values;
  std::transform(numbers.begin(), numbers.end(), std::back_inserter(values),
                 [](const Rational& number) {
                   return Value{0, number};
                 });
  return {0, std::move(values)};
}

Value vector(const ExactPoint& v) { return list({v.x, v.y, v.z}); }

Node node(std::string name, std::vector<Value> values) {
  Node result;
  result.name = std::move(name);
  for (Value& value : values) {
    result.arguments.push_back({0, "", std::move(value)});
  }
  return result;
}

// The positive square root, if it is rational.
std::optional<Rational> positive_root(const Rational& square) {
  if (square <= 0) {
    return std::nullopt;
  }
  const Rational root(sqrt(Integer(numerator(square))), sqrt(Integer(denominator(square))));
  return root * root == square ? std::optional(root) : std::nullopt;
}

Node contour_node(Value::List points, geometry::ContourKind kind, bool closed) {
  Node result = node("contour", {Value{0, std::move(points)}});
  result.arguments.push_back({0, "kind", Value{0, std::string(name_of(kind))}});
  result.arguments.push_back({0, "closed", Value{0, closed}});
  return result;
}

Node sweep(const surface::SweptSurface& surface) {
  const geometry::Contour& contour = surface.contour();
  Value::List points;
  for (const geometry::PlanePoint& p : contour.points()) {
    points.push_back(list({p.u, p.v}));
  }
  Node child = contour_node(std::move(points), contour.kind(), contour.closed());
  Node result = node(std::string(name_of(surface.sweep())), {});
  if (surface.sweep() == surface::Sweep::GeneralisedConic) {
    result.arguments.push_back({0, "x", list(surface.scaling().x)});
    result.arguments.push_back({0, "y", list(surface.scaling().y)});
  }
  if (surface.sweep() != surface::Sweep::Rotational) {
    result.arguments.push_back({0, "capped", Value{0, false}});
  }
  result.children.push_back(std::move(child));
  return result;
}

Node sweep(const surface::SphereSweep& surface) {
  const geometry::Trajectory& trajectory = surface.trajectory();
  Value::List points;
  for (const ExactPoint& p : trajectory.points()) {
    points.push_back(vector(p));
  }
  Node result = node("sphere_sweep", {Value{0, surface.radius()}});
  result.children.push_back(
      contour_node(std::move(points), trajectory.kind(), trajectory.closed()));
  return result;
}

// The primitive that reads back as the very same surface.
Node half_space(const LocalSurface& surface) {
  const auto& c = surface.coefficients;
  switch (surface.kind) {
    case Kind::Plane:
      return node("halfspace", {list({c[0], c[1], c[2]}), Value{0, Rational(-c[3])}});
    case Kind::Torus:
      return node("torus", {Value{0, c[0]}, Value{0, c[1]}});
    case Kind::Sweep:
      return surface.sweep ? sweep(*surface.sweep) : sweep(*surface.sphere_sweep);
    case Kind::Quadric:
      break;
  }
  if (const auto radius = positive_root(-c[9])) {
    if (surface == surface::sphere(*radius)) {
      return node("sphere", {Value{0, *radius}});
    }
    if (surface == surface::infinite_cylinder(*radius)) {
      return node("infinite_cylinder", {Value{0, *radius}});
    }
  }
  if (const auto slope = positive_root(-c[2])) {
    if (surface == surface::infinite_cone(*slope, 0)) {
      return node("cone", {Value{0, *slope}});
    }
  }
  Value::List rows{list({c[0], c[3], c[4], c[6]}), list({0, c[1], c[5], c[7]}),
                   list({0, 0, c[2], c[8]}), list({0, 0, 0, c[9]})};
  return node("quadric", {Value{0, std::move(rows)}});
}

using Linear = std::array<std::array<Rational, 3>, 3>;

Linear linear_part(const AffineMap& map) {
  Linear linear;
  for (std::size_t i = 0; i < 3; ++i) {
    std::copy_n(map.rows[i].begin(), 3, linear[i].begin());
  }
  return linear;
}

// The nodes that state a map, outermost first: none for the identity.
std::vector<Node> transforms(const AffineMap& map) {
  const auto& m = map.rows;
  const ExactPoint shift{m[0][3], m[1][3], m[2][3]};
  const Linear linear = linear_part(map);
  std::vector<Node> nodes;
  if (shift != ExactPoint{}) {
    nodes.push_back(node("translate", {vector(shift)}));
  }
  if (linear == linear_part({})) {
    return nodes;
  }
  const ExactPoint diagonal{m[0][0], m[1][1], m[2][2]};
  if (linear == linear_part(geometry::scaling(diagonal))) {
    nodes.push_back(node("scale", {vector(diagonal)}));
    return nodes;
  }
  // With the quaternion 1 + xi + yj + zk, m[2][1] - m[1][2] is 4 x / (1 + x^2 + y^2 + z^2), and
  // so on, and 1 + the trace is 4 / (1 + x^2 + y^2 + z^2).
  if (const Rational w = 1 + diagonal.x + diagonal.y + diagonal.z; w != 0) {
    const ExactPoint xyz{(m[2][1] - m[1][2]) / w, (m[0][2] - m[2][0]) / w, (m[1][0] - m[0][1]) / w};
    if (linear == linear_part(geometry::rotation(1, xyz))) {
      nodes.push_back(node("rotate", {list({1, xyz.x, xyz.y, xyz.z})}));
      nodes.back().arguments.front().name = "quaternion";
      return nodes;
    }
  }
  Value::List rows;
  for (const AffineMap::Row& row : m) {
    rows.push_back(list({row.begin(), row.end()}));
  }
  return {node("multmatrix", {Value{0, std::move(rows)}})};
}

// The shortest decimals that are read as these doubles.
Value decimal(double value) { return {0, number::parse_rational(fmt::format("{}", value))}; }

template <std::size_t Count>
Value decimals(const std::array<double, Count>& values) {
  Value::List list;
  std::transform(values.begin(), values.end(), std::back_inserter(list), decimal);
  return {0, std::move(list)};
}

// `material("name", ...)` with what is not as in a material of which nothing is stated.
Node look_of(const Material& material) {
  const Material plain;
  Node look = node("material", {Value{0, material.name}});
  const auto state = [&look](const char* name, bool differs, const auto& value) {
    if (differs) {
      look.arguments.push_back({0, name, value()});
    }
  };
  const auto number = [&](const char* name, double Material::*member) {
    state(name, material.*member != plain.*member, [&] { return decimal(material.*member); });
  };
  state("color", material.color != plain.color, [&] { return decimals(material.color); });
  state("index", material.refractive_index != plain.refractive_index, [&] {
    return Value{0, material.refractive_index};
  });
  number("mirror", &Material::mirror);
  number("ambient", &Material::ambient);
  number("diffuse", &Material::diffuse);
  number("specular", &Material::specular);
  number("shininess", &Material::shininess);
  state("texture", material.texture != plain.texture, [&] {
    return Value{0, std::string(name_of(material.texture))};
  });
  state("second_color", material.second_color != plain.second_color,
        [&] { return decimals(material.second_color); });
  number("grain", &Material::grain);
  return look;
}

class Writer {
 public:
  explicit Writer(const Scene& scene) : scene_(scene) {
    std::map<Linear, std::size_t> known;
    for (const AffineMap& to_local : scene.frames) {
      to_world_.push_back(inverse(to_local).value());
      linear_.push_back(known.try_emplace(linear_part(to_local), known.size()).first->second);
    }
    // Leaves are numbered from left to right, and children come before their parents.
    first_leaf_.resize(scene.tree.nodes().size());
    last_leaf_.resize(scene.tree.nodes().size());
    for (NodeIndex i = 0; i < first_leaf_.size(); ++i) {
      first_leaf_[i] = i < scene.leaves.size() ? i : first_leaf_[scene.tree.nodes()[i].left];
      last_leaf_[i] = i < scene.leaves.size() ? i : last_leaf_[scene.tree.nodes()[i].right];
    }
  }

  Node root() {
    Node root;
    root.name = "root";
    if (!scene_.tree.empty()) {
      Node solid = write(scene_.tree.root(), {});
      if (solid.name == "add") {
        return solid;  // the top level adds
      }
      root.children.push_back(std::move(solid));
    }
    return root;
  }

 private:
  // What the nodes around a node state.
  struct Context {
    AffineMap to_world;
    AffineMap to_local;
    std::string material = "default";
  };

  struct Wrapping {
    std::vector<Node> nodes;  // outermost first
    Context inside;
  };

  // Have all leaves below the node the same property?
  template <typename Property>
  [[nodiscard]] bool uniform(NodeIndex index, Property property) const {
    const auto leaf = scene_.leaves.begin();
    return std::all_of(leaf + first_leaf_[index], leaf + last_leaf_[index] + 1,
                       [&, first = property(leaf[first_leaf_[index]])](const Leaf& each) {
                         return property(each) == first;
                       });
  }

  // What all leaves below the node share, and the context does not have yet: the material, the
  // frame, or else the linear part of the frame, so that only translations are left.
  [[nodiscard]] Wrapping wrapping(NodeIndex index, const Context& context) const {
    Wrapping result{{}, context};
    const Leaf& first = scene_.leaves[first_leaf_[index]];
    const std::string& material = scene_.materials[first.medium].name;
    if (material != context.material &&
        uniform(index, [](const Leaf& leaf) { return leaf.medium; })) {
      result.nodes.push_back(node("material", {Value{0, material}}));
      result.inside.material = material;
    }
    const AffineMap& frame = scene_.frames[first.frame];
    if (uniform(index, [](const Leaf& leaf) { return leaf.frame; }) ||
        (linear_part(frame) != linear_part(context.to_local) &&
         uniform(index, [this](const Leaf& leaf) { return linear_[leaf.frame]; }))) {
      auto nodes = transforms(compose(context.to_local, to_world_[first.frame]));
      std::move(nodes.begin(), nodes.end(), std::back_inserter(result.nodes));
      result.inside.to_world = to_world_[first.frame];
      result.inside.to_local = frame;
    }
    return result;
  }

  // The operands that Tree makes this node from: the longest list that it balances like this.
  [[nodiscard]] std::vector<NodeIndex> operands(NodeIndex index, const Context& context) const {
    const auto& [op, left, right, parent] = scene_.tree.nodes()[index];
    if (op == Operator::Difference) {
      std::vector<NodeIndex> list{left};
      const auto rest = operands_as(Operator::Add, right, context);
      list.insert(list.end(), rest.begin(), rest.end());
      return list;
    }
    // The left half of a list has as many operands as the right one, or one less.
    const auto fits = [](const auto& a, const auto& b) {
      return a.size() == b.size() || a.size() + 1 == b.size();
    };
    auto a = operands_as(op, left, context);
    auto b = operands_as(op, right, context);
    if (!fits(a, b)) {
      const std::vector<NodeIndex> whole_left{left};
      const std::vector<NodeIndex> whole_right{right};
      if (fits(a, whole_right)) {
        b = whole_right;
      } else {
        a = whole_left;
        b = fits(a, b) ? b : whole_right;
      }
    }
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  // The operands of the node if it can be flattened into one with `op`, else the node itself.
  [[nodiscard]] std::vector<NodeIndex> operands_as(Operator op, NodeIndex index,
                                                   const Context& context) const {
    const bool flat = index >= scene_.leaves.size() && scene_.tree.nodes()[index].op == op &&
                      wrapping(index, context).nodes.empty();
    return flat ? operands(index, context) : std::vector{index};
  }

  Node write(NodeIndex index, const Context& context) {
    auto [nodes, inside] = wrapping(index, context);
    if (index < scene_.leaves.size()) {
      nodes.push_back(half_space(scene_.leaves[index].surface));
    } else {
      const Operator op = scene_.tree.nodes()[index].op;
      nodes.push_back(node(op == Operator::Add          ? "add"
                           : op == Operator::Difference ? "difference"
                                                        : "intersection",
                           {}));
      for (const NodeIndex operand : operands(index, inside)) {
        nodes.back().children.push_back(write(operand, inside));
      }
    }
    for (; nodes.size() > 1; nodes.pop_back()) {
      nodes[nodes.size() - 2].children.push_back(std::move(nodes.back()));
    }
    return std::move(nodes.front());
  }

  const Scene& scene_;
  std::vector<AffineMap> to_world_;    // by frame
  std::vector<std::size_t> linear_;    // by frame: equal where the linear parts are
  std::vector<LeafIndex> first_leaf_;  // below each node of the tree
  std::vector<LeafIndex> last_leaf_;
};

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
    }
    result += c == '\n' ? "\\n" : c == '\t' ? "\\t" : std::string(1, c);
  }
  return result + '"';
}

std::string text_of(const Value& value) {
  if (const auto* number = std::get_if<Rational>(&value.content)) {
    return number::to_text(*number);
  }
  if (const auto* text = std::get_if<std::string>(&value.content)) {
    return quoted(*text);
  }
  if (const auto* truth = std::get_if<bool>(&value.content)) {
    return *truth ? "true" : "false";
  }
  if (value.undefined()) {
    return "undef";
  }
  std::vector<std::string> items;
  for (const Value& item : std::get<Value::List>(value.content)) {
    items.push_back(text_of(item));
  }
  return fmt::format("[{}]", fmt::join(items, ", "));
}

void append(std::string& text, const Node& node, std::size_t indent) {
  std::vector<std::string> arguments;
  for (const Argument& argument : node.arguments) {
    arguments.push_back(argument.name.empty()
                            ? text_of(argument.value)
                            : fmt::format("{}={}", argument.name, text_of(argument.value)));
  }
  text += fmt::format("{}{}({})", node.modifiers, node.name, fmt::join(arguments, ", "));
  if (node.children.empty()) {
    text += ";\n";
  } else if (node.children.size() == 1) {
    text += ' ';
    append(text, node.children.front(), indent);
  } else {
    text += " {\n";
    for (const Node& child : node.children) {
      text.append(indent + 2, ' ');
      append(text, child, indent + 2);
    }
    text.append(indent, ' ');
    text += "}\n";
  }
}

}  // namespace

Node syntax_of(const Scene& scene) { return Writer(scene).root(); }

Node declarations_of(const Scene& scene) {
  Node root;
  root.name = "root";
  // The first is the empty medium.
  for (auto material = std::next(scene.materials.begin()); material != scene.materials.end();
       ++material) {
    Node look = look_of(*material);
    if (look.arguments.size() > 1) {
      root.children.push_back(std::move(look));
    }
  }
  const auto named = [](std::string name, Value value) {
    return Argument{0, std::move(name), std::move(value)};
  };
  if (scene.camera) {
    const Camera& camera = *scene.camera;
    root.children.push_back(node("camera", {}));
    root.children.back().arguments = {
        named("eye", vector(camera.eye)), named("look_at", vector(camera.look_at)),
        named("up", vector(camera.up)), named("fov", Value{0, camera.fov_degrees})};
  }
  for (const Light& light : scene.lights) {
    root.children.push_back(node("light", {}));
    root.children.back().arguments = {named("position", vector(light.position)),
                                      named("color", decimals(light.color))};
  }
  if (scene.background != Scene().background) {
    root.children.push_back(node("background", {decimals(scene.background)}));
  }
  return root;
}

std::string text_of(const Node& root) {
  std::string text;
  for (const Node& node : root.children) {
    append(text, node, 0);
  }
  return text;
}

}  // namespace lamina::scene
