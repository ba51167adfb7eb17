// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/SupportCurves.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "pmtool/Timing.h"

namespace pmtool
{

using namespace osgPMObjects;

namespace
{

/// The number of intervals between the levels of a curve that are written.
constexpr std::size_t kWrittenLevels = 160;

/// Levels to write: the first with no more faces than each of kWrittenLevels shares, spread evenly in their
/// logarithm.
std::vector<std::size_t> writtenLevels(const core::AreaCurve& curve)
{
    std::vector<std::size_t> levels;
    const double all = static_cast<double>(curve.faces.front());
    for (std::size_t i = 0; i <= kWrittenLevels; ++i)
    {
        const double count = all * std::pow(all, -static_cast<double>(i) / kWrittenLevels);
        levels.push_back(curve.levelOf(static_cast<std::size_t>(std::lround(count))));
    }
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
}

double errorAfter(const core::RemovalSequence& sequence, std::size_t level)
{
    return level > 0 ? sequence.steps[level - 1].error : 0.0;
}

} // namespace

SupportVariant removeWith(const core::Mesh& shape, const NamedSupportRule& rule, std::uint32_t octreeDepth,
                          core::RemovalOptions options)
{
    SupportVariant variant{rule.name, 0, {}, {}, 0.0};
    variant.ms = millisecondsOf(
        [&]
        {
            options.isSupport =
                core::supportVertices(shape, core::OctreeDivisions::ofDepth(octreeDepth), rule.rule);
            variant.sequence = core::removeVertices(shape, options);
        });
    variant.supportVertices =
        static_cast<std::size_t>(std::count(options.isSupport.begin(), options.isSupport.end(), true));
    variant.curve = core::areaCurve(shape, variant.sequence);
    return variant;
}

std::string csvOf(const std::vector<SupportVariant>& variants)
{
    std::ostringstream out;
    out << "support,removed,faces,area,areaShare,error\n" << std::setprecision(9);
    for (const SupportVariant& v : variants)
        for (const std::size_t level : writtenLevels(v.curve))
            out << v.name << ',' << level << ',' << v.curve.faces[level] << ',' << v.curve.areas[level] << ','
                << v.curve.areas[level] / v.curve.areas.front() << ',' << errorAfter(v.sequence, level)
                << '\n';
    return out.str();
}

AreaPanel panelOf(const std::string& title, const std::vector<SupportVariant>& variants)
{
    AreaPanel panel{title, {}};
    for (std::size_t i = 0; i < variants.size(); ++i)
    {
        const core::AreaCurve& curve = variants[i].curve;
        AreaLine line{std::to_string(i + 1) + ' ' + variants[i].name, {}};
        for (const std::size_t level : writtenLevels(curve))
            line.points.emplace_back(static_cast<double>(curve.faces[level]) /
                                         static_cast<double>(curve.faces.front()),
                                     curve.areas[level] / curve.areas.front());
        panel.lines.push_back(std::move(line));
    }
    return panel;
}

} // namespace pmtool
