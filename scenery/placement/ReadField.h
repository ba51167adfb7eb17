// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scenery/placement/JsonFields.h"
#include "scenery/placement/SceneryDescription.h"

namespace scenery
{

/// One field of a description, which stands at `pointer`; the files it names are relative to `folder`.
SceneryField readField(const nlohmann::json& object, const std::string& pointer,
                       const std::filesystem::path& folder, Complaint& complaint);

} // namespace scenery
