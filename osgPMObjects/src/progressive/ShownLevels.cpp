// SPDX-License-Identifier: Apache-2.0
#include "ShownLevels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <osg/Program>

#include <osgTraversal/CullFacts>

namespace osgPMObjects
{

namespace
{

/// Returns whether a state above in the scene has a program.
bool hasProgram(osgUtil::CullVisitor& visitor)
{
    for (const osgUtil::StateGraph* at = visitor.getCurrentStateGraph(); at; at = at->_parent)
    {
        const osg::StateSet* const state = at->getStateSet();
        const auto* const program =
            state ? dynamic_cast<const osg::Program*>(state->getAttribute(osg::StateAttribute::PROGRAM))
                  : nullptr;
        if (program) return !program->isFixedFunction();
    }
    return false;
}

/// Puts one object into the render graph for one camera.
class LevelCull
{
public:
    LevelCull(osgUtil::CullVisitor& visitor, const ProgressiveShape& shape, const ShownLevels& shown,
              bool isShaded)
        : _visitor(visitor),
          _shape(shape),
          _shown(shown),
          _isShaded(isShaded && !hasProgram(visitor)),
          _depth(visitor.getDistanceFromEyePoint(shape.box().center(), false))
    {
    }

    /// Adds all depths of a level before its first colour, and one level after the other.
    void add(bool isSecond)
    {
        for (const LookPass pass : {LookPass::all, LookPass::depth, LookPass::colour})
            for (const auto& part : isSecond ? _shown.second : _shown.first)
                add(*part, isSecond, pass);
    }

private:
    void add(GroupPart& part, bool isSecond, LookPass pass)
    {
        const ProgressiveShape::Group& group = _shape.groups()[part.group()];
        const bool isTransparent = _shape.progressive().mesh.materials[group.material].isTransparent;
        const Look look = _shown.lookOf(isSecond, isTransparent);
        const bool hasPasses = look.isBlended && !isTransparent;
        if (!look.isDrawn() || hasPasses == (pass == LookPass::all)) return;

        const osg::ref_ptr<osg::StateSet> lookBelow = look.isPlain() ? nullptr : lookState(look, pass, group);
        const osg::StateSet* const states[] = {group.state, _isShaded ? group.shading.get() : nullptr,
                                               lookBelow};
        for (const osg::StateSet* const state : states)
            if (state) _visitor.pushStateSet(state);
        if (hasPasses)
            addInOrder(part);
        else
            _visitor.apply(part);
        for (const osg::StateSet* const state : states)
            if (state) _visitor.popStateSet();
    }

    /// Adds parts to the bin that is sorted by depth: all at the object's depth, each slightly nearer than
    /// the one before.
    void addInOrder(GroupPart& part)
    {
        osg::RefMatrix& matrix = *_visitor.getModelViewMatrix();
        if (osgTraversal::seeksNearFar(_visitor) && !_visitor.updateCalculatedNearFar(matrix, part, false))
            return;
        _visitor.addDrawableAndDepth(&part, &matrix, _depth);
        _depth = std::nextafter(_depth, std::numeric_limits<float>::lowest());
    }

    osgUtil::CullVisitor& _visitor;
    const ProgressiveShape& _shape;
    const ShownLevels& _shown;
    bool _isShaded;
    float _depth;
};

} // namespace

Look ShownLevels::lookOf(bool isSecond, bool isTransparent) const
{
    Look look;
    const core::DrawnLevel& level = isSecond ? drawn.second : drawn.first;
    if (isBlend() && (byDoor || isTransparent))
    {
        const bool isFiner = level.level == std::min(drawn.first.level, drawn.second.level);
        look.doorFrom = isFiner ? 0.0f : alpha * finerShare;
        look.doorTo = isFiner ? alpha * finerShare : alpha;
        return look;
    }
    look.isMorphing = isMorphing;
    look.morph = drawn.morph;
    look.firstMorphing = firstMorphing;
    const float shownAlpha = alpha * level.alpha;
    if (byDoor)
        look.doorTo = shownAlpha;
    else
    {
        look.alpha = shownAlpha;
        look.isBlended = shownAlpha < 1.0f;
    }
    return look;
}

void cullLevels(osgUtil::CullVisitor& visitor, const ProgressiveShape& shape, const ShownLevels& shown,
                bool isShaded)
{
    LevelCull cull(visitor, shape, shown, isShaded);
    cull.add(false);
    if (shown.isBlend()) cull.add(true);
}

} // namespace osgPMObjects
