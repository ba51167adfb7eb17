// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <viewlod/ViewState.h>

namespace osgPMObjects::core
{

/// What the selection of levels needs of a camera, worked out once a view.
/// A viewing device (binoculars, a sight) that the picture is seen through and that the camera's matrices do not know
/// multiplies every pixel scale by its magnification Γ, and so divides distances by it; a camera that zooms by itself has it
/// in its projection. Both are one thing, the size of a pixel, and go together.
/// A parallel projection is what a perspective becomes from far away, and is taken for one from kFarM: its picture differs from the true one by
/// the share of an object's depth in that, and rules for pixels need no second form. Its distances are those at which the reference camera would
/// see pixels as large, the same for all objects; without a reference they are from the camera's place.
/// Frame: world. Units: metres, pixels.
/// Source: paper 004, section 1 (field of view as a condition of choice); spec 5, field of view and optics.
struct SelectionView
{
    /// How far away the eye of a parallel projection is taken to be. Doubles still tell micrometres there.
    static constexpr double kFarM = 1e10;

    glm::dvec3 eyeWorld{0.0};
    glm::dvec3 distancesFrom{
        0.0}; ///< what distances in settings are compared from: the eye, or the parallel camera's place
    /// A point p seen from the eye falls on (acrossPx · p, upPx · p) / (forward · p) pixels.
    glm::dvec3 acrossPx{1.0, 0.0, 0.0}, upPx{0.0, 1.0, 0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0}; ///< of unit length
    double pixelsPerTangent = 1.0;      ///< K · Γ at the picture's centre
    /// The same that holds everywhere in the picture, however the camera turns about its eye within it.
    double guaranteedPixelsPerTangent = 1.0;
    double pixelsPerTangentArea = 1.0; ///< pixels per unit of tangent squared: |(acrossPx × upPx) · forward|
    /// What distances are multiplied by before they are compared with those of a scene's author: K of the camera that the
    /// author had in mind by that of this one.
    double distanceScale = 1.0;
    double nearM =
        0.1; ///< depth of the plane that nothing is drawn before; a parallel projection's magnifies nothing

    /// `magnification`: Γ > 0 of a device that `view` does not know. `referencePixelsPerTangent`: K of the camera for which
    /// distances were given; 0: this one's without the device.
    static SelectionView from(const viewlod::ViewState& view, double magnification = 1.0,
                              double referencePixelsPerTangent = 0.0);
};

} // namespace osgPMObjects::core
