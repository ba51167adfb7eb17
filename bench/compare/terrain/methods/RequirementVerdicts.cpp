// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "compare/terrain/methods/Verdicts.h"
#include "measurement/HtmlPage.h"

namespace terraintool
{

namespace
{

using measurement::figureText;

constexpr double kMostTimesFewest = 1.15;      // R1
constexpr double kSpikeTrianglesPerLevel = 32; // R3, of log2 of the side
constexpr double kMostTimesMedian = 4.0;       // R4
constexpr double kMostTransforms = 1.0;        // R5: what a long strip takes
constexpr double kLongStrip = 10.0;            // R5, triangles
constexpr double kMostChangedPercent = 5.0;    // R6: the paper's share
constexpr double kMostPopPx = 1.0;             // R6
constexpr double kLeastOfCeiling = 0.99;       // R7
constexpr const char* kOneMesh = "one mesh for all eyes";

std::string met(bool isMet)
{
    return isMet ? "met" : "not met";
}

double fewestTriangles(const DemComparison& dem)
{
    double fewest = std::numeric_limits<double>::infinity();
    for (const MethodFigures& m : dem.methods)
        fewest = std::min(fewest, m.triangles);
    return fewest;
}

RequirementVerdict noRedundancy(const MethodFigures& m, double fewest)
{
    return {"R1", m.name, met(m.triangles <= kMostTimesFewest * fewest),
            figureText(m.triangles / fewest) + " times the triangles of the method with the fewest"};
}

RequirementVerdict noBreaks(const MethodFigures& m)
{
    return {"R2", m.name, met(m.breaks == 0),
            figureText(static_cast<double>(m.breaks)) + " T-junctions and cracks"};
}

RequirementVerdict localFeatures(const MethodFigures& m)
{
    if (!m.spikeTriangles) return {"R3", m.name, "not measured", "no spike was prepared"};
    const double most = kSpikeTrianglesPerLevel * std::log2(m.sideSamples);
    return {"R3", m.name, met(*m.spikeTriangles <= most),
            "a spike adds " + figureText(*m.spikeTriangles) + " triangles, " + figureText(most) +
                " are allowed"};
}

RequirementVerdict steadyTime(const MethodFigures& m)
{
    if (!m.adapts) return {"R4", m.name, "not measured", kOneMesh};
    return {"R4", m.name, met(m.adaptUsP99 <= kMostTimesMedian * m.adaptUsP50),
            "the 99th percentile is " + figureText(m.adaptUsP99 / m.adaptUsP50) + " times the median"};
}

constexpr const char* kNothingShared = "triangles share no vertices";

RequirementVerdict longStrips(const char* name, const MethodFigures& m, const std::optional<double>& length,
                              const char* made)
{
    if (!length) return {name, m.name, "not measured", kNothingShared};
    return {name, m.name, met(*length >= kLongStrip), figureText(*length) + " triangles a strip, " + made};
}

RequirementVerdict fewTransforms(const MethodFigures& m)
{
    if (!m.transformsPerTriangle) return {"R5 transforms", m.name, "not measured", kNothingShared};
    return {"R5 transforms", m.name, met(*m.transformsPerTriangle <= kMostTransforms),
            figureText(*m.transformsPerTriangle) + " vertices transformed a triangle"};
}

RequirementVerdict smallChanges(const MethodFigures& m)
{
    if (!m.adapts) return {"R6", m.name, "not measured", kOneMesh};
    return {"R6", m.name, met(m.changedPercent <= kMostChangedPercent && m.popPx <= kMostPopPx),
            figureText(m.changedPercent) + " % of the triangles change in a frame, the surface by up to " +
                figureText(m.popPx) + " px"};
}

RequirementVerdict knownComplexity(const MethodFigures& m)
{
    if (!m.ceiling) return {"R7", m.name, "not met", "takes no number of triangles"};
    if (m.ceiling->ceiling > m.ceiling->asked)
        return {"R7", m.name, "not met",
                "draws no fewer than " + figureText(m.ceiling->ceiling) + " triangles, " +
                    figureText(m.ceiling->asked) + " were asked; true error " +
                    figureText(m.ceiling->trueErrorPx) + " px"};
    const bool isMet = m.ceiling->framesAbove == 0 && m.ceiling->leastShare >= kLeastOfCeiling;
    return {"R7", m.name, met(isMet),
            "of " + figureText(m.ceiling->ceiling) + " triangles at least " +
                figureText(100.0 * m.ceiling->leastShare) + " % used, " +
                figureText(static_cast<double>(m.ceiling->framesAbove)) + " frames above; true error " +
                figureText(m.ceiling->trueErrorPx) + " px"};
}

RequirementVerdict alwaysValid(const MethodFigures& m)
{
    if (!m.slices) return {"R8", m.name, "not met", "does not stop in time"};
    if (m.slices->stops == 0) return {"R8", m.name, "not measured", "no frame had to stop"};
    return {"R8", m.name, met(m.slices->faults == 0),
            figureText(static_cast<double>(m.slices->stops)) +
                " frames stopped before their work was done, " +
                figureText(static_cast<double>(m.slices->faults)) + " left a mesh that is not valid"};
}

} // namespace

std::vector<RequirementVerdict> requirementVerdicts(const DemComparison& dem)
{
    std::vector<RequirementVerdict> verdicts;
    const double fewest = fewestTriangles(dem);
    for (const MethodFigures& m : dem.methods)
        for (RequirementVerdict verdict :
             {noRedundancy(m, fewest), noBreaks(m), localFeatures(m), steadyTime(m),
              longStrips("R5 strips", m, m.dualStripLength, "made by the dual graph"),
              longStrips("R5 slots", m, m.stripLength, "in the order of the slots"), fewTransforms(m),
              smallChanges(m), knownComplexity(m), alwaysValid(m)})
            verdicts.push_back(std::move(verdict));
    return verdicts;
}

} // namespace terraintool
