// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <foundation/Result.h>

namespace pmtool
{

/// Measures how many vertices the vertex cache of this machine's OpenGL keeps: the most vertices that can be
/// drawn twice, one after the other, while each is transformed once (at most 1024). A card that works in
/// batches gives the vertices of a batch.
/// Errors: there is no OpenGL, or it does not count vertex shader invocations.
/// Source: the count of ARB_pipeline_statistics_query; *Cache-friendly view-independent progressive meshes*
/// (Graphicon 2003), section 5, which lets models be optimised for the accelerator of the user's machine.
foundation::Result<std::uint32_t> measureVertexCache();

} // namespace pmtool
