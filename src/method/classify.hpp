// The one loop behind every method: groups of events, in order, through the CSG tree.
#pragma once

#include <algorithm>
#include <span>

#include "csg/ray_state.hpp"
#include "method/method.hpp"
#include "method/ray_events.hpp"
#include "method/report.hpp"

namespace lamina::method {

/// Receives each event as it is processed; the default does nothing and costs nothing.
struct IgnoreEvents {
  void operator()(const EventRecord&) const {}
};

/// What a ray that is spawned takes over, by leaf; leaves that it does not take over, and all
/// of a primary ray's, are classified along the ray.
struct Inherited {
  static constexpr std::uint8_t kOutside = 0;
  static constexpr std::uint8_t kInside = 1;
  static constexpr std::uint8_t kAnew = 2;

  std::span<const std::uint8_t> states;  ///< empty: all anew
  /// Are events that contradict a state that is taken over rejected, whatever the method's check?
  bool validated = false;

  [[nodiscard]] bool takes(csg::LeafIndex leaf) const {
    return !states.empty() && states[leaf] != kAnew;
  }
};

/// Which leaves changed at a hit: enough to have the state before it from the one after it.
struct Hit {
  std::vector<csg::LeafIndex> group;   ///< by events processed at once, in order
  std::vector<csg::LeafIndex> passed;  ///< then crossed by the look-ahead of W&T 3.6
};

/// Goes along one ray and fills the report: a method's parts decide what is done at once,
/// what a leaf's state is, and which events count. Allocates nothing once `report` and
/// `state` have seen a ray, but for LookAhead::All and Class, which mark crossings.
template <number::RealNumber Number, typename OnEvent>
class Classifier {
 public:
  /// `step` is the method's epsilon in units of t, and `reference` its reference distance.
  Classifier(const scene::Scene& scene, const RayEvents<Number>& events, csg::RayState& state,
             Report& report, OnEvent on_event)
      : scene_(scene),
        events_(events),
        crossings_(events.crossings()),
        state_(state),
        report_(report),
        on_event_(on_event) {}

  /// Only the crossings ahead count for leaves that the ray has taken over.
  void inherit(Inherited inherited) { inherited_ = inherited; }

  /// Ends the ray at its first interface, where `hit` and the state are left as it goes on.
  void stop_at(Hit& hit) { hit_ = &hit; }

  void run(const Method& method, const Number& step, const Number& reference) {
    report_.clear();
    if (method.status == Status::Geometric) {
      run_geometric(method);
    } else {
      run_carried(method, step, reference);
    }
  }

 private:
  [[nodiscard]] bool ahead(std::size_t i) const { return events_.positive(crossings_[i].t); }

  [[nodiscard]] static bool enters(const Method& method, const Crossing<Number>& crossing) {
    return method.sense == Sense::Normal ? crossing.enters_by_normal : crossing.enters_by_parity;
  }

  // One past the last crossing that is processed together with `first`.
  [[nodiscard]] std::size_t group_end(const Method& method, std::size_t first,
                                      const Number& step) const {
    std::size_t end = first + 1;
    if (method.grouping == Grouping::Single) {
      return end;
    }
    const auto& t = crossings_[first].t;
    const bool equal_only = method.grouping == Grouping::EqualT;
    while (end < crossings_.size() &&
           (equal_only ? !events_.less(t, crossings_[end].t)
                       : events_.within(t, crossings_[end].t, step, method.relative_epsilon))) {
      ++end;
    }
    return end;
  }

  // Updates the event's leaf. Returns whether the medium of the whole changed.
  bool cross(const Method& method, std::size_t i, std::uint32_t group,
             std::vector<csg::LeafIndex> Hit::*changed) {
    const Crossing<Number>& crossing = crossings_[i];
    if (inherited_.takes(crossing.leaf) && !ahead(i)) {
      return false;
    }
    const bool in = enters(method, crossing);
    const csg::Medium before = state_.medium();
    const bool was_inside = state_.inside(crossing.leaf);
    const bool consistent = was_inside != in;
    const bool checked = method.check == Check::Validity ||
                         (inherited_.validated && inherited_.takes(crossing.leaf));
    const bool accepted = consistent || !checked;
    if (accepted) {
      if (method.status == Status::Carried) {
        state_.set(crossing.leaf, in);
      } else {
        state_.toggle(crossing.leaf);
      }
    }
    if (accepted && hit_ != nullptr && state_.inside(crossing.leaf) != was_inside) {
      (hit_->*changed).push_back(crossing.leaf);
    }
    if (!consistent && ahead(i)) {
      ++report_.inconsistent;
      report_.rejected += accepted ? 0 : 1;
    }
    on_event_({static_cast<std::uint32_t>(i), group, in, accepted, state_.inside(crossing.leaf),
               state_.medium()});
    return state_.medium() != before;
  }

  // Is the leaf of the crossing `later` none of those in first .. later-1? A surface that has
  // just been crossed is not one of the "additional surfaces" of W&T 3.6: its next crossing is
  // its far side, and an inside test at the point would only see rounding.
  [[nodiscard]] bool is_additional(std::size_t first, std::size_t later) const {
    return std::none_of(crossings_.begin() + first, crossings_.begin() + later,
                        [&](const auto& c) { return c.leaf == crossings_[later].leaf; });
  }

  // W&T 3.6: is the point of `hit` beyond the surface of the later crossing?
  [[nodiscard]] bool passed(const Method& method, std::size_t hit, std::size_t later) const {
    return events_.inside_at(crossings_[later].leaf, crossings_[hit].t) ==
           enters(method, crossings_[later]);
  }

  [[nodiscard]] bool stops_ray(csg::Medium medium) const {
    return medium != csg::kEmpty && scene_.materials[medium].opaque();
  }

  // W&T 3.6: crosses what the point of the crossing `hit` has already passed. `end` is one past
  // the last crossing that is done, and moves on.
  void look_ahead(const Method& method, std::size_t first, std::size_t hit, std::size_t& end,
                  std::uint32_t group) {
    if (method.look_ahead == LookAhead::Literal) {
      while (end < crossings_.size() && !stops_ray(state_.medium()) && is_additional(first, end) &&
             passed(method, hit, end)) {
        cross(method, end++, group, &Hit::passed);
      }
      return;
    }
    done_.resize(crossings_.size());
    if (method.look_ahead == LookAhead::Class) {
      look_ahead_in_class(method, hit, end, group);
      return;
    }
    for (std::size_t i = end; i < crossings_.size() && !stops_ray(state_.medium()); ++i) {
      if (done_[i] == 0 && is_additional(first, i) && passed(method, hit, i)) {
        cross(method, i, group, &Hit::passed);
        done_[i] = 1;
      }
    }
  }

  // Crosses, with the hit leaf, the leaves that coincide with it and are not yet crossed.
  void look_ahead_in_class(const Method& method, std::size_t hit, std::size_t end,
                           std::uint32_t group) {
    const csg::LeafIndex hit_leaf = crossings_[hit].leaf;
    const scene::Leaf& leaf = scene_.leaves[hit_leaf];
    for (const csg::LeafIndex other : scene_.leaves_of_carrier[leaf.carrier]) {
      const bool alike = scene_.leaves[other].side == leaf.side;
      if (state_.inside(other) == (alike == state_.inside(hit_leaf))) {
        continue;
      }
      for (std::size_t i = end; i < crossings_.size(); ++i) {
        if (crossings_[i].leaf == other && done_[i] == 0) {
          cross(method, i, group, &Hit::passed);
          done_[i] = 1;
          break;
        }
      }
    }
  }

  void run_carried(const Method& method, const Number& step, const Number& reference) {
    state_.reset([&](csg::LeafIndex leaf) {
      return inherited_.takes(leaf) ? inherited_.states[leaf] == Inherited::kInside
                                    : events_.starts_inside(leaf, reference);
    });
    report_.start = state_.medium();
    std::uint32_t group = 0;
    for (std::size_t first = 0; first < crossings_.size(); ++group) {
      if (first < done_.size() && done_[first] != 0) {
        ++first;
        continue;
      }
      if (hit_ != nullptr) {
        hit_->group.clear();
        hit_->passed.clear();
      }
      std::size_t end = group_end(method, first, step);
      const csg::Medium from = state_.medium();
      std::size_t surface = first;
      for (std::size_t i = first; i < end; ++i) {
        if (cross(method, i, group, &Hit::group) && method.surface == Surface::LastChange) {
          surface = i;
        }
      }
      if (method.look_ahead != LookAhead::None && state_.medium() != from) {
        look_ahead(method, first, surface, end, group);
      }
      const csg::Medium to = state_.medium();
      if (!ahead(first)) {
        report_.start = to;
      } else if (from != to && events_.finite(crossings_[surface].t)) {
        report_.interfaces.push_back({static_cast<std::uint32_t>(surface), {from, to}});
        if (hit_ != nullptr) {
          break;
        }
      }
      first = end;
    }
    report_.end = state_.medium();
  }

  void run_geometric(const Method& method) {
    const csg::Tree& tree = scene_.tree;
    const typename RayEvents<Number>::Root origin{Number(0)};
    report_.start = csg::evaluate(tree, [&](csg::LeafIndex leaf) {
      return events_.inside_at(leaf, origin) ? tree.medium_of(leaf) : csg::kEmpty;
    });
    report_.end = report_.start;
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      const Crossing<Number>& crossing = crossings_[i];
      if (!ahead(i) || !events_.finite(crossing.t)) {
        continue;
      }
      const bool in = enters(method, crossing);
      const csg::Transition transition =
          csg::evaluate(tree, [&](csg::LeafIndex leaf) -> csg::Transition {
            const csg::Medium medium = tree.medium_of(leaf);
            if (leaf == crossing.leaf) {
              return in ? csg::Transition{csg::kEmpty, medium}
                        : csg::Transition{medium, csg::kEmpty};
            }
            return events_.inside_at(leaf, crossing.t) ? csg::Transition{medium, medium}
                                                       : csg::Transition{};
          });
      on_event_({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i), in, true, in,
                 transition.to});
      if (transition.from != transition.to) {
        report_.interfaces.push_back({static_cast<std::uint32_t>(i), transition});
        report_.end = transition.to;
        if (hit_ != nullptr) {
          break;
        }
      }
    }
  }

  const scene::Scene& scene_;
  const RayEvents<Number>& events_;
  std::span<const Crossing<Number>> crossings_;
  csg::RayState& state_;
  Report& report_;
  OnEvent on_event_;
  Inherited inherited_;
  Hit* hit_ = nullptr;
  std::vector<std::uint8_t> done_;  // by crossing, where All and Class have been
};

}  // namespace lamina::method
