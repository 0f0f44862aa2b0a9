// The methods by their parts: grouping x status x check, and how they are spelled.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "number/rational.hpp"

namespace lamina::method {

/// Which events are processed at once.
enum class Grouping : std::uint8_t {
  Single,         ///< one after the other in order of t, ties by leaf index
  EqualT,         ///< all of equal t
  WithinEpsilon,  ///< all not farther than epsilon behind the first of the group
};

/// Where a leaf's IN or OUT comes from when another leaf's event is classified.
enum class Status : std::uint8_t {
  Toggled,    ///< carried along the ray, flipped by each of the leaf's events
  Carried,    ///< carried along the ray, set by enter and leave, if the check lets them
  Geometric,  ///< f <= 0 at the event's rounded point: nothing is carried
};

/// Which leaf a group of events is reported as.
enum class Surface : std::uint8_t {
  FirstOfGroup,  ///< Roth's: the nearest intersection, whatever it does
  LastChange,    ///< the one that last changed the medium
};

/// Which events count.
enum class Check : std::uint8_t {
  None,
  Validity,  ///< entering where IN, and leaving where OUT, is rejected (W&T 3.5)
};

/// What tells entering from leaving.
enum class Sense : std::uint8_t {
  Normal,  ///< the sign of normal . direction at the rounded point (W&T 3.2)
  Parity,  ///< the number of the leaf's crossings before this one
};

/// Whether later surfaces that the point has already passed are crossed with it (W&T 3.6).
enum class LookAhead : std::uint8_t {
  None,
  Literal,  ///< the next one, and so on until one is not passed or the ray is stopped
  All,      ///< every later one, whatever is between, until the ray is stopped
  /// Those of the leaves that share the hit leaf's carrier, which coincide exactly: nothing is
  /// tested, and an opaque medium stops nothing. The interface is then the class's, or none.
  Class,
};

/// Where the leaf states of a spawned ray come from.
enum class Secondary : std::uint8_t {
  Parity,   ///< each ray anew, from its crossings behind the start (W&T 3.7)
  Inherit,  ///< all from the ray before it, as it was at the hit (W&T 3.3, 3.5)
  Hybrid,   ///< the hit leaf's from the ray before it, the others' anew
  /// All from the ray before it: reflected and shadow rays as it was before the leaves that
  /// share the hit leaf's carrier, which coincide exactly, were crossed; transmitted ones as it
  /// is when all of them are.
  Cluster,
};

/// One way of deciding what a ray sees.
struct Method {
  std::string name;  ///< as it is spelled, and as it stands in tables
  Grouping grouping = Grouping::EqualT;
  Status status = Status::Toggled;
  Surface surface = Surface::LastChange;
  Check check = Check::None;
  Sense sense = Sense::Parity;
  LookAhead look_ahead = LookAhead::None;
  Secondary secondary = Secondary::Parity;
  /// Do reflected and shadow rays take the hit leaf as the hit has left it? W&T 3.4 say that it
  /// "has already been updated", and that these rays start outside: both only if it is set back.
  bool keeps_hit_leaf = false;
  number::Rational epsilon{0};    ///< for WithinEpsilon; always stated, never a default
  bool relative_epsilon = false;  ///< a multiple of the group's |t|, not a length
  /// Where a carried state starts: 0, from the sign of f at t = -infinity; else from an inside
  /// test at the point this length before the leaf's first crossing, or before the origin if
  /// it has none (W&T 3.7).
  number::Rational reference{0};
};

/// Roth 1982: all events of equal t; the surface is the first of them.
Method roth();
/// Wyvill and Sharp 1988: one event at a time, other leaves by a geometric inside test.
Method wyvill_sharp();
/// Amanatides and Mitchell 1990: events within epsilon are one.
Method epsilon(const number::Rational& epsilon, bool relative);
/// Tilove 1980: all events of equal t at once, only what has volume on both sides counts.
Method regularized();
/// Wyvill and Trotman 1990, section 3.
Method wyvill_trotman();

/// Returns the method that the text spells:
///   roth | wyvill-sharp | regularized
///   epsilon:E | epsilon:E:relative      E a length, or a multiple of |t|
///   wyvill-trotman[:parity][:no-look-ahead | :look-ahead-all | :look-ahead-class]
///                 [:reference:D]     D a length
///                 [:secondary:inherit | :secondary:parity | :secondary:hybrid |
///                  :secondary:cluster][:keeps-hit-leaf]
/// Throws base::InputError that lists these.
Method parse_method(std::string_view text);

/// One line for each spelling: the text and what it means.
struct MethodHelp {
  std::string spelling;
  std::string meaning;
};
std::vector<MethodHelp> method_help();

}  // namespace lamina::method
