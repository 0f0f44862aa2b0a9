#include "scene/sweeps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "base/contract.hpp"
#include "geometry/conic_spline.hpp"
#include "scene/revolved.hpp"

namespace lamina::scene {

using csg::Operator;
using geometry::Contour;
using geometry::ContourKind;
using geometry::PlanePoint;
using number::Rational;
using surface::Sweep;

namespace {

using SharedContour = std::shared_ptr<const Contour>;
using Rows = std::vector<std::vector<Rational>>;

const Signature kContour{
    R"(contour([[u, v], ...], kind = "line" | "bspline" | "catmull_rom", closed = true))",
    {"points", "kind", "closed"},
    1};
const Signature kTrajectory{
    R"(contour([[x, y, z], ...], kind = "line" | "bspline" | "catmull_rom", closed = true))",
    {"points", "kind", "closed"},
    1};
const Signature kPolygon{
    "polygon(points = [[x, y], ...], paths = [[0, 1, ...]])", {"points", "paths", "convexity"}, 1};
const Signature kSquare{"square(size = [x, y], center = false)", {"size", "center"}};

std::vector<PlanePoint> plane_points(const Rows& rows) {
  std::vector<PlanePoint> points;
  std::transform(rows.begin(), rows.end(), std::back_inserter(points),
                 [](const std::vector<Rational>& row) {
                   return PlanePoint{row[0], row[1]};
                 });
  return points;
}

// An error of what is made from a node's arguments is the node's.
template <typename Make>
auto at(const Arguments& arguments, const Make& make) {
  try {
    return make();
  } catch (const base::InputError& error) {
    arguments.fail(error.what());
  }
}

// What a node states, before it is known to be a contour.
struct Statement {
  std::vector<PlanePoint> points;
  ContourKind kind = ContourKind::Line;
  bool closed = true;
};

ContourKind kind_of(const Arguments& arguments) {
  return at(arguments,
            [&] { return geometry::parse_contour_kind(arguments.text("kind").value_or("line")); });
}

Statement contour(const Arguments& arguments) {
  return {plane_points(*arguments.matrix("points", 2)), kind_of(arguments),
          arguments.boolean("closed").value_or(true)};
}

Statement polygon(const Arguments& arguments) {
  std::vector<PlanePoint> points = plane_points(*arguments.matrix("points", 2));
  if (!arguments.has("paths")) {
    return {std::move(points)};
  }
  const auto path = arguments.matrix("paths");
  if (path->size() != 1) {
    arguments.fail_at("paths", "only one path is read: state a solid for each, and a difference");
  }
  std::vector<PlanePoint> ordered;
  for (const Rational& index : path->front()) {
    if (denominator(index) != 1 || index < 0 || index >= points.size()) {
      arguments.fail_at("paths", fmt::format("point {} of `paths` is none of `points`, which are "
                                             "numbered from 0",
                                             number::to_text(index)));
    }
    ordered.push_back(points[static_cast<std::size_t>(number::nearest_double(index))]);
  }
  return {std::move(ordered)};
}

Statement square(const Arguments& arguments) {
  const geometry::ExactPoint size =
      arguments.vector_or_number("size", Rational(0)).value_or(geometry::ExactPoint{1, 1, 0});
  if (size.x <= 0 || size.y <= 0) {
    arguments.fail_at("size", "`size` must be positive");
  }
  const Rational low = arguments.boolean("center").value_or(false) ? Rational(-1) / 2 : Rational(0);
  const auto corner = [&](int i, int j) {
    return PlanePoint{(low + i) * size.x, (low + j) * size.y};
  };
  return {{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}};
}

struct FigureNode {
  std::string_view name;
  const Signature& signature;
  Statement (*read)(const Arguments& arguments);
};

const FigureNode* find_figure(std::string_view name) {
  static const std::array all{FigureNode{"contour", kContour, contour},
                              FigureNode{"polygon", kPolygon, polygon},
                              FigureNode{"square", kSquare, square}};
  const auto* const found = std::find_if(
      all.begin(), all.end(), [name](const FigureNode& known) { return known.name == name; });
  return found == all.end() ? nullptr : found;
}

// The smallest rectangle around all pieces.
geometry::Rectangle rectangle_around(const Contour& contour) {
  geometry::Rectangle all = contour.boxes().front();
  for (const geometry::Rectangle& box : contour.boxes()) {
    all = {std::min(all.u_min, box.u_min), std::max(all.u_max, box.u_max),
           std::min(all.v_min, box.v_min), std::max(all.v_max, box.v_max)};
  }
  return all;
}

surface::LocalSurface swept(const Arguments& arguments, Sweep sweep, SharedContour contour) {
  return at(arguments, [&] { return surface::swept({sweep, std::move(contour)}); });
}

// What is between two planes across the z axis.
Solid capped(surface::LocalSurface side, const Rational& bottom, const Rational& top,
             const Bounds& box) {
  return {.op = Operator::Difference,
          .parts = {{"side", std::move(side)},
                    {"bottom", surface::plane({0, 0, 1}, bottom)},
                    {"top", surface::plane({0, 0, -1}, -top)}},
          .box = box};
}

Solid translational(const Arguments& arguments, const PlaneFigure& figure) {
  SharedContour contour = figure.contour();
  const geometry::Rectangle box = rectangle_around(*contour);
  surface::LocalSurface side = swept(arguments, Sweep::Translational, std::move(contour));
  if (!arguments.boolean("capped").value_or(true)) {
    return {.parts = {{"", std::move(side)}}};
  }
  return capped(std::move(side), 0, 1, {{box.u_min, box.v_min, 0}, {box.u_max, box.v_max, 1}});
}

Solid conic(const Arguments& arguments, const PlaneFigure& figure) {
  SharedContour contour = figure.contour();
  const geometry::Rectangle box = rectangle_around(*contour);
  surface::LocalSurface side = swept(arguments, Sweep::Conic, std::move(contour));
  if (!arguments.boolean("capped").value_or(true)) {
    return {.parts = {{"", std::move(side)}}};
  }
  const Rational zero(0);
  return capped(std::move(side), 0, 1,
                {{std::min(zero, box.u_min), std::min(zero, box.v_min), 0},
                 {std::max(zero, box.u_max), std::max(zero, box.v_max), 1}});
}

// Not above, and not below, any value of the polynomial for 0 <= z <= 1.
std::pair<Rational, Rational> bounds_to_one(const std::vector<Rational>& polynomial) {
  const std::vector<Rational> weighed = geometry::bezier(polynomial);
  const auto [least, greatest] = std::minmax_element(weighed.begin(), weighed.end());
  return {*least, *greatest};
}

Solid generalised_conic(const Arguments& arguments, const PlaneFigure& figure) {
  const surface::Scaling scaling{*arguments.numbers("x"), *arguments.numbers("y")};
  SharedContour contour = figure.contour();
  const geometry::Rectangle box = rectangle_around(*contour);
  surface::LocalSurface side = at(arguments, [&] {
    return surface::swept({scaling, std::move(contour)});
  });
  if (!arguments.boolean("capped").value_or(true)) {
    return {.parts = {{"", std::move(side)}}};
  }
  // A product of two ranges is extreme at their ends.
  const auto product = [](const Rational& low, const Rational& high,
                          const std::pair<Rational, Rational>& factor) {
    return std::minmax({Rational(low * factor.first), Rational(low * factor.second),
                        Rational(high * factor.first), Rational(high * factor.second)});
  };
  const auto x = product(box.u_min, box.u_max, bounds_to_one(scaling.x));
  const auto y = product(box.v_min, box.v_max, bounds_to_one(scaling.y));
  return capped(std::move(side), 0, 1, {{x.first, y.first, 0}, {x.second, y.second, 1}});
}

Solid turned(const Arguments& arguments, SharedContour contour) {
  const geometry::Rectangle box = rectangle_around(*contour);
  return {.parts = {{"", swept(arguments, Sweep::Rotational, std::move(contour))}},
          .box = Bounds{{-box.u_max, -box.u_max, box.v_min}, {box.u_max, box.u_max, box.v_max}}};
}

Solid linear_extrude(const Arguments& arguments, const PlaneFigure& figure) {
  for (const std::string_view name : {"scale", "twist"}) {
    const bool straight = name == "twist" ? arguments.number("twist").value_or(0) == 0
                                          : arguments.vector_or_number("scale", Rational(1))
                                                    .value_or(geometry::ExactPoint{1, 1, 1}) ==
                                                geometry::ExactPoint{1, 1, 1};
    if (!straight) {
      arguments.fail_at(name, fmt::format("only straight extrusions are read: leave `{}` out, or "
                                          "take conic_sweep for one that narrows to a point",
                                          name));
    }
  }
  const Rational height = arguments.size("height").value_or(100);
  if (height == 0) {
    return {};
  }
  const Rational bottom =
      arguments.boolean("center").value_or(false) ? Rational(-height / 2) : Rational(0);
  SharedContour contour = figure.contour();
  const geometry::Rectangle box = rectangle_around(*contour);
  return capped(swept(arguments, Sweep::Translational, std::move(contour)), bottom, bottom + height,
                {{box.u_min, box.v_min, bottom}, {box.u_max, box.v_max, bottom + height}});
}

Solid rotational(const Arguments& arguments, const PlaneFigure& figure) {
  return turned(arguments, figure.contour());
}

Solid rotate_extrude(const Arguments& arguments, const PlaneFigure& figure) {
  if (arguments.number("angle").value_or(360) != 360) {
    arguments.fail_at("angle", "only whole turns are read: leave `angle` out, and cut the solid");
  }
  SharedContour contour = figure.contour();
  // OpenSCAD turns what is left of the axis as well, if nothing is right of it.
  std::vector<PlanePoint> points = contour->points();
  if (std::all_of(points.begin(), points.end(), [](const PlanePoint& p) { return p.u <= 0; })) {
    for (PlanePoint& p : points) {
      p.u = -p.u;
    }
    contour = at(arguments, [&] {
      return std::make_shared<const Contour>(std::move(points), contour->kind(), contour->closed());
    });
  }
  return turned(arguments, std::move(contour));
}

// The number of a point, as people count them.
std::size_t point_number(const Arguments& arguments, std::string_view parameter,
                         const Rational& number, std::size_t count) {
  if (denominator(number) != 1 || number < 1 || number > count) {
    arguments.fail_at(parameter, fmt::format("a row of `{}` begins with the number of a point, "
                                             "from 1 to {}",
                                             parameter, count));
  }
  return static_cast<std::size_t>(number::nearest_double(number));
}

Solid conic_spline(const Arguments& arguments, const PlaneFigure& figure) {
  const std::vector<PlanePoint> points = figure.points();
  std::vector<geometry::ArcAt> arcs;
  for (const auto& row : arguments.matrix("arcs", 3).value_or(Rows{})) {
    arcs.push_back({point_number(arguments, "arcs", row[0], points.size()), row[1], row[2]});
  }
  std::vector<geometry::SlopeAt> slopes;
  for (const auto& row : arguments.matrix("slopes", 2).value_or(Rows{})) {
    slopes.push_back({point_number(arguments, "slopes", row[0], points.size()), row[1]});
  }
  return at(arguments,
            [&] { return revolved_solid(geometry::fit_conic_spline(points, arcs, slopes)); });
}

Solid cone_stack(const Arguments& arguments, const PlaneFigure& figure) {
  constexpr int kMostPieces = 2'000;  // all pairs of which are compared
  const Rational pieces = *arguments.number("pieces");
  if (denominator(pieces) != 1 || pieces < 1 || pieces > kMostPieces) {
    arguments.fail_at("pieces",
                      fmt::format("`pieces` must be a whole number from 1 to {}", kMostPieces));
  }
  const SharedContour contour = figure.contour();
  return at(arguments, [&] {
    return revolved_solid(geometry::inscribed_cones(
        *contour, static_cast<std::size_t>(number::nearest_double(pieces))));
  });
}

Solid sphere_sweep(const Arguments& arguments, const PlaneFigure& figure) {
  const Rational radius = *arguments.number("r");
  const auto trajectory = figure.trajectory();
  surface::LocalSurface side =
      at(arguments, [&] { return surface::swept(surface::SphereSweep(radius, trajectory)); });
  geometry::Box box = trajectory->boxes().front();
  for (const auto& [lower, upper] : trajectory->boxes()) {
    box = {{std::min(box.lower.x, lower.x), std::min(box.lower.y, lower.y),
            std::min(box.lower.z, lower.z)},
           {std::max(box.upper.x, upper.x), std::max(box.upper.y, upper.y),
            std::max(box.upper.z, upper.z)}};
  }
  const geometry::ExactPoint reach{radius, radius, radius};
  return {.parts = {{"", std::move(side)}}, .box = Bounds{box.lower - reach, box.upper + reach}};
}

const std::array kSweeps{
    SweepNode{"translational_sweep",
              {"translational_sweep(capped = true) contour(...);", {}, 0, {"capped"}},
              translational},
    SweepNode{
        "conic_sweep", {"conic_sweep(capped = true) contour(...);", {}, 0, {"capped"}}, conic},
    SweepNode{"generalised_conic_sweep",
              {"generalised_conic_sweep(x = [p_0, p_1, ...], y = [q_0, q_1, ...], capped = true) "
               "contour(...);",
               {"x", "y", "capped"},
               2},
              generalised_conic},
    SweepNode{"rotational_sweep", {"rotational_sweep() contour(...);"}, rotational},
    SweepNode{"sphere_sweep",
              {"sphere_sweep(r = number) contour([[x, y, z], ...]);", {"r"}, 1},
              sphere_sweep},
    SweepNode{"conic_spline_sweep",
              {"conic_spline_sweep(arcs = [[point, radius, tangent of half the angle], ...], "
               "slopes = [[point, d(u^2)/dv], ...]) contour([[u, v], ...]);",
               {"arcs", "slopes"}},
              conic_spline},
    SweepNode{
        "cone_stack", {"cone_stack(pieces = number) contour(...);", {"pieces"}, 1}, cone_stack},
    SweepNode{"linear_extrude",
              {"linear_extrude(height = number, center = false) polygon(...);",
               {"height", "center", "convexity", "twist", "slices", "scale"}},
              linear_extrude,
              true},
    SweepNode{"rotate_extrude",
              {"rotate_extrude() polygon(...);", {"angle", "convexity"}},
              rotate_extrude,
              true},
};

}  // namespace

bool PlaneFigure::is_one(std::string_view name) { return find_figure(name) != nullptr; }

PlaneFigure::PlaneFigure(const Source& source, const Node& node, SharedContours& contours)
    : source_(source), node_(node), contours_(contours) {
  if (!is_one(node.name)) {
    source.fail(node.offset,
                fmt::format("`{}`: a sweep takes a contour, a polygon or a square", node.name));
  }
}

SharedContour PlaneFigure::contour() const {
  const FigureNode& figure = *find_figure(node_.name);
  const Arguments arguments(source_, node_, figure.signature);
  Statement statement = figure.read(arguments);
  const auto known = std::find_if(contours_.begin(), contours_.end(), [&](const auto& c) {
    return c->points() == statement.points && c->kind() == statement.kind &&
           c->closed() == statement.closed;
  });
  if (known != contours_.end()) {
    return *known;
  }
  return contours_.emplace_back(at(arguments, [&] {
    return std::make_shared<const Contour>(std::move(statement.points), statement.kind,
                                           statement.closed);
  }));
}

std::vector<PlanePoint> PlaneFigure::points() const {
  const FigureNode& figure = *find_figure(node_.name);
  const Arguments arguments(source_, node_, figure.signature);
  for (const std::string_view parameter : {"kind", "closed"}) {
    if (arguments.has(parameter)) {
      arguments.fail_at(parameter, fmt::format("the points are joined by conics here: leave `{}` "
                                               "out",
                                               parameter));
    }
  }
  return figure.read(arguments).points;
}

std::shared_ptr<const geometry::Trajectory> PlaneFigure::trajectory() const {
  if (node_.name != "contour") {
    source_.fail(node_.offset,
                 fmt::format("`{}`: this sweep takes a contour of points in space", node_.name));
  }
  const Arguments arguments(source_, node_, kTrajectory);
  std::vector<geometry::ExactPoint> points;
  const Rows rows = *arguments.matrix("points", 3);
  for (const std::vector<Rational>& row : rows) {
    points.push_back({row[0], row[1], row[2]});
  }
  return at(arguments, [&] {
    return std::make_shared<const geometry::Trajectory>(std::move(points), kind_of(arguments),
                                                        arguments.boolean("closed").value_or(true));
  });
}

const SweepNode* find_sweep(std::string_view name) {
  const auto found = std::find_if(kSweeps.begin(), kSweeps.end(),
                                  [name](const SweepNode& known) { return known.name == name; });
  return found == kSweeps.end() ? nullptr : &*found;
}

}  // namespace lamina::scene
