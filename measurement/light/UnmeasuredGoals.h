// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace measurement
{

/// A goal, or a part of one, of which there is no figure, and why.
struct UnmeasuredGoal
{
    const char* goal; ///< "N1" …: docs/measurements/light.md
    const char* what;
    const char* why;
};

/// Returns all of them.
std::span<const UnmeasuredGoal> unmeasuredGoals();

} // namespace measurement
