// Laws of the truth: what it says of two scenes that mean the same.
#include <catch2/catch.hpp>

#include <algorithm>

#include "geometry/ray_text.hpp"
#include "support/class_tally.hpp"
#include "support/law_models.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using reference::Node;
using support::LawModel;
using support::MediaAlongRay;
using support::node_text;
using support::TruthBench;

constexpr std::uint64_t kSeed = 2;
constexpr std::uint64_t kLatticeModels = 60;
constexpr std::uint64_t kFamilyModels = 40;
constexpr std::uint64_t kRays = 12;

/// Counts what a law was tried on, and fails where it is broken.
class Law {
 public:
  explicit Law(std::string name) : name_(std::move(name)) {}

  /// `expected` is of the ray last found in `bench`.
  void holds(const LawModel& model, TruthBench& bench, const geometry::ExactRay& ray,
             const MediaAlongRay& actual, const MediaAlongRay& expected) {
    tally_.add("rays");
    tally_.add("changes", !expected.changes.empty());
    const auto& classes = bench.truth().classes();
    tally_.add("coincident", std::any_of(classes.begin(), classes.end(),
                                         [](const auto& cls) { return cls.leaves.size() > 1; }));
    if (!(actual == expected)) {
      FAIL(name_ << ": " << model.name << ", ray \"" << geometry::to_text(ray) << "\": " << actual
                 << " is not " << expected << "\nin\n"
                 << bench.text());
    }
    if (!bench.verdict(method::regularized()).right()) {
      FAIL("regularized is not the truth: " << model.name << ", ray \"" << geometry::to_text(ray)
                                            << "\" in\n"
                                            << bench.text());
    }
  }

  void reached() const {
    INFO(name_ << ": " << tally_);
    CHECK(tally_.count("rays") >= 500);
    CHECK(tally_.count("coincident") >= tally_.count("rays") / 4);
  }

 private:
  std::string name_;
  support::ClassTally tally_{"rays", "changes", "coincident"};
};

template <typename Check>
void for_each_model(Check check) {
  for (std::uint64_t i = 0; i < kLatticeModels; ++i) {
    // A torus costs as much as ten other solids: a few are enough.
    check(support::lattice_model(kSeed, i, kRays, {.tori = i % 16 == 0}));
  }
  for (std::uint64_t i = 0; i < kFamilyModels; ++i) {
    check(support::family_model(kSeed, i, kRays));
  }
}

TEST_CASE("A model and itself: a - a is nothing, a add a and a inter a are a", "[laws]") {
  Law nothing("a - a");
  Law twice("a add a");
  Law both("a intersection a");
  for_each_model([&](const LawModel& model) {
    const std::vector<std::string> pair{model.text, model.text};
    TruthBench plain(model.text);
    TruthBench difference(node_text("difference", pair));
    TruthBench sum(node_text("add", pair));
    TruthBench intersection(node_text("intersection", pair));
    for (const auto& ray : model.rays) {
      const MediaAlongRay media = plain.media(ray);
      const MediaAlongRay none = difference.media(ray);
      nothing.holds(model, difference, ray, none, MediaAlongRay{});
      const MediaAlongRay added = sum.media(ray);
      twice.holds(model, sum, ray, added, media);
      const MediaAlongRay common = intersection.media(ray);
      both.holds(model, intersection, ray, common, media);
    }
  });
  nothing.reached();
  twice.reached();
  both.reached();
}

// Two parts of one lattice scene: their surfaces coincide.
TEST_CASE("Two operands: add commutes in volume, a inter b is a - (a - b)", "[laws]") {
  Law commutes("a add b and b add a");
  Law de_morgan("a intersection b and a - (a - b)");
  for (std::uint64_t i = 0; i < 2 * kLatticeModels; ++i) {
    const LawModel model = support::lattice_model(kSeed + 1, i, kRays);
    const std::string a = text_of(model.data.root.operands[0]);
    const std::string b = text_of(model.data.root.operands[1]);
    TruthBench ab(node_text("add", {a, b}));
    TruthBench ba(node_text("add", {b, a}));
    TruthBench common(node_text("intersection", {a, b}));
    TruthBench rest(node_text("difference", {a, node_text("difference", {a, b})}));
    for (const auto& ray : model.rays) {
      const MediaAlongRay left = ab.media(ray);
      const MediaAlongRay right = ba.media(ray);
      commutes.holds(model, ab, ray, left.solid(), right.solid());
      const MediaAlongRay inside = common.media(ray);
      const MediaAlongRay taken = rest.media(ray);
      de_morgan.holds(model, rest, ray, taken, inside);
    }
  }
  commutes.reached();
  de_morgan.reached();
}

template <typename Iterator>
void shuffle(Iterator first, Iterator last, SeededStream& stream) {
  for (auto left = last - first; left > 1; --left) {
    std::iter_swap(first + (left - 1), first + static_cast<std::ptrdiff_t>(
                                                   stream.below(static_cast<std::uint64_t>(left))));
  }
}

// The operands in another order, as far as that changes nothing: all of add and intersection
// where there is one material; else only those behind the first of difference and intersection.
Node permuted(Node node, bool one_material, SeededStream& stream) {
  for (Node& operand : node.operands) {
    operand = permuted(operand, one_material, stream);
  }
  if (!node.is_solid()) {
    const bool all = one_material && node.operation != reference::Operation::Difference;
    if (all || node.operation != reference::Operation::Add) {
      shuffle(node.operands.begin() + (all ? 0 : 1), node.operands.end(), stream);
    }
  }
  return node;
}

TEST_CASE("The order of operands changes nothing where it has no meaning", "[laws]") {
  Law law("permuted operands");
  for (std::uint64_t i = 0; i < 2 * kLatticeModels; ++i) {
    const bool one_material = i % 2 == 0;
    const LawModel model =
        support::lattice_model(kSeed + 2, i, kRays, {.one_material = one_material});
    SeededStream stream("laws/permuted", kSeed, i);
    TruthBench plain(model.text);
    TruthBench other(text_of(permuted(model.data.root, one_material, stream)));
    for (const auto& ray : model.rays) {
      const MediaAlongRay media = plain.media(ray);
      const MediaAlongRay again = other.media(ray);
      law.holds(model, other, ray, again, media);
    }
  }
  law.reached();
}

// A primitive as the intersection of its half-spaces, in any order.
Node expanded(const Node& node, SeededStream& stream) {
  using reference::Primitive;
  Node result = node;
  result.operands.clear();
  for (const Node& operand : node.operands) {
    result.operands.push_back(expanded(operand, stream));
  }
  const auto& n = node.primitive.numbers;
  const auto face = [&](Primitive::Kind kind, std::vector<number::Rational> numbers) {
    Node part;
    part.chain = node.chain;
    part.material = node.material;
    part.primitive = {kind, std::move(numbers)};
    result.operands.push_back(std::move(part));
  };
  if (node.is_solid() && node.primitive.kind == Primitive::Kind::Box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const number::Rational low = node.primitive.center ? number::Rational(-n[axis] / 2) : 0;
      std::vector<number::Rational> numbers(4);
      numbers[axis] = -2;
      numbers[3] = -2 * low;
      face(Primitive::Kind::HalfSpace, numbers);
      numbers[axis] = 3;
      numbers[3] = 3 * (low + n[axis]);
      face(Primitive::Kind::HalfSpace, numbers);
    }
  } else if (node.is_solid() && node.primitive.kind == Primitive::Kind::Cylinder) {
    const number::Rational low = node.primitive.center ? number::Rational(-n[0] / 2) : 0;
    const number::Rational slope = (n[2] - n[1]) / n[0];
    const number::Rational at_zero = n[1] - slope * low;
    face(Primitive::Kind::HalfSpace, {0, 0, -1, -low});
    face(Primitive::Kind::HalfSpace, {0, 0, 1, low + n[0]});
    // x^2 + y^2 - (at_zero + slope z)^2
    face(Primitive::Kind::Quadric, {1, 0, 0, 0,                                  //
                                    0, 1, 0, 0,                                  //
                                    0, 0, -slope * slope, -2 * slope * at_zero,  //
                                    0, 0, 0, -at_zero * at_zero});
  }
  if (node.is_solid() && !result.operands.empty()) {
    result.operation = reference::Operation::Intersection;
    shuffle(result.operands.begin(), result.operands.end(), stream);
  }
  return result;
}

TEST_CASE("A primitive is the intersection of its half-spaces in any order", "[laws]") {
  Law law("half-spaces for primitives");
  for (std::uint64_t i = 0; i < 2 * kLatticeModels; ++i) {
    const LawModel model = support::lattice_model(kSeed + 3, i, kRays);
    SeededStream stream("laws/expanded", kSeed, i);
    TruthBench plain(model.text);
    TruthBench other(text_of(expanded(model.data.root, stream)));
    for (const auto& ray : model.rays) {
      const MediaAlongRay media = plain.media(ray);
      if (plain.truth().in_some_carrier()) {
        continue;  // what is cut away and what is kept have other conventions there
      }
      const MediaAlongRay again = other.media(ray);
      law.holds(model, other, ray, again, media);
    }
  }
  law.reached();
}

TEST_CASE("A map of scene and ray together changes nothing", "[laws]") {
  using reference::Step;
  enum class Which { Rotation, Translation, Scaling, Mirror, Chain };
  const auto which =
      GENERATE(Which::Rotation, Which::Translation, Which::Scaling, Which::Mirror, Which::Chain);
  Law law("map " + std::to_string(static_cast<int>(which)));
  std::uint64_t case_id = 0;
  for_each_model([&](const LawModel& model) {
    SeededStream stream("laws/map", kSeed, case_id++);
    const auto number = [&stream] {
      const number::Rational value = 1 + stream.integer(0, 8);
      return number::Rational(value / stream.integer(1, 9));
    };
    reference::Chain chain;
    switch (which) {
      case Which::Rotation:
        chain = {{Step::Kind::Rotate, {number(), number(), -number(), number()}}};
        break;
      case Which::Translation:
        chain = {{Step::Kind::Translate, {number(), -number(), number()}}};
        break;
      case Which::Scaling:
        chain = {{Step::Kind::Scale, {number(), -number(), number()}}};
        break;
      case Which::Mirror:
        chain = {{Step::Kind::Mirror, {number(), -number(), number()}}};
        break;
      case Which::Chain:
        chain = reference::random_frame(stream);
        break;
    }
    TruthBench plain(model.text);
    TruthBench other(text_of(chain) + "{\n" + model.text + "}\n");
    for (const auto& ray : model.rays) {
      const MediaAlongRay media = plain.media(ray);
      const geometry::ExactRay image =
          support::exact_ray(reference::mapped(chain, support::reference_ray(ray)));
      const MediaAlongRay again = other.media(image);
      law.holds(model, other, image, again, media);
    }
  });
  law.reached();
}

}  // namespace
}  // namespace lamina
