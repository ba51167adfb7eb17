// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include <osg/Geometry>

namespace scenery
{

/// A closed ring of points across a body, all rings of a loft having the same number.
using Ring = std::vector<osg::Vec3f>;

/// Builds a model of few primitives: triangles with normals and one colour each.
/// Frame: the body's, x forward, y left, z up. Units: metres; colours as display values.
class ModelMesh
{
public:
    /// Adds the surface over rings in order, with flat caps at both ends. Faces look away from the middles of
    /// the rings, so each ring must be star-shaped about its middle. `creaseDeg`: edges sharper than this
    /// stay sharp, all others are smooth.
    void addLoft(std::span<const Ring> rings, const osg::Vec4f& colour, double creaseDeg = 40.0);

    /// A band of the surface of a loft, moved out by `liftM`: windows, lamps, stripes. `from`, `to`: point
    /// indices along the ring; the band runs from ring `first` to ring `last`.
    struct Patch
    {
        std::size_t first, last, from, to;
        float liftM;
    };
    void addPatch(std::span<const Ring> rings, const Patch& patch, const osg::Vec4f& colour);

    /// A closed body of revolution: its radius at positions along the axis.
    struct Turned
    {
        osg::Vec3f origin;
        osg::Vec3f axis;                              ///< unit length
        std::vector<std::pair<float, float>> profile; ///< along the axis, radius
        int sides = 24;
    };
    void addTurned(const Turned& turned, const osg::Vec4f& colour);

    void addBox(const osg::Vec3f& low, const osg::Vec3f& high, const osg::Vec4f& colour);

    /// A straight round bar.
    void addBar(const osg::Vec3f& from, const osg::Vec3f& to, float radiusM, const osg::Vec4f& colour);

    /// One flat triangle that looks towards `outward` (any length).
    void addFace(const std::array<osg::Vec3f, 3>& corners, const osg::Vec3f& outward,
                 const osg::Vec4f& colour);

    /// Mirrors everything added since triangle `since` in the plane y = 0.
    void mirrorSince(std::size_t since);
    std::size_t triangles() const { return _positions.size() / 3; }

    osg::ref_ptr<osg::Geometry> geometry() const;

private:
    struct Corner
    {
        osg::Vec3f position, normal;
    };
    void addTriangle(const Corner& a, const Corner& b, const Corner& c, const osg::Vec4f& colour);
    void addCap(const Ring& ring, const osg::Vec3f& outward, const osg::Vec4f& colour);

    std::vector<osg::Vec3f> _positions;
    std::vector<osg::Vec3f> _normals;
    std::vector<osg::Vec4f> _colours;
};

} // namespace scenery
