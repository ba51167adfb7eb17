// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <foundation/Result.h>

namespace osgTerrainROAM::core
{

/// Finds the null values ("*") of a GRASS ASCII grid, as indices in file order. GDAL reads them as 0, which
/// on a coast is an ordinary height.
/// Source: GRASS GIS manual, r.in.ascii: a header of "key: value" lines, then rows of numbers or null
/// strings.
/// Errors: the file holds fewer values than `expected`.
foundation::Result<std::vector<std::size_t>> grassNulls(const std::string& gdalPath, std::size_t expected);

} // namespace osgTerrainROAM::core
