// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/progressive/ProgressiveMesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace pmtool
{

/// A mesh with its levels, of which some are measured.
struct CacheSubject
{
    osgPMObjects::core::Mesh mesh;
    osgPMObjects::core::CollapseSequence sequence;
    std::vector<std::uint32_t> levels;                ///< steps, rising
    osgPMObjects::core::ArrangementSettings settings; ///< for every arrangement

    CacheSubject(osgPMObjects::core::Mesh subject, std::size_t levelCount,
                 const osgPMObjects::core::ArrangementSettings& arrangementSettings);
};

/// The names of all arrangements of faces, as in tables.
std::vector<std::string> cacheOrderNames();

/// Measures one arrangement and returns its row. Transforms per vertex count the vertices that a level's
/// faces use. There is one draw call for each material; it begins with an empty cache. Arrangements made anew
/// for every level have no time and no bytes.
nlohmann::ordered_json cacheRow(const CacheSubject& subject, const std::string& order);

} // namespace pmtool
