// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/FallingDrops.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/Transform>
#include <osgSky/Atmosphere>

#include <shaders/scenery.h>

#include "scenery/nodes/NoBound.h"

namespace scenery
{

namespace
{

constexpr int kDropBin = 12;            // after what is blended and what glows
constexpr int kCornersOfADrop = 6;      // two triangles
constexpr double kExposureS = 1.0 / 50; // over which an eye sees a drop as a streak

/// Goes with each eye in whole boxes, so that the coordinates in it are small anywhere in the world.
class BoxesAroundEye : public osg::Transform
{
public:
    BoxesAroundEye() { setCullingActive(false); }

    bool computeLocalToWorldMatrix(osg::Matrix& matrix, osg::NodeVisitor* visitor) const override
    {
        if (visitor) matrix.preMultTranslate(cornerAt(visitor->getEyePoint()));
        return true;
    }
    bool computeWorldToLocalMatrix(osg::Matrix& matrix, osg::NodeVisitor* visitor) const override
    {
        if (visitor) matrix.postMultTranslate(-cornerAt(visitor->getEyePoint()));
        return true;
    }
    osg::BoundingSphere computeBound() const override { return {}; }

private:
    static osg::Vec3d cornerAt(const osg::Vec3d& eye)
    {
        constexpr double kM = FallingDrops::kBoxM;
        return {std::floor(eye.x() / kM) * kM, std::floor(eye.y() / kM) * kM, std::floor(eye.z() / kM) * kM};
    }
};

/// Two triangles for each drop: the place in the box 0 … 1, side and end of the streak, and a random share.
osg::ref_ptr<osg::Geometry> makeDrops(osg::DrawArrays& faces)
{
    std::mt19937 random(7);
    const auto share = [&random] { return static_cast<float>(random() >> 8) / 16777216.0F; };
    osg::ref_ptr<osg::Vec3Array> places = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (int i = 0; i < FallingDrops::kMostDrops; ++i)
    {
        const float x = share(), y = share(), z = share(), size = share();
        for (const auto& [side, end] :
             {std::pair{-1.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {-1.0F, 0.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}})
        {
            places->push_back({x, y, z});
            corners->push_back({side, end, size});
        }
    }
    osg::ref_ptr<osg::Geometry> drops = new osg::Geometry;
    drops->setVertexArray(places);
    drops->setTexCoordArray(0, corners, osg::Array::BIND_PER_VERTEX);
    drops->addPrimitiveSet(&faces);
    drops->setUseDisplayList(false);
    drops->setUseVertexBufferObjects(true);
    drops->setCullingActive(false);
    drops->setComputeBoundingBoxCallback(new NoBound);
    drops->setDataVariance(osg::Object::DYNAMIC);
    return drops;
}

osg::Vec4f with(const osg::Vec3d& vector, double last)
{
    return osg::Vec4f(osg::Vec4d(vector, last));
}

} // namespace

osg::ref_ptr<osg::Program> makeFallingDropsProgram()
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("falling drops");
    const std::string head = std::string("#version 130\n") + osgSky::Atmosphere::glslFunctions();
    program->addShader(new osg::Shader(osg::Shader::VERTEX, head + shaders::kDropsVertexMain));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, head + shaders::kDropsMain));
    return program;
}

FallingDrops::FallingDrops()
    : _faces(new osg::DrawArrays(GL_TRIANGLES, 0, 0)),
      _shift(new osg::Uniform("dropsShift", osg::Vec4f())),
      _streak(new osg::Uniform("dropsStreak", osg::Vec4f())),
      _look(new osg::Uniform("dropsLook", osg::Vec4f()))
{
    const osg::ref_ptr<BoxesAroundEye> boxes = new BoxesAroundEye;
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setCullingActive(false);
    geode->addDrawable(makeDrops(*_faces));
    boxes->addChild(geode);
    boxes->setName("falling drops");
    boxes->setNodeMask(0);
    osg::StateSet* state = boxes->getOrCreateStateSet();
    state->setDataVariance(osg::Object::DYNAMIC);
    state->setAttributeAndModes(makeFallingDropsProgram());
    state->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setRenderBinDetails(kDropBin, "RenderBin");
    for (osg::Uniform* uniform : {_shift.get(), _streak.get(), _look.get()})
        state->addUniform(uniform);
    _node = boxes;
}

void FallingDrops::show(const simulation::Hydrometeors& falling, double timeS, const osg::Vec3d& wind,
                        const osg::Vec3d& eye)
{
    const double all = falling.perM3 * kBoxM * kBoxM * kBoxM;
    const int drops = static_cast<int>(std::min<double>(all, kMostDrops));
    _node->setNodeMask(drops > 0 ? ~0U : 0U);
    _faces->setCount(kCornersOfADrop * drops);
    _faces->dirty();
    const osg::Vec3d velocity = wind - osg::Vec3d(0.0, 0.0, falling.fallMps);
    osg::Vec3d shift = velocity * timeS;
    for (int axis = 0; axis < 3; ++axis)
        shift[axis] -= std::floor(shift[axis] / kBoxM) * kBoxM;
    _shift->set(with(shift, kBoxM));
    // Each drawn one stands for so many.
    constexpr double kWidest = 3.0;
    const double wider = drops > 0 ? std::min(std::sqrt(all / drops), kWidest) : 1.0;
    _streak->set(with((velocity - eye) * kExposureS, 0.5 * falling.sizeM * wider));
    _look->set(osg::Vec4f(falling.isSnow ? 1.0F : 0.0F, 0.0F, 0.0F, 0.0F));
}

int FallingDrops::shownDrops() const
{
    return _faces->getCount() / kCornersOfADrop;
}

} // namespace scenery
