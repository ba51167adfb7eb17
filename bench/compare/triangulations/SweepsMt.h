// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

#include "compare/triangulations/MtBenchRequest.h"

namespace terraintool
{

/// Returns three tables over one surface: numbers of trees from a quarter of the balanced one to four times
/// it, against memory and detail of a zone that moves across; thresholds of the zone
/// (ZoneSettings::hysteresis) against what it reads; the R-tree of extents against a linear scan. Files are
/// written to request.folder and removed.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), sections 3
/// to 5, whose claims these are.
foundation::Result<nlohmann::ordered_json> sweepsOver(const osgMultiTriangulation::core::SurfaceMesh& mesh,
                                                      const MtBenchRequest& request);

} // namespace terraintool
