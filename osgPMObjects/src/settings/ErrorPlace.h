// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

namespace osgPMObjects
{

/// An outcome whose error's place begins with `place` instead of its first part: of "attention.gaze" and
/// "ProgressiveField.attention" it makes "ProgressiveField.attention.gaze".
inline foundation::Outcome at(const std::string& place, const foundation::Outcome& outcome)
{
    if (outcome) return outcome;
    const foundation::Error& error = outcome.error();
    const std::size_t rest = error.place.find('.');
    return foundation::Error{place + (rest == std::string::npos ? "" : error.place.substr(rest)), error.what,
                             error.remedy};
}

} // namespace osgPMObjects
