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

/// One setting of the level of detail in one look, and what its pictures showed along the flight.
/// D_t = LOD_t − Full_t, both from the eye of frame t; Δ_t = D_t − D_{t−1}.
/// Pop_t = LOD_t − the mesh of frame t−1 from the eye of frame t: what the change of the mesh alone does to the picture.
class PopRow
{
public:
    /// `samplesPerPx`: along an axis of the picture; the tolerance is one of finished pixels.
    PopRow(const Request& request, Look look, double tolerancePx, bool morphing, int samplesPerPx);

    Look look() const { return _look; }

    /// Draws a frame and counts it. `edges`: its silhouettes and those of the frame before.
    /// Errors: pictures that cannot be written.
    viewlod::Outcome frame(const Request& request, Stage& stage, int frame, const Picture& full,
                           const std::vector<bool>& edges, const std::string& antialiasing);

    Report json(const std::string& antialiasing) const;

private:
    void count(const Picture& delta, const Picture& pop, const std::vector<bool>& edges);
    viewlod::Outcome keep(const Request& request, const std::string& antialiasing, const Picture& lod,
                          const Picture& full, const Picture& delta) const;

    Look _look;
    double _tolerancePx;
    bool _morphing;
    int _samplesPerPx;
    osg::ref_ptr<osg::StateSet> _state;
    osg::ref_ptr<osgTerrainROAM::RoamDrawable> _drawable;
    osgTerrainROAM::core::RoamMesh _mesh; ///< the same mesh once more, to be drawn a frame late
    std::optional<Picture> _before;       ///< D of the frame before
    LevelHistogram _difference, _delta, _deltaAtEdges, _deltaInside, _pop, _popInside;
    double _triangles = 0.0;
    int _frames = 0;
};

} // namespace framebench
