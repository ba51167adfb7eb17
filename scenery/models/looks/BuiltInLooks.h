// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "scenery/models/vehicles/VehicleLook.h"

namespace scenery::models
{

/// Returns the names of the looks of data/vehicles/looks, which are part of the library.
std::vector<std::string_view> builtInLookNames();

/// Returns the text of one of them; empty where there is none of that name.
std::string_view builtInLookText(std::string_view name);

/// Returns one of them, the same for all who ask. Precondition: there is one of that name. Threads: any.
std::shared_ptr<const VehicleLook> builtInLook(std::string_view name);

} // namespace scenery::models
