// The crossings of spawned rays against expressions with nested square roots (CORE), which share
// no code with them: planes and quadrics, rays spawned once and twice.
#include <CGAL/CORE_Expr.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "base/seeded_stream.hpp"
#include "method/ray_events.hpp"
#include "method/spawned_events.hpp"
#include "number/rational.hpp"
#include "support/class_tally.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using CORE::Expr;
using method::SpawnedEvents;
using number::Rational;

// f(p) = p^T M p with p = (x, y, z, 1), M symmetric.
using Matrix = std::array<std::array<int, 4>, 4>;
template <typename Number>
using Vector = std::array<Number, 4>;  // the last is 1 for points, 0 for directions

template <typename Number>
Number product(const Vector<Number>& a, const Matrix& m, const Vector<Number>& b) {
  Number sum(0);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (m[i][j] != 0) {
        sum = sum + a[i] * b[j] * Number(m[i][j]);
      }
    }
  }
  return sum;
}

struct ExprRay {
  Vector<Expr> origin;
  Vector<Expr> direction;

  [[nodiscard]] Vector<Expr> at(const Expr& s) const {
    Vector<Expr> point = origin;
    for (std::size_t i = 0; i < 3; ++i) {
      point[i] = origin[i] + s * direction[i];
    }
    return point;
  }
};

// All roots along the ray, ascending; double roots, which no ray here has, are left out.
// `starts_on`: s = 0 is a root, and is left out.
std::vector<Expr> roots(const Matrix& m, const ExprRay& ray, bool starts_on) {
  const Expr a = product(ray.direction, m, ray.direction);
  const Expr half_b = product(ray.origin, m, ray.direction);
  const bool linear = a == Expr(0);
  if (starts_on) {
    return linear ? std::vector<Expr>{} : std::vector<Expr>{Expr(-2) * half_b / a};
  }
  const Expr c = product(ray.origin, m, ray.origin);
  if (linear) {
    return half_b == Expr(0) ? std::vector<Expr>{} : std::vector<Expr>{-c / (Expr(2) * half_b)};
  }
  const Expr discriminant = half_b * half_b - a * c;
  if (discriminant <= Expr(0)) {
    return {};
  }
  const Expr root = sqrt(discriminant);
  std::vector<Expr> both{(-half_b - root) / a, (-half_b + root) / a};
  if (both[1] < both[0]) {
    std::swap(both[0], both[1]);
  }
  return both;
}

// Planes, spheres and other quadrics with small integers; a random one stands twice, the second
// time times 3.
std::vector<Matrix> random_surfaces(SeededStream& stream) {
  std::vector<Matrix> surfaces;
  const std::int64_t count = stream.integer(3, 5);
  for (std::int64_t n = 0; n < count; ++n) {
    Matrix m{};
    const auto any = [&stream] { return static_cast<int>(stream.integer(-4, 4)); };
    const std::uint64_t kind = stream.below(3);
    for (std::size_t i = 0; i < 3; ++i) {
      if (kind == 1) {
        m[i][i] = 1;
      } else if (kind == 2) {
        for (std::size_t j = i; j < 3; ++j) {
          m[i][j] = m[j][i] = any();
        }
      }
      m[i][3] = m[3][i] = any();
    }
    m[0][3] = m[3][0] = m[0][3] == 0 ? 1 : m[0][3];
    m[3][3] = -static_cast<int>(stream.integer(1, 30));
    surfaces.push_back(m);
  }
  Matrix twice = surfaces[stream.below(surfaces.size())];
  for (auto& row : twice) {
    for (int& entry : row) {
      entry *= 3;
    }
  }
  surfaces.push_back(twice);
  return surfaces;
}

std::string text_of(const std::vector<Matrix>& surfaces) {
  std::ostringstream text;
  text << "add() {\n";
  for (const Matrix& m : surfaces) {
    text << "  quadric([";
    for (std::size_t i = 0; i < 4; ++i) {
      text << (i > 0 ? ", [" : "[");
      for (std::size_t j = 0; j < 4; ++j) {
        text << (j > 0 ? ", " : "") << m[i][j];
      }
      text << "]";
    }
    text << "]);\n";
  }
  text << "}\n";
  return text.str();
}

// What a ray spawned on a carrier meets, by expressions.
struct Expected {
  surface::CarrierIndex carrier = 0;
  Expr s;
};

class Bench {
 public:
  explicit Bench(SeededStream& stream)
      : surfaces_(random_surfaces(stream)),
        text_(text_of(surfaces_)),
        scene_(scene::parse_scene(text_, "random")) {}

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  [[nodiscard]] const Matrix& surface(std::size_t leaf) const { return surfaces_[leaf]; }

  // The crossings s > 0, ascending, of a ray that starts on a carrier.
  [[nodiscard]] std::vector<Expected> expected(const ExprRay& ray, surface::CarrierIndex on) const {
    std::vector<Expected> all;
    for (surface::CarrierIndex c = 0; c < scene_.carriers.size(); ++c) {
      const Matrix& m = surfaces_[scene_.leaves_of_carrier[c].front()];
      for (const Expr& s : roots(m, ray, c == on)) {
        if (s > Expr(0)) {
          all.push_back({c, s});
        }
      }
    }
    std::sort(all.begin(), all.end(),
              [](const Expected& a, const Expected& b) { return a.s < b.s; });
    return all;
  }

  // Is the leaf inside just behind the start?
  [[nodiscard]] bool starts_inside(std::size_t leaf, const ExprRay& ray,
                                   surface::CarrierIndex on) const {
    const Matrix& m = surfaces_[leaf];
    return scene_.leaves[leaf].carrier == on ? product(ray.origin, m, ray.direction) < Expr(0)
                                             : product(ray.origin, m, ray.origin) < Expr(0);
  }

  // Checks all and returns what is right.
  std::vector<Expected> check(const SpawnedEvents& events, const ExprRay& ray,
                              surface::CarrierIndex on) const {
    std::vector<Expected> right = expected(ray, on);
    REQUIRE(events.classes().size() == right.size());
    for (std::size_t i = 0; i < right.size(); ++i) {
      CHECK(events.classes()[i].carrier == right[i].carrier);
      const double s = right[i].s.doubleValue();
      CHECK(std::abs(events.classes()[i].s - s) <= 1e-12 * std::max(1.0, s));
    }
    for (csg::LeafIndex leaf = 0; leaf < surfaces_.size(); ++leaf) {
      CHECK(events.starts_inside(leaf) == starts_inside(leaf, ray, on));
    }
    return right;
  }

 private:
  std::vector<Matrix> surfaces_;
  std::string text_;
  scene::Scene scene_;
};

// Three small integers over 16, not all zero.
std::array<int, 3> random_vector(SeededStream& stream) {
  std::array<int, 3> v{};
  while (v == std::array<int, 3>{}) {
    for (int& x : v) {
      x = static_cast<int>(stream.integer(-40, 40));
    }
  }
  return v;
}

geometry::ExactPoint exactly(const std::array<int, 3>& v) {
  return {Rational(v[0], 16), Rational(v[1], 16), Rational(v[2], 16)};
}

Vector<Expr> as_expression(const std::array<int, 3>& v, int last) {
  const auto part = [](int x) { return Expr(x) / Expr(16); };
  return {part(v[0]), part(v[1]), part(v[2]), Expr(last)};
}

TEST_CASE("Rays spawned once and twice meet what expressions with square roots say", "[spawned]") {
  constexpr std::uint64_t kScenes = 1'100;
  constexpr int kRaysPerScene = 8;
  std::uint64_t spawned = 0;
  support::ClassTally tally{
      "linear",         "quadratic",     "twice",    "hits the surface it starts on",
      "several leaves", "meets nothing", "undecided"};
  for (std::uint64_t id = 0; id < kScenes; ++id) {
    SeededStream stream("spawned-events", 1, id);
    const Bench bench(stream);
    method::RayEvents<number::exact> primary(bench.scene(), {});
    for (int r = 0; r < kRaysPerScene; ++r) {
      const auto from = random_vector(stream);
      const auto way = random_vector(stream);
      const geometry::ExactRay ray{exactly(from), exactly(way)};
      primary.find(ray);
      if (primary.in_some_carrier() || primary.crossings().empty()) {
        continue;
      }
      const auto& hit = primary.crossings()[stream.below(primary.crossings().size())];
      const surface::CarrierIndex on = bench.scene().leaves[hit.leaf].carrier;
      const ExprRay incident{as_expression(from, 1), as_expression(way, 0)};
      const auto incident_roots = roots(bench.surface(hit.leaf), incident, false);
      REQUIRE(hit.index < incident_roots.size());

      const auto next = random_vector(stream);
      const ExprRay once{incident.at(incident_roots[hit.index]), as_expression(next, 0)};
      INFO(bench.text() << "ray from " << from[0] << " " << from[1] << " " << from[2] << " way "
                        << way[0] << " " << way[1] << " " << way[2] << " (over 16), hit "
                        << hit.t.lower() << ", then " << next[0] << " " << next[1] << " "
                        << next[2]);
      SpawnedEvents events(bench.scene());
      const method::ExactStart start = events.start_on(ray, hit.t);
      REQUIRE(std::binary_search(start.carriers.begin(), start.carriers.end(), on));
      if (start.carriers.size() > 1 || !events.find(start, exactly(next))) {
        tally.add("undecided");
        continue;
      }
      ++spawned;
      const std::vector<Expected> right = bench.check(events, once, on);
      const auto& classes = events.classes();
      tally.add(bench.scene().carriers[on].degree == 1 ? "linear" : "quadratic");
      tally.add("several leaves", bench.scene().leaves_of_carrier[on].size() > 1);
      tally.add("hits the surface it starts on",
                std::any_of(classes.begin(), classes.end(),
                            [on](const auto& cls) { return cls.carrier == on; }));
      tally.add("meets nothing", classes.empty());
      if (classes.empty()) {
        continue;
      }
      const std::size_t at = stream.below(classes.size());
      const surface::CarrierIndex second = classes[at].carrier;
      const Expr& s = right[at].s;
      const auto last = random_vector(stream);
      const ExprRay twice{once.at(s), as_expression(last, 0)};
      SpawnedEvents further(bench.scene());
      if (!further.find(events.start_on(at), exactly(last))) {
        tally.add("undecided");
        continue;
      }
      ++spawned;
      tally.add("twice");
      bench.check(further, twice, second);
    }
  }
  INFO(tally);
  CHECK(tally.count("undecided") < spawned / 100);
  for (const char* reached : {"linear", "quadratic", "twice", "hits the surface it starts on",
                              "several leaves", "meets nothing"}) {
    CHECK(tally.count(reached) >= 100);
  }
  CHECK(spawned >= 10'000);
}

}  // namespace
}  // namespace lamina
