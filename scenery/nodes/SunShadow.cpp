// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/SunShadow.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <foundation/Angle.h>

#include <osg/Geode>
#include <osg/Program>
#include <osg/Texture2D>

#include <shaders/scenery.h>

#include "scenery/nodes/OcclusionProgram.h"

namespace scenery
{

namespace
{

constexpr int kPatchCells = 10;      ///< each way
constexpr double kSameSun = 2e-4;    ///< difference of unit vectors: 0.01°
constexpr double kNearGroundM = 1.0; ///< what is higher flies

osg::ref_ptr<osg::StateSet> shadowState(osg::Image& mask)
{
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(&mask);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setResizeNonPowerOfTwoHint(false);
    constexpr int kBin = 9; // after the ground, before what is seen through
    osg::ref_ptr<osg::StateSet> state = makeOcclusionState(makeSunShadowProgram(), kBin);
    state->setTextureAttributeAndModes(0, texture);
    state->addUniform(new osg::Uniform("shadowMask", 0));
    return state;
}

bool areNear(const models::ShadowView& a, const models::ShadowView& b)
{
    double most = glm::length(a.sun - b.sun);
    for (int i = 0; i < 3; ++i)
        most = std::max(most, glm::length(a.planeFromBody[i] - b.planeFromBody[i]));
    return most < kSameSun && std::abs(a.heightM - b.heightM) < 1e-6 + 0.002 * std::abs(a.heightM);
}

/// Horizontal axes that look the way a body does.
glm::dmat3 levelAxes(const glm::dmat3& body)
{
    glm::dvec3 ahead(body[0].x, body[0].y, 0.0);
    ahead = glm::length(ahead) > 1e-6 ? glm::normalize(ahead) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 up(0.0, 0.0, 1.0);
    return {ahead, glm::cross(up, ahead), up};
}

} // namespace

osg::ref_ptr<osg::Program> makeSunShadowProgram()
{
    return makeOcclusionProgram("shadow", shaders::kShadowMain);
}

SunShadow::SunShadow()
{
    const osg::ref_ptr<osg::Vec2Array> places = new osg::Vec2Array;
    const osg::ref_ptr<osg::DrawElementsUShort> faces = new osg::DrawElementsUShort(GL_TRIANGLES);
    for (int i = 0; i <= kPatchCells; ++i)
        for (int j = 0; j <= kPatchCells; ++j)
        {
            places->push_back({static_cast<float>(i) / kPatchCells, static_cast<float>(j) / kPatchCells});
            _corners->push_back({});
            if (i == 0 || j == 0) continue;
            const int corner = i * (kPatchCells + 1) + j, before = corner - kPatchCells - 1;
            for (const int index : {corner, before - 1, before, corner, corner - 1, before - 1})
                faces->push_back(static_cast<GLushort>(index));
        }
    _image->allocateImage(models::ShadowMask::kCells, models::ShadowMask::kCells, 1, GL_LUMINANCE,
                          GL_UNSIGNED_BYTE);
    _image->setDataVariance(osg::Object::DYNAMIC);
    _patch->setDataVariance(osg::Object::DYNAMIC);
    _patch->setUseDisplayList(false);
    _patch->setUseVertexBufferObjects(true);
    _patch->setVertexArray(_corners);
    _patch->setTexCoordArray(0, places, osg::Array::BIND_PER_VERTEX);
    _patch->addPrimitiveSet(faces);
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(_patch);
    geode->setStateSet(shadowState(*_image));
    _placed->setName("sun shadow");
    _placed->setDataVariance(osg::Object::DYNAMIC);
    _placed->addChild(geode);
    _placed->setNodeMask(0);
}

/// The plane onto which an entity casts its shadow: what stands has it under itself, what flies below.
std::optional<SunShadow::Plane> SunShadow::planeOf(const simulation::EntityState& state,
                                                   const simulation::GroundProvider& ground) const
{
    const glm::dmat3 body = state.bodyToLocal();
    const auto below = ground ? ground(state.position.x, state.position.y, state.position.z) : std::nullopt;
    const double heightM = below ? state.position.z - below->heightM : 0.0;
    if (std::abs(heightM) < kNearGroundM && (state.isOnGround || below))
        return Plane{state.position, body, 0.0};
    if (!below || heightM < 0.0 || heightM > kHighestM) return std::nullopt;
    return Plane{{state.position.x, state.position.y, below->heightM}, levelAxes(body), heightM};
}

/// Lays the patch onto the ground.
void SunShadow::drape(const Plane& plane, const simulation::GroundProvider& ground)
{
    constexpr double kFromAboveM = 2.0; // a car under a bridge stays below it
    const glm::dvec2 size = _mask.high - _mask.low;
    const glm::dvec2 middle = 0.5 * (_mask.low + _mask.high);
    const glm::dvec3 anchor = plane.origin + plane.axes * glm::dvec3(middle, 0.0);
    for (std::size_t k = 0; k < _corners->size(); ++k)
    {
        const auto columns = static_cast<std::size_t>(kPatchCells) + 1;
        const glm::dvec2 share(static_cast<double>(k / columns) / kPatchCells,
                               static_cast<double>(k % columns) / kPatchCells);
        glm::dvec3 at = plane.origin + plane.axes * glm::dvec3(_mask.low + share * size, 0.0);
        if (const auto below = ground ? ground(at.x, at.y, at.z + kFromAboveM) : std::nullopt; below)
            at.z = below->heightM;
        const glm::dvec3 local = at - anchor;
        (*_corners)[k] = osg::Vec3f(osg::Vec3d(local.x, local.y, local.z));
    }
    _corners->dirty();
    _patch->dirtyBound();
    _placed->setMatrix(osg::Matrixd::translate(anchor.x, anchor.y, anchor.z));
}

void SunShadow::show(const models::EntityModel& model, const std::vector<glm::dmat4>& pose,
                     const simulation::EntityState& state, const glm::dvec3& sun,
                     const simulation::GroundProvider& ground)
{
    const double lowest = std::sin(foundation::radiansOf(kLowestSunDeg));
    const auto plane = sun.z > lowest ? planeOf(state, ground) : std::nullopt;
    const glm::dvec3 fromPlane = plane ? glm::transpose(plane->axes) * sun : glm::dvec3(0.0);
    _placed->setNodeMask(plane && fromPlane.z > lowest ? ~0U : 0U);
    if (_placed->getNodeMask() == 0U) return;
    const models::ShadowView view{glm::transpose(plane->axes) * state.bodyToLocal(), fromPlane,
                                  plane->heightM};
    const bool isSame = !_mask.cover.empty() && areNear(view, _maskOf);
    if (!isSame)
    {
        _mask = models::castShadow(model, pose, view);
        _maskOf = view;
        if (_mask.cover.empty()) return _placed->setNodeMask(0);
        std::memcpy(_image->data(), _mask.cover.data(), _mask.cover.size());
        _image->dirty();
    }
    if (isSame && state.position == _drapedAt) return;
    _drapedAt = state.position;
    drape(*plane, ground);
}

} // namespace scenery
