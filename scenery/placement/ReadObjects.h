// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scenery/json/JsonFields.h"
#include "scenery/placement/SceneryDescription.h"

namespace scenery
{

/// Reads the member `objects` of a field: kinds with seeds, and files relative to `folder`.
void readObjects(JsonFields& parent, const std::filesystem::path& folder,
                 std::vector<SceneryObject>& objects);

} // namespace scenery
