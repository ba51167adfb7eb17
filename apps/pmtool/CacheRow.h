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

/// The ways to keep faces in order, as they stand in tables.
std::vector<std::string> cacheOrderNames();

/// One row of the table. Transforms per vertex: of those that a level's faces use. Calls begin with an empty cache, one for each
/// material. What an order does not have is left out of the row: time and bytes of those that are made anew for every level.
nlohmann::ordered_json cacheRow(const CacheSubject& subject, const std::string& order);

} // namespace pmtool
