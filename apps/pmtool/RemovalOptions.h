// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>
#include <osgPMObjects/core/simplify/SupportVertices.h>

#include "pmtool/Commands.h"

namespace pmtool
{

/// How a command removes vertices one by one.
struct RemovalRequest
{
    osgPMObjects::core::SupportRule support = osgPMObjects::core::SupportRule::none;
    std::uint32_t octreeDepth = 3;
};

/// Declares --support and --support-depth.
void addRemovalOptions(CLI::App& command, RemovalRequest& request);

/// Removes vertices one by one and fills the holes by fans, so that a progressive mesh can play the steps.
/// `mesh`: consolidated.
osgPMObjects::core::CollapseSequence removalsOf(const osgPMObjects::core::Mesh& mesh,
                                                const RemovalRequest& request);

} // namespace pmtool
