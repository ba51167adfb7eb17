// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "Race.h"

namespace objectbench
{

/// Measures the levels of a model in each order of its faces and with each number of lights, and adds a plot
/// for each number.
/// Errors: cannot be read, has no triangles.
foundation::Result<Race::Json> measureModel(const std::string& file, const Request& request, Race& race,
                                            std::vector<std::string>& plots);

} // namespace objectbench
