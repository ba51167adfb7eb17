// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <osg/MatrixTransform>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/ProgressiveField>

#include "ProgressiveSubject.h"
#include "Random.h"

/// Fields to intersect, and the same objects as separate nodes.
namespace fieldsubjects
{

using namespace progressive;
using Segment = osgUtil::LineSegmentIntersector;

inline FieldKind kindOf(const Subject& subject)
{
    FieldKind kind;
    kind.shape = subject.shape;
    return kind;
}

inline std::vector<FieldKind> torus(std::uint32_t around = 30)
{
    return {kindOf(subjectOf(testsupport::torus(around, 20)))};
}

/// Makes instances of the first kind at positions, without rotation or scale.
inline std::vector<FieldInstance> standingAt(std::initializer_list<osg::Vec3d> places)
{
    std::vector<FieldInstance> made;
    for (const osg::Vec3d& place : places)
        made.emplace_back().position = place;
    return made;
}

/// Two kinds: a torus beside a sheet, and a shape whose origin lies some 30 km from it.
inline std::vector<FieldKind> kinds()
{
    static const Subject near = torusAndSheet();
    static const Subject away = []
    {
        core::Mesh mesh = testsupport::torus(30, 20);
        for (glm::dvec3& p : mesh.positions)
            p += glm::dvec3(2e4, -1e4, 2e4);
        return subjectOf(std::move(mesh));
    }();
    EXPECT_NE(away.shape->origin(), osg::Vec3d());
    return {kindOf(near), kindOf(away)};
}

inline osg::Quat turn(testsupport::Random& random)
{
    osg::Quat attitude;
    attitude.makeRotate(6.0 * random.unit(), osg::Vec3d(random.unit(), random.unit(), 1.0));
    return attitude;
}

/// Scatters all kinds in turn over a square with sides of 400; what is visible of each instance lies about
/// its position.
inline std::vector<FieldInstance> scattered(std::size_t count, const std::vector<FieldKind>& of)
{
    testsupport::Random random(17);
    std::vector<FieldInstance> made(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        FieldInstance& instance = made[i];
        instance.kind = static_cast<std::uint32_t>(i % of.size());
        instance.attitude = turn(random);
        instance.scale = 0.5 + random.unit();
        const osg::Vec3d at(400.0 * random.unit(), 400.0 * random.unit(), 20.0 * random.unit());
        instance.position = at - instance.attitude * (of[instance.kind].shape->origin() * instance.scale);
    }
    return made;
}

inline osg::ref_ptr<ProgressiveField> fieldOf(const std::vector<FieldKind>& of,
                                              const std::vector<FieldInstance>& placed)
{
    osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    const auto outcome = field->setContents(of, placed);
    EXPECT_TRUE(outcome) << (outcome ? "" : outcome.error().message());
    return field;
}

/// The same instances as plain geometry; the names of the transforms are the instances' numbers.
inline osg::ref_ptr<osg::Group> plain(const std::vector<FieldKind>& of,
                                      const std::vector<FieldInstance>& placed)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (std::size_t i = 0; i < placed.size(); ++i)
    {
        const FieldInstance& instance = placed[i];
        const osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(
            osg::Matrixd::scale(instance.scale, instance.scale, instance.scale) *
            osg::Matrixd::rotate(instance.attitude) * osg::Matrixd::translate(instance.position));
        transform->setName(std::to_string(i));
        transform->addChild(bakeLevel(*of[instance.kind].shape, 0));
        root->addChild(transform);
    }
    return root;
}

/// The node below a transform that rotates, moves and scales.
inline osg::ref_ptr<osg::MatrixTransform> below(osg::Node& node)
{
    osg::ref_ptr<osg::MatrixTransform> root = new osg::MatrixTransform(
        osg::Matrixd::scale(2.0, 2.0, 2.0) * osg::Matrixd::rotate(0.7, osg::Vec3d(1.0, 2.0, 3.0)) *
        osg::Matrixd::translate(-50.0, 900.0, 30.0));
    root->addChild(&node);
    return root;
}

inline Segment::Intersections hits(osg::Node& node, const osg::Vec3d& from, const osg::Vec3d& to)
{
    const osg::ref_ptr<Segment> segment = new Segment(from, to);
    osgUtil::IntersectionVisitor visitor(segment);
    node.accept(visitor);
    return segment->getIntersections();
}

struct Line
{
    osg::Vec3d from, to;
};

/// Lines through the square, across and down, in the frame above below()'s transform.
inline std::vector<Line> lines(std::size_t count, const osg::Matrixd& place)
{
    testsupport::Random random(5);
    std::vector<Line> made;
    for (std::size_t i = 0; i < count; ++i)
    {
        const osg::Vec3d from(400.0 * random.unit(), 400.0 * random.unit(), 60.0);
        const osg::Vec3d to = i % 2 == 0 ? from + osg::Vec3d(random.unit(), random.unit(), -100.0)
                                         : osg::Vec3d(400.0 * random.unit(), 400.0 * random.unit(), -20.0);
        made.push_back({from * place, to * place});
    }
    return made;
}

} // namespace fieldsubjects
