// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgPMObjects/ProgressiveField>
#include <osgPMObjects/ProgressiveNode>

namespace osgPMObjects
{

/// Settings as lines of a scene file: a name and its values without spaces, e.g. "tolerancePx=1.5". A number has as few digits as
/// give back the same number; infinity is kept, too.
/// `Settings`: ProgressiveNodeSettings, ProgressiveFieldSettings, or FieldKind without its shape.
template<class Settings>
std::vector<std::string> linesOf(const Settings& settings);

/// The inverse of linesOf(). A field without a line stays as it is.
/// Errors: a name that is not known, a value that cannot be read; nothing is changed then. Ranges are checked by the setters.
template<class Settings>
foundation::Outcome readLines(const std::vector<std::string>& lines, Settings& settings);

/// An instance of a field as one line, "instance=…"; see visitNumbers().
std::string lineOf(const FieldInstance& instance);
foundation::Result<FieldInstance> instanceOf(const std::string& line);

} // namespace osgPMObjects
