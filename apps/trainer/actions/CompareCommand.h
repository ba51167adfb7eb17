// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "simulation/record/CompareMotions.h"

namespace trainer
{

/// The arguments of `trainer compare`.
struct CompareRequest
{
    std::filesystem::path table;
    std::filesystem::path reference;
    simulation::MotionLimits limits;
    bool failsBeyond = false;       ///< the limits
    std::filesystem::path jsonFile; ///< empty: none
};

/// Prints the largest and the RMS difference of each entity of the reference, by time and by place, one line
/// each.
/// Errors: a table that cannot be read; no entity in both. Where it `failsBeyond`: a difference beyond the
/// limits, or a row that the other table does not have.
foundation::Outcome compare(const CompareRequest& request);

} // namespace trainer
