// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/ModelMesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <osg/Math>

namespace scenery
{

namespace
{

osg::Vec3f middleOf(const Ring& ring)
{
    osg::Vec3f sum;
    for (const osg::Vec3f& point : ring)
        sum += point;
    return sum / static_cast<float>(ring.size());
}

osg::Vec3f unit(osg::Vec3f v)
{
    v.normalize();
    return v;
}

/// The faces of a loft: face (band, point) lies between two rings and two neighbouring points.
class LoftFaces
{
public:
    LoftFaces(std::span<const Ring> rings, double creaseDeg)
        : _rings(rings), _creaseCosine(static_cast<float>(std::cos(osg::DegreesToRadians(creaseDeg))))
    {
        for (std::size_t band = 0; band + 1 < rings.size(); ++band)
            for (std::size_t point = 0; point < points(); ++point)
                _normals.push_back(outwardNormal(band, point));
    }

    std::size_t points() const { return _rings.front().size(); }
    const osg::Vec3f& faceNormal(std::size_t band, std::size_t point) const
    {
        return _normals[band * points() + point % points()];
    }

    /// Of a face at one of its corners: the mean over the faces that meet there at less than the crease.
    osg::Vec3f cornerNormal(std::size_t band, std::size_t point, std::size_t ring, std::size_t corner) const
    {
        const osg::Vec3f& own = faceNormal(band, point);
        osg::Vec3f sum;
        for (std::size_t b = ring == 0 ? 0 : ring - 1; b < std::min(ring + 1, _rings.size() - 1); ++b)
            for (const std::size_t p : {corner + points() - 1, corner})
                if (faceNormal(b, p) * own > _creaseCosine) sum += faceNormal(b, p);
        return sum.length2() > 0.0F ? unit(sum) : own;
    }

private:
    osg::Vec3f outwardNormal(std::size_t band, std::size_t point) const
    {
        const Ring& first = _rings[band];
        const Ring& second = _rings[band + 1];
        const std::size_t next = (point + 1) % points();
        osg::Vec3f normal = unit((second[next] - first[point]) ^ (second[point] - first[next]));
        const osg::Vec3f middle = (first[point] + first[next] + second[point] + second[next]) * 0.25F;
        if (normal * (middle - (middleOf(first) + middleOf(second)) * 0.5F) < 0.0F) normal = -normal;
        return normal;
    }

    std::span<const Ring> _rings;
    float _creaseCosine;
    std::vector<osg::Vec3f> _normals;
};

} // namespace

void ModelMesh::addTriangle(const Corner& a, const Corner& b, const Corner& c, const osg::Vec4f& colour)
{
    const osg::Vec3f across = (b.position - a.position) ^ (c.position - a.position);
    if (across.length2() < 1e-14F) return; // where a ring shrinks to a point
    const bool looksOutward = across * (a.normal + b.normal + c.normal) >= 0.0F;
    for (const Corner* corner : {&a, looksOutward ? &b : &c, looksOutward ? &c : &b})
    {
        _positions.push_back(corner->position);
        _normals.push_back(corner->normal);
        _colours.push_back(colour);
    }
}

void ModelMesh::addFace(const std::array<osg::Vec3f, 3>& corners, const osg::Vec3f& outward,
                        const osg::Vec4f& colour)
{
    osg::Vec3f normal = unit((corners[1] - corners[0]) ^ (corners[2] - corners[0]));
    if (normal * outward < 0.0F) normal = -normal;
    addTriangle({corners[0], normal}, {corners[1], normal}, {corners[2], normal}, colour);
}

void ModelMesh::addCap(const Ring& ring, const osg::Vec3f& outward, const osg::Vec4f& colour)
{
    const osg::Vec3f middle = middleOf(ring);
    const osg::Vec3f normal = unit(outward);
    for (std::size_t i = 0; i < ring.size(); ++i)
        addTriangle({middle, normal}, {ring[i], normal}, {ring[(i + 1) % ring.size()], normal}, colour);
}

void ModelMesh::addLoft(std::span<const Ring> rings, const osg::Vec4f& colour, double creaseDeg)
{
    const LoftFaces faces(rings, creaseDeg);
    const std::size_t points = faces.points();
    for (std::size_t band = 0; band + 1 < rings.size(); ++band)
    {
        for (std::size_t point = 0; point < points; ++point)
        {
            const std::size_t next = (point + 1) % points;
            const Corner a{rings[band][point], faces.cornerNormal(band, point, band, point)};
            const Corner b{rings[band][next], faces.cornerNormal(band, point, band, next)};
            const Corner c{rings[band + 1][next], faces.cornerNormal(band, point, band + 1, next)};
            const Corner d{rings[band + 1][point], faces.cornerNormal(band, point, band + 1, point)};
            addTriangle(a, b, c, colour);
            addTriangle(a, c, d, colour);
        }
    }
    addCap(rings.front(), middleOf(rings[0]) - middleOf(rings[1]), colour);
    addCap(rings.back(), middleOf(rings.back()) - middleOf(rings[rings.size() - 2]), colour);
}

void ModelMesh::addPatch(std::span<const Ring> rings, const Patch& patch, const osg::Vec4f& colour)
{
    const LoftFaces faces(rings, 60.0);
    for (std::size_t band = patch.first; band < patch.last; ++band)
    {
        for (std::size_t i = patch.from; i < patch.to; ++i)
        {
            const std::size_t point = i % faces.points();
            const std::size_t next = (i + 1) % faces.points();
            const auto lifted = [&](std::size_t ring, std::size_t corner)
            {
                const osg::Vec3f normal = faces.cornerNormal(band, point, ring, corner);
                return Corner{rings[ring][corner] + normal * patch.liftM, normal};
            };
            addTriangle(lifted(band, point), lifted(band, next), lifted(band + 1, next), colour);
            addTriangle(lifted(band, point), lifted(band + 1, next), lifted(band + 1, point), colour);
        }
    }
}

void ModelMesh::addTurned(const Turned& turned, const osg::Vec4f& colour)
{
    const osg::Vec3f helper = std::abs(turned.axis.z()) < 0.9F ? osg::Vec3f(0, 0, 1) : osg::Vec3f(1, 0, 0);
    const osg::Vec3f u = unit(turned.axis ^ helper);
    const osg::Vec3f v = turned.axis ^ u;
    std::vector<Ring> rings;
    for (const auto& [along, radius] : turned.profile)
    {
        Ring& ring = rings.emplace_back();
        for (int i = 0; i < turned.sides; ++i)
        {
            const auto angle = static_cast<float>(2.0 * osg::PI * i / turned.sides);
            ring.push_back(turned.origin + turned.axis * along +
                           (u * std::cos(angle) + v * std::sin(angle)) * radius);
        }
    }
    addLoft(rings, colour, 50.0);
}

void ModelMesh::addBox(const osg::Vec3f& low, const osg::Vec3f& high, const osg::Vec4f& colour)
{
    const auto ringAt = [&](float x)
    {
        return Ring{
            {x, low.y(), low.z()}, {x, high.y(), low.z()}, {x, high.y(), high.z()}, {x, low.y(), high.z()}};
    };
    addLoft(std::array{ringAt(low.x()), ringAt(high.x())}, colour);
}

void ModelMesh::addBar(const osg::Vec3f& from, const osg::Vec3f& to, float radiusM, const osg::Vec4f& colour)
{
    const osg::Vec3f along = to - from;
    addTurned({from, unit(along), {{0.0F, radiusM}, {along.length(), radiusM}}, 8}, colour);
}

void ModelMesh::mirrorSince(std::size_t since)
{
    const auto across = [](const osg::Vec3f& v) { return osg::Vec3f(v.x(), -v.y(), v.z()); };
    const std::size_t end = triangles();
    for (std::size_t t = since; t < end; ++t)
    {
        const auto corner = [&](std::size_t i) { return Corner{across(_positions[i]), across(_normals[i])}; };
        const osg::Vec4f colour = _colours[3 * t]; // a copy: the array grows
        addTriangle(corner(3 * t), corner(3 * t + 1), corner(3 * t + 2), colour);
    }
}

osg::ref_ptr<osg::Geometry> ModelMesh::geometry() const
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(new osg::Vec3Array(static_cast<unsigned>(_positions.size()), _positions.data()));
    geometry->setNormalArray(new osg::Vec3Array(static_cast<unsigned>(_normals.size()), _normals.data()),
                             osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(new osg::Vec4Array(static_cast<unsigned>(_colours.size()), _colours.data()),
                            osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(_positions.size())));
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    return geometry;
}

} // namespace scenery
