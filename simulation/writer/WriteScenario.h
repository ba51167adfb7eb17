// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Writes a scenario as OpenSCENARIO XML 1.3. A strict reading of the text gives an equal model except for
/// the version in its header. Parameters and catalogue entries are written as replaced. Errors: Unsupported
/// content, which has only a name.
foundation::Result<std::string> scenarioText(const Scenario& scenario);

} // namespace simulation
