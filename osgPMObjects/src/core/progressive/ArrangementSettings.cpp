// SPDX-License-Identifier: Apache-2.0
#include <foundation/SettingsCheck.h>

#include <osgPMObjects/core/progressive/ArrangementSettings.h>

namespace osgPMObjects::core
{

foundation::Outcome checkSettings(const ArrangementSettings& settings)
{
    using Limits = ArrangementSettings;
    return foundation::SettingsCheck("arrangement")
        .within("cacheSize", settings.cacheSize, 3, Limits::kMostCacheSize)
        .within("blockFaces", settings.blockFaces, 0, Limits::kMostBlockFaces)
        .within("windowBlocks", settings.windowBlocks, 2, Limits::kMostWindowBlocks)
        .above("tswapStep", settings.tswapStep, 0.0, 1.0)
        .within("stayWeight", settings.stayWeight, 0.0)
        .within("touchedLineWeight", settings.touchedLineWeight, 0.0)
        .within("lookAhead", settings.lookAhead, 1, Limits::kMostLookAhead)
        .outcome();
}

} // namespace osgPMObjects::core
