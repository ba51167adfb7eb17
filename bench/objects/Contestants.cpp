// SPDX-License-Identifier: Apache-2.0
#include "Contestants.h"

#include <osgPMObjects/core/order/FaceOrder.h>
#include <osgPMObjects/core/order/TriangleOrders.h>
#include <osgPMObjects/core/order/TriangleStrips.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ProgressiveDrawable>

namespace objectbench
{

using namespace osgPMObjects;

namespace
{

Contestant played(const std::string& name, const core::Mesh& mesh, const core::CollapseSequence& sequence,
                  const core::ArrangementSettings& settings)
{
    const osg::ref_ptr<ProgressiveDrawable> drawable = new ProgressiveDrawable(
        new ProgressiveShape(core::buildProgressiveMesh(mesh, sequence, settings), {}));
    return {name, [drawable](std::uint32_t steps) -> osg::ref_ptr<osg::Node> {
                return drawable->setSteps(steps) ? drawable : nullptr;
            }};
}

} // namespace

std::vector<Contestant> contestantsOf(const core::Mesh& mesh, const core::CollapseSequence& sequence)
{
    std::vector<Contestant> all;
    all.push_back(played("plain", mesh, sequence, {.arrangement = core::Arrangement::plain}));
    all.push_back(played("tswap", mesh, sequence, {.arrangement = core::Arrangement::tswap}));
    all.push_back(played("ours", mesh, sequence, {.arrangement = core::Arrangement::windows}));
    all.push_back({"scratch",
                   [&mesh, &sequence](std::uint32_t steps) -> osg::ref_ptr<osg::Node>
                   {
                       core::Mesh level = core::meshAfter(mesh, sequence, steps);
                       core::orderFaces(level, core::FaceOrder::library);
                       return exportNode(level, {});
                   }});
    return all;
}

std::vector<Contestant> stripContestantsOf(const core::Mesh& mesh, const core::CollapseSequence& sequence)
{
    const auto drawn = [&](const auto& order, const StripMaker& strip)
    {
        return [&mesh, &sequence, order, strip](std::uint32_t steps) -> osg::ref_ptr<osg::Node>
        {
            core::Mesh level = core::meshAfter(mesh, sequence, steps);
            core::orderFaces(level, order);
            return exportNode(level, {}, strip);
        };
    };
    const auto strips = [&](core::StripKind kind)
    {
        return drawn(core::FaceOrder::library,
                     [kind](std::span<const core::Triangle> triangles, std::uint32_t vertexCount)
                     { return core::joinStrips(triangles, core::stripsOf(triangles, vertexCount, kind)); });
    };
    return {{"triangles", drawn(core::FaceOrder::library, {})},
            {"triangles, Hilbert", drawn(core::TriangleOrder(core::hilbertOrder), {})},
            {"SGI strips", strips(core::StripKind::sgi)},
            {"dual-graph strips", strips(core::StripKind::dualGraph)}};
}

std::vector<Contestant> movingContestantsOf(const core::Mesh& mesh, const core::CollapseSequence& sequence)
{
    std::vector<Contestant> all;
    all.push_back(played("plain", mesh, sequence, {.arrangement = core::Arrangement::plain}));
    for (const auto& [name, step] :
         {std::pair{"tswap .4", 0.4f}, {"tswap .2", 0.2f}, {"tswap .1", 0.1f}, {"tswap .05", 0.05f}})
        all.push_back(
            played(name, mesh, sequence, {.arrangement = core::Arrangement::tswap, .tswapStep = step}));
    all.push_back(played("ours", mesh, sequence, {.arrangement = core::Arrangement::windows}));
    return all;
}

} // namespace objectbench
