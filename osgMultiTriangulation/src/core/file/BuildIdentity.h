// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgMultiTriangulation/core/split/Partition.h>
#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>
#include <osgMultiTriangulation/core/surface/PlanFrame.h>

namespace osgMultiTriangulation::core
{

/// Return a sum over all on which the bytes of the parts of a build depend.
std::uint32_t identityOf(const SurfaceMesh& mesh, const PlanFrame& frame, const Partition& partition);
std::uint32_t identityOf(const SurfaceSpool& spool, const PlanFrame& frame, const Partition& partition,
                         std::uint64_t mostHidden);

} // namespace osgMultiTriangulation::core
