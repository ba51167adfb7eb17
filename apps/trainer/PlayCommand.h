// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "PlayRequest.h"

namespace trainer
{

/// Plays request.scenario to its end and leaves the pictures, statistics and report that were asked for.
foundation::Outcome play(const PlayRequest& request);

/// Lays a tour over the terrain request.terrain, writes it to `saveFile` unless that is empty, and plays it.
/// Units: seconds.
foundation::Outcome tour(const PlayRequest& request, const std::filesystem::path& saveFile, double durationS);

/// Reads a scenario tolerantly and prints everything that is wrong or not supported, one line each.
/// Errors: the text is no scenario at all, or anything was found.
foundation::Outcome check(const std::filesystem::path& scenario);

} // namespace trainer
