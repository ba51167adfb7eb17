// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <system_error>

#include <foundation/WholeText.h>
#include <tiny_gltf.h>

#include <osgPMObjects/core/gltf/GltfImport.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>

#include "GltfExtensions.h"
#include "GltfMeshopt.h"
#include "GltfScene.h"

namespace osgPMObjects::core
{

namespace
{

/// The bytes of image files, by the number of the image.
using ImageFiles = std::map<int, std::string>;

/// Accepts all images, and keeps their files: one that cannot be decoded is no reason to refuse the model.
// NOLINTNEXTLINE(readability-function-size): the parameters are tinygltf's
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

/// Returns the first numbers of an array; `values` where there is none.
template<std::size_t Count>
std::array<double, Count> numbersIn(const tinygltf::Value& object, const char* member,
                                    std::array<double, Count> values)
{
    if (!object.Has(member)) return values;
    const tinygltf::Value& list = object.Get(member);
    for (std::size_t i = 0; i < Count && list.IsArray() && i < list.ArrayLen(); ++i)
        if (list.Get(i).IsNumber()) values[i] = list.Get(i).GetNumberAsDouble();
    return values;
}

/// Reads the transform of a texture. Source: Khronos, *KHR_texture_transform* (2018): offset · rotation ·
/// scale.
void readTransform(const tinygltf::TextureInfo& texture, GltfMaterial& material)
{
    const auto found = texture.extensions.find("KHR_texture_transform");
    if (found == texture.extensions.end() || !found->second.IsObject()) return;
    const tinygltf::Value& extension = found->second;
    const auto offset = numbersIn<2>(extension, "offset", {0.0, 0.0});
    const auto scale = numbersIn<2>(extension, "scale", {1.0, 1.0});
    const auto numberIn = [&](const char* member, double missing)
    {
        return extension.Has(member) && extension.Get(member).IsNumber()
                   ? extension.Get(member).GetNumberAsDouble()
                   : missing;
    };
    const double angle = numberIn("rotation", 0.0), c = std::cos(angle), s = std::sin(angle);
    material.texMatrix =
        glm::dmat3x2(c * scale[0], -s * scale[0], s * scale[1], c * scale[1], offset[0], offset[1]);
    if (numberIn("texCoord", material.texCoordSet) != material.texCoordSet)
        material.texCoordSet = static_cast<int>(std::clamp(numberIn("texCoord", 0.0), 0.0, 9.0));
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
    readTransform(pbr.baseColorTexture, material);
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

bool parse(tinygltf::TinyGLTF& loader, const std::string& bytes, const std::string& folder,
           tinygltf::Model& model, std::string& error)
{
    std::string warnings;
    const auto length = static_cast<unsigned>(bytes.size());
    if (bytes.starts_with("glTF"))
        return loader.LoadBinaryFromMemory(
            &model, &error, &warnings, reinterpret_cast<const unsigned char*>(bytes.data()), length, folder);
    return loader.LoadASCIIFromString(&model, &error, &warnings, bytes.data(), length, folder);
}

/// `folder`: that of the model's other files.
foundation::Result<GltfModel> readModel(std::string bytes, const std::string& name, OtherFiles others,
                                        const std::string& folder)
{
    const auto refused = [&](std::string why)
    {
        std::replace(why.begin(), why.end(), '\n', ' ');
        return foundation::Error{name, "cannot be read as glTF 2: " + why, "export the model again as .glb"};
    };
    GltfModel model;
    tinygltf::Model parsed;
    ImageFiles files;
    try
    {
        if (const auto prepared = prepareExtensions(bytes, name, model.report); !prepared)
            return prepared.error();
        tinygltf::TinyGLTF loader;
        loader.SetImageLoader(loadImage, &files);
        loader.SetFsCallbacks({others == OtherFiles::read ? isFile : isNone, &tinygltf::ExpandFilePath,
                               readFile, &tinygltf::WriteWholeFile, nullptr});
        std::string error;
        if (!parse(loader, bytes, folder, parsed, error)) return refused(error.empty() ? "damaged" : error);
    }
    catch (const std::exception& thrown) // of the parser: from JSON or memory
    {
        return refused(thrown.what());
    }
    bytes = {};
    if (const auto decompressed = decompressViews(parsed, name); !decompressed) return decompressed.error();
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

constexpr std::size_t kMostBytes = std::numeric_limits<unsigned>::max() / 2;

foundation::Result<GltfModel> parseBytes(std::span<const unsigned char> bytes, const std::string& name)
{
    if (bytes.size() > kMostBytes) return foundation::Error{name, "is larger than 2 GiB", "split the model"};
    return readModel({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name, OtherFiles::refused,
                     "");
}

} // namespace

foundation::Result<GltfModel> parseGlb(std::span<const unsigned char> bytes, const std::string& name)
{
    return parseBytes(bytes, name);
}

foundation::Result<GltfModel> parseGltf(std::span<const unsigned char> bytes, const std::string& name)
{
    return parseBytes(bytes, name);
}

foundation::Result<GltfModel> readGltf(const std::filesystem::path& file)
{
    auto bytes = foundation::readWholeText(file, kMostBytes);
    if (!bytes) return bytes.error();
    return readModel(*std::move(bytes), file.string(), OtherFiles::read, file.parent_path().string());
}

} // namespace osgPMObjects::core
