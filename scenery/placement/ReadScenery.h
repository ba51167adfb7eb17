// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "scenery/placement/SceneryDescription.h"

namespace scenery
{

/// Reads a description from its JSON text (docs/reference/scenery-file.md) and no other file. `name`: of the
/// file, for messages; the files that it names are relative to its folder.
/// Errors: no JSON, with the line; an unknown member or word or a number out of range, with its JSON pointer.
foundation::Result<SceneryDescription> parseScenery(std::string_view text, const std::filesystem::path& name);

/// Errors: cannot be read, larger than 4 MB; as parseScenery().
foundation::Result<SceneryDescription> readScenery(const std::filesystem::path& file);

} // namespace scenery
