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

/// Measures what the parts of a picture cost: while a play goes on, kRun pictures in a row leave out another
/// part (shadows, scenery, roads, ground, sky, mirrors, inside, or none), in turn, and each is waited for. A
/// part costs what pictures without it take less. The first kRun pictures, which make meshes and compile
/// shaders, do not count, nor does the first of each run: shadow maps that are kept are drawn anew for what
/// appears. Threads: between pictures.
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
    static constexpr std::size_t kRun = 4;

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
