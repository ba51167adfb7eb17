// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <system_error>

#include <tiny_gltf.h>

#include <osgPMObjects/core/gltf/GltfImport.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>

#include "GltfScene.h"

namespace osgPMObjects::core
{

namespace
{

using Parse = std::function<bool(tinygltf::TinyGLTF&, tinygltf::Model&, std::string& error)>;

/// The bytes of image files, by the number of the image.
using ImageFiles = std::map<int, std::string>;

/// Accepts all images, and keeps their files: one that cannot be decoded is no reason to refuse the model.
bool loadImage(tinygltf::Image* image, const int number, std::string*, std::string*, int width, int height,
               const unsigned char* bytes, int size, void* files)
{
    std::string ignored, ignoredToo;
    if (tinygltf::LoadImageData(image, number, &ignored, &ignoredToo, width, height, bytes, size, nullptr))
        (*static_cast<ImageFiles*>(files))[number].assign(reinterpret_cast<const char*>(bytes),
                                                          static_cast<std::size_t>(size));
    else
        image->width = image->height = image->component = 0;
    return true;
}

GltfImage imageOf(const tinygltf::Image& from)
{
    const bool isWhole =
        from.bits == 8 && from.width > 0 && from.height > 0 && from.component >= 1 && from.component <= 4 &&
        from.image.size() == static_cast<std::size_t>(from.width) * static_cast<std::size_t>(from.height) *
                                 static_cast<std::size_t>(from.component);
    if (!isWhole) return {};
    return {from.width, from.height, from.component, from.image, {}, {}};
}

void takeImages(const tinygltf::Model& parsed, ImageFiles& files, GltfModel& model)
{
    for (const tinygltf::Image& from : parsed.images)
    {
        GltfImage& image = model.images.emplace_back(imageOf(from));
        image.uri = from.uri;
        image.file = std::move(files[static_cast<int>(model.images.size()) - 1]);
        if (image.channels > 0) continue;
        if (image.uri.empty())
            ++model.report.unreadImages;
        else
            model.report.missingImages.push_back(image.uri);
    }
}

GltfMaterial materialOf(const tinygltf::Model& model, const tinygltf::Material& from)
{
    GltfMaterial material;
    material.name = from.name;
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, pbr.baseColorFactor.size()); ++i)
        material.baseColour[static_cast<int>(i)] = static_cast<float>(pbr.baseColorFactor[i]);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, from.emissiveFactor.size()); ++i)
        material.emission[static_cast<int>(i)] = static_cast<float>(from.emissiveFactor[i]);
    material.roughness = pbr.roughnessFactor;
    const int texture = pbr.baseColorTexture.index;
    if (texture >= 0 && static_cast<std::size_t>(texture) < model.textures.size())
    {
        const int source = model.textures[static_cast<std::size_t>(texture)].source;
        if (source >= 0 && static_cast<std::size_t>(source) < model.images.size()) material.image = source;
        material.texCoordSet = pbr.baseColorTexture.texCoord;
    }
    material.isBlended = from.alphaMode == "BLEND";
    if (from.alphaMode == "MASK") material.alphaCutoff = from.alphaCutoff;
    material.isTwoSided = from.doubleSided;
    return material;
}

bool isFile(const std::string& name, void*)
{
    std::error_code failed;
    return std::filesystem::is_regular_file(name, failed);
}

/// Reads files only: for a folder the parser would request as many bytes as there are numbers.
bool readFile(std::vector<unsigned char>* bytes, std::string* error, const std::string& name, void* data)
{
    if (isFile(name, data)) return tinygltf::ReadWholeFile(bytes, error, name, data);
    *error += name + " is not a file";
    return false;
}

/// Finds no other files for a model from memory, which has no folder.
bool isNone(const std::string&, void*)
{
    return false;
}

enum class OtherFiles
{
    refused,
    read,
};

foundation::Result<GltfModel> readModel(const Parse& parse, const std::string& name, OtherFiles others)
{
    const auto refused = [&](std::string why)
    {
        std::replace(why.begin(), why.end(), '\n', ' ');
        return foundation::Error{name, "cannot be read as glTF 2: " + why, "export the model again as .glb"};
    };
    tinygltf::Model parsed;
    ImageFiles files;
    try
    {
        tinygltf::TinyGLTF loader;
        loader.SetImageLoader(loadImage, &files);
        loader.SetFsCallbacks({others == OtherFiles::read ? isFile : isNone, &tinygltf::ExpandFilePath,
                               readFile, &tinygltf::WriteWholeFile, nullptr});
        std::string error;
        if (!parse(loader, parsed, error)) return refused(error.empty() ? "damaged" : error);
    }
    catch (const std::exception& thrown) // of the parser: from JSON or memory
    {
        return refused(thrown.what());
    }
    GltfModel model;
    takeImages(parsed, files, model);
    for (const tinygltf::Material& material : parsed.materials)
        model.materials.push_back(materialOf(parsed, material));
    model.materials.emplace_back();
    model.report.animations += parsed.animations.size();
    if (const auto read = readGltfScene(parsed, name, model); !read) return read.error();
    if (const std::string defect = defectOf(model.mesh); !defect.empty())
        return foundation::Error{name, defect, "repair the model, or split it"};
    return model;
}

} // namespace

foundation::Result<GltfModel> parseGlb(std::span<const unsigned char> bytes, const std::string& name)
{
    if (bytes.size() > std::numeric_limits<unsigned>::max() / 2)
        return foundation::Error{name, "is larger than 2 GiB", "split the model"};
    return readModel(
        [&](tinygltf::TinyGLTF& loader, tinygltf::Model& model, std::string& error)
        {
            std::string warnings;
            return loader.LoadBinaryFromMemory(&model, &error, &warnings, bytes.data(),
                                               static_cast<unsigned>(bytes.size()));
        },
        name, OtherFiles::refused);
}

foundation::Result<GltfModel> parseGltf(std::span<const unsigned char> bytes, const std::string& name)
{
    if (bytes.size() > std::numeric_limits<unsigned>::max() / 2)
        return foundation::Error{name, "is larger than 2 GiB", "split the model"};
    return readModel(
        [&](tinygltf::TinyGLTF& loader, tinygltf::Model& model, std::string& error)
        {
            std::string warnings;
            return loader.LoadASCIIFromString(&model, &error, &warnings,
                                              reinterpret_cast<const char*>(bytes.data()),
                                              static_cast<unsigned>(bytes.size()), "");
        },
        name, OtherFiles::refused);
}

foundation::Result<GltfModel> readGltf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    char magic[4] = {};
    if (!stream)
        return foundation::Error{file.string(), "cannot be opened", "check its path and permissions"};
    stream.read(magic, sizeof magic);
    const bool isBinary = std::memcmp(magic, "glTF", 4) == 0;
    return readModel(
        [&](tinygltf::TinyGLTF& loader, tinygltf::Model& model, std::string& error)
        {
            std::string warnings;
            return isBinary ? loader.LoadBinaryFromFile(&model, &error, &warnings, file.string())
                            : loader.LoadASCIIFromFile(&model, &error, &warnings, file.string());
        },
        file.string(), OtherFiles::read);
}

} // namespace osgPMObjects::core
