#include "report/outcome_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "report/page.hpp"
#include "report/truth_text.hpp"

namespace lamina::report {
namespace {

using census::kNoCrossing;
using fmt::format;
using method::EventRecord;

// The events of one outcome as rows of a table.
class Events {
 public:
  Events(const Outcome& outcome, const Divergence& divergence, const Legend& legend,
         bool with_numbers)
      : outcome_(outcome), divergence_(divergence), legend_(legend), with_numbers_(with_numbers) {
    collect();
  }

  [[nodiscard]] std::string text() const {
    Columns columns;
    const std::string t = format("t in {}", outcome_.lane->number->name);
    columns.add(cells("", with_numbers_ ? t : "", "", "ulps off", "event", "inside", "medium", ""));
    columns.add(cells("", "start", "", "", "", start_states_,
                      medium_name(*outcome_.scene, outcome_.report.start),
                      behind_ == 0 ? "" : format("{} events at t <= 0", behind_)));
    const auto [first, last] = window();
    note_left_out(columns, first);
    for (std::size_t i = first; i < last; ++i) {
      add_row(columns, i);
    }
    note_left_out(columns, rows_.size() - last);
    return columns.text(0);
  }

 private:
  // An event, an exact crossing that was not found, or events of leaves that are not shown.
  struct Row {
    std::uint32_t record = kNoCrossing;
    std::uint32_t missing = kNoCrossing;
    std::size_t others = 0;
    std::string states{};
  };

  void collect() {
    std::vector<bool> states;
    for (const csg::LeafIndex leaf : legend_.leaves()) {
      states.push_back(outcome_.first_state(leaf));
    }
    start_states_ = states_text(states);
    std::vector<std::uint32_t> missing = missing_crossings();
    for (std::uint32_t r = 0; r < outcome_.records.size(); ++r) {
      const EventRecord& record = outcome_.records[r];
      const double t = outcome_.lane->tracer->t(record.crossing);
      while (!missing.empty() && exact_t(missing.front()) < t) {
        rows_.push_back({.missing = missing.front(), .states = states_text(states)});
        missing.erase(missing.begin());
      }
      for (std::size_t i = 0; i < states.size(); ++i) {
        states[i] = outcome_.state_behind(record, legend_.leaves()[i], states[i]);
      }
      if (!listed(r)) {
        start_states_ = states_text(states);
        ++behind_;
      } else if (legend_.shows(outcome_.leaf_of(record))) {
        rows_.push_back({.record = r, .states = states_text(states)});
      } else if (!rows_.empty() && rows_.back().others > 0) {
        ++rows_.back().others;
      } else {
        rows_.push_back({.others = 1});
      }
    }
    for (const std::uint32_t crossing : missing) {
      rows_.push_back({.missing = crossing, .states = states_text(states)});
    }
  }

  // Events behind the start are listed where the divergence is one of them.
  [[nodiscard]] bool listed(std::uint32_t r) const {
    return outcome_.ahead(outcome_.records[r]) || shows_behind();
  }
  [[nodiscard]] bool shows_behind() const {
    for (const std::uint32_t r : {divergence_.record, divergence_.other}) {
      if (r != Divergence::kNone && !outcome_.ahead(outcome_.records[r])) {
        return true;
      }
    }
    return divergence_.exact != Divergence::kNone && exact_t(divergence_.exact) <= 0;
  }

  [[nodiscard]] std::vector<std::uint32_t> missing_crossings() const {
    std::vector<std::uint32_t> missing;
    const auto& matches = outcome_.lane->judge.matches();
    for (std::uint32_t i = 0; i < matches.size(); ++i) {
      if (matches[i] == kNoCrossing && legend_.shows(outcome_.truth->crossings()[i].leaf) &&
          (exact_t(i) > 0 || shows_behind())) {
        missing.push_back(i);
      }
    }
    return missing;
  }

  [[nodiscard]] double exact_t(std::uint32_t crossing) const {
    return nearest_double(outcome_.truth->crossings()[crossing].t);
  }

  [[nodiscard]] std::string states_text(const std::vector<bool>& states) const {
    std::string text;
    for (std::size_t i = 0; i < states.size() && legend_.has_letters(); ++i) {
      text += states[i] ? legend_.name(legend_.leaves()[i]) : ".";
    }
    return text;
  }

  [[nodiscard]] bool is_arrow(const Row& row) const {
    return (row.record != kNoCrossing && row.record == divergence_.record) ||
           (row.missing != kNoCrossing && row.missing == divergence_.exact &&
            divergence_.record == Divergence::kNone);
  }

  // Rows to show: all, or those around the arrow.
  [[nodiscard]] std::pair<std::size_t, std::size_t> window() const {
    constexpr std::size_t kMost = 32;
    constexpr std::size_t kAround = 10;
    if (rows_.size() <= kMost) {
      return {0, rows_.size()};
    }
    const auto arrow =
        std::find_if(rows_.begin(), rows_.end(), [this](const Row& row) { return is_arrow(row); });
    const std::size_t center =
        arrow == rows_.end() ? 0 : static_cast<std::size_t>(arrow - rows_.begin());
    return {center - std::min(center, kAround), std::min(center + kAround + 1, rows_.size())};
  }

  void note_left_out(Columns& columns, std::size_t count) const {
    if (count > 0) {
      columns.add(cells("", "..", "", "", "", "", "", format("{} more rows", count)));
    }
  }

  // Drops the columns that do not apply.
  [[nodiscard]] std::vector<std::string> cells(std::string arrow, std::string t, std::string group,
                                               std::string ulps, std::string event,
                                               std::string states, std::string medium,
                                               std::string remark) const {
    std::vector<std::string> row{std::move(arrow), std::move(t), std::move(group)};
    if (outcome_.lane->number->significand_bits > 0 && with_numbers_) {
      row.push_back(std::move(ulps));
    }
    row.push_back(std::move(event));
    if (legend_.has_letters()) {
      row.push_back(std::move(states));
    }
    row.push_back(std::move(medium));
    row.push_back(std::move(remark));
    return row;
  }

  void add_row(Columns& columns, std::size_t index) const {
    const Row& row = rows_[index];
    const std::string arrow = is_arrow(row) ? "->" : "";
    if (row.record != kNoCrossing) {
      const EventRecord& record = outcome_.records[row.record];
      columns.add(cells(arrow, t_text(record), group_bracket(index), ulps_text(record),
                        format("{} {}", legend_.name(outcome_.leaf_of(record)),
                               record.enters ? "enters" : "leaves"),
                        row.states, medium_name(*outcome_.scene, record.medium), remark(record)));
    } else if (row.missing != kNoCrossing) {
      const auto& crossing = outcome_.truth->crossings()[row.missing];
      columns.add(cells(arrow, with_numbers_ ? shortest_text(exact_t(row.missing), 0) : "", "", "",
                        format("{} ({})", legend_.name(crossing.leaf),
                               crossing.enters_by_parity ? "enters" : "leaves"),
                        row.states, "", "root not found"));
    } else {
      columns.add(cells("", "..", "", "", "", "", "", format("{} of other leaves", row.others)));
    }
  }

  [[nodiscard]] std::string t_text(const EventRecord& record) const {
    return with_numbers_ ? shortest_text(outcome_.lane->tracer->t(record.crossing),
                                         outcome_.lane->number->significand_bits)
                         : "";
  }

  [[nodiscard]] std::string ulps_text(const EventRecord& record) const {
    const std::uint32_t exact = outcome_.exact_of(record);
    if (!with_numbers_ || exact == kNoCrossing || outcome_.lane->number->significand_bits == 0) {
      return "";
    }
    const number::Root& truth = outcome_.truth->crossings()[exact].t;
    return format("{:.2g}", outcome_.lane->tracer->error(record.crossing, truth).t_ulps);
  }

  [[nodiscard]] std::string group_bracket(std::size_t index) const {
    const auto same_group = [this, index](const Row& row) {
      return row.record != kNoCrossing &&
             outcome_.records[row.record].group == outcome_.records[rows_[index].record].group;
    };
    const auto count = std::count_if(rows_.begin(), rows_.end(), same_group);
    const auto before = std::count_if(
        rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(index), same_group);
    return bracket(static_cast<std::size_t>(before), static_cast<std::size_t>(count));
  }

  [[nodiscard]] std::string remark(const EventRecord& record) const {
    std::vector<std::string> remarks;
    if (const method::Interface* seen = outcome_.reported(record)) {
      remarks.push_back(format("interface {} -> {}",
                               medium_name(*outcome_.scene, seen->transition.from),
                               medium_name(*outcome_.scene, seen->transition.to)));
    }
    if (!record.accepted) {
      remarks.push_back(format("rejected: {} already", record.inside ? "inside" : "outside"));
    }
    const std::uint32_t exact = outcome_.exact_of(record);
    if (exact == kNoCrossing) {
      remarks.emplace_back("no such crossing in truth");
    } else if (outcome_.truth->crossings()[exact].enters_by_parity != record.enters) {
      remarks.push_back(format("in truth it {}", record.enters ? "leaves" : "enters"));
    }
    return format("{}", fmt::join(remarks, "; "));
  }

  const Outcome& outcome_;
  const Divergence& divergence_;
  const Legend& legend_;
  bool with_numbers_;
  std::string start_states_;
  std::size_t behind_ = 0;  // events before the first that is listed
  std::vector<Row> rows_;
};

}  // namespace

std::string verdict_text(const census::Verdict& verdict) {
  if (verdict.right()) {
    return "right";
  }
  std::vector<std::string> found;
  for (std::size_t a = 0; a < census::kArtifactCount; ++a) {
    if (const std::uint32_t count = verdict.count[a]; count > 0) {
      found.push_back(format("{}{}", census::artifact_texts()[a].heading,
                             count > 1 ? format(" x{}", count) : ""));
    }
  }
  return format("{}", fmt::join(found, ", "));
}

std::string events_text(const Outcome& outcome, const Divergence& divergence,
                        const Legend& legend) {
  return Events(outcome, divergence, legend, true).text();
}

std::string pattern_of(const Outcome& outcome, const Divergence& divergence, const Legend& legend) {
  return format("{} {} {}", static_cast<int>(divergence.cause), verdict_text(outcome.verdict),
                Events(outcome, divergence, legend, false).text());
}

}  // namespace lamina::report
