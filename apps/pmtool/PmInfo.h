// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <viewlod/Result.h>

namespace pmtool
{

/// Whether a file's name says that it is a progressive mesh.
bool isPmFile(const std::string& file);

/// What is in a progressive mesh: counts, errors of some levels, materials, and after which levels a reader may stop.
/// Errors: as PmReader.
viewlod::Result<nlohmann::ordered_json> describePm(const std::string& file);

} // namespace pmtool
