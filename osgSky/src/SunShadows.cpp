// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include <osg/Notify>
#include <osgSky/SunShadows>
#include <osgUtil/CullVisitor>
#include <osgUtil/RenderStage>

#include <osgTraversal/CullFacts>

#include "ShadowPlan.h"

namespace osgSky
{

namespace
{

constexpr int kMaps = ShadowPlan::kMaps;
constexpr float kLeastTexels = 3.0F;   ///< what is smaller in a map is not drawn into it
constexpr double kSameSun = 0.9999985; ///< cosine of 0.1 degrees

bool areUsable(const SunShadowSettings& settings)
{
    return settings.reachesM[0] > 0.0 && std::is_sorted(settings.reachesM.begin(), settings.reachesM.end()) &&
           settings.reachesM[kMaps - 1] <= ShadowPlan::kDepthM && settings.texels >= 64 &&
           settings.texels <= 4096 && settings.cellShare >= 0.0 && settings.cellShare <= 0.2 &&
           settings.movingMaps >= 0 && settings.movingMaps <= kMaps;
}

/// Four maps, two by two.
osg::ref_ptr<osg::Texture2D> makeTexture(int texels)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(2 * texels, 2 * texels);
    texture->setInternalFormat(GL_DEPTH_COMPONENT24);
    texture->setSourceFormat(GL_DEPTH_COMPONENT);
    texture->setSourceType(GL_UNSIGNED_INT);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setShadowComparison(true);
    texture->setShadowCompareFunc(osg::Texture::LEQUAL);
    return texture;
}

osg::ref_ptr<osg::Camera> makeCamera(osg::Texture2D* texture, int map, const SunShadowSettings& settings)
{
    const int texels = settings.texels;
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setName("sun shadow map");
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF_INHERIT_VIEWPOINT); // the levels of the main camera
    camera->setRenderOrder(osg::Camera::PRE_RENDER, map - kMaps);             // before mirrors
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->attach(osg::Camera::DEPTH_BUFFER, texture);
    camera->setImplicitBufferAttachmentMask(0, 0); // OSG adds a buffer of colours to each camera otherwise
    camera->setDrawBuffer(GL_NONE);
    camera->setReadBuffer(GL_NONE);
    camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    camera->setViewport((map % 2) * texels, (map / 2) * texels, texels, texels);
    camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    camera->getOrCreateStateSet()->setDefine("SUN_SHADOW_MAP");
    camera->setInheritanceMask(camera->getInheritanceMask() & ~osg::CullSettings::CULL_MASK);
    camera->setCullMask(~(SunShadows::kCastsNone |
                          (map < settings.movingMaps ? 0U : SunShadows::kMoves | SunShadows::kSlender)));
    camera->setCullingMode(osg::CullSettings::VIEW_FRUSTUM_SIDES_CULLING |
                           osg::CullSettings::SMALL_FEATURE_CULLING);
    camera->setSmallFeatureCullingPixelSize(kLeastTexels);
    return camera;
}

glm::dvec3 vectorOf(const osg::Vec3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

osg::Matrixd viewMatrix(const glm::dmat3& lightFromWorld, const osg::Vec3d& eye)
{
    osg::Matrixd rotation;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            rotation(row, column) = lightFromWorld[row][column]; // OSG multiplies row vectors
    return osg::Matrixd::translate(-eye) * rotation;
}

} // namespace

/// The children of a SunShadows as the cameras of its maps see them.
class SunShadows::Casters : public osg::Group
{
public:
    explicit Casters(SunShadows& shadows) : _shadows(shadows) { setCullingActive(false); }

    void traverse(osg::NodeVisitor& visitor) override { _shadows.osg::Group::traverse(visitor); }

private:
    SunShadows& _shadows;
};

/// What a map shows: it need not be drawn anew for the same place, light and casters.
struct SunShadows::Drawn
{
    unsigned int context = 0;
    glm::dmat3 lightFromWorld{0.0};
    ShadowMap map;
    std::vector<osg::BoundingSphere> casters; ///< of the children, in their order
};

/// What one camera knows of the maps: where they lie, if its picture has maps of its own, and what its
/// programs see of them.
struct SunShadows::View
{
    osg::observer_ptr<osg::Camera> camera;
    std::optional<unsigned int> frame; ///< of the plan
    ShadowPlan plan, before;           ///< `before`: of the frame before that
    glm::dvec3 sun{0.0};               ///< of the plan
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    osg::ref_ptr<osg::Uniform> axes = new osg::Uniform(osg::Uniform::FLOAT_MAT3, "sunShadowAxes");
    osg::ref_ptr<osg::Uniform> maps = new osg::Uniform(osg::Uniform::FLOAT_VEC4, "sunShadowMaps", kMaps);

    View(osg::Camera& of, osg::Texture2D* texture, const SunShadowSettings& settings) : camera(&of)
    {
        state->setDataVariance(osg::Object::DYNAMIC);
        state->setDefine("SUN_SHADOWS");
        if (!settings.isSoft) state->setDefine("SUN_SHADOW_HARD");
        state->setTextureAttribute(kUnit, texture);
        state->addUniform(new osg::Uniform("sunShadowMap", kUnit));
        state->addUniform(new osg::Uniform("sunShadowTexels", static_cast<float>(settings.texels)));
        state->addUniform(new osg::Uniform("sunShadowDepthM", static_cast<float>(ShadowPlan::kDepthM)));
        state->addUniform(axes);
        state->addUniform(maps);
    }

    void show(const ShadowPlan& shown, const osg::Vec3d& eye)
    {
        osg::Matrix3 matrix;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                matrix[3 * column + row] = static_cast<float>(shown.lightFromWorld[column][row]);
        axes->set(matrix);
        unsigned int number = 0;
        for (const ShadowMap& map : shown.from(vectorOf(eye)))
            maps->setElement(number++,
                             osg::Vec4f(osg::Vec4d(map.centre.x, map.centre.y, map.centre.z, map.reachM)));
    }
};

SunShadows::SunShadows(const osg::ref_ptr<const Atmosphere>& atmosphere, const SunShadowSettings& settings)
    : _atmosphere(atmosphere)
{
    setCullingActive(false); // a shadow is seen where what casts it is not
    setSettings(settings);
}

void SunShadows::setSettings(const SunShadowSettings& settings)
{
    if (_texture && settings == _settings) return;
    _settings = settings;
    if (!areUsable(_settings))
    {
        OSG_WARN << "SunShadows: reaches must ascend from above 0 to " << ShadowPlan::kDepthM
                 << " m, a map have 64 to 4096 texels, a cell a share of 0 to 0.2, and 0 to 4 maps show what "
                    "moves; the usual settings are used\n";
        _settings = {};
    }
    makeMaps();
}

void SunShadows::makeMaps()
{
    _views.clear();
    _texture = makeTexture(_settings.texels);
    for (int map = 0; map < kMaps; ++map)
    {
        _cameras[map] = makeCamera(_texture, map, _settings);
        _cameras[map]->addChild(new Casters(*this));
        _drawn[map] = std::make_unique<Drawn>();
    }
}

SunShadows::~SunShadows() = default;

SunShadows::View& SunShadows::viewOf(osg::Camera& camera)
{
    std::erase_if(_views, [](const auto& entry) { return !entry.second->camera.valid(); });
    std::unique_ptr<View>& view = _views[&camera];
    if (!view) view = std::make_unique<View>(camera, _texture, _settings);
    return *view;
}

/// Where the maps of a picture lie in a frame, whichever of its cameras is culled first.
const ShadowPlan& SunShadows::planOf(osg::Camera& root, unsigned int frame)
{
    View& view = viewOf(root);
    if (view.frame == frame) return view.plan;
    osg::Vec3d sun = _atmosphere->settings().sunDirectionWorld;
    sun.normalize();
    view.before = view.plan;
    // Turned axes would draw all maps anew.
    const bool isKept = _settings.cellShare > 0.0 && glm::dot(view.sun, vectorOf(sun)) > kSameSun;
    if (!isKept) view.sun = vectorOf(sun);
    view.plan = ShadowPlan::of(vectorOf(root.getInverseViewMatrix().getTrans()), view.sun, _settings.reachesM,
                               _settings.texels, _settings.cellShare);
    view.frame = frame;
    return view.plan;
}

/// The maps that a camera finds which is drawn before the pictures, as that of a mirror: those of the last
/// frame, of a picture whose eye is near. Null: there are none.
const ShadowPlan* SunShadows::lastPlan(const osg::Camera& camera, unsigned int frame) const
{
    constexpr double kNearM = 20.0;
    for (const auto& [other, view] : _views)
    {
        if (!view->frame || view->before.maps[0].reachM == 0.0 || !view->camera.valid()) continue;
        const osg::Vec3d between =
            other->getInverseViewMatrix().getTrans() - camera.getInverseViewMatrix().getTrans();
        if (other->getGraphicsContext() == camera.getGraphicsContext() && between.length() < kNearM)
            return view->frame == frame ? &view->before : &view->plan;
    }
    return nullptr;
}

/// Whether a child has moved that casts into a map and not into the nearer one alone.
bool SunShadows::hasMoved(int map, const ShadowPlan& plan) const
{
    const Drawn& drawn = *_drawn[map];
    if (drawn.casters.size() != getNumChildren()) return true;
    const auto touches = [&](const osg::BoundingSphere& sphere, const ShadowMap& of, double sign)
    {
        const glm::dvec3 away = glm::abs(plan.lightFromWorld * vectorOf(sphere.center()) - of.centre);
        return std::max(away.x, away.y) + sign * sphere.radius() < of.reachM;
    };
    for (unsigned int i = 0; i < getNumChildren(); ++i)
    {
        if ((getChild(i)->getNodeMask() & _cameras[static_cast<std::size_t>(map)]->getCullMask()) == 0U)
            continue;
        const osg::BoundingSphere &before = drawn.casters[i], now = getChild(i)->getBound();
        if (before.center() == now.center() && before.radius() == now.radius()) continue;
        for (const osg::BoundingSphere& sphere : {before, now})
            if (sphere.valid() && touches(sphere, plan.maps[map], -1.0) &&
                (map == 0 || !touches(sphere, plan.maps[map - 1], 1.0)))
                return true;
    }
    return false;
}

/// Whether a map has to be drawn; it counts as drawn then.
bool SunShadows::needsDrawing(int map, const ShadowPlan& plan, unsigned int context)
{
    if (_settings.cellShare == 0.0) return true;
    Drawn& drawn = *_drawn[map];
    const bool isSame = drawn.context == context && drawn.lightFromWorld == plan.lightFromWorld &&
                        drawn.map == plan.maps[map];
    if (isSame && !hasMoved(map, plan)) return false;
    drawn = {context, plan.lightFromWorld, plan.maps[map], {}};
    for (unsigned int i = 0; i < getNumChildren(); ++i)
        drawn.casters.push_back(getChild(i)->getBound());
    return true;
}

void SunShadows::drawMaps(osgUtil::CullVisitor& visitor, const ShadowPlan& plan, const osg::Vec3d& eye)
{
    const auto maps = plan.from(vectorOf(eye));
    const unsigned int context = visitor.getState() ? visitor.getState()->getContextID() : 0;
    for (int i = 0; i < kMaps; ++i)
    {
        if (!needsDrawing(i, plan, context)) continue;
        const glm::dvec3 low = maps[i].centre - maps[i].reachM, high = low + 2.0 * maps[i].reachM;
        _cameras[i]->setViewMatrix(viewMatrix(plan.lightFromWorld, eye));
        _cameras[i]->setProjectionMatrixAsOrtho(low.x, high.x, low.y, high.y,
                                                -ShadowPlan::kDepthM - maps[i].centre.z,
                                                ShadowPlan::kDepthM - maps[i].centre.z);
        _cameras[i]->accept(visitor);
    }
}

void SunShadows::cull(osgUtil::CullVisitor& visitor)
{
    osg::Camera& camera = *visitor.getCurrentCamera();
    osg::Camera* const root = visitor.getRenderStage()->getCamera();
    const bool isNested = root && root != &camera;
    const bool isFirst = !isNested && camera.getRenderOrder() == osg::Camera::PRE_RENDER;
    const unsigned int frame = osgTraversal::frameOf(visitor);
    const ShadowPlan* const plan =
        isFirst ? lastPlan(camera, frame) : &planOf(isNested ? *root : camera, frame);
    if (!plan) return osg::Group::traverse(visitor);
    const osg::Vec3d eye = visitor.getEyeLocal();
    View& view = viewOf(camera);
    view.show(*plan, eye);
    visitor.pushStateSet(view.state);
    osg::Group::traverse(visitor);
    visitor.popStateSet();
    // After the picture, whose levels of detail they show; they are drawn before it. Mirrors use those of a
    // picture.
    if (!isNested && !isFirst) drawMaps(visitor, *plan, eye);
}

void SunShadows::traverse(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* const cullVisitor = visitor.asCullVisitor();
    const bool isLit =
        _atmosphere->light().sun.length2() > 0.0F && _atmosphere->settings().sunDirectionWorld.z() > 0.0;
    if (!cullVisitor || !_isShown || !isLit) return osg::Group::traverse(visitor);
    cull(*cullVisitor);
}

} // namespace osgSky
