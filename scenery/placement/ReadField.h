// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scenery/json/JsonFields.h"
#include "scenery/placement/SceneryDescription.h"

namespace scenery
{

/// Reads one field of a description at the JSON pointer `pointer`; the files that it names are relative to
/// `folder`.
SceneryField readField(const nlohmann::json& object, const std::string& pointer,
                       const std::filesystem::path& folder, Complaint& complaint);

} // namespace scenery
