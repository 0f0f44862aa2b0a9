#include "report/outcome_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
  Events(const Outcome& outcome, const Divergence& divergence, const Legend& legend)
      : outcome_(outcome), divergence_(divergence), legend_(legend) {
    collect();
  }

  [[nodiscard]] std::string text() const {
    Columns columns;
    const std::string t = format("t in {}", outcome_.lane->number->name);
    columns.add(cells("", t, "", "ulps off", "event", "inside", "medium", ""));
    const auto [first, last] = window();
    note_left_out(columns, first);
    for (std::size_t i = first; i < last; ++i) {
      add_row(columns, i);
    }
    note_left_out(columns, rows_.size() - last);
    return columns.text(0);
  }

 private:
  // An event, an exact crossing that was not found, events of leaves that are not shown, or
  // the start of the ray.
  struct Row {
    std::uint32_t record = kNoCrossing;
    std::uint32_t missing = kNoCrossing;
    std::size_t others = 0;
    bool start = false;
    std::string states{};
  };

  void collect() {
    std::vector<bool> states;
    for (const csg::LeafIndex leaf : legend_.leaves()) {
      states.push_back(outcome_.first_state(leaf));
    }
    const auto& records = outcome_.records;
    const bool list_behind = shows_behind();
    std::vector<std::uint32_t> missing = missing_crossings(list_behind);
    const auto add_missing_before = [&](double t) {
      const auto end = std::find_if(missing.begin(), missing.end(),
                                    [&](std::uint32_t crossing) { return exact_t(crossing) >= t; });
      for (auto crossing = missing.begin(); crossing != end; ++crossing) {
        rows_.push_back({.missing = *crossing, .states = states_text(states)});
      }
      missing.erase(missing.begin(), end);
    };
    const auto add_start = [&] {
      add_missing_before(0);
      rows_.push_back({.start = true, .states = states_text(states)});
    };
    for (std::uint32_t r = 0; r < records.size(); ++r) {
      if (outcome_.ahead(records[r]) && (r == 0 || !outcome_.ahead(records[r - 1]))) {
        add_start();
      }
      for (std::size_t i = 0; i < states.size(); ++i) {
        states[i] = outcome_.state_behind(records[r], legend_.leaves()[i], states[i]);
      }
      if (!outcome_.ahead(records[r]) && !list_behind) {
        ++left_out_;
        continue;
      }
      add_missing_before(outcome_.lane->tracer->t(records[r].crossing));
      if (legend_.shows(outcome_.leaf_of(records[r]))) {
        rows_.push_back({.record = r, .states = states_text(states)});
      } else if (!rows_.empty() && rows_.back().others > 0) {
        ++rows_.back().others;
      } else {
        rows_.push_back({.others = 1});
      }
    }
    if (records.empty() || !outcome_.ahead(records.back())) {
      add_start();
    }
    add_missing_before(std::numeric_limits<double>::infinity());
  }

  // Events behind the start are listed where the divergence is one of them.
  [[nodiscard]] bool shows_behind() const {
    for (const std::uint32_t r : {divergence_.record, divergence_.other}) {
      if (r != Divergence::kNone && !outcome_.ahead(outcome_.records[r])) {
        return true;
      }
    }
    return divergence_.exact != Divergence::kNone && exact_t(divergence_.exact) <= 0;
  }

  [[nodiscard]] std::vector<std::uint32_t> missing_crossings(bool list_behind) const {
    std::vector<std::uint32_t> missing;
    const auto& matches = outcome_.lane->judge.matches();
    for (std::uint32_t i = 0; i < matches.size(); ++i) {
      if (matches[i] == kNoCrossing && legend_.shows(outcome_.truth->crossings()[i].leaf) &&
          (exact_t(i) > 0 || list_behind)) {
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
    constexpr std::size_t kMost = 24;
    constexpr std::size_t kAround = 8;
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
      columns.add(cells("", "..", "", "", "", "", "", counted(count, "more row")));
    }
  }

  // Drops the columns that do not apply.
  [[nodiscard]] std::vector<std::string> cells(std::string arrow, std::string t, std::string group,
                                               std::string ulps, std::string event,
                                               std::string states, std::string medium,
                                               std::string remark) const {
    std::vector<std::string> row{std::move(arrow), std::move(t), std::move(group)};
    if (outcome_.lane->number->significand_bits > 0) {
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
      columns.add(cells(arrow, shortest_text(exact_t(row.missing), 0), "", "",
                        format("{} ({})", legend_.name(crossing.leaf),
                               crossing.enters_by_parity ? "enters" : "leaves"),
                        row.states, "", "root not found"));
    } else if (row.start) {
      columns.add(cells("", "start", "", "", "", row.states,
                        medium_name(*outcome_.scene, outcome_.report.start),
                        left_out_ == 0 ? "" : format("{} at t <= 0", counted(left_out_, "event"))));
    } else {
      columns.add(cells("", "..", "", "", "", "", "",
                        format("{} of other leaves", counted(row.others, "event"))));
    }
  }

  [[nodiscard]] std::string t_text(const EventRecord& record) const {
    return shortest_text(outcome_.lane->tracer->t(record.crossing),
                         outcome_.lane->number->significand_bits);
  }

  [[nodiscard]] std::string ulps_text(const EventRecord& record) const {
    const std::uint32_t exact = outcome_.exact_of(record);
    if (exact == kNoCrossing || outcome_.lane->number->significand_bits == 0 ||
        !std::isfinite(outcome_.lane->tracer->t(record.crossing))) {
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
  std::size_t left_out_ = 0;  // events behind the start
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
  return Events(outcome, divergence, legend).text();
}

}  // namespace lamina::report
