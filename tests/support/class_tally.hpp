// Counts which hard classes a random test reached, so that it cannot pass by missing them.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lamina::support {

class ClassTally {
 public:
  ClassTally(std::initializer_list<std::string> names) {
    for (const std::string& name : names) {
      counts_[name] = 0;
    }
  }

  /// Counts one case of a class; throws std::out_of_range for a name that is not listed.
  void add(std::string_view name, bool reached = true) {
    const auto found = counts_.find(name);
    if (found == counts_.end()) {
      throw std::out_of_range("no such class: " + std::string(name));
    }
    found->second += reached ? 1 : 0;
  }

  [[nodiscard]] std::uint64_t count(std::string_view name) const {
    const auto found = counts_.find(name);
    return found == counts_.end() ? 0 : found->second;
  }

  [[nodiscard]] bool each_at_least(std::uint64_t least) const {
    for (const auto& [name, count] : counts_) {
      if (count < least) {
        return false;
      }
    }
    return true;
  }

  friend std::ostream& operator<<(std::ostream& out, const ClassTally& tally) {
    out << "reached";
    for (const auto& [name, count] : tally.counts_) {
      out << ' ' << name << '=' << count;
    }
    return out;
  }

 private:
  std::map<std::string, std::uint64_t, std::less<>> counts_;
};

}  // namespace lamina::support
