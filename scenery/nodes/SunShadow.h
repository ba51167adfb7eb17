// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include <osg/Geometry>
#include <osg/Image>
#include <osg/MatrixTransform>
#include <osg/Program>

#include "scenery/models/entities/ShadowMask.h"
#include "simulation/state/EntityState.h"
#include "simulation/state/GroundProvider.h"

namespace scenery
{

/// The shadow that the sun makes of an entity: a patch that lies on the ground and belongs to it. Its outline
/// is that of the entity's parts, its edge softer the higher the entity flies. Above kHighestM there is none,
/// nor with the sun low.
/// Frame: world. Threads: show() in the update phase. Cost: some 120 questions to the ground when the entity
/// has moved, and a mask (ShadowMask.h) when the sun shines on it from elsewhere.
class SunShadow
{
public:
    static constexpr double kHighestM = 1500.0, kLowestSunDeg = 3.0;

    SunShadow();

    osg::Node* node() const { return _placed.get(); }

    /// `pose`: of the model's parts. `sun`: towards it, unit vector. Without ground there the shadow of what
    /// stands is cast onto the plane that it stands on, and what flies has none.
    void show(const models::EntityModel& model, const std::vector<glm::dmat4>& pose,
              const simulation::EntityState& state, const glm::dvec3& sun,
              const simulation::GroundProvider& ground);

    const models::ShadowMask& mask() const { return _mask; }

private:
    struct Plane
    {
        glm::dvec3 origin{0.0}; ///< on the ground, where the entity's reference point is above it or on it
        glm::dmat3 axes{1.0};
        double heightM = 0.0; ///< of the reference point
    };
    std::optional<Plane> planeOf(const simulation::EntityState& state,
                                 const simulation::GroundProvider& ground) const;
    void drape(const Plane& plane, const simulation::GroundProvider& ground);

    models::ShadowMask _mask;
    models::ShadowView _maskOf; ///< for which the mask was made
    glm::dvec3 _drapedAt{1e300};
    osg::ref_ptr<osg::Image> _image = new osg::Image;
    osg::ref_ptr<osg::Vec3Array> _corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Geometry> _patch = new osg::Geometry;
    osg::ref_ptr<osg::MatrixTransform> _placed = new osg::MatrixTransform;
};

/// The program of the patch: it darkens what lies below by its mask, as much as the haze lets through.
osg::ref_ptr<osg::Program> makeSunShadowProgram();

} // namespace scenery
