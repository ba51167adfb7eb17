// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// The scenario as OpenSCENARIO XML 1.3: reading the text back strictly gives an equal model, but for the
/// version in its header. Catalogue entries and parameters stand where they were put in. Errors: content that
/// the model keeps only by name (Unsupported).
foundation::Result<std::string> scenarioText(const Scenario& scenario);

} // namespace simulation
