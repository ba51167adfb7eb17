// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "pmtool/polygons/WarpTexture.h"

namespace pmtool
{

/// Reads a picture that OSG has a plugin for. Errors: no such file, no picture, compressed texels.
foundation::Result<Texels> readTexels(const std::filesystem::path& file);

/// Writes a picture as PNG with red, green, blue and alpha of 8 bits. Errors: those of
/// osgOffscreen::writePng().
foundation::Outcome writeTexels(const Texels& texels, const std::filesystem::path& file);

} // namespace pmtool
