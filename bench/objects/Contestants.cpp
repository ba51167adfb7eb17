// SPDX-License-Identifier: Apache-2.0
#include "Contestants.h"

#include <osgPMObjects/core/order/FaceOrder.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ProgressiveDrawable>

namespace objectbench
{

using namespace osgPMObjects;

namespace
{

Contestant played(const std::string& name, const core::Mesh& mesh, const core::CollapseSequence& sequence,
                  core::Arrangement arrangement)
{
    const osg::ref_ptr<ProgressiveDrawable> drawable = new ProgressiveDrawable(
        new ProgressiveShape(core::buildProgressiveMesh(mesh, sequence, {.arrangement = arrangement}), {}));
    return {name, [drawable](std::uint32_t steps) -> osg::ref_ptr<osg::Node> {
                return drawable->setSteps(steps) ? drawable : nullptr;
            }};
}

} // namespace

std::vector<Contestant> contestantsOf(const core::Mesh& mesh, const core::CollapseSequence& sequence)
{
    std::vector<Contestant> all;
    all.push_back(played("plain", mesh, sequence, core::Arrangement::plain));
    all.push_back(played("tswap", mesh, sequence, core::Arrangement::tswap));
    all.push_back(played("ours", mesh, sequence, core::Arrangement::windows));
    all.push_back({"scratch",
                   [&mesh, &sequence](std::uint32_t steps) -> osg::ref_ptr<osg::Node>
                   {
                       core::Mesh level = core::meshAfter(mesh, sequence, steps);
                       core::orderFaces(level, core::FaceOrder::library);
                       return exportNode(level, {});
                   }});
    return all;
}

} // namespace objectbench
