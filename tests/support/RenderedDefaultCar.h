// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/entities/DefaultSize.h"
#include "scenery/nodes/EntityNode.h"

/// A red car of usual size as a node. Frame: the car's until setState().
struct DefaultCar
{
    static scenery::models::EntityShape shape()
    {
        scenery::models::EntityShape car;
        car.kind = scenery::models::EntityKind::car;
        car.red = 0.72F;
        car.green = 0.10F;
        car.blue = 0.09F;
        scenery::models::setDefaultSize(car);
        return car;
    }

    osg::Node* node() const { return car.node(); }
    void setState(const simulation::EntityState& state, const scenery::models::LitLamps& lit = {})
    {
        car.setState(state, lit);
    }

    scenery::EntityShapes shapes;
    scenery::EntityNode car{shape(), shapes};
};
