// SPDX-License-Identifier: Apache-2.0
// Progressive objects of generated meshes, and the triangles that drawables show, for comparison.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <osg/Drawable>
#include <osg/Material>
#include <osg/TriangleFunctor>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgPMObjects/ProgressiveShape>

#include "ClosedMeshes.h"
#include "SimplifyMeshes.h"

namespace progressive
{

using namespace osgPMObjects;

/// A mesh, its sequence of levels, and its shape.
struct Subject
{
    core::Mesh mesh;
    core::CollapseSequence sequence;
    osg::ref_ptr<ProgressiveShape> shape;
};

inline Subject subjectOf(core::Mesh mesh)
{
    std::vector<osg::ref_ptr<osg::StateSet>> states;
    for (core::Material& material : mesh.materials)
    {
        material.state = static_cast<std::uint32_t>(states.size());
        states.push_back(new osg::StateSet);
        states.back()->setAttribute(new osg::Material);
    }
    Subject subject{std::move(mesh), {}, {}};
    subject.sequence = core::simplify(subject.mesh);
    subject.shape =
        new ProgressiveShape(core::buildProgressiveMesh(subject.mesh, subject.sequence), std::move(states));
    return subject;
}

/// A torus of radius 3 beside a sheet of another material: 2 × 30 × 20 and 2 × 24 × 18 faces.
inline Subject torusAndSheet()
{
    return subjectOf(
        testsupport::together(testsupport::torus(30, 20), testsupport::waves(24, 18), {4.0, 0.0, 0.0}));
}

/// A triangle by its corners in floats, the least first, so that equal triangles compare equal.
using SeenTriangle = std::array<std::array<float, 3>, 3>;

inline SeenTriangle seen(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c)
{
    SeenTriangle t{{{a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()}, {c.x(), c.y(), c.z()}}};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

struct TriangleList
{
    std::vector<SeenTriangle> triangles;
    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false)
    {
        triangles.push_back(seen(a, b, c));
    }
};

template<class Drawables>
std::vector<SeenTriangle> trianglesOf(const Drawables& drawables)
{
    osg::TriangleFunctor<TriangleList> functor;
    for (const auto& drawable : drawables)
        drawable->accept(functor);
    std::sort(functor.triangles.begin(), functor.triangles.end());
    return functor.triangles;
}

/// Returns the triangles of a plain mesh about an origin.
inline std::vector<SeenTriangle> trianglesOf(const core::Mesh& mesh, const osg::Vec3d& origin = {})
{
    std::vector<SeenTriangle> triangles;
    const auto at = [&](const core::Face& face, int corner)
    {
        const glm::dvec3& p = mesh.at(face, corner);
        return osg::Vec3(osg::Vec3d(p.x, p.y, p.z) - origin);
    };
    for (const core::Face& face : mesh.faces)
        triangles.push_back(seen(at(face, 0), at(face, 1), at(face, 2)));
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

} // namespace progressive
