// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/split/BorderFit.h>
#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>

namespace osgMultiTriangulation::core
{

/// Does the same as fitBorder() for a surface in files, with one more file beside them while it runs.
/// Memory: 1 MB, and the rectangles. Errors: no room on the disk.
foundation::Result<BorderModel> fitBorder(const SurfaceSpool& spool, SplitAt where);

} // namespace osgMultiTriangulation::core
