#include "method/locate.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/arrangement.hpp"
#include "number/algebraic.hpp"
#include "surface/carrier.hpp"

namespace lamina::method {
namespace {

using csg::kEmpty;
using csg::Medium;
using geometry::ExactPoint;
using geometry::IntegerVector;
using number::Integer;
using number::IntegerPolynomial;
using surface::RayMonomials;

ExactPoint exact(const IntegerVector& v) { return {v.x, v.y, v.z}; }

bool is_zero(const IntegerVector& v) { return v.x.is_zero() && v.y.is_zero() && v.z.is_zero(); }

Integer coefficient(const IntegerPolynomial& polynomial, int power) {
  return polynomial.degree() < power ? Integer(0) : polynomial[power];
}

// The tree at a point: leaves whose carriers do not contain the point are decided, and so is
// all that does not depend on the others.
class LocalTree {
 public:
  LocalTree(const scene::Scene& scene, const ExactPoint& point)
      : scene_(scene),
        point_(point),
        at_point_({point, {0, 0, 0}}),
        signs_(scene.carriers.size(), kUnknown) {
    root_ = scene.tree.empty() ? constant(kEmpty) : reduced(scene.tree.root());
  }

  /// Is the medium the same whatever the carriers through the point do?
  [[nodiscard]] bool decided() const { return nodes_[root_].kind == Node::Kind::Constant; }

  /// The carriers through the point that matter.
  [[nodiscard]] const std::vector<surface::CarrierIndex>& carriers() const { return carriers_; }

  /// The medium where carriers()[i] has signs[i].
  [[nodiscard]] Medium medium(std::span<const int> signs) const {
    return medium(root_, [signs](const Node& leaf) { return leaf.side * signs[leaf.slot] < 0; });
  }

  /// The medium where the point itself is inside of all half-spaces whose boundary it is on.
  [[nodiscard]] Medium medium_if_closed() const {
    return medium(root_, [](const Node&) { return true; });
  }

 private:
  struct Node {
    enum class Kind : std::uint8_t { Constant, Leaf, Operation };
    Kind kind = Kind::Constant;
    csg::Operator op = csg::Operator::Add;
    Medium medium = kEmpty;  // of a constant, or inside a leaf
    int side = 1;
    std::size_t slot = 0;  // of a leaf's carrier in carriers_
    std::size_t left = 0;
    std::size_t right = 0;
  };

  static constexpr std::int8_t kUnknown = 2;

  std::size_t add(const Node& node) {
    nodes_.push_back(node);
    return nodes_.size() - 1;
  }

  std::size_t constant(Medium medium) { return add({.medium = medium}); }

  [[nodiscard]] bool is_constant(std::size_t node, Medium medium) const {
    return nodes_[node].kind == Node::Kind::Constant && nodes_[node].medium == medium;
  }

  int sign(surface::CarrierIndex carrier) {
    std::int8_t& sign = signs_[carrier];
    if (sign == kUnknown) {
      sign = static_cast<std::int8_t>(sign_of(scene_.carriers[carrier]));
    }
    return sign;
  }

  int sign_of(const surface::Carrier& carrier) {
    if (carrier.sweep) {
      return sign_at(carrier, point_);
    }
    const IntegerPolynomial value = at_point_.restrict(carrier);
    return value.is_zero() ? 0 : value[0].sign();
  }

  std::size_t reduced_leaf(const scene::Leaf& leaf) {
    if (const int s = leaf.side * sign(leaf.carrier); s != 0) {
      return constant(s < 0 ? leaf.medium : kEmpty);
    }
    const auto known = std::find(carriers_.begin(), carriers_.end(), leaf.carrier);
    const auto slot = static_cast<std::size_t>(known - carriers_.begin());
    if (known == carriers_.end()) {
      carriers_.push_back(leaf.carrier);
    }
    return add({.kind = Node::Kind::Leaf, .medium = leaf.medium, .side = leaf.side, .slot = slot});
  }

  std::size_t reduced(csg::NodeIndex index) {
    if (index < scene_.tree.leaf_count()) {
      return reduced_leaf(scene_.leaves[index]);
    }
    const csg::Tree::Node& node = scene_.tree.nodes()[index];
    const std::size_t left = reduced(node.left);
    if (is_constant(left, kEmpty)) {
      return node.op == csg::Operator::Add ? reduced(node.right) : left;
    }
    const std::size_t right = reduced(node.right);
    if (nodes_[right].kind == Node::Kind::Constant) {
      // A right operand that is known fixes the result, or leaves the left one as it is.
      const Medium if_empty = combine(node.op, kEmpty, nodes_[right].medium);
      const Medium if_solid = combine(node.op, Medium{1}, nodes_[right].medium);
      return if_empty == if_solid ? constant(if_empty) : left;
    }
    return add({.kind = Node::Kind::Operation, .op = node.op, .left = left, .right = right});
  }

  template <typename Inside>
  [[nodiscard]] Medium medium(std::size_t index, const Inside& inside) const {
    const Node& node = nodes_[index];
    switch (node.kind) {
      case Node::Kind::Constant:
        return node.medium;
      case Node::Kind::Leaf:
        return inside(node) ? node.medium : kEmpty;
      case Node::Kind::Operation:
        break;
    }
    return combine(node.op, medium(node.left, inside), medium(node.right, inside));
  }

  const scene::Scene& scene_;
  const ExactPoint& point_;
  RayMonomials at_point_;
  std::vector<std::int8_t> signs_;  // by carrier, as far as they were asked for
  std::vector<Node> nodes_;
  std::vector<surface::CarrierIndex> carriers_;
  std::size_t root_ = 0;
};

// Two directions that span the plane perpendicular to a third.
std::pair<IntegerVector, IntegerVector> perpendicular(const IntegerVector& v) {
  const IntegerVector axis =
      v.x.is_zero() && v.y.is_zero() ? IntegerVector{1, 0, 0} : IntegerVector{0, 0, 1};
  const IntegerVector first = cross(axis, v);
  return {first, cross(v, first)};
}

// The directions around a point on carriers, and the media that they lead into.
class Surroundings {
 public:
  Surroundings(const scene::Scene& scene, const ExactPoint& point, const LocalTree& tree)
      : point_(point), tree_(tree) {
    std::array<RayMonomials, 3> axes{RayMonomials({point, {1, 0, 0}}),
                                     RayMonomials({point, {0, 1, 0}}),
                                     RayMonomials({point, {0, 0, 1}})};
    const auto add = [&](const surface::Carrier& carrier, int side) {
      carriers_.push_back(carrier);
      gradients_.push_back(Integer(side) *
                           IntegerVector{coefficient(axes[0].restrict(carrier), 1),
                                         coefficient(axes[1].restrict(carrier), 1),
                                         coefficient(axes[2].restrict(carrier), 1)});
    };
    for (const surface::CarrierIndex index : tree.carriers()) {
      const surface::Carrier& carrier = scene.carriers[index];
      Stretch stretch{carriers_.size()};
      if (!carrier.sweep) {
        add(carrier, 1);
      } else if (const auto facets = facets_at(*carrier.sweep, point)) {
        for (const ExactPoint& normal : facets->normals) {
          const auto plane = carrier_of(surface::plane(normal, dot(normal, point)), {});
          add(plane.carrier, plane.side);
        }
        stretch.convex = facets->convex;
      } else {
        known_ = false;
        return;
      }
      stretch.end = carriers_.size();
      of_tree_.push_back(stretch);
    }
  }

  /// Does each carrier have a polynomial around the point?
  [[nodiscard]] bool known() const { return known_; }

  Location look() {
    if (std::none_of(gradients_.begin(), gradients_.end(), is_zero)) {
      for_each_cell(gradients_,
                    [this](const auto&, std::span<const int> signs) { return see(medium(signs)); });
    }
    Location location;
    if (!boundary()) {
      const std::vector<IntegerVector> doubtful = doubtful_directions();
      for (const IntegerVector& direction : doubtful) {
        look_along(direction);
      }
      location.undecided = !boundary() && !doubtful.empty();
    }
    location.boundary = boundary();
    if (!location.boundary) {
      const Medium closed = tree_.medium_if_closed();
      location.medium = seen_.empty() || seen_.contains(closed) ? closed : *seen_.rbegin();
    }
    return location;
  }

 private:
  // The planes that stand for one of the tree's carriers around the point, or the carrier itself.
  struct Stretch {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool convex = true;
  };

  // Where the carriers here have these signs.
  [[nodiscard]] Medium medium(std::span<const int> signs) const {
    std::vector<int> of_tree;
    for (const auto& [begin, end, convex] : of_tree_) {
      const auto planes = signs.subspan(begin, end - begin);
      of_tree.push_back(convex ? *std::max_element(planes.begin(), planes.end())
                               : *std::min_element(planes.begin(), planes.end()));
    }
    return tree_.medium(of_tree);
  }

  [[nodiscard]] bool boundary() const { return seen_.contains(kEmpty) && seen_.size() > 1; }

  // Returns whether another medium could still change the answer.
  bool see(Medium medium) {
    seen_.insert(medium);
    return !boundary();
  }

  // Directions in which tangent planes do not tell all cells apart; samples, where these are
  // whole planes or all of space.
  [[nodiscard]] std::vector<IntegerVector> doubtful_directions() const {
    constexpr int kReach = 2;  // samples are combinations with factors -2 .. 2
    std::vector<IntegerVector> result;
    if (std::all_of(carriers_.begin(), carriers_.end(),
                    [](const surface::Carrier& carrier) { return carrier.degree == 1; })) {
      return result;
    }
    if (std::any_of(gradients_.begin(), gradients_.end(), is_zero)) {
      for (int x = -kReach; x <= kReach; ++x) {
        for (int y = -kReach; y <= kReach; ++y) {
          for (int z = -kReach; z <= kReach; ++z) {
            result.push_back({x, y, z});
          }
        }
      }
    }
    for (std::size_t i = 0; i < gradients_.size(); ++i) {
      for (std::size_t j = i + 1; j < gradients_.size(); ++j) {
        const IntegerVector edge = cross(gradients_[i], gradients_[j]);
        if (!is_zero(edge)) {
          if (!told_apart_along(edge)) {
            result.push_back(edge);
            result.push_back(Integer(-1) * edge);
          }
        } else if (!is_zero(gradients_[i])) {
          const auto [u, v] = perpendicular(gradients_[i]);
          for (int a = -kReach; a <= kReach; ++a) {
            for (int b = -kReach; b <= kReach; ++b) {
              result.push_back(Integer(a) * u + Integer(b) * v);
            }
          }
        }
      }
    }
    std::erase_if(result, is_zero);
    return result;
  }

  // Two surfaces that cross have the cells of their tangent planes. So have more, if they
  // share the line in which these planes meet.
  [[nodiscard]] bool told_apart_along(const IntegerVector& edge) const {
    RayMonomials line({point_, exact(edge)});
    std::size_t tangent = 0;
    bool share_line = true;
    for (std::size_t k = 0; k < carriers_.size(); ++k) {
      if (dot(gradients_[k], edge).is_zero()) {
        ++tangent;
        share_line = share_line && line.restrict(carriers_[k]).is_zero();
      }
    }
    return tangent == 2 || share_line;
  }

  // The cells along the curves point + s direction + s^2 w, as s -> 0+, for all w. With g the
  // gradient and q the second coefficient along the straight line, f is s g.direction to the
  // first order; where that is zero, it is s^2 (q + g.w): an arrangement of lines in the
  // plane of w, and so a central one of planes, in which the last coordinate is positive.
  void look_along(const IntegerVector& direction) {
    RayMonomials line({point_, exact(direction)});
    const auto [u, v] = perpendicular(direction);
    std::vector<int> signs;
    std::vector<std::size_t> tangent;
    std::vector<IntegerVector> normals;
    for (std::size_t k = 0; k < carriers_.size(); ++k) {
      const Integer slope = dot(gradients_[k], direction);
      const Integer bend = coefficient(line.restrict(carriers_[k]), 2);
      if (is_zero(gradients_[k])) {
        if (bend.is_zero()) {
          return;  // the sign is of a higher order
        }
        signs.push_back(bend.sign());
        continue;
      }
      signs.push_back(slope.sign());
      if (slope.is_zero()) {
        tangent.push_back(k);
        normals.push_back({dot(gradients_[k], u), dot(gradients_[k], v), bend});
      }
    }
    normals.push_back({0, 0, 1});
    for_each_cell(normals, [&](const auto&, std::span<const int> found) {
      if (found.back() < 0) {
        return true;
      }
      for (std::size_t i = 0; i < tangent.size(); ++i) {
        signs[tangent[i]] = found[i];
      }
      return see(medium(signs));
    });
  }

  const ExactPoint& point_;
  const LocalTree& tree_;
  bool known_ = true;
  std::vector<surface::Carrier> carriers_;  // of flat sides of a sweep, their planes
  std::vector<Stretch> of_tree_;
  std::vector<IntegerVector> gradients_;  // times one positive factor for each carrier
  std::set<Medium> seen_;
};

// Are both the inside and the outside of a sweep next to this point of its surface, for certain?
bool parts_space(const surface::PlacedSweep& sweep, const ExactPoint& point) {
  const auto* sphere_sweep = std::get_if<surface::SphereSweep>(&sweep.surface);
  // Near every point of a contour that does not touch itself is its inside and its outside.
  return sphere_sweep == nullptr || sphere_sweep->has_one_foot(apply(sweep.to_local, point));
}

// Where a sweep that is curved there is among the carriers of the point.
Location location_on_sweep(const scene::Scene& scene, const ExactPoint& point,
                           const LocalTree& tree) {
  Location location;
  const surface::Carrier& first = scene.carriers[tree.carriers().front()];
  if (tree.carriers().size() == 1 && parts_space(*first.sweep, point)) {
    const Medium inside = tree.medium(std::array{-1});
    const Medium outside = tree.medium(std::array{1});
    location.boundary = (inside == kEmpty) != (outside == kEmpty);
  } else {
    location.undecided = true;
  }
  if (!location.boundary) {
    location.medium = tree.medium_if_closed();
  }
  return location;
}

}  // namespace

Location locate_exact(const scene::Scene& scene, const ExactPoint& point) {
  const LocalTree tree(scene, point);
  if (tree.decided()) {
    return {.medium = tree.medium_if_closed()};
  }
  Surroundings surroundings(scene, point, tree);
  return surroundings.known() ? surroundings.look() : location_on_sweep(scene, point, tree);
}

}  // namespace lamina::method
