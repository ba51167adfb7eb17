// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/MatrixTransform>
#include <osg/Texture2D>

#include "scenery/models/cockpit/InteriorModel.h"
#include "scenery/nodes/Pose.h"

namespace scenery
{

/// The interior of a vehicle as nodes: instruments and wheel follow the readings, mirrors show textures that
/// somebody else draws (MirrorCamera.h). Frame: world; the vehicle's pose places it. Needs the uniforms of an
/// Atmosphere above it in the graph.
/// Threads: show() in the update phase.
class InteriorNode
{
public:
    explicit InteriorNode(models::InteriorModel model);

    /// All that hides what is behind it.
    osg::Node* node() const { return _placed.get(); }

    /// The disc of a propeller that turns fast, which one sees through; it belongs behind node() and before
    /// the scene. Null: none.
    osg::Node* disc() const { return _discPlaced.get(); }
    const models::InteriorModel& model() const { return _model; }

    /// The picture of each of the model's mirrors, in their order, as makeMirrorCamera() draws it.
    const std::vector<osg::ref_ptr<osg::Texture2D>>& mirrorPictures() const { return _mirrors; }

    /// Places everything. `isDark`: the instruments are lit.
    void show(const Pose& vehicle, const models::Readings& readings, bool isDark);

private:
    osg::ref_ptr<osg::Node> makeMirror(const models::InteriorMirror& mirror);

    models::InteriorModel _model;
    osg::ref_ptr<osg::MatrixTransform> _placed;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> _parts;
    std::vector<osg::ref_ptr<osg::Texture2D>> _mirrors;
    osg::ref_ptr<osg::MatrixTransform> _discPlaced; ///< null without a propeller
};

} // namespace scenery
