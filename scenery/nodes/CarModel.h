// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <osg/MatrixTransform>
#include <osg/Vec4f>

#include "simulation/player/EntityState.h"

namespace scenery
{

/// A four-door car of lofted sections, 4.4 m long, 1.8 m wide, 1.46 m high, wheelbase 2.65 m: body, cabin with
/// windows, lamps, wheels that turn, steer and spring, and a soft shadow where it touches the ground.
/// Frame: as OpenSCENARIO vehicles: origin on the ground below the rear axle, x forward, y left, z up; metres. Needs
/// the uniforms of an Atmosphere above it in the graph. Threads: setState() in the update phase.
class CarModel
{
public:
    /// `paint`: display values.
    explicit CarModel(const osg::Vec4f& paint = {0.72F, 0.10F, 0.09F, 1.0F});

    /// Returns the node, which setState() places by the reference point.
    osg::Node* node() const { return _placed.get(); }

    /// Places the car and sets its wheels: rotation, steering, and travel on uneven ground (at most 0.15 m).
    void setState(const simulation::EntityState& state);

private:
    osg::ref_ptr<osg::MatrixTransform> _placed;
    std::array<osg::ref_ptr<osg::MatrixTransform>, 4>
        _wheels; ///< front left, front right, rear left, rear right
};

/// Returns the eye point of the driver, `heightM` above the ground. Frame: the car's.
glm::dvec3 driverEyeInCar(double heightM = 1.5);

} // namespace scenery
