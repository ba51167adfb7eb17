// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/simplify/Simplify.h>

#include "pmtool/Commands.h"

namespace pmtool
{

/// Declares --quadrics.
void addQuadrics(CLI::App& command, osgPMObjects::core::Quadrics& quadrics);

} // namespace pmtool
