// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <utility>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <foundation/WholeFile.h>
#include <gdal_priv.h>

#include "roadtool/Pictures.h"
#include "terminal/Guard.h"

namespace roadtool
{

namespace
{

struct CloseDataset
{
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// Returns the image as a dataset in memory.
Dataset datasetOf(const RgbImage& image)
{
    GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
    Dataset dataset(memory ? memory->Create("", image.width, image.height, 3, GDT_Byte, nullptr) : nullptr);
    if (!dataset) return nullptr;
    auto* const pixels = const_cast<std::uint8_t*>(image.pixels.data()); // GDAL only reads it
    const CPLErr written =
        dataset->RasterIO(GF_Write, 0, 0, image.width, image.height, pixels, image.width, image.height,
                          GDT_Byte, 3, nullptr, 3, 3 * image.width, 1, nullptr);
    return written == CE_None ? std::move(dataset) : nullptr;
}

} // namespace

foundation::Outcome writePng(const RgbImage& image, const std::filesystem::path& file)
{
    GDALAllRegister();
    CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", "NO"); // no file beside the image
    CPLPushErrorHandler(CPLQuietErrorHandler);
    foundation::WholeFile whole(file);
    const Dataset dataset = datasetOf(image);
    if (!dataset)
    {
        CPLPopErrorHandler();
        return terminal::outOfMemory(file.string());
    }
    GDALDriver* const png = GetGDALDriverManager()->GetDriverByName("PNG");
    const Dataset copy(
        png ? png->CreateCopy(whole.written().string().c_str(), dataset.get(), 0, nullptr, nullptr, nullptr)
            : nullptr);
    const std::string reason = CPLGetLastErrorMsg();
    CPLPopErrorHandler();
    if (!copy) return whole.failure("cannot be written", reason.empty() ? "GDAL has no PNG driver" : reason);
    return whole.commit();
}

} // namespace roadtool
