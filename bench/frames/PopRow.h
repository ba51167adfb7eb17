// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include <osgTerrainROAM/RoamDrawable>

#include "LevelHistogram.h"
#include "Look.h"
#include "Picture.h"
#include "Request.h"

namespace framebench
{

/// How the mesh adapts to the camera.
enum class Following
{
    switching, ///< detail changes at once
    morphing,  ///< detail moves gradually
    frozen,    ///< no change: the mesh of the middle of the flight, a control without popping
};

/// One setting of the level of detail in one look, and the popping that its images show along the flight.
/// D_t = LOD_t − Full_t, both from the camera of frame t; Δ_t = D_t − D_{t−1}. Pop_t = LOD_t − the mesh of
/// frame t−1 from the camera of frame t: the effect of the change of the mesh alone.
class PopRow
{
public:
    struct Setting
    {
        Look look = Look::full;
        double tolerancePx = 1.0; ///< of the finished picture
        Following following = Following::switching;
        std::string antialiasing;
        int samplesPerPx = 1; ///< along an axis
    };

    /// Frames are drawn on `stage`, which has to outlive it.
    PopRow(const Request& request, Stage& stage, Setting setting);

    Look look() const { return _setting.look; }

    /// Draws a frame and counts it. `full`: the image of the full mesh; `edges`: its silhouettes and those of
    /// the frame before. Errors: images that cannot be written.
    foundation::Outcome frame(int frame, const Picture& full, const std::vector<bool>& edges);

    Report json() const;

private:
    struct Counts
    {
        LevelHistogram difference, delta, deltaAtEdges, deltaInside, pop, popInside;
    };

    bool measuresPop() const;
    void refine(int frame);
    Picture drawn(osg::Node* node, int frame);
    void count(const Picture& delta, const Picture* pop, const std::vector<bool>& edges);
    foundation::Outcome keep(const Picture& lod, const Picture& full, const Picture& delta) const;

    const Request& _request;
    Stage& _stage;
    Setting _setting;
    osg::ref_ptr<osg::StateSet> _state;
    osg::ref_ptr<osgTerrainROAM::RoamDrawable> _drawable;
    osgTerrainROAM::core::RoamMesh _mesh; ///< the same mesh once more, to be drawn a frame late, or frozen
    osg::ref_ptr<osg::Geode> _frozen;
    std::optional<Picture> _before; ///< D of the frame before
    Counts _counts;
};

} // namespace framebench
