// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 10.5.2 (superelevation), 10.5.3 (shape); 1.4, 5.3.6.2 (crossfall).
#include <map>
#include <utility>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

Crossfall readCrossfall(NodeReader& lateral)
{
    std::vector<Cubic> left, right;
    lateral.each("crossfall",
                 [&](NodeReader& entry)
                 {
                     const Cubic piece = entry.cubic("s");
                     const std::string side = entry.text("side");
                     if (side != "right") left.push_back(piece);
                     if (side != "left") right.push_back(piece);
                     if (side != "left" && side != "right" && side != "both" && !side.empty())
                         entry.mistake("crossfall/side has the unknown value \"" + side.substr(0, 40) + "\"",
                                       "write left, right or both, which is used");
                 });
    sortByStart(lateral, "crossfall", left);
    sortByStart(lateral, "crossfall", right);
    return {CubicProfile(std::move(left)), CubicProfile(std::move(right))};
}

std::vector<ShapeSection> readShapes(NodeReader& lateral)
{
    std::map<double, std::vector<Cubic>> byStart;
    lateral.each("shape", [&](NodeReader& entry) { byStart[entry.number("s")].push_back(entry.cubic("t")); });
    std::vector<ShapeSection> sections;
    for (auto& [s, pieces] : byStart)
    {
        sortByStart(lateral, "shape", pieces);
        sections.push_back({s, CubicProfile(std::move(pieces))});
    }
    return sections;
}

} // namespace

void readLateralProfile(NodeReader& road, Road& into)
{
    road.each("lateralProfile",
              [&](NodeReader& lateral)
              {
                  into.superelevationRad = lateral.profile("superelevation", "s");
                  into.crossfall = readCrossfall(lateral);
                  into.shapes = readShapes(lateral);
              });
}

} // namespace osgRoads::core
