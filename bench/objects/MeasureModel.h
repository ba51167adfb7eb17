// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "Race.h"

namespace objectbench
{

/// What a model's levels take in each order of its faces, under each number of lights; a plot for each number is added.
/// Errors: cannot be read, has no triangles.
foundation::Result<Race::Json> measureModel(const std::string& file, const Request& request, Race& race,
                                            std::vector<std::string>& plots);

} // namespace objectbench
