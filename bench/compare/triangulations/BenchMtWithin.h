// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <osgMultiTriangulation/core/input/PointDistribution.h>

#include "compare/triangulations/MtBenchRequest.h"

namespace terraintool
{

/// Builds made-up points within request.memoryMb, in a process of its own whose data the system limits to
/// that (RLIMIT_DATA). Points go to files as they are made. Returns the row of a table; "peakMB" is the most
/// that was resident.
/// Errors: those of the build; the process ended by itself, as one does that asks for more.
foundation::Result<nlohmann::ordered_json>
benchCaseWithin(const std::string& name, osgMultiTriangulation::core::PointDistribution distribution,
                std::size_t count, const MtBenchRequest& request);

} // namespace terraintool
