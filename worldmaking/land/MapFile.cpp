// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/MapFile.h"

#include <system_error>

#include <ogrsf_frmts.h>

#include "worldmaking/map/GdalScope.h"

namespace worldmaking
{

namespace
{

constexpr const char* kDate =
    "2000-01-01T00:00:00.000Z"; ///< a GeoPackage notes when it was written: the same bytes need one

using Heights = std::vector<std::vector<double>>;

/// The points of a path, with heights where there are any.
void addPoints(OGRSimpleCurve& curve, const std::vector<glm::dvec2>& path, const Heights& heights,
               std::size_t number)
{
    for (std::size_t i = 0; i < path.size(); ++i)
        if (heights.empty())
            curve.addPoint(path[i].x, path[i].y);
        else
            curve.addPoint(path[i].x, path[i].y, heights[number][i]);
}

std::unique_ptr<OGRGeometry> geometryOf(ShapeForm form, const std::vector<std::vector<glm::dvec2>>& paths,
                                        const Heights& heights)
{
    if (form == ShapeForm::point)
        return std::make_unique<OGRPoint>(paths.front().front().x, paths.front().front().y);
    if (form == ShapeForm::line)
    {
        auto line = std::make_unique<OGRLineString>();
        addPoints(*line, paths.front(), heights, 0);
        return line;
    }
    auto polygon = std::make_unique<OGRPolygon>();
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
        auto* const ring = new OGRLinearRing; // the polygon's from here on
        addPoints(*ring, paths[i], heights, i);
        ring->closeRings();
        polygon->addRingDirectly(ring);
    }
    return polygon;
}

OGRwkbGeometryType typeOf(ShapeForm form)
{
    return form == ShapeForm::point ? wkbPoint : (form == ShapeForm::line ? wkbLineString : wkbPolygon);
}

} // namespace

/// What is open while a file is written. Errors of GDAL on this thread are kept.
struct MapFile::Open
{
    Open()
    {
        CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", kDate);
        degrees.SetWellKnownGeogCS("WGS84");
        degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    }
    ~Open()
    {
        dataset.reset();
        CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr);
    }
    Open(const Open&) = delete;
    Open& operator=(const Open&) = delete;

    GdalScope errors;
    DatasetPtr dataset;
    OGRLayer* layer = nullptr;
    ShapeForm form = ShapeForm::point;
    OGRSpatialReference degrees;
};

MapFile::MapFile(std::filesystem::path file) : _file(std::move(file)), _part(_file.string() + ".part.gpkg")
{
    std::error_code ignored;
    for (const char* left : {"", "-journal", "-wal", "-shm"}) // by a build that was killed
        std::filesystem::remove(_part.string() + left, ignored);
    _open = std::make_unique<Open>();
    if (GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GPKG"))
        _open->dataset.reset(driver->Create(_part.string().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (_open->dataset) _open->dataset->StartTransaction();
}

MapFile::~MapFile()
{
    _open.reset();
    std::error_code ignored;
    std::filesystem::remove(_part, ignored);
}

void MapFile::beginLayer(const std::string& name, ShapeForm form, const std::vector<std::string>& keys,
                         bool hasHeights)
{
    if (!_open->dataset) return;
    char** options = CSLSetNameValue(nullptr, "SPATIAL_INDEX", "NO");
    _open->layer = _open->dataset->CreateLayer(name.c_str(), &_open->degrees,
                                               hasHeights ? wkbSetZ(typeOf(form)) : typeOf(form), options);
    CSLDestroy(options);
    _open->form = form;
    for (const std::string& key : keys)
    {
        OGRFieldDefn field(key.c_str(), OFTString);
        if (_open->layer) _open->layer->CreateField(&field);
    }
}

void MapFile::add(const std::vector<std::vector<glm::dvec2>>& paths, const Tags& tags,
                  const std::vector<std::vector<double>>& heightsM)
{
    if (!_open->layer) return;
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(_open->layer->GetLayerDefn()));
    for (int i = 0; i < feature->GetFieldCount(); ++i)
        if (const auto value = valueOf(tags, feature->GetFieldDefnRef(i)->GetNameRef()); !value.empty())
            feature->SetField(i, std::string(value).c_str());
    feature->SetGeometryDirectly(geometryOf(_open->form, paths, heightsM).release());
    if (_open->layer->CreateFeature(feature.get()) != OGRERR_NONE)
        _open->layer = nullptr; // finish() tells why
}

foundation::Outcome MapFile::finish()
{
    if (_open->dataset) _open->dataset->CommitTransaction();
    _open->dataset.reset();
    std::error_code failed;
    if (!_open->errors.hasFailed()) std::filesystem::rename(_part, _file, failed);
    if (_open->errors.hasFailed() || failed)
        return foundation::Error{
            _file.string(), "cannot be written: " + (failed ? failed.message() : _open->errors.firstError()),
            "check that the folder can be written and the disk has room"};
    return foundation::success();
}

} // namespace worldmaking
