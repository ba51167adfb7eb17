// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <osgPMObjects/core/simplify/AreaCurve.h>
#include <osgPMObjects/core/simplify/RemoveVertices.h>
#include <osgPMObjects/core/simplify/SupportVertices.h>

#include "compare/objects/AreaChart.h"

namespace pmtool
{

/// A rule for support vertices, and its name in tables.
struct NamedSupportRule
{
    const char* name;
    osgPMObjects::core::SupportRule rule;
};

/// The rules of curves 1, 2 and 3 in Sadykov & Zakharov, *Choosing the level of detail in continuous
/// simplification of polygonal objects* (2002), figure 14.
constexpr std::array<NamedSupportRule, 3> kSupportRules{
    {{"none", osgPMObjects::core::SupportRule::none},
     {"maximum", osgPMObjects::core::SupportRule::farthest},
     {"maximum and minimum", osgPMObjects::core::SupportRule::farthestAndNearest}}};

/// The removal of vertices from a model under one rule for support vertices.
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

/// Returns levels of all variants as CSV, as docs/reference/json-tables.md describes it.
std::string csvOf(const std::vector<SupportVariant>& variants);

AreaPanel panelOf(const std::string& title, const std::vector<SupportVariant>& variants);

} // namespace pmtool
