// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/CoverRaster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>

#include <ogr_spatialref.h>

#include "worldmaking/map/GdalScope.h"

namespace worldmaking
{

CoverRaster::CoverRaster(const MapBox& box, double texelM) : _box(box), _texelM(texelM)
{
    const glm::dvec2 size = box.high - box.low;
    _texelM = std::max(texelM, std::max(size.x, size.y) / kMostCells);
    _columns = std::max(1, static_cast<int>(std::ceil(size.x / _texelM)));
    _rows = std::max(1, static_cast<int>(std::ceil(size.y / _texelM)));
    _classes.assign(static_cast<std::size_t>(_columns) * static_cast<std::size_t>(_rows), 0);
}

void CoverRaster::paint(const PlanRings& rings, Cover cover)
{
    const MapBox around = boxOf(rings.front());
    const int first = std::max(0, static_cast<int>((around.low.y - _box.low.y) / _texelM) - 1);
    const int last = std::min(_rows - 1, static_cast<int>((around.high.y - _box.low.y) / _texelM) + 1);
    std::vector<double> crossings;
    for (int row = first; row <= last; ++row)
    {
        const double y = _box.low.y + (row + 0.5) * _texelM;
        crossings.clear();
        for (const auto& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
            {
                const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
                if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
            }
        std::sort(crossings.begin(), crossings.end());
        const auto columnOf = [&](double x) {
            return static_cast<int>(
                std::ceil(std::clamp((x - _box.low.x) / _texelM - 0.5, -1.0, 1.0 * _columns)));
        };
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            for (int column = std::max(0, columnOf(crossings[i]));
                 column < std::min(_columns, columnOf(crossings[i + 1])); ++column)
                _classes[static_cast<std::size_t>(row) * static_cast<std::size_t>(_columns) +
                         static_cast<std::size_t>(column)] = static_cast<std::uint8_t>(cover);
    }
}

Cover CoverRaster::at(const glm::dvec2& plan) const
{
    const glm::dvec2 cell = glm::floor((plan - _box.low) / _texelM);
    if (!(cell.x >= 0.0 && cell.y >= 0.0 && cell.x < _columns && cell.y < _rows)) return Cover::none;
    return static_cast<Cover>(_classes[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(_columns) +
                                       static_cast<std::size_t>(cell.x)]);
}

std::size_t CoverRaster::count(Cover cover) const
{
    return static_cast<std::size_t>(
        std::count(_classes.begin(), _classes.end(), static_cast<std::uint8_t>(cover)));
}

foundation::Outcome CoverRaster::write(const std::filesystem::path& file, const std::string& proj) const
{
    const std::filesystem::path part = file.string() + ".part.tif";
    GdalScope errors;
    OGRSpatialReference reference;
    reference.importFromProj4(proj.c_str());
    char* options[] = {const_cast<char*>("COMPRESS=DEFLATE"),
                       nullptr}; // GDAL's interface knows no const here
    GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    DatasetPtr dataset(driver ? driver->Create(part.string().c_str(), _columns, _rows, 1, GDT_Byte, options)
                              : nullptr);
    bool isWritten = dataset != nullptr;
    if (dataset)
    {
        std::array<double, 6> place{_box.low.x, _texelM, 0.0, _box.low.y + _rows * _texelM, 0.0, -_texelM};
        dataset->SetGeoTransform(place.data());
        dataset->SetSpatialRef(&reference);
        dataset->GetRasterBand(1)->SetNoDataValue(0.0);
        for (int row = 0; row < _rows; ++row)
        {
            auto line = std::vector<std::uint8_t>(
                _classes.begin() + static_cast<std::ptrdiff_t>(_rows - 1 - row) * _columns,
                _classes.begin() + static_cast<std::ptrdiff_t>(_rows - row) * _columns);
            isWritten =
                isWritten && dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, row, _columns, 1, line.data(),
                                                                 _columns, 1, GDT_Byte, 0, 0) == CE_None;
        }
    }
    dataset.reset();
    std::error_code failed;
    isWritten = isWritten && !errors.hasFailed();
    if (isWritten) std::filesystem::rename(part, file, failed);
    if (isWritten && !failed) return foundation::success();
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    return foundation::Error{file.string(),
                             "cannot be written: " + (failed ? failed.message() : errors.firstError()),
                             "check that the folder can be written and the disk has room"};
}

} // namespace worldmaking
