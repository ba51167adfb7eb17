// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <foundation/Result.h>

namespace worldmaking
{

/// Returns the text of a map in XML, plain or compressed by gzip, in UTF-8 where it is written otherwise,
/// with a declaration that says so; nothing: it is in UTF-8 by its declaration, or no XML by its name. The
/// parsers of libosmium and GDAL know four encodings only. Errors: as foundation::Utf8Text::of().
foundation::Result<std::optional<std::string>> convertedXml(const std::filesystem::path& file);

} // namespace worldmaking
