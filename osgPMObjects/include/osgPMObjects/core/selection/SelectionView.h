// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <viewlod/ViewState.h>

namespace osgPMObjects::core
{

/// The properties of a camera that selection needs, computed once a view.
/// Magnification: a viewing device (binoculars, a sight) that is not part of the camera's matrices multiplies
/// every pixel scale by its magnification Γ, and so divides distances by it. A camera that zooms has this in
/// its projection.
/// Parallel projections: they are treated as a perspective from the distance kFarM, with which they agree but
/// for the share (object's depth / kFarM). Distances are then those at which the reference camera sees pixels
/// as large, the same for all objects; without a reference camera they are measured from the position of the
/// parallel camera.
/// Frame: world. Units: metres, pixels.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 1 (field of view as a condition of the choice).
struct SelectionView
{
    /// Assumed distance of the eye of a parallel projection. Doubles resolve some micrometres at this
    /// distance.
    static constexpr double kFarM = 1e10;

    glm::dvec3 eyeWorld{0.0};
    glm::dvec3 distancesFrom{
        0.0}; ///< origin of the distances in settings: the eye, or the position of a parallel camera
    /// The projection to pixels: a point p relative to the eye has the coordinates (acrossPx · p, upPx · p) /
    /// (forward · p).
    glm::dvec3 acrossPx{1.0, 0.0, 0.0}, upPx{0.0, 1.0, 0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0}; ///< of unit length
    double pixelsPerTangent = 1.0;      ///< K · Γ: pixels a unit of tangent at the image's centre
    /// The largest pixelsPerTangent at any point of the image: it bounds errors however the camera turns
    /// about its eye.
    double guaranteedPixelsPerTangent = 1.0;
    double pixelsPerTangentArea = 1.0; ///< pixels a unit of tangent squared: |(acrossPx × upPx) · forward|
    /// The factor that turns this view's distances into metres of the author's camera: K of the camera that
    /// the author of the settings had in mind, divided by pixelsPerTangent.
    double distanceScale = 1.0;
    double nearM = 0.1; ///< distance of the near plane; 0 for a parallel projection

    /// Computes the properties of a view. `magnification`: Γ > 0 of a device that `view` does not include.
    /// `referencePixelsPerTangent`: K of the author's camera; 0: that of `view`, without the device.
    static SelectionView from(const viewlod::ViewState& view, double magnification = 1.0,
                              double referencePixelsPerTangent = 0.0);
};

} // namespace osgPMObjects::core
