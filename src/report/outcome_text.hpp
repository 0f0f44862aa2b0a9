// What one method does along a ray in one number type, event by event, as text.
#pragma once

#include <string>

#include "report/divergence.hpp"
#include "report/legend.hpp"
#include "report/outcome.hpp"

namespace lamina::report {

/// `right`, or the artifacts found.
std::string verdict_text(const census::Verdict& verdict);

/// A row for each event that the method processes ahead of the start, in its order: t in the
/// number type and how far it is off, entering or leaving, the leaves that the method takes to
/// be inside, the medium, the interface reported. Events processed at once are in brackets; an
/// arrow marks the divergence. Long lists are cut down to what is around it.
std::string events_text(const Outcome& outcome, const Divergence& divergence, const Legend& legend);

}  // namespace lamina::report
