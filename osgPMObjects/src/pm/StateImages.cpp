// SPDX-License-Identifier: Apache-2.0
#include "StateImages.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include <osg/ImageStream>
#include <osg/Texture>

#include "ImageFiles.h"

namespace osgPMObjects
{

namespace
{

using States = std::vector<osg::ref_ptr<osg::StateSet>>;

constexpr const char* kTexelName = "pm-image-";

/// Calls visit(state, unit, texture, override) for every texture of states.
template<class Visit>
void forEachTexture(const States& states, const Visit& visit)
{
    for (const osg::ref_ptr<osg::StateSet>& state : states)
        for (unsigned unit = 0; state && unit < state->getTextureAttributeList().size(); ++unit)
        {
            const osg::StateSet::AttributeList attributes = state->getTextureAttributeList()[unit];
            for (const auto& [key, attribute] : attributes)
                if (auto* const texture = dynamic_cast<osg::Texture*>(attribute.first.get()))
                    visit(*state, unit, *texture, attribute.second);
        }
}

/// Makes an image of one opaque texel: the mean of the colours that are seen.
osg::ref_ptr<osg::Image> texelFor(const osg::Image& image, std::size_t number)
{
    constexpr int kMostSamples = 128; // along each side
    osg::Vec4d sum;
    for (int i = 0; i < std::min(image.t(), kMostSamples); ++i)
        for (int j = 0; j < std::min(image.s(), kMostSamples); ++j)
        {
            const int s = j * image.s() / std::min(image.s(), kMostSamples);
            const int t = i * image.t() / std::min(image.t(), kMostSamples);
            const osg::Vec4d colour = image.getColor(static_cast<unsigned>(s), static_cast<unsigned>(t));
            sum += osg::Vec4d(colour.x() * colour.w(), colour.y() * colour.w(), colour.z() * colour.w(),
                              colour.w());
        }
    const osg::ref_ptr<osg::Image> texel = new osg::Image;
    texel->allocateImage(1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int c = 0; c < 3; ++c)
        texel->data()[c] = static_cast<unsigned char>(
            sum.w() > 0.0 ? std::clamp(255.0 * sum[c] / sum.w() + 0.5, 0.0, 255.0) : 255.0);
    texel->data()[3] = 255;
    texel->setFileName(kTexelName + std::to_string(number));
    return texel;
}

std::optional<std::size_t> numberOf(const osg::Image& texel)
{
    const std::string& name = texel.getFileName();
    const std::size_t prefix = std::char_traits<char>::length(kTexelName);
    std::size_t number = 0;
    if (!name.starts_with(kTexelName)) return {};
    const auto read = std::from_chars(name.data() + prefix, name.data() + name.size(), number);
    return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

/// The images that textures show, each once, with the file of each.
class ImageTable
{
public:
    ImageTable(const States& states, const std::filesystem::path& folder)
    {
        std::set<const osg::Image*> known;
        forEachTexture(states,
                       [&](osg::StateSet&, unsigned, osg::Texture& texture, auto)
                       {
                           for (unsigned face = 0; face < texture.getNumImages(); ++face)
                               if (const osg::Image* image = texture.getImage(face); image && image->data())
                                   if (known.insert(image).second) add(*image, folder);
                       });
        std::stable_sort(_files.begin(), _files.end(),
                         [](const Entry& a, const Entry& b)
                         { return a.file.bytes.size() < b.file.bytes.size(); });
        for (std::size_t i = 0; i < _files.size(); ++i)
            _texels[_files[i].image] = texelFor(*_files[i].image, i);
    }

    /// Returns the texel that stands for an image; nothing for one that stays.
    osg::Image* texelOf(const osg::Image* image) const
    {
        const auto found = _texels.find(image);
        return found == _texels.end() ? nullptr : found->second.get();
    }

    std::vector<core::PmImage> files() const
    {
        std::vector<core::PmImage> files;
        for (const Entry& entry : _files)
            files.push_back(entry.file);
        return files;
    }

private:
    struct Entry
    {
        const osg::Image* image;
        core::PmImage file;
    };

    void add(const osg::Image& image, const std::filesystem::path& folder)
    {
        if (dynamic_cast<const osg::ImageStream*>(&image)) return;
        core::PmImage file = asImageFile(image, folder);
        if (!file.bytes.empty()) _files.push_back({&image, std::move(file)});
    }

    std::vector<Entry> _files;
    std::map<const osg::Image*, osg::ref_ptr<osg::Image>> _texels;
};

} // namespace

SeparatedStates separated(const States& states, const std::filesystem::path& folder)
{
    const ImageTable table(states, folder);
    SeparatedStates result{{}, table.files()};
    for (const osg::ref_ptr<osg::StateSet>& state : states)
        result.states.push_back(state ? new osg::StateSet(*state) : nullptr);
    std::map<const osg::Texture*, osg::ref_ptr<osg::Texture>> copies;
    forEachTexture(result.states,
                   [&](osg::StateSet& state, unsigned unit, osg::Texture& texture, auto value)
                   {
                       osg::ref_ptr<osg::Texture>& copy = copies[&texture];
                       if (!copy) copy = osg::clone(&texture);
                       for (unsigned face = 0; face < texture.getNumImages(); ++face)
                           if (osg::Image* const texel = table.texelOf(texture.getImage(face)))
                               copy->setImage(face, texel);
                       state.setTextureAttribute(unit, copy, value);
                   });
    return result;
}

std::size_t putBack(const std::vector<core::PmImage>& images, const States& states)
{
    std::map<std::size_t, osg::ref_ptr<osg::Image>> decodedImages;
    std::set<std::size_t> missing;
    forEachTexture(states,
                   [&](osg::StateSet&, unsigned, osg::Texture& texture, auto)
                   {
                       for (unsigned face = 0; face < texture.getNumImages(); ++face)
                       {
                           const osg::Image* const texel = texture.getImage(face);
                           const auto number = texel ? numberOf(*texel) : std::nullopt;
                           if (!number) continue;
                           if (*number < images.size() && !decodedImages.contains(*number))
                               decodedImages[*number] = decoded(images[*number]);
                           if (osg::Image* const image = decodedImages[*number].get())
                               texture.setImage(face, image);
                           else
                               missing.insert(*number);
                       }
                   });
    return missing.size();
}

} // namespace osgPMObjects
