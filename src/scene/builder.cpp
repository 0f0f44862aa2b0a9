#include "scene/builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "scene/arguments.hpp"
#include "scene/materials.hpp"
#include "scene/primitives.hpp"
#include "scene/sweeps.hpp"
#include "scene/transforms.hpp"

namespace lamina::scene {

using csg::Expression;
using csg::Medium;
using csg::Operator;
using geometry::AffineMap;
using geometry::ExactPoint;
using number::Rational;

namespace {

using namespace std::string_view_literals;

const Signature kNoArguments{"it without arguments"};
const Signature kRender{"render(convexity = number)", {"convexity"}};
const Signature kColor{R"(color(c = [r, g, b, a]) or color("name", alpha = number))",
                       {"c", "alpha"}};
const Signature kMaterial{
    R"(material("name", color = [r, g, b, a], index = number, mirror = 0 .. 1, ambient = 0 .. 1, )"
    R"(diffuse = 0 .. 1, specular = 0 .. 1, shininess = number, texture = "wood" | "marble" | )"
    R"("checker", second_color = [r, g, b], grain = length))",
    {"name", "color"},
    1,
    {"index", "mirror", "ambient", "diffuse", "specular", "shininess", "texture", "second_color",
     "grain"}};
const Signature kCamera{
    "camera(eye = [x, y, z], look_at = [x, y, z], up = [x, y, z], fov = degrees)",
    {"eye", "look_at", "up", "fov"},
    2};
const Signature kLight{"light(position = [x, y, z], color = [r, g, b])", {"position", "color"}, 1};
const Signature kBackground{"background(color = [r, g, b])", {"color"}, 1};

// Nodes of OpenSCAD that are known but not read.
constexpr std::array kUnsupported{"circle"sv,    "fill"sv,   "hull"sv,       "import"sv,
                                  "minkowski"sv, "offset"sv, "polyhedron"sv, "projection"sv,
                                  "resize"sv,    "roof"sv,   "surface"sv,    "text"sv};

struct Operation {
  std::string_view name;
  Operator op;
  const Signature& signature;
};

const std::array kOperations{Operation{"add", Operator::Add, kNoArguments},
                             Operation{"union", Operator::Add, kNoArguments},
                             Operation{"group", Operator::Add, kNoArguments},
                             Operation{"root", Operator::Add, kNoArguments},
                             Operation{"render", Operator::Add, kRender},
                             Operation{"difference", Operator::Difference, kNoArguments},
                             Operation{"intersection", Operator::Intersection, kNoArguments}};

bool left_out(const Node& node) { return node.has_modifier('%') || node.has_modifier('*'); }

// A node that states something about the scene, and is no object in it.
bool is_declaration(const Node& node) {
  return node.name == "camera" || node.name == "light" || node.name == "background" ||
         (node.name == "material" && node.ended_by_semicolon);
}

std::array<double, 4> rgba(const Color& color) {
  using number::nearest_double;
  return {nearest_double(color[0]), nearest_double(color[1]), nearest_double(color[2]),
          nearest_double(color[3])};
}

std::array<double, 3> rgb(const Color& color) {
  return {number::nearest_double(color[0]), number::nearest_double(color[1]),
          number::nearest_double(color[2])};
}

void extend(std::optional<Bounds>& bounds, const ExactPoint& point) {
  if (!bounds) {
    bounds = Bounds{point, point};
  }
  auto& [lower, upper] = *bounds;
  lower = {std::min(lower.x, point.x), std::min(lower.y, point.y), std::min(lower.z, point.z)};
  upper = {std::max(upper.x, point.x), std::max(upper.y, point.y), std::max(upper.z, point.z)};
}

// The box around the image of a box.
Bounds image(const AffineMap& map, const Bounds& box) {
  std::optional<Bounds> result;
  for (const Rational& x : {box.lower.x, box.upper.x}) {
    for (const Rational& y : {box.lower.y, box.upper.y}) {
      for (const Rational& z : {box.lower.z, box.upper.z}) {
        extend(result, apply(map, {x, y, z}));
      }
    }
  }
  return *result;
}

// What is in force at a node.
struct Context {
  AffineMap to_world;
  Medium medium = csg::kEmpty;  // empty: none is stated, so `default`
  FacetSettings facets;
  std::string path;      // of what encloses the node
  std::string position;  // `[k]` if the node is the k-th of several children

  [[nodiscard]] std::string path_to(std::string_view name) const {
    return fmt::format("{}{}{}{}", path, path.empty() ? "" : ".", name, position);
  }
};

// The index of an item in a list without repetitions; added if it is new.
template <typename Item, typename Key>
std::uint32_t index_in(std::vector<Item>& items, const Item& item,
                       std::map<Key, std::uint32_t>& known, const Key& key) {
  const auto [entry, added] = known.try_emplace(key, static_cast<std::uint32_t>(items.size()));
  if (added) {
    items.push_back(item);
  }
  return entry->second;
}

struct PlacedSolid {
  AffineMap to_local;
  std::optional<Bounds> box;  // in world coordinates
};

class Builder {
 public:
  Builder(const Source& source, const ReadOptions& options) : source_(source), options_(options) {}

  Scene build(const Node& root) {
    Context context;
    context.facets = Arguments(source_, root, kNoArguments).facets(context.facets);
    std::vector<const Node*> objects;
    for (const Node& node : root.children) {
      if (left_out(node)) {
        continue;
      }
      if (is_declaration(node)) {
        declare(node);
      } else {
        objects.push_back(&node);
      }
    }
    if (const Node* only = find_root_modifier(root)) {
      objects = {only};
    }
    finish(combine(Operator::Add, "", objects, context));
    return std::move(scene_);
  }

 private:
  // The first node with `!` in the order of the text.
  const Node* find_root_modifier(const Node& node) {
    const Node* found = nullptr;
    for (const Node& child : node.children) {
      if (left_out(child)) {
        continue;
      }
      const Node* here = child.has_modifier('!') ? &child : find_root_modifier(child);
      if (found == nullptr) {
        found = here;
      } else if (here != nullptr) {
        warn(*here, "only the first `!` counts");
      }
    }
    return found;
  }

  void warn(const Node& node, std::string_view message) {
    scene_.warnings.push_back(
        source_.warning(node.offset, fmt::format("`{}`: {}", node.name, message)));
  }

  void declare(const Node& node) {
    if (!node.children.empty()) {
      fail(node, "it takes no children: end it with `;`");
    }
    if (node.name == "material") {
      material(Arguments(source_, node, kMaterial));
    } else if (node.name == "camera") {
      camera(Arguments(source_, node, kCamera));
    } else if (node.name == "light") {
      const Arguments arguments(source_, node, kLight);
      const Color color = arguments.color("color").value_or(Color{1, 1, 1, 1});
      scene_.lights.push_back({*arguments.vector("position"), rgb(color)});
    } else {
      const Arguments arguments(source_, node, kBackground);
      scene_.background = rgb(arguments.color("color").value_or(Color{}));
    }
  }

  void camera(const Arguments& arguments) {
    if (scene_.camera) {
      arguments.fail("there is a camera already: keep one");
    }
    Camera camera;
    camera.eye = *arguments.vector("eye");
    camera.look_at = *arguments.vector("look_at");
    camera.up = arguments.vector("up").value_or(camera.up);
    camera.fov_degrees = arguments.number("fov").value_or(camera.fov_degrees);
    if (cross(camera.look_at - camera.eye, camera.up) == ExactPoint{}) {
      arguments.fail("the direction of view and `up` must span a plane");
    }
    if (camera.fov_degrees <= 0 || camera.fov_degrees >= 180) {
      arguments.fail_at("fov", "`fov` must be between 0 and 180");
    }
    scene_.camera = camera;
  }

  // The medium of a material node, which may state its look.
  Medium material(const Arguments& arguments) {
    const std::string name = *arguments.text("name");
    if (name.empty()) {
      arguments.fail_at("name", "the name must not be empty");
    }
    const Medium medium = medium_named(name, arguments);
    const std::optional<Material> look = look_of(arguments);
    if (look && !materials_.set_look(medium, *look)) {
      arguments.fail(fmt::format("`{}` has another look already", name));
    }
    return medium;
  }

  // What the arguments state of a material's look; nothing if they state nothing.
  static std::optional<Material> look_of(const Arguments& arguments) {
    Material look;
    bool stated = false;
    const auto read = [&](std::string_view parameter, double& value, double most) {
      if (const std::optional<Rational> given = arguments.size(parameter)) {
        value = number::nearest_double(*given);
        stated = true;
        if (value > most) {
          arguments.fail_at(parameter, fmt::format("`{}` must be from 0 to {}", parameter, most));
        }
      }
    };
    read("mirror", look.mirror, 1);
    read("ambient", look.ambient, 1);
    read("diffuse", look.diffuse, 1);
    read("specular", look.specular, 1);
    read("shininess", look.shininess, 1e6);
    read("grain", look.grain, 1e300);
    if (look.grain <= 0) {
      arguments.fail_at("grain", "`grain` must be positive");
    }
    if (const std::optional<Rational> index = arguments.number("index")) {
      if (*index <= 0) {
        arguments.fail_at("index", "`index`, the index of refraction, must be positive");
      }
      look.refractive_index = *index;
      stated = true;
    }
    if (const std::optional<Color> color = arguments.color("color")) {
      look.color = rgba(*color);
      stated = true;
    }
    if (const std::optional<Color> color = arguments.color("second_color")) {
      look.second_color = rgb(*color);
      stated = true;
    }
    if (const std::optional<std::string> texture = arguments.text("texture")) {
      const std::optional<Texture> found = texture_named(*texture);
      if (!found) {
        arguments.fail_at("texture", "`texture` must be \"wood\", \"marble\" or \"checker\"");
      }
      look.texture = *found;
      stated = true;
    }
    return stated ? std::optional(look) : std::nullopt;
  }

  Medium medium_named(const std::string& name, const Arguments& user) {
    const std::optional<Medium> medium = materials_.named(name);
    if (!medium) {
      user.fail("there are too many materials");
    }
    return *medium;
  }

  Expression build(const Node& node, Context context) {
    if (const Primitive* found = find_primitive(node.name)) {
      return primitive(node, *found, context);
    }
    if (const SweepNode* found = find_sweep(node.name)) {
      return sweep(node, *found, context);
    }
    if (const Transform* found = find_transform(node.name)) {
      const Arguments arguments(source_, node, found->signature);
      context.facets = arguments.facets(context.facets);
      context.to_world = compose(context.to_world, found->read(arguments));
      return combine(Operator::Add, "add", children(node), context);
    }
    for (const Operation& operation : kOperations) {
      if (operation.name == node.name) {
        context.facets = Arguments(source_, node, operation.signature).facets(context.facets);
        const bool add = operation.op == Operator::Add;
        return combine(operation.op, add ? "add" : operation.name, children(node), context);
      }
    }
    if (node.name == "color") {
      return color(node, context);
    }
    if (is_declaration(node)) {
      fail(node, "it stands at top level, outside of other nodes");
    }
    if (node.name == "material") {
      const Arguments arguments(source_, node, kMaterial);
      context.facets = arguments.facets(context.facets);
      context.medium = material(arguments);
      return combine(Operator::Add, "add", children(node), context);
    }
    if (std::find(kUnsupported.begin(), kUnsupported.end(), node.name) != kUnsupported.end()) {
      fail(node, "this node is not supported yet: leave it out, or put `*` before it");
    }
    if (PlaneFigure::is_one(node.name)) {
      fail(node, "it is no solid: put it in a sweep, as in `rotational_sweep() contour(...);`");
    }
    fail(node,
         "there is no such node; a program is flattened by "
         "`openscad -o model.csg model.scad`");
  }

  Expression color(const Node& node, Context context) {
    const Arguments arguments(source_, node, kColor);
    context.facets = arguments.facets(context.facets);
    if (std::optional<Color> color = arguments.color("c")) {
      (*color)[3] = arguments.number("alpha").value_or((*color)[3]);
      if ((*color)[3] < 0 || (*color)[3] > 1) {
        arguments.fail_at("alpha", "`alpha` must be from 0 to 1");
      }
      context.medium = medium_named(canonical_text(*color), arguments);
      Material look;
      look.color = rgba(*color);
      if (!materials_.set_look(context.medium, look)) {
        arguments.fail("a material has the name of this colour, and another look");
      }
    }
    return combine(Operator::Add, "add", children(node), context);
  }

  Expression primitive(const Node& node, const Primitive& primitive, const Context& context) {
    if (!node.children.empty()) {
      fail(node, "it takes no children: end it with `;`");
    }
    const Arguments arguments(source_, node, primitive.signature);
    const FacetSettings facets = arguments.facets(context.facets);
    return placed(node, primitive.read(arguments, options_.facets ? &facets : nullptr), arguments,
                  context);
  }

  Expression sweep(const Node& node, const SweepNode& sweep, const Context& context) {
    const std::vector<const Node*> figures = figures_in(node);
    if (figures.empty() && sweep.is_extrusion) {
      warn(node, "there is nothing in it, so it is empty");
      return Expression::empty();
    }
    if (figures.size() != 1) {
      fail(node, fmt::format("it takes one contour: {}", sweep.signature.usage));
    }
    const Arguments arguments(source_, node, sweep.signature);
    if (options_.facets && sweep.name == "rotate_extrude") {
      fail(node, "it is read as the curved solid only: leave --facets out");
    }
    return placed(node, sweep.read(arguments, PlaneFigure(source_, *figures.front(), contours_)),
                  arguments, context);
  }

  // What the node is applied to, groups around it left out.
  static std::vector<const Node*> figures_in(const Node& node) {
    std::vector<const Node*> figures;
    for (const Node* child : children(node)) {
      if (is_group(child->name)) {
        const auto inner = figures_in(*child);
        figures.insert(figures.end(), inner.begin(), inner.end());
      } else {
        figures.push_back(child);
      }
    }
    return figures;
  }

  // Does the node do nothing but stand around its children?
  static bool is_group(std::string_view name) {
    return std::any_of(kOperations.begin(), kOperations.end(), [name](const Operation& operation) {
      return operation.name == name && operation.op == Operator::Add;
    });
  }

  Expression placed(const Node& node, const Solid& solid, const Arguments& arguments,
                    const Context& context) {
    if (solid.parts.empty() && solid.solids.empty()) {
      warn(node, "its size is zero, so it is empty");
      return Expression::empty();
    }
    const Medium medium =
        context.medium != csg::kEmpty ? context.medium : medium_named("default", arguments);
    placed_.push_back({inverse(context.to_world).value(), std::nullopt});
    if (solid.box) {
      placed_.back().box = image(context.to_world, *solid.box);
    }
    return expression(solid, medium, context.path_to(node.name), placed_.size() - 1);
  }

  // Of a solid in a frame that is in placed_, or in a new one of its own.
  Expression expression(const Solid& solid, Medium medium, const std::string& path,
                        std::size_t frame) {
    if (solid.placement) {
      const PlacedSolid outer = placed_[frame];
      placed_.push_back({compose(inverse(*solid.placement).value(), outer.to_local), outer.box});
      frame = placed_.size() - 1;
    }
    std::vector<Expression> operands;
    for (const Solid::Part& part : solid.parts) {
      operands.push_back(Expression::of_leaf(static_cast<csg::LeafIndex>(drafts_.size())));
      Leaf leaf;
      leaf.surface = part.surface;
      leaf.frame = static_cast<std::uint32_t>(frame);
      leaf.medium = medium;
      leaf.path = part.name.empty() ? path : path + "." + part.name;
      drafts_.push_back(std::move(leaf));
    }
    for (std::size_t k = 0; k < solid.solids.size(); ++k) {
      operands.push_back(
          expression(solid.solids[k], medium, fmt::format("{}[{}]", path, k + 1), frame));
    }
    return Expression::of(solid.op, std::move(operands));
  }

  static std::vector<const Node*> children(const Node& node) {
    std::vector<const Node*> result;
    for (const Node& child : node.children) {
      if (!left_out(child)) {
        result.push_back(&child);
      }
    }
    return result;
  }

  // The operator on the children. An `add` of one child is that child, and has no place in
  // its path; nor has the top level, which has no name.
  Expression combine(Operator op, std::string_view name, const std::vector<const Node*>& children,
                     Context context) {
    const bool skipped = op == Operator::Add && children.size() == 1;
    if (!skipped && !name.empty()) {
      context.path = context.path_to(name);
      context.position.clear();
    }
    std::vector<Expression> operands;
    for (std::size_t k = 0; k < children.size(); ++k) {
      if (children.size() > 1) {
        context.position = fmt::format("[{}]", k + 1);
      }
      operands.push_back(build(*children[k], context));
    }
    return Expression::of(op, std::move(operands));
  }

  // Numbers the leaves that are left from left to right, and finds equal frames and carriers.
  void finish(Expression expression) {
    std::map<decltype(AffineMap::rows), std::uint32_t> known_frames;
    std::map<surface::Carrier, surface::CarrierIndex> known_carriers;
    std::vector<Medium> media;
    for (const csg::LeafIndex draft : renumber_leaves(expression)) {
      Leaf& leaf = scene_.leaves.emplace_back(std::move(drafts_[draft]));
      const auto& [to_local, box] = placed_[leaf.frame];
      if (box) {
        extend(scene_.bounds, box->lower);
        extend(scene_.bounds, box->upper);
      }
      const auto [carrier, side] = surface::carrier_of(leaf.surface, to_local);
      leaf.side = side;
      leaf.frame = index_in(scene_.frames, to_local, known_frames, to_local.rows);
      leaf.carrier = index_in(scene_.carriers, carrier, known_carriers, carrier);
      scene_.leaves_of_carrier.resize(scene_.carriers.size());
      scene_.leaves_of_carrier[leaf.carrier].push_back(static_cast<csg::LeafIndex>(media.size()));
      media.push_back(leaf.medium);
    }
    scene_.tree = csg::Tree(expression, std::move(media));
    scene_.materials = materials_.materials();
  }

  [[noreturn]] void fail(const Node& node, std::string_view reason) const {
    source_.fail(node.offset, fmt::format("`{}`: {}", node.name, reason));
  }

  const Source& source_;
  const ReadOptions& options_;
  Scene scene_;
  MaterialTable materials_;
  SharedContours contours_;
  std::vector<Leaf> drafts_;  // as they come; `frame` is an index into placed_
  std::vector<PlacedSolid> placed_;
};

}  // namespace

Scene build_scene(const Source& source, const Node& root, const ReadOptions& options) {
  return Builder(source, options).build(root);
}

}  // namespace lamina::scene
