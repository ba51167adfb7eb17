// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "scenery/placement/SceneryDescription.h"

namespace scenery
{

/// A description from its JSON text (docs/reference/scenery-file.md); reads no other file. `name`: of the file, for messages; what it names is
/// relative to its folder.
/// Errors: no JSON, with line; an unknown member or word, a number out of range, with the JSON pointer of the place.
foundation::Result<SceneryDescription> parseScenery(std::string_view text, const std::filesystem::path& name);

/// Errors: cannot be read, larger than 4 MB; as parseScenery().
foundation::Result<SceneryDescription> readScenery(const std::filesystem::path& file);

} // namespace scenery
