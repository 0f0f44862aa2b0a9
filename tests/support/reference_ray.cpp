#include "support/reference_ray.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/reference_faces.hpp"

namespace lamina::reference {
namespace {

// A polynomial in t, ascending.
class Polynomial {
 public:
  explicit Polynomial(const Rational& constant) : c_{constant} {}
  Polynomial(const Rational& constant, const Rational& slope) : c_{constant, slope} {}

  [[nodiscard]] Rational operator[](std::size_t power) const {
    return power < c_.size() ? c_[power] : Rational(0);
  }
  [[nodiscard]] bool is_zero() const {
    return std::all_of(c_.begin(), c_.end(), [](const Rational& c) { return c == 0; });
  }

  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a.add(b, 1); }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a.add(b, -1); }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product(Rational(0));
    product.c_.resize(a.c_.size() + b.c_.size() - 1);
    for (std::size_t i = 0; i < a.c_.size(); ++i) {
      for (std::size_t j = 0; j < b.c_.size(); ++j) {
        product.c_[i + j] += a.c_[i] * b.c_[j];
      }
    }
    return product;
  }

 private:
  Polynomial& add(const Polynomial& other, int factor) {
    c_.resize(std::max(c_.size(), other.c_.size()));
    for (std::size_t i = 0; i < other.c_.size(); ++i) {
      c_[i] += factor * other.c_[i];
    }
    return *this;
  }

  std::vector<Rational> c_;
};

// One half-space along the ray.
struct Face {
  Polynomial f;
  bool cut;
};

void collect(const Node& node, const Ray& ray, std::vector<Face>& all) {
  for (const Node& operand : node.operands) {
    collect(operand, ray, all);
  }
  if (node.is_solid()) {
    const Vector o = to_local(node.chain, ray.origin, Kind::Point);
    const Vector d = to_local(node.chain, ray.direction, Kind::Direction);
    std::size_t face = 0;
    const std::array<Polynomial, 3> point{Polynomial(o[0], d[0]), Polynomial(o[1], d[1]),
                                          Polynomial(o[2], d[2])};
    for (const Polynomial& f : faces_at<Polynomial>(node.primitive, point)) {
      all.push_back({f, is_cut(node.primitive, face++)});
    }
  }
}

std::vector<Face> along(const Node& node, const Ray& ray) {
  std::vector<Face> all;
  collect(node, ray, all);
  return all;
}

// The medium where the half-spaces, counted on from `next`, are as stated.
Medium medium(const Node& node, const std::vector<bool>& inside, std::size_t& next) {
  if (node.is_solid()) {
    bool all = true;
    for (const std::size_t end = next + face_count(node.primitive); next < end; ++next) {
      all = all && inside[next];
    }
    return all ? node.material : kNothing;
  }
  Medium result = kNothing;
  for (std::size_t i = 0; i < node.operands.size(); ++i) {
    const Medium operand = medium(node.operands[i], inside, next);
    result = i == 0 ? operand : operate(node.operation, result, operand);
  }
  return result;
}

Medium medium(const Node& node, const std::vector<bool>& inside) {
  std::size_t next = 0;
  return medium(node, inside, next);
}

// Owners and lamina by their definitions: in some order the crossing of a leaf comes behind
// just those of any subset of the others.
void look_at_subsets(const Node& node, const std::vector<bool>& before, RayClass& cls) {
  const std::size_t size = cls.leaves.size();
  if (size > RayClass::kMostLeaves) {
    return;
  }
  std::vector<Medium> behind(std::size_t{1} << size);
  for (std::size_t subset = 0; subset < behind.size(); ++subset) {
    std::vector<bool> inside = before;
    for (std::size_t i = 0; i < size; ++i) {
      if (((subset >> i) & 1U) != 0) {
        inside[cls.leaves[i]] = !inside[cls.leaves[i]];
      }
    }
    behind[subset] = medium(node, inside);
    cls.lamina = cls.lamina || behind[subset] != behind[0];
  }
  cls.lamina = cls.lamina && cls.from == cls.to;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t bit = std::size_t{1} << i;
    for (std::size_t subset = 0; subset < behind.size(); ++subset) {
      if ((subset & bit) == 0 && behind[subset] != behind[subset | bit]) {
        cls.owners.push_back(cls.leaves[i]);
        break;
      }
    }
  }
}

struct Event {
  Surd t;
  std::size_t leaf;
};

}  // namespace

std::size_t in_carriers(const Node& node, const Ray& ray) {
  const std::vector<Face> all = along(node, ray);
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [](const Face& face) { return face.f.is_zero(); }));
}

RayAnswer answer(const Node& node, const Ray& ray) {
  RayAnswer result;
  std::vector<Event> events;
  std::vector<bool> inside;
  for (const auto& [f, cut] : along(node, ray)) {
    const std::size_t leaf = inside.size();
    const Rational a = f[2];
    const Rational b = f[1];
    const Rational c = f[0];
    if (f[3] != 0 || f[4] != 0) {
      throw std::logic_error("a torus has more roots than square roots tell");
    }
    result.in_carriers += f.is_zero() ? 1 : 0;
    inside.push_back(a != 0 ? a < 0 : b != 0 ? b > 0 : c != 0 ? c < 0 : cut);
    if (a == 0 && b != 0) {
      events.push_back({Surd(-c / b, 0, 0), leaf});
    } else if (a != 0) {
      const Rational discriminant = b * b - 4 * a * c;
      const Rational middle = -b / (2 * a);
      if (discriminant > 0) {
        const Rational half = 1 / (2 * a);
        events.push_back({Surd(middle, half, discriminant), leaf});
        events.push_back({Surd(middle, -half, discriminant), leaf});
      } else if (discriminant == 0 && middle > 0) {
        ++result.touches;
      }
    }
  }
  std::sort(events.begin(), events.end(), [](const Event& x, const Event& y) {
    const int order = compare(x.t, y.t);
    return order < 0 || (order == 0 && x.leaf < y.leaf);
  });
  result.before = result.start = medium(node, inside);
  for (std::size_t first = 0; first < events.size();) {
    RayClass cls{events[first].t, {}, {}};
    while (first < events.size() && compare(cls.t, events[first].t) == 0) {
      cls.leaves.push_back(events[first++].leaf);
    }
    const std::vector<bool> before = inside;
    for (const std::size_t leaf : cls.leaves) {
      inside[leaf] = !inside[leaf];
    }
    if (cls.t.sign() > 0) {
      cls.from = medium(node, before);
      cls.to = medium(node, inside);
      look_at_subsets(node, before, cls);
      result.classes.push_back(std::move(cls));
    } else {
      result.start = medium(node, inside);
    }
  }
  result.end = medium(node, inside);
  return result;
}

}  // namespace lamina::reference
