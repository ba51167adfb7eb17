// SPDX-License-Identifier: Apache-2.0
#include "view/DrawCounts.h"

#include <algorithm>

#include <osg/Geometry>
#include <osgUtil/CullVisitor>

#include <osgTraversal/DrawCount>

namespace trainer
{

namespace
{

unsigned int drawsOf(const osg::Drawable& drawable)
{
    if (const auto* const counted = dynamic_cast<const osgTraversal::DrawCount*>(&drawable))
        return counted->draws();
    const osg::Geometry* const geometry = drawable.asGeometry();
    return geometry ? std::max(geometry->getNumPrimitiveSets(), 1U) : 1; // 1: terrain and roads
}

} // namespace

unsigned int drawsOf(osgUtil::RenderBin& bin)
{
    unsigned int draws = 0;
    for (const osgUtil::StateGraph* const graph : bin.getStateGraphList())
        for (const auto& leaf : graph->_leaves)
            draws += drawsOf(*leaf->getDrawable());
    for (const osgUtil::RenderLeaf* const leaf : bin.getRenderLeafList())
        draws += drawsOf(*leaf->getDrawable());
    for (const auto& [number, inner] : bin.getRenderBinList())
        draws += drawsOf(*inner);
    return draws;
}

unsigned int drawsBefore(osgUtil::RenderStage& stage)
{
    unsigned int draws = 0;
    for (const auto& [order, before] : stage.getPreRenderList())
        draws += drawsOf(*before) + drawsBefore(*before);
    return draws;
}

void DrawCounter::operator()(osg::Node* node, osg::NodeVisitor* visitor)
{
    traverse(node, visitor);
    osgUtil::CullVisitor* const cull = visitor->asCullVisitor();
    if (!cull || !cull->getRenderStage()) return;
    _draws = drawsOf(*cull->getRenderStage());
    _drawsBefore = trainer::drawsBefore(*cull->getRenderStage());
}

} // namespace trainer
