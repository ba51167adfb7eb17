// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>
#include <osgPMObjects/core/simplify/ErrorLadder.h>

namespace osgPMObjects::core
{

/// Measures a ladder of levels of a progressive mesh against its finest level and keeps it in
/// ProgressiveMesh::ladder. Levels without a visible surface are left out. The settings must satisfy
/// checkSettings().
/// Deterministic: the same for any number of threads. Cost: LevelMeter::measure() for each of some 80 levels;
/// see docs/measurements/progressive-meshes.md. Source: that of LevelMeter.
void measureLevels(ProgressiveMesh& progressive, const LadderSettings& settings = {});

} // namespace osgPMObjects::core
