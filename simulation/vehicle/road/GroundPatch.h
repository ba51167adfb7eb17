// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <glm/glm.hpp>

#include "simulation/vehicle/Ground.h"

namespace simulation
{

/// Pieces of the ground below bodies, as a shape of Bullet: triangles over cells of half a metre, of a metre
/// below large bodies.
class GroundPatches : public btConcaveShape
{
public:
    GroundPatches()
    {
        m_shapeType = TERRAIN_SHAPE_PROXYTYPE;
    } // the custom type is taken for a distance field

    /// Asks for the ground around a place and keeps it for a body.
    void lay(int body, const Ground& ground, const glm::dvec3& middle, double reachM);
    void lift(int body);
    bool isEmpty() const { return _patches.empty(); }

    void processAllTriangles(btTriangleCallback* callback, const btVector3& least,
                             const btVector3& most) const override;
    void getAabb(const btTransform& transform, btVector3& least, btVector3& most) const override;
    void setLocalScaling(const btVector3&) override {}
    const btVector3& getLocalScaling() const override { return _scaling; }
    void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
    const char* getName() const override { return "GroundPatches"; }

private:
    struct Patch
    {
        int body = 0;
        glm::dvec3 middle{0.0};
        double cellM = 0.5;
        int column = 0, row = 0; ///< of the first point, in cells
        int points = 0;          ///< on each side
        std::vector<GroundPoint> ground;
    };

    btVector3 cornerOf(const Patch& patch, int column, int row) const;

    std::vector<Patch> _patches;
    btVector3 _scaling{1.0, 1.0, 1.0};
};

} // namespace simulation
