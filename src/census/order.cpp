#include "census/order.hpp"

#include <algorithm>
#include <numeric>

#include "base/seeded_stream.hpp"

namespace lamina::census {
namespace {

constexpr std::size_t kAllOrdersUpTo = 4;  // 24 orders

}  // namespace

OrderProbe::OrderProbe(const scene::Scene& scene, std::uint32_t random_orders)
    : scene_(scene), random_orders_(random_orders), rank_(scene.leaves.size()) {
  std::iota(rank_.begin(), rank_.end(), csg::LeafIndex{0});
}

void OrderProbe::find_ties(const method::Tracer& tracer) {
  const auto crossings = tracer.crossings();
  tied_.clear();
  run_of_.assign(crossings.size(), 0);
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const bool equal = tracer.equal_t(i - 1, i);
    run_of_[i] = run_of_[i - 1] + (equal ? 0 : 1);
    if (equal) {
      tied_.push_back(crossings[i - 1].leaf);
      tied_.push_back(crossings[i].leaf);
    }
  }
  std::sort(tied_.begin(), tied_.end());
  tied_.erase(std::unique(tied_.begin(), tied_.end()), tied_.end());
}

std::vector<OrderProbe::Seen> OrderProbe::seen_in(const method::Report& report,
                                                  const method::Tracer& tracer) const {
  std::vector<Seen> seen;
  for (const method::Interface& interface : report.interfaces) {
    seen.push_back({run_of_[interface.crossing], tracer.crossings()[interface.crossing].leaf,
                    interface.transition});
  }
  return seen;
}

// `order` is one of tied_: its leaves share the ranks that are theirs by index.
void OrderProbe::try_order(method::Tracer& tracer, const std::vector<method::Method>& methods,
                           const std::vector<csg::LeafIndex>& order) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank_[order[i]] = tied_[i];
  }
  tracer.reorder(rank_);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::vector<Seen> seen;
    if (methods[m].status == method::Status::Geometric) {
      // Inside tests do not know of the order: only the interfaces' own changes.
      seen = by_index_[m];
      std::stable_sort(seen.begin(), seen.end(), [this](const Seen& a, const Seen& b) {
        return a.run != b.run ? a.run < b.run : rank_[a.leaf] < rank_[b.leaf];
      });
    } else {
      tracer.run(methods[m], report_);
      seen = seen_in(report_, tracer);
    }
    Outcome outcome;
    // Whichever event changed the medium last owns the interface, so that only its media
    // count; the first of a group need not own it.
    const bool any_leaf = methods[m].surface == method::Surface::FirstOfGroup;
    for (const Seen& s : seen) {
      outcome.insert(outcome.end(), {s.run, s.transition.from, s.transition.to,
                                     any_leaf ? scene_.leaves[s.leaf].medium : csg::kEmpty});
    }
    auto& known = outcomes_[m];
    if (std::find(known.begin(), known.end(), outcome) == known.end()) {
      known.push_back(std::move(outcome));
    }
  }
}

const std::vector<std::uint32_t>& OrderProbe::outcomes(method::Tracer& tracer,
                                                       const std::vector<method::Method>& methods,
                                                       const std::vector<method::Report>& reports) {
  counts_.assign(methods.size(), 1);
  find_ties(tracer);
  if (tied_.empty()) {
    return counts_;
  }
  outcomes_.assign(methods.size(), {});
  by_index_.assign(methods.size(), {});
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m].status == method::Status::Geometric) {
      by_index_[m] = seen_in(reports[m], tracer);
    }
  }
  std::vector<csg::LeafIndex> order = tied_;
  if (order.size() <= kAllOrdersUpTo) {
    do {
      try_order(tracer, methods, order);
    } while (std::next_permutation(order.begin(), order.end()));
  } else {
    base::SeededStream stream("census/order", 0, 0);
    try_order(tracer, methods, order);
    for (std::uint32_t i = 0; i < random_orders_; ++i) {
      for (std::size_t k = order.size() - 1; k > 0; --k) {
        std::swap(order[k], order[stream.below(k + 1)]);
      }
      try_order(tracer, methods, order);
    }
  }
  for (const csg::LeafIndex leaf : tied_) {
    rank_[leaf] = leaf;
  }
  tracer.reorder(rank_);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    counts_[m] = static_cast<std::uint32_t>(outcomes_[m].size());
  }
  return counts_;
}

}  // namespace lamina::census
