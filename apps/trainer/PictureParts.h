// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include <osg/GraphicsContext>
#include <osgViewer/Viewer>

#include "PlayScene.h"
#include "view/DrawCounts.h"
#include "view/InteriorView.h"
#include "view/PartsTable.h"

namespace trainer
{

/// Measures what the parts of a picture cost: while a play goes on, each picture leaves out another part (shadows, scenery, roads, ground,
/// sky, mirrors, inside, or none), in turn, and is waited for. A part costs what pictures without it take less. The first round of pictures, which
/// makes meshes and compiles shaders, does not count. Threads: between pictures.
class PictureParts
{
public:
    /// `viewer`, `contexts`, `scene` and `interior` must outlive it. `interior`: null without.
    PictureParts(PlayScene& scene, InteriorView* interior, osgViewer::Viewer& viewer,
                 const std::vector<osg::ref_ptr<osg::GraphicsContext>>& contexts);

    /// Draws a picture without the part whose turn it is; the scene is whole again afterwards.
    void draw(double timeS);

    const std::vector<PartCosts>& costs() const { return _costs; }

private:
    struct Part
    {
        const char* name;
        std::function<void(bool)> show;
    };

    void addParts(PlayScene& scene);
    void addParts(InteriorView& interior);

    osgViewer::Viewer& _viewer;
    const std::vector<osg::ref_ptr<osg::GraphicsContext>>& _contexts;
    std::vector<osg::ref_ptr<DrawCounter>> _counters; ///< of the viewer's cameras
    std::vector<Part> _parts;
    std::vector<PartCosts> _costs; ///< by part
    std::size_t _pictures = 0;
};

} // namespace trainer
