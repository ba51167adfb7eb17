// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

namespace pmtool
{

/// Whether a file's name says that it is a progressive mesh.
bool isPmFile(const std::string& file);

/// What is in a progressive mesh: counts, errors of some levels, materials, and after which levels a reader may stop.
/// Errors: as PmReader.
foundation::Result<nlohmann::ordered_json> describePm(const std::string& file);

} // namespace pmtool
