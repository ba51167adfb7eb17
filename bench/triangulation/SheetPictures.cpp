// SPDX-License-Identifier: Apache-2.0
#include "SheetPictures.h"

#include <cstdio>
#include <cstdlib>

#include <osgOffscreen/PngFile>

namespace sheet
{

void endWith(const std::string& message)
{
    std::fprintf(stderr, "%s\n", message.c_str());
    std::exit(1);
}

std::unique_ptr<osgOffscreen::OffscreenViewer> viewerOn(osg::Node* scene, int widthPx, int heightPx)
{
    auto made =
        osgOffscreen::OffscreenViewer::create({.widthPx = widthPx, .heightPx = heightPx, .samples = 4});
    if (!made) endWith(made.error().message());
    (*made)->viewer().setSceneData(scene);
    (*made)->camera().setClearColor({0.82F, 0.87F, 0.92F, 1.0F});
    return std::move(*made);
}

void write(const osg::Image& image, const std::filesystem::path& file,
           std::vector<std::filesystem::path>& files)
{
    files.push_back(file);
    if (!osgOffscreen::writePng(image, file)) endWith(file.string() + " cannot be written");
}

} // namespace sheet
