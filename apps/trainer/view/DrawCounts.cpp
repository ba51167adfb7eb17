// SPDX-License-Identifier: Apache-2.0
#include "view/DrawCounts.h"

#include <algorithm>

#include <osg/Geometry>
#include <osgViewer/Renderer>

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

void DrawCounter::operator()(osg::RenderInfo& renderInfo) const
{
    auto* const renderer = dynamic_cast<osgViewer::Renderer*>(renderInfo.getCurrentCamera()->getRenderer());
    for (unsigned int i = 0; renderer && i < 2; ++i)
    {
        osgUtil::SceneView* const view = renderer->getSceneView(i);
        if (!view || !view->getRenderStage()) continue;
        _draws = drawsOf(*view->getRenderStage());
        if (_draws > 0) return;
    }
}

} // namespace trainer
