// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <foundation/Earth.h>

#include <osg/Uniform>

#include <osgTerrainROAM/core/cover/GroundMakeup.h>

#include <osgTerrainROAM/TerrainMaterial>
#include <osgTraversal/DrawOrder>

#include "material/CoverTexture.h"
#include "material/DetailImages.h"
#include "material/FeatureTextures.h"
#include "material/FineNormals.h"
#include "material/GrainImage.h"
#include "material/GroundPalette.h"
#include "material/ImageBytes.h"
#include "material/LandMap.h"
#include "material/MapGrid.h"
#include "material/MapTexture.h"
#include "material/NormalMap.h"
#include "material/OpeningTexture.h"
#include "material/SheetNormals.h"
#include "material/TerrainShader.h"

namespace osgTerrainROAM
{

namespace
{

void addTexture(osg::StateSet& stateSet, const char* name, TerrainMaterial::Unit unit, osg::Image* image,
                osg::Texture::WrapMode wrap)
{
    stateSet.setTextureAttributeAndModes(unit, mapTexture(image, wrap));
    stateSet.addUniform(new osg::Uniform(name, static_cast<int>(unit)));
}

/// Computes the scale and offset from grid positions to texture coordinates of a map whose first and last
/// texel centres are first and last sample.
osg::Vec4f mapFromGrid(double texelsPerSample, double offsetTexels, int side, bool wide)
{
    const auto scale = static_cast<float>(texelsPerSample / side);
    const auto offset = static_cast<float>(offsetTexels / side);
    return wide ? osg::Vec4f(scale, 0, offset, 0) : osg::Vec4f(0, scale, 0, offset);
}

/// Computes by how many texels each layer of the grain bends a border: half a texel by the layers whose
/// features, an eighth of their period, are finer than texels.
osg::Vec4f bendOver(double texelM)
{
    const auto bend = [=](double periodM)
    {
        return static_cast<float>(8.0 * std::min(1.0, 8.0 * texelM / periodM) *
                                  std::min(1.0, periodM / (2.0 * texelM)));
    };
    return {0.3f * bend(2.0), bend(28.0), bend(324.0), bend(4700.0)};
}

foundation::Outcome checkImagery(const std::vector<ImageryLayer>& layers)
{
    const char* const place = "TerrainMaterial.imagery";
    if (layers.size() > TerrainMaterial::kMaxImagery)
        return foundation::Error{place, std::to_string(layers.size()) + " layers are too many",
                                 "give " + std::to_string(TerrainMaterial::kMaxImagery) + " at most"};
    for (const ImageryLayer& layer : layers)
    {
        if (!layer.image || layer.image->s() < 2 || layer.image->t() < 2)
            return foundation::Error{place, "a layer has no image", "give each one of 2×2 texels or more"};
        const glm::dvec2 extent = layer.lastGrid - layer.firstGrid;
        if (!(extent.x > 0.0 && extent.y > 0.0 && std::isfinite(extent.x + extent.y)))
            return foundation::Error{place, "a layer has no extent on the grid",
                                     "set firstGrid and lastGrid"};
        if (!(std::isfinite(layer.texelM) && layer.texelM > 0.0))
            return foundation::Error{place, "the texels of a layer have no size", "set texelM"};
    }
    return foundation::success();
}

} // namespace

TerrainMaterial::TerrainMaterial(const core::PlacedTile& tile, const Climate& climate, osg::Image* drapeImage,
                                 foundation::KeptFrom kept)
    : _climate(climate),
      _kept(std::move(kept)),
      _hasDrape(drapeImage != nullptr),
      _stateSet(new osg::StateSet)
{
    addMaps(tile, drapeImage);
    addScales(tile);
    measureHeights(tile);
    setPalette();
    addClipping(tile);
    if (!tile.samples().sheets().empty())
        _sheetNormals = std::make_unique<SheetNormals>(tile, *_stateSet, sheetNormals);
    if (tile.grid().exponent() > 0)
        _fineNormals = std::make_unique<FineNormals>(tile, *_stateSet, fineIndex, fineNormals);
    setProgram();
    _stateSet->setRenderBinDetails(osgTraversal::DrawOrder::kGround, "RenderBin");
    // The ground has no underside, and a far slope must not win against the near one in the depth buffer's
    // last step.
    _stateSet->setMode(GL_CULL_FACE, osg::StateAttribute::ON);
}

TerrainLook TerrainMaterial::ownLook() const
{
    return {.drape = _hasDrape,
            .layers = _imageryLayers,
            .features = _hasFeatures,
            .farFeatures = _hasFarFeatures,
            .openings = _hasOpenings,
            .cover = _hasCover,
            .sheets = _sheetNormals ? _sheetNormals->maps() : 0,
            .fine = _fineNormals != nullptr,
            .season = _season.has_value()};
}

void TerrainMaterial::setProgram()
{
    _stateSet->setAttributeAndModes(terrainProgram(ownLook()));
    for (const auto& [state, look] : _borrowers)
        lend(*state, look);
}

void TerrainMaterial::lendLook(osg::StateSet* to, BorrowedLook look)
{
    _borrowers.emplace_back(to, std::move(look));
    lend(*to, _borrowers.back().second);
}

void TerrainMaterial::lend(osg::StateSet& to, const BorrowedLook& look) const
{
    to.merge(*_stateSet);
    for (const GLenum plane : {GL_CLIP_PLANE0, GL_CLIP_PLANE1})
        to.setMode(plane, osg::StateAttribute::OFF); // its vertices have no distances
    const osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("lent ground");
    const TerrainLook ground{.drape = _hasDrape,
                             .layers = _imageryLayers,
                             .features = _hasFeatures,
                             .cover = _hasCover,
                             .season = _season.has_value(),
                             .lentNames = look.names};
    program->addShader(
        new osg::Shader(osg::Shader::VERTEX, "#version 330 compatibility\n" + look.vertexText));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, look.fragmentText.empty()
                                                                  ? terrainFragmentText(ownLook())
                                                                  : groundText(ground) + look.fragmentText));
    if (look.finish) look.finish(to, *program);
    to.setAttributeAndModes(program);
}

void TerrainMaterial::setFeatures(const core::FeatureCells& cells)
{
    setFeatures(FeatureMaps::of(cells, _kept.withoutMark()));
}

void TerrainMaterial::setFeatures(const FeatureMaps& maps)
{
    addFeatureTextures(*_stateSet, maps, features);
    _hasFeatures = true;
    setProgram();
}

void TerrainMaterial::setFarFeatures(const core::FeatureCells& cells, double nearestM)
{
    setFarFeatures(FeatureMaps::farOf(cells, _kept.withoutMark()), nearestM);
}

void TerrainMaterial::setFarFeatures(const FeatureMaps& maps, double nearestM)
{
    addFarFeatureTexture(*_stateSet, maps, farFeatures);
    _stateSet->getOrCreateUniform("farFeatureNearestM", osg::Uniform::FLOAT)
        ->set(static_cast<float>(nearestM));
    _hasFarFeatures = true;
    setProgram();
}

void TerrainMaterial::setOpenings(const core::OpeningCells& cells)
{
    _hasOpenings = !cells.isEmpty();
    if (_hasOpenings) addOpeningTexture(*_stateSet, cells, openings);
    setProgram();
}

foundation::Outcome TerrainMaterial::setImagery(std::vector<ImageryLayer> layers)
{
    if (foundation::Outcome checked = checkImagery(layers); !checked) return checked;
    std::stable_sort(layers.begin(), layers.end(),
                     [](const ImageryLayer& a, const ImageryLayer& b) { return a.texelM > b.texelM; });
    _imageryLayers = static_cast<int>(layers.size());
    osg::Uniform* fromGrid = _stateSet->getOrCreateUniform(
        "imageryFromGrid", osg::Uniform::FLOAT_VEC4, static_cast<unsigned>(std::max(_imageryLayers, 1)));
    for (int i = 0; i < _imageryLayers; ++i)
    {
        const ImageryLayer& layer = layers[static_cast<std::size_t>(i)];
        const auto unit = static_cast<Unit>(imagery + i);
        addTexture(*_stateSet, ("imageryLayer" + std::to_string(i)).c_str(), unit, layer.image.get(),
                   osg::Texture::CLAMP_TO_EDGE);
        const glm::dvec2 size(layer.image->s(), layer.image->t());
        const glm::dvec2 scale = (size - 1.0) / (layer.lastGrid - layer.firstGrid);
        const glm::dvec2 offset = 0.5 - layer.firstGrid * scale;
        fromGrid->setElement(static_cast<unsigned>(i), osg::Vec4f(scale.x / size.x, scale.y / size.y,
                                                                  offset.x / size.x, offset.y / size.y));
    }
    setProgram();
    return foundation::success();
}

void TerrainMaterial::addMaps(const core::PlacedTile& tile, osg::Image* drapeImage)
{
    const MapGrid grid(tile);
    _normalImage = keptImage(_kept, "normals", {}, [&] { return normalMap(tile, grid); });
    const osg::ref_ptr<osg::Image> landImage =
        keptImage(_kept, "land", core::markOfClimate(_climate),
                  [&] { return landMap(tile, grid, _climate, *_normalImage); });
    addTexture(*_stateSet, "terrainNormals", normals, _normalImage.get(), osg::Texture::CLAMP_TO_EDGE);
    addTexture(*_stateSet, "terrainLand", land, landImage.get(), osg::Texture::CLAMP_TO_EDGE);
    addTexture(*_stateSet, "terrainGrain", grain,
               keptImage(_kept.withoutMark(), "grain", {}, grainImage).get(), osg::Texture::REPEAT);
    _stateSet->setTextureAttribute(detail, detailTexture(_kept.withoutMark()));
    _stateSet->addUniform(new osg::Uniform("terrainDetail", static_cast<int>(detail)));
    const double perSample = 1.0 / grid.step;
    _stateSet->addUniform(
        new osg::Uniform("terrainMapFromGrid", mapFromGrid(perSample, 0.5, grid.width, true) +
                                                   mapFromGrid(perSample, 0.5, grid.height, false)));
    if (drapeImage)
    {
        addTexture(*_stateSet, "terrainDrape", drape, drapeImage, osg::Texture::CLAMP_TO_EDGE);
        const double perColumn = (drapeImage->s() - 1.0) / (tile.grid().dataColumns() - 1.0);
        const double perRow = (drapeImage->t() - 1.0) / (tile.grid().dataRows() - 1.0);
        _stateSet->addUniform(
            new osg::Uniform("terrainDrapeFromGrid", mapFromGrid(perColumn, 0.5, drapeImage->s(), true) +
                                                         mapFromGrid(perRow, 0.5, drapeImage->t(), false)));
    }
}

void TerrainMaterial::measureHeights(const core::PlacedTile& tile)
{
    const int column = tile.grid().dataColumns() / 2, row = tile.grid().dataRows() / 2;
    const glm::dvec3 middle = tile.position(column, row);
    // Seen from the tile's frame the Earth falls away by about d²/2R; a metre more or less does not move a
    // snow line.
    const double fall =
        tile.frame().placement() == core::Placement::curved ? 0.5 / foundation::kEarthRadiusM : 0.0;
    const double over =
        tile.samples().heightM(column, row) - middle.z - fall * (middle.x * middle.x + middle.y * middle.y);
    _heights.set(static_cast<float>(fall), static_cast<float>(over));
    _lastSample.set(static_cast<float>(tile.grid().dataColumns() - 1),
                    static_cast<float>(tile.grid().dataRows() - 1));
    _spacingM = 0.5 * (tile.field().spacingEastM + tile.field().spacingNorthM) / tile.grid().cellSide();
}

TerrainMaterial::~TerrainMaterial() = default;

void TerrainMaterial::followEdits(const core::PlacedTile& tile, std::span<const core::GridRect> moved)
{
    updateNormals(*_normalImage, tile, MapGrid(tile), moved);
    if (_sheetNormals) _sheetNormals->follow(tile, moved);
    if (_fineNormals) _fineNormals->follow(tile, moved);
}

void TerrainMaterial::addScales(const core::PlacedTile& tile)
{
    const double spacingM = 0.5 * (tile.field().spacingEastM + tile.field().spacingNorthM);
    _stateSet->addUniform(new osg::Uniform("terrainBumpiness", bumpinessOver(spacingM)));
    _stateSet->addUniform(new osg::Uniform("terrainBend", bendOver(MapGrid(tile).spacingM(tile)) * 0.3f));
    const double perPeriod = 1.0 / (4700.0 * tile.grid().cellSide());
    _stateSet->addUniform(new osg::Uniform(
        "terrainBroad", osg::Vec2f(static_cast<float>(tile.field().spacingEastM * perPeriod),
                                   static_cast<float>(tile.field().spacingNorthM * perPeriod))));
    // A beach some 25 m wide, within the two samples that the water mask slopes over.
    _stateSet->addUniform(new osg::Uniform(
        "terrainShore",
        static_cast<float>(std::clamp(0.5 - 0.69 * 25.0 / std::max(spacingM, 0.1), 0.05, 0.42))));
}

void TerrainMaterial::setPalette()
{
    const GroundPalette palette = groundPalette(_climate, _season);
    const auto set = [&](const char* name, const osg::Vec3f& albedo)
    { _stateSet->getOrCreateUniform(name, osg::Uniform::FLOAT_VEC3)->set(albedo); };
    set("terrainRock", palette.rock);
    set("terrainSoil", palette.soil);
    set("terrainDryGrass", palette.dryGrass);
    set("terrainMeadow", palette.meadow);
    set("terrainForest", palette.forest);
    set("terrainSand", palette.sand);
    set("terrainSnow", palette.snow);
    set("terrainWater", palette.water);
    const auto dry = static_cast<float>(std::clamp((_climate.aridity - 0.15) / 0.7, 0.0, 1.0));
    _stateSet->getOrCreateUniform("terrainStrata", osg::Uniform::FLOAT)->set(0.10f + 0.22f * dry);
    set("featureSoil", palette.fieldSoil);
    osg::Uniform* crops = _stateSet->getOrCreateUniform("featureCrops", osg::Uniform::FLOAT_VEC3, 4);
    for (unsigned i = 0; i < 4; ++i)
        crops->setElement(i, palette.crops[i]);
    osg::Uniform* albedos =
        _stateSet->getOrCreateUniform("coverAlbedo", osg::Uniform::FLOAT_VEC4, core::kGroundKinds);
    osg::Uniform* patches =
        _stateSet->getOrCreateUniform("coverPatch", osg::Uniform::FLOAT_VEC4, core::kGroundKinds);
    osg::Uniform* open =
        _stateSet->getOrCreateUniform("coverOpen", osg::Uniform::FLOAT_VEC4, core::kGroundKinds);
    osg::Uniform* litter =
        _stateSet->getOrCreateUniform("coverLitter", osg::Uniform::FLOAT, core::kGroundKinds);
    const auto looks = kindLooks(palette);
    for (unsigned i = 0; i < looks.size(); ++i)
    {
        const core::GroundMakeup& of = core::kGroundMakeup[i];
        open->setElement(i, osg::Vec4f(of.grass, of.stones, of.earth, of.rock));
        litter->setElement(i, of.litter);
        albedos->setElement(i, osg::Vec4f(looks[i].albedo, looks[i].wood));
        patches->setElement(i, osg::Vec4f(looks[i].patch, looks[i].patches));
    }
    _stateSet->getOrCreateUniform("seasonSnowLine", osg::Uniform::FLOAT_VEC4)
        ->set(osg::Vec4f(static_cast<float>(_climate.snowLineM), palette.snowShiftM, _heights.x(),
                         _heights.y()));
}

foundation::Outcome TerrainMaterial::setSeason(std::optional<double> yearShare)
{
    if (yearShare && !(*yearShare >= 0.0 && *yearShare <= 1.0))
        return foundation::Error{
            "TerrainMaterial.season", std::to_string(*yearShare) + " is no share of a year",
            "give a number from 0 (first of January) to 1 (last of December), or nothing"};
    const bool wasSet = _season.has_value();
    _season = yearShare;
    // A frame that is still being drawn is waited for.
    _stateSet->setDataVariance(osg::Object::DYNAMIC);
    setPalette();
    if (wasSet != _season.has_value()) setProgram();
    return foundation::success();
}

void TerrainMaterial::setCover(const core::CoverMap& map)
{
    const osg::ref_ptr<osg::Image> image = coverImage(map);
    addTexture(*_stateSet, "terrainCover2D", cover, image.get(), osg::Texture::CLAMP_TO_EDGE);
    auto* texture =
        static_cast<osg::Texture*>(_stateSet->getTextureAttribute(cover, osg::StateAttribute::TEXTURE));
    // Numbers of kinds: nothing lies between two of them.
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST_MIPMAP_NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setUseHardwareMipMapGeneration(false);
    const double perColumn = (map.width - 1.0) / _lastSample.x(),
                 perRow = (map.height - 1.0) / _lastSample.y();
    _stateSet->addUniform(new osg::Uniform("coverFromGrid", mapFromGrid(perColumn, 0.5, map.width, true) +
                                                                mapFromGrid(perRow, 0.5, map.height, false)));
    _stateSet->addUniform(new osg::Uniform("coverLevels", static_cast<int>(image->getNumMipmapLevels())));
    const double texelM = _spacingM / std::max(perColumn, 1e-9);
    _stateSet->addUniform(new osg::Uniform("coverBend", bendOver(texelM)));
    _hasCover = true;
    setProgram();
}

void TerrainMaterial::addClipping(const core::PlacedTile& tile)
{
    _stateSet->addUniform(
        new osg::Uniform("terrainLastSample", osg::Vec2f(static_cast<float>(tile.grid().dataColumns() - 1),
                                                         static_cast<float>(tile.grid().dataRows() - 1))));
    // GL_CLIP_DISTANCE0 and 1 have the numbers of the first two clip planes.
    _stateSet->setMode(GL_CLIP_PLANE0, osg::StateAttribute::ON);
    _stateSet->setMode(GL_CLIP_PLANE1, osg::StateAttribute::ON);
}

} // namespace osgTerrainROAM
