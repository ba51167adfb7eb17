// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

namespace scenery
{

/// The most bytes of a description.
inline constexpr std::size_t kMostJsonBytes = 4U << 20U;

/// Reads a JSON text, in which comments are allowed. `name`: of the file, for messages.
/// Errors: more than 4 MB; no JSON, with the line.
foundation::Result<nlohmann::json> parseJson(std::string_view text, const std::string& name);

/// Reads up to 4 MB of a file and a byte. `what`: for the message: "a scenery's JSON file".
/// Errors: cannot be read, or is empty.
foundation::Result<std::string> readJsonText(const std::filesystem::path& file, const std::string& what);

} // namespace scenery
