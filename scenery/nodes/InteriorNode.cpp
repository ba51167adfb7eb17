// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/InteriorNode.h"

#include <osg/Geometry>

#include <osgPMObjects/ObjectShader>

#include "scenery/nodes/InteriorShading.h"
#include "scenery/nodes/ModelStates.h"
#include "scenery/nodes/RotorDisc.h"

namespace scenery
{

namespace
{

using models::InteriorCoat;
using models::Reading;

constexpr int kMirrorWidthPx = 256, kMirrorHeightPx = 128;

osg::Matrixd osgMatrixOf(const glm::dmat4& matrix)
{
    return osg::Matrixd(&matrix[0][0]); // GLM's columns are OSG's rows
}

osg::Vec3f single(const glm::dvec3& v)
{
    return osg::Vec3f(osg::Vec3d(v.x, v.y, v.z));
}

osg::ref_ptr<osg::Texture2D> makeMirrorPicture()
{
    osg::ref_ptr<osg::Texture2D> picture = new osg::Texture2D;
    picture->setTextureSize(kMirrorWidthPx, kMirrorHeightPx);
    picture->setInternalFormat(GL_RGBA);
    picture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    picture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    picture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    picture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    return picture;
}

/// What lamps of the vehicle add to the light on a part.
osg::Vec3f lampOn(InteriorCoat coat, bool isDark)
{
    const osg::Vec3f light(kPanelLight[0], kPanelLight[1], kPanelLight[2]);
    return !isDark ? osg::Vec3f() : coat == InteriorCoat::dial ? light : light * 0.05F;
}

} // namespace

InteriorNode::InteriorNode(models::InteriorModel model)
    : _model(std::move(model)), _placed(new osg::MatrixTransform)
{
    _placed->setDataVariance(osg::Object::DYNAMIC);
    ModelStates states;
    for (const models::InteriorPart& made : _model.parts)
    {
        const osg::ref_ptr<osg::MatrixTransform> part = new osg::MatrixTransform;
        part->setName(made.name);
        part->setDataVariance(osg::Object::DYNAMIC);
        part->addChild(makeModelNode(made.model, states));
        setInteriorShading(*part, made.coat);
        _parts.push_back(part);
        _placed->addChild(part);
    }
    for (const models::InteriorMirror& mirror : _model.mirrors)
        _placed->addChild(makeMirror(mirror));
    if (_model.propeller)
    {
        _discPlaced = new osg::MatrixTransform;
        _discPlaced->setDataVariance(osg::Object::DYNAMIC);
        _discPlaced->addChild(makeRotorDisc(*_model.propeller));
    }
    show({}, {}, false);
}

osg::ref_ptr<osg::Node> InteriorNode::makeMirror(const models::InteriorMirror& mirror)
{
    _mirrors.push_back(makeMirrorPicture());
    const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    const osg::ref_ptr<osg::Vec2Array> places = new osg::Vec2Array;
    for (const auto& [right, up] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
    {
        corners->push_back(single(mirror.lowLeft + right * (mirror.lowRight - mirror.lowLeft) +
                                  up * (mirror.topLeft - mirror.lowLeft)));
        places->push_back(
            osg::Vec2f(osg::Vec2d(1.0 - right, up))); // the picture is seen from behind the mirror
    }
    const osg::ref_ptr<osg::Geometry> glass = new osg::Geometry;
    glass->setName(mirror.name);
    glass->setVertexArray(corners);
    glass->setTexCoordArray(0, places);
    glass->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 4));
    glass->setUseDisplayList(false);
    glass->setUseVertexBufferObjects(true);
    osg::StateSet& state = *glass->getOrCreateStateSet();
    state.setAttributeAndModes(makeMirrorProgram());
    state.addUniform(new osg::Uniform("objectTexture", 0));
    state.setTextureAttributeAndModes(0, _mirrors.back());
    return glass;
}

void InteriorNode::show(const Pose& vehicle, const models::Readings& readings, bool isDark)
{
    _placed->setMatrix(osgMatrixOf(worldFromModel(vehicle)));
    for (std::size_t i = 0; i < _parts.size(); ++i)
    {
        const models::InteriorPart& made = _model.parts[i];
        if (made.place) _parts[i]->setMatrix(osgMatrixOf(made.place(readings)));
        _parts[i]->setNodeMask(!made.isShown || made.isShown(readings) ? ~0U : 0U);
        if (made.coat == InteriorCoat::inside || made.coat == InteriorCoat::dial)
            _parts[i]->getStateSet()->getUniform("interiorLamp")->set(lampOn(made.coat, isDark));
    }
    if (!_discPlaced) return;
    _discPlaced->setMatrix(_placed->getMatrix());
    _discPlaced->setNodeMask(isBlurred(readings[Reading::propellerRadps]) ? ~0U : 0U);
}

} // namespace scenery
