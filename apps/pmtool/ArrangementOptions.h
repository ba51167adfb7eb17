// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osgPMObjects/core/progressive/ArrangementSettings.h>

#include "pmtool/Commands.h"

namespace pmtool
{

/// How a command arranges faces.
struct ArrangementRequest
{
    osgPMObjects::core::ArrangementSettings settings;
    bool measuresCache = false; ///< --fifo measure: the size of the cache is found on this machine
};

/// Declares --fifo and the parameters of tswap and of windows.
void addArrangementOptions(CLI::App& command, ArrangementRequest& request);

/// Returns the settings, with the cache of this machine where it was asked for. Errors: as
/// measureVertexCache().
foundation::Result<osgPMObjects::core::ArrangementSettings>
arrangementSettingsOf(const ArrangementRequest& request);

} // namespace pmtool
