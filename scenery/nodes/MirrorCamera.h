// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Camera>
#include <osg/Texture2D>

#include "scenery/models/cockpit/InteriorModel.h"
#include "scenery/nodes/Pose.h"

namespace scenery
{

/// A view through a flat mirror: from the eye's mirror image, through the mirror's frame.
/// Source: Kooima, *Generalized Perspective Projection*, 2009: the frustum of an eye and a rectangle.
struct MirrorView
{
    glm::dmat4 view{1.0};       ///< from the world
    glm::dmat4 projection{1.0}; ///< of OpenGL; what is behind the mirror is cut off
    bool isSeen = false;        ///< the eye is before the mirror
};

/// `vehicle`: places the mirror in the world. `eyeWorld`: who looks into it. `farM`: how far it shows.
MirrorView mirrorView(const models::InteriorMirror& mirror, const Pose& vehicle, const glm::dvec3& eyeWorld,
                      double farM);

/// Whether a part of a mirror may lie in a picture. `clipFromWorld`: of the picture's camera.
bool isInPicture(const models::InteriorMirror& mirror, const Pose& vehicle, const glm::dmat4& clipFromWorld);

/// Makes a camera that draws a scene into the picture of a mirror before the picture of the eye. It belongs
/// among the slaves of a viewer: OSG gives the shaders of a nested camera the matrices of the outer one. It
/// rests until setMirrorView().
osg::ref_ptr<osg::Camera> makeMirrorCamera(osg::Texture2D& picture);

/// Draws the picture anew; where the mirror is not seen, it rests.
void setMirrorView(osg::Camera& camera, const MirrorView& view);

/// The picture stays as it is.
void rest(osg::Camera& camera);

} // namespace scenery
