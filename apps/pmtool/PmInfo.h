// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

namespace pmtool
{

/// Tells by a file's name whether it is a progressive mesh.
bool isPmFile(const std::string& file);

/// Returns counts, errors of some levels, and materials of a progressive mesh, and the levels after which a reader may stop.
/// Errors: as PmReader.
foundation::Result<nlohmann::ordered_json> describePm(const std::string& file);

} // namespace pmtool
