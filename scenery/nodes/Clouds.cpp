// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/Clouds.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include <foundation/KeptResults.h>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/NodeCallback>
#include <osg/Program>
#include <osg/Texture2D>
#include <osg/Texture3D>
#include <osgSky/Atmosphere>
#include <osgUtil/CullVisitor>

#include <osgTraversal/DrawOrder>
#include <shaders/scenery.h>

#include "scenery/clouds/CloudVolumeBytes.h"
#include "scenery/clouds/TiledNoise3.h"
#include "scenery/nodes/CloudPicture.h"

namespace scenery
{

namespace
{

using clouds::CloudVolume;

constexpr int kVolumeUnit = 2, kDetailUnit = 3; ///< of the rays
constexpr int kShadeUnit = 24;                  ///< behind those of TerrainMaterial and SunShadows
constexpr int kDetailSide = 32;
constexpr double kSameLight = 0.99985; ///< cosine of a degree
constexpr const char* kShadeDefine = "CLOUD_SHADOWS";

osg::ref_ptr<osg::Texture> texture3D(osg::Image* image, osg::Texture::WrapMode upwards)
{
    osg::ref_ptr<osg::Texture3D> texture = new osg::Texture3D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_R, upwards);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

/// What carves the edges: noise that repeats in all directions.
osg::ref_ptr<osg::Image> detailImage()
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kDetailSide, kDetailSide, kDetailSide, GL_RED, GL_UNSIGNED_BYTE);
    image->setInternalTextureFormat(GL_R8);
    unsigned char* byte = image->data();
    constexpr int kCells = 5;
    constexpr float kPerSample = static_cast<float>(kCells) / kDetailSide;
    for (int z = 0; z < kDetailSide; ++z)
        for (int y = 0; y < kDetailSide; ++y)
            for (int x = 0; x < kDetailSide; ++x)
            {
                const float sum =
                    clouds::tiledSum3(glm::vec3(x, y, z) * kPerSample, glm::ivec3(kCells), 2, 5U);
                *byte++ = static_cast<unsigned char>(255.0F * std::clamp(0.5F + 0.9F * sum, 0.0F, 1.0F));
            }
    return image;
}

/// Made, or found among the user's kept ones.
CloudVolume keptVolume(const simulation::CloudLayer& layer, std::uint32_t seed)
{
    foundation::ContentMark mark;
    mark.addWord(static_cast<std::uint64_t>(layer.kind)).addWord(static_cast<std::uint64_t>(layer.oktas));
    mark.addWord(std::bit_cast<std::uint64_t>(layer.baseM)).addWord(std::bit_cast<std::uint64_t>(layer.topM));
    mark.addWord(seed);
    return foundation::KeptResults::ofUser().findOrMake(
        "clouds", mark, clouds::cloudVolumeIn, [&] { return clouds::makeCloudVolume(layer, seed); },
        clouds::bytesOf);
}

osg::ref_ptr<osg::Program> program(const char* name, const std::string& fragment)
{
    osg::ref_ptr<osg::Program> made = new osg::Program;
    made->setName(name);
    made->addShader(new osg::Shader(osg::Shader::VERTEX, shaders::kCloudVert));
    made->addShader(new osg::Shader(osg::Shader::FRAGMENT, "#version 130\n" + fragment));
    return made;
}

osg::ref_ptr<osg::Node> makeRays(CloudPicture* picture)
{
    const osg::ref_ptr<osg::Geode> rays = new osg::Geode;
    rays->setName("cloud rays");
    rays->setCullingActive(false);
    rays->addDrawable(new CloudRays(picture));
    osg::StateSet* const state = rays->getOrCreateStateSet();
    state->setAttributeAndModes(
        program("cloud rays", osgSky::Atmosphere::glslFunctions() + std::string(shaders::kCloudRays)));
    state->addUniform(new osg::Uniform("cloudVolume", kVolumeUnit));
    state->addUniform(new osg::Uniform("cloudDetail", kDetailUnit));
    state->setTextureAttribute(kDetailUnit, texture3D(detailImage(), osg::Texture::REPEAT));
    state->setMode(GL_DEPTH_TEST, osg::StateAttribute::OFF);
    state->setMode(GL_BLEND, osg::StateAttribute::OFF);
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setMode(GL_MULTISAMPLE, osg::StateAttribute::OFF);
    state->setRenderBinDetails(-1000, "RenderBin"); // before what would have to be stored meanwhile
    state->setDataVariance(osg::Object::DYNAMIC);
    return rays;
}

osg::ref_ptr<osg::Node> makeSheet(CloudPicture* picture, bool isAmong)
{
    const osg::ref_ptr<osg::Geode> sheet = new osg::Geode;
    sheet->setName("clouds");
    sheet->setCullingActive(false);
    sheet->addDrawable(new CloudSheet(picture));
    osg::StateSet* const state = sheet->getOrCreateStateSet();
    state->setAttributeAndModes(makeCloudSheetProgram(isAmong));
    state->addUniform(new osg::Uniform("cloudColour", static_cast<int>(CloudSheet::kColourUnit)));
    state->addUniform(new osg::Uniform("cloudAway", static_cast<int>(CloudSheet::kAwayUnit)));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setRenderBinDetails(osgTraversal::DrawOrder::kSky + 3, "RenderBin");
    return sheet;
}

/// Chooses, for each camera, the sheet that fits its eye.
class ChooseSheet : public osg::NodeCallback
{
public:
    ChooseSheet(osg::Node* behind, osg::Node* among, double baseM)
        : _behind(behind), _among(among), _baseM(baseM)
    {
    }

    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        const auto* const cull = dynamic_cast<osgUtil::CullVisitor*>(visitor);
        constexpr double kNearM = 30.0;
        const bool isBelow = !cull || cull->getEyePoint().z() < _baseM - kNearM;
        for (const auto& child : {_behind, _among})
            if ((child == _behind) == isBelow) child->accept(*visitor);
        (void)node;
    }

private:
    osg::ref_ptr<osg::Node> _behind, _among;
    double _baseM;
};

osg::Image* newImage(int depth, GLenum format, GLint internal)
{
    auto* const image = new osg::Image;
    image->allocateImage(CloudVolume::kSide, CloudVolume::kSide, depth, format, GL_UNSIGNED_BYTE);
    image->setInternalTextureFormat(internal);
    image->setDataVariance(osg::Object::DYNAMIC);
    return image;
}

} // namespace

osg::ref_ptr<osg::Program> makeCloudSheetProgram(bool isAmong)
{
    return program(isAmong ? "clouds among things" : "clouds behind things",
                   std::string(isAmong ? "#define AMONG\n" : "") + shaders::kCloudSheet);
}

Clouds::Clouds() : _root(new osg::Group), _shadeImage(newImage(1, GL_RED, GL_R8))
{
    const osg::ref_ptr<CloudPicture> picture = new CloudPicture;
    _root->setName("clouds");
    _root->setCullingActive(false);
    _root->setUserData(picture);
    _march = makeRays(picture);
    _laidBehind = makeSheet(picture, false);
    _laidAmong = makeSheet(picture, true);
    _root->addChild(_march);
    _root->setNodeMask(0U);
    setDetail(4, 40);
}

void Clouds::setDetail(int pixelsPerRay, int steps)
{
    static_cast<CloudPicture*>(_root->getUserData())->setPixelsPerRay(pixelsPerRay);
    _march->getStateSet()->getOrCreateUniform("cloudSteps", osg::Uniform::INT)->set(steps);
}

void Clouds::setLayers(const std::vector<simulation::CloudLayer>& layers, double groundM)
{
    if (layers == _layers && groundM == _groundM) return;
    _layers = layers;
    _groundM = groundM;
    _volumes.clear();
    for (const simulation::CloudLayer& layer : layers)
        if (layer.oktas > 0)
            _volumes.push_back(keptVolume(layer, 1U + 100U * static_cast<std::uint32_t>(_volumes.size())));
    _litFrom.set(0.0, 0.0, 0.0);
    _root->setNodeMask(_volumes.empty() ? 0U : ~0U);
    _root->removeChildren(1, _root->getNumChildren() - 1);
    if (_volumes.empty())
    {
        if (_below) _below->removeDefine(kShadeDefine);
        return;
    }
    const int count = static_cast<int>(_volumes.size());
    osg::StateSet& state = *_march->getStateSet();
    state.getOrCreateUniform("cloudLayers", osg::Uniform::INT)->set(count);
    osg::Uniform* const slabs = state.getOrCreateUniform("cloudSlab", osg::Uniform::FLOAT_VEC4, 3);
    for (int i = 0; i < count; ++i)
        slabs->setElement(static_cast<unsigned>(i),
                          osg::Vec4f(static_cast<float>(groundM + _volumes[i].baseM),
                                     static_cast<float>(groundM + _volumes[i].topM),
                                     static_cast<float>(_volumes[i].extinctionPerM), _volumes[i].sharpness));
    _volumeImage = newImage(CloudVolume::kSlices * count, GL_RGBA, GL_RGBA8);
    state.setTextureAttribute(kVolumeUnit, texture3D(_volumeImage, osg::Texture::CLAMP_TO_EDGE));
    const osg::ref_ptr<osg::Group> sheets = new osg::Group;
    sheets->setCullingActive(false);
    sheets->addCullCallback(new ChooseSheet(_laidBehind, _laidAmong, groundM + _volumes[0].baseM));
    sheets->addChild(_laidBehind);
    sheets->addChild(_laidAmong);
    _root->addChild(sheets);
    if (_below) shadeBy(*_below);
}

void Clouds::updateLight(const osg::Vec3d& towardsSun)
{
    _litFrom = towardsSun;
    const glm::vec3 towards(towardsSun.x(), towardsSun.y(), towardsSun.z());
    std::vector<clouds::SunInClouds> suns;
    unsigned char* texel = _volumeImage->data();
    for (const CloudVolume& volume : _volumes)
    {
        suns.push_back(clouds::sunInClouds(volume, towards));
        for (std::size_t i = 0; i < volume.form.size(); ++i, texel += 4)
        {
            texel[0] = volume.form[i];
            texel[1] = suns.back().within[i];
            texel[2] = volume.skylit[i];
            texel[3] = volume.gap[i];
        }
    }
    _volumeImage->dirty();
    const std::vector<std::uint8_t> shade = clouds::shadeBelow(_volumes, suns, towards);
    std::copy(shade.begin(), shade.end(), _shadeImage->data());
    _shadeImage->dirty();
}

void Clouds::show(const osg::Vec3d& towardsSun, const osg::Vec3f& sunLight, const osg::Vec2d& driftM)
{
    if (_volumes.empty()) return;
    osg::Vec3d towards = towardsSun;
    towards.normalize();
    if (towards * _litFrom < kSameLight) updateLight(towards);
    osg::StateSet& state = *_march->getStateSet();
    const auto inTile = [](double metres)
    { return static_cast<float>(metres - CloudVolume::kTileM * std::floor(metres / CloudVolume::kTileM)); };
    const osg::Vec2f drift(inTile(driftM.x()), inTile(driftM.y()));
    state.getOrCreateUniform("cloudSun", osg::Uniform::FLOAT_VEC3)->set(sunLight);
    state.getOrCreateUniform("cloudDrift", osg::Uniform::FLOAT_VEC2)->set(drift);
    if (!_below) return;
    _below->getOrCreateUniform("cloudShadeDrift", osg::Uniform::FLOAT_VEC2)->set(drift);
}

void Clouds::shadeBy(osg::StateSet& below)
{
    _below = &below;
    if (_volumes.empty()) return;
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(_shadeImage);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    below.setTextureAttribute(kShadeUnit, texture);
    below.getOrCreateUniform("cloudShade", osg::Uniform::SAMPLER_2D)->set(kShadeUnit);
    below.setDefine(kShadeDefine);
    setShadowStrength(1.0);
}

void Clouds::setShadowStrength(double strength)
{
    if (!_below || _volumes.empty()) return;
    _below->getOrCreateUniform("cloudShadeSlab", osg::Uniform::FLOAT_VEC3)
        ->set(osg::Vec3f(static_cast<float>(_groundM + _volumes.front().baseM),
                         static_cast<float>(_groundM + _volumes.back().topM), static_cast<float>(strength)));
}

double Clouds::coverAbove(double eyeM) const
{
    double open = 1.0;
    for (const simulation::CloudLayer& layer : _layers)
    {
        const double within = (eyeM - _groundM - layer.baseM) / (layer.topM - layer.baseM);
        open *= 1.0 - layer.oktas / 8.0 * (1.0 - std::clamp(within, 0.0, 1.0));
    }
    return 1.0 - open;
}

} // namespace scenery
