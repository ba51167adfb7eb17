// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <osgPMObjects/core/simplify/AreaCurve.h>
#include <osgPMObjects/core/simplify/RemoveVertices.h>
#include <osgPMObjects/core/simplify/SupportVertices.h>

#include "pmtool/AreaChart.h"

namespace pmtool
{

/// A kind of support vertices, by the name that tables have for it.
struct NamedSupportRule
{
    const char* name;
    osgPMObjects::core::SupportRule rule;
};

/// In the order of the curves 1, 2 and 3 of paper 004.
constexpr std::array<NamedSupportRule, 3> kSupportRules{
    {{"none", osgPMObjects::core::SupportRule::none},
     {"maximum", osgPMObjects::core::SupportRule::farthest},
     {"maximum and minimum", osgPMObjects::core::SupportRule::farthestAndNearest}}};

/// A model with its vertices removed as far as one kind of support vertices lets them.
struct SupportVariant
{
    std::string name; ///< of the rule
    std::size_t supportVertices = 0;
    osgPMObjects::core::RemovalSequence sequence;
    osgPMObjects::core::AreaCurve curve;
    double ms = 0.0; ///< to find support vertices and to remove the others
};

/// `options` without support vertices.
SupportVariant removeWith(const osgPMObjects::core::Mesh& shape, const NamedSupportRule& rule,
                          std::uint32_t octreeDepth, osgPMObjects::core::RemovalOptions options);

/// Levels of all variants, as docs/reference/json-tables.md lays them out.
std::string csvOf(const std::vector<SupportVariant>& variants);

AreaPanel panelOf(const std::string& title, const std::vector<SupportVariant>& variants);

} // namespace pmtool
