#include <fmt/format.h>

#include <optional>

#include "report/divergence.hpp"
#include "report/page.hpp"

namespace lamina::report {
namespace {

using Cause = Divergence::Cause;
using fmt::format;

// The phrases that the sentences are made of.
class Phrases {
 public:
  Phrases(const Divergence& divergence, const Outcome& outcome, const Legend& legend)
      : divergence_(divergence), outcome_(outcome), legend_(legend) {}

  [[nodiscard]] std::string of_cause() const {
    const std::uint32_t r = divergence_.record;
    const std::uint32_t other = divergence_.other;
    const std::string leaf = legend_.name(divergence_.leaf);
    switch (divergence_.cause) {
      case Cause::None:
        return "";
      case Cause::RootMissing:
        return format("The solver finds no root for {} here; in truth the ray {} it at t = {}.",
                      leaf, enters(exact_enters(divergence_.exact)), exact_t(divergence_.exact));
      case Cause::RootInvented:
        return format("The solver finds a root for {} at t = {}; in truth there is none.", leaf,
                      t(r));
      case Cause::WrongStart:
        return format("For t towards -infinity {} is taken to be {}; in truth it is {}.", leaf,
                      in(outcome_.first_state(divergence_.leaf)),
                      in(outcome_.truth->starts_inside(divergence_.leaf)));
      case Cause::OtherSide:
        return format("In truth {} is crossed at t = {}, {} the start; here its t comes out as {}.",
                      leaf, exact_t(exact()), ahead_in_truth() ? "ahead of" : "not ahead of",
                      found_t());
      case Cause::NotFinite:
        return format("The t of {} overflows; in truth it is {}.", leaf, exact_t(exact()));
      case Cause::WrongSense:
        return format("By {} the ray {} {} here; in truth it {} it.", sense(),
                      enters(record(r).enters), leaf, enters(exact_enters(exact())));
      case Cause::Rejected:
        return format(
            "The validity check rejects that the ray {} {}, which is taken to be {} already.",
            enters(record(r).enters), leaf, in(record(r).inside));
      case Cause::Swapped:
        return format("In truth {} is crossed before {}, at t = {} and {}; rounding puts {} first.",
                      name(other), leaf, exact_t(exact_of(other)), exact_t(exact_of(r)), leaf);
      case Cause::Split:
        return format(
            "{} and {} are crossed at exactly the same t; in {} they are at t = {} and {}, {}: "
            "between them the medium is {}.",
            leaf, name(other), number(), t(r), t(other),
            within_epsilon() ? "farther apart than epsilon" : "and so are not processed at once",
            medium_behind_group(r));
      case Cause::OneAtATime:
        return format(
            "{} and {} are crossed at exactly the same t, but are processed one at a time: behind "
            "{} alone the medium is {}.",
            leaf, name(other), leaf, medium_behind_group(r));
      case Cause::Merged: {
        const bool in_order = exact_of(other) < exact_of(r);
        const std::uint32_t first = in_order ? other : r;
        const std::uint32_t second = in_order ? r : other;
        return format(
            "In truth {} and {} are crossed one after the other, at t = {} and {}; {}.",
            name(first), name(second), exact_t(exact_of(first)), exact_t(exact_of(second)),
            within_epsilon()
                ? "that is within epsilon, and so they are processed at once"
                : format("in {} both are at t = {}, and so are processed at once", number(), t(r)));
      }
      case Cause::LookedAhead:
        return format(
            "The look-ahead (W&T 3.6) crosses {} together with {}: the inside test says that the "
            "rounded point is beyond it already. In truth {} is crossed at t = {}, and {} at {}.",
            leaf, name(other), name(other), exact_t(exact_of(other)), leaf, exact_t(exact_of(r)));
      case Cause::InsideTest:
        return inside_test();
      case Cause::NotOwner:
        return format(
            "The interface is reported as {}, the first event of its group; {} does not own it: in "
            "no order of these events does {} change the medium.",
            leaf, leaf, leaf);
      case Cause::Unknown:
        return "The cause could not be told; compare the events with those of the truth.";
    }
    return "";
  }

 private:
  [[nodiscard]] const method::EventRecord& record(std::uint32_t r) const {
    return outcome_.records[r];
  }
  [[nodiscard]] std::uint32_t exact_of(std::uint32_t r) const {
    return outcome_.exact_of(record(r));
  }
  [[nodiscard]] std::uint32_t exact() const {
    return divergence_.record == Divergence::kNone ? divergence_.exact
                                                   : exact_of(divergence_.record);
  }
  [[nodiscard]] std::string name(std::uint32_t r) const {
    return legend_.name(outcome_.leaf_of(record(r)));
  }
  [[nodiscard]] std::string number() const { return outcome_.lane->number->name; }

  [[nodiscard]] std::string t_of_crossing(std::size_t crossing) const {
    return shortest_text(outcome_.lane->tracer->t(crossing),
                         outcome_.lane->number->significand_bits);
  }
  [[nodiscard]] std::string t(std::uint32_t r) const { return t_of_crossing(record(r).crossing); }
  [[nodiscard]] std::string found_t() const {
    return t_of_crossing(outcome_.lane->judge.matches()[exact()]);
  }
  [[nodiscard]] std::string exact_t(std::uint32_t crossing) const {
    return shortest_text(nearest_double(outcome_.truth->crossings()[crossing].t), 0);
  }
  [[nodiscard]] bool exact_enters(std::uint32_t crossing) const {
    return outcome_.truth->crossings()[crossing].enters_by_parity;
  }
  [[nodiscard]] bool ahead_in_truth() const {
    return compare(outcome_.truth->crossings()[exact()].t, number::Rational(0)) > 0;
  }

  static std::string_view enters(bool yes) { return yes ? "enters" : "leaves"; }
  static std::string_view in(bool yes) { return yes ? "inside" : "outside"; }

  [[nodiscard]] std::string sense() const {
    return outcome_.method->sense == method::Sense::Normal
               ? format("the normal at the rounded point of {}", legend_.name(divergence_.leaf))
               : format("the count of the roots of {}", legend_.name(divergence_.leaf));
  }
  [[nodiscard]] bool within_epsilon() const {
    return outcome_.method->grouping == method::Grouping::WithinEpsilon;
  }
  [[nodiscard]] std::string medium_behind_group(std::uint32_t r) const {
    while (r + 1 < outcome_.records.size() && record(r + 1).group == record(r).group) {
      ++r;
    }
    return medium_name(*outcome_.scene, record(r).medium);
  }

  [[nodiscard]] std::string inside_test() const {
    const csg::LeafIndex leaf = divergence_.leaf;
    const std::string tested = legend_.name(leaf);
    const method::Tracer& tracer = *outcome_.lane->tracer;
    if (divergence_.record == Divergence::kNone) {
      const bool inside = tracer.inside_at(leaf, method::Tracer::kStart);
      return format(
          "At the start of the ray the inside test finds the point {} {}; in truth the "
          "ray starts {} it.",
          in(inside), tested, in(!inside));
    }
    const method::EventRecord& event = record(divergence_.record);
    const std::string own = name(divergence_.record);
    const bool inside = tracer.inside_at(leaf, event.crossing);
    const std::string point =
        outcome_.lane->number->significand_bits > 0 ? "the rounded point" : "the point";
    const auto coincident = partner(leaf, event);
    if (!coincident) {
      return format("The inside test finds {} of {} {} {}; in truth it is {}.", point, own,
                    in(inside), tested, in(!inside));
    }
    std::string text = format(
        "{} and {} are crossed at exactly the same t, but the inside test finds {} of {} {} {}",
        own, tested, point, own, in(inside), tested);
    if (const method::EventRecord* back = *coincident) {
      const bool reported = outcome_.reported(event) != nullptr;
      const bool reported_back = outcome_.reported(*back) != nullptr;
      text += format(", and that of {} {} {}: {} reported", tested,
                     in(tracer.inside_at(outcome_.leaf_of(event), back->crossing)), own,
                     reported && reported_back ? "both are"
                     : reported                ? format("only {} is", own)
                     : reported_back           ? format("only {} is", tested)
                                               : "neither is");
    }
    return text + ".";
  }

  // The leaf's event at exactly the t of another one, which may be missing; nothing if it has
  // no crossing there in truth.
  [[nodiscard]] std::optional<const method::EventRecord*> partner(
      csg::LeafIndex leaf, const method::EventRecord& event) const {
    const auto crossings = outcome_.truth->crossings();
    for (const census::TruthCrossing& candidate : outcome_.truth->crossings_of(leaf)) {
      if (compare(crossings[candidate.crossing].t, crossings[outcome_.exact_of(event)].t) == 0) {
        for (const method::EventRecord& other : outcome_.records) {
          if (outcome_.exact_of(other) == candidate.crossing) {
            return &other;
          }
        }
        return nullptr;
      }
    }
    return std::nullopt;
  }

  const Divergence& divergence_;
  const Outcome& outcome_;
  const Legend& legend_;
};

}  // namespace

std::string sentence(const Divergence& divergence, const Outcome& outcome, const Legend& legend) {
  const std::string cause = Phrases(divergence, outcome, legend).of_cause();
  return divergence.harmless ? "What the ray sees is right all the same. " + cause : cause;
}

}  // namespace lamina::report
