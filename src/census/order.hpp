// How much of an answer hangs on the order of the leaves.
#pragma once

#include <cstdint>
#include <vector>

#include "method/tracer.hpp"

namespace lamina::census {

/// Counts the different answers that methods give to one ray when the leaves of the scene
/// are put in other orders, which decide ties of t: all orders of the leaves that tie if they
/// are four or fewer, else some random ones, the same for every run. Answers differ if
/// surfaces are seen elsewhere or between other media; and, from a method that reports the first
/// event of a group whatever it does, if they are of another material.
class OrderProbe {
 public:
  /// `random_orders` are tried where more than four leaves tie.
  OrderProbe(const scene::Scene& scene, std::uint32_t random_orders);

  /// Returns the number of different answers for each method; 1 where nothing ties. The
  /// tracer has found a ray, to which the methods gave these reports; it is left as it was.
  const std::vector<std::uint32_t>& outcomes(method::Tracer& tracer,
                                             const std::vector<method::Method>& methods,
                                             const std::vector<method::Report>& reports);

 private:
  using Outcome = std::vector<std::uint32_t>;
  struct Seen {
    std::uint32_t run = 0;
    csg::LeafIndex leaf = 0;
    csg::Transition transition;
  };

  void find_ties(const method::Tracer& tracer);
  [[nodiscard]] std::vector<Seen> seen_in(const method::Report& report,
                                          const method::Tracer& tracer) const;
  void try_order(method::Tracer& tracer, const std::vector<method::Method>& methods,
                 const std::vector<csg::LeafIndex>& order);

  const scene::Scene& scene_;
  std::uint32_t random_orders_;
  std::vector<csg::LeafIndex> tied_;            // ascending
  std::vector<std::uint32_t> run_of_;           // by crossing: which of the runs of equal t
  std::vector<csg::LeafIndex> rank_;            // by leaf
  std::vector<std::vector<Seen>> by_index_;     // by method, of geometric ones: ties by leaf index
  std::vector<std::vector<Outcome>> outcomes_;  // by method, distinct
  std::vector<std::uint32_t> counts_;
  method::Report report_;
};

}  // namespace lamina::census
