// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

namespace pmtool
{

/// Tells by a file's name whether it is a progressive mesh.
bool isPmFile(const std::string& file);

/// Returns counts, estimates for some levels, measured errors of the ladder, materials, and the positions
/// that are there after each section of the file.
/// Errors: as PmReader.
foundation::Result<nlohmann::ordered_json> describePm(const std::string& file);

} // namespace pmtool
