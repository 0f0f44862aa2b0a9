// The first place where a method goes another way than the truth, and why.
#pragma once

#include <cstdint>
#include <string>

#include "report/legend.hpp"
#include "report/outcome.hpp"

namespace lamina::report {

/// What makes the first wrong interface of an outcome wrong.
struct Divergence {
  enum class Cause : std::uint8_t {
    None,          ///< the outcome is right
    RootMissing,   ///< the solver did not find `exact`
    RootInvented,  ///< `record` is no crossing
    WrongStart,    ///< `leaf` is taken for what it is not, t towards -infinity
    OtherSide,     ///< `record` is on the other side of t = 0
    NotFinite,     ///< the t of `record` overflowed
    WrongSense,    ///< `record` enters what it leaves, or the other way round
    Rejected,      ///< `record` failed the validity check
    Swapped,       ///< `record` comes before `other`, in truth behind it
    Split,         ///< `record` and `other` are at the same t in truth, not here
    OneAtATime,    ///< `record` and `other` are at the same t, and processed one by one
    Merged,        ///< `other` and `record` are processed at once, in truth one is later
    LookedAhead,   ///< `record` is crossed with `other` since its point has passed it
    InsideTest,    ///< at the point of `record`, or at the start, `leaf` is not as tested
    NotOwner,      ///< `record` is not what makes this interface
    Unknown,
  };
  static constexpr std::uint32_t kNone = UINT32_MAX;

  Cause cause = Cause::None;
  std::uint32_t record = kNone;  ///< index into Outcome::records; none for roots not found
  std::uint32_t other = kNone;   ///< index into Outcome::records
  std::uint32_t exact = kNone;   ///< index into census::Truth::crossings()
  csg::LeafIndex leaf = 0;       ///< the leaf of `record` or `exact`, or as said above
  bool harmless = false;         ///< all that a ray sees is right nevertheless
};

/// Finds the wrong interface nearest to the start and what it comes from: first in the states
/// of leaves that the method carries there, then in the events at that place.
Divergence first_divergence(const Outcome& outcome);

/// One or two sentences for people.
std::string sentence(const Divergence& divergence, const Outcome& outcome, const Legend& legend);

}  // namespace lamina::report
