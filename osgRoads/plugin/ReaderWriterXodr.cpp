// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <optional>
#include <sstream>
#include <string>

#include <osg/Notify>

#include <osgRoads/OpenNetwork>
#include <osgTraversal/NodeReader>

namespace
{

/// osgDB's way to road networks: osgviewer town.xodr shows the surface of its roads with their marks, without
/// ground (for that: trainer tour town.xodr). Options, as words of the option string: "farthest=METRES" and
/// "tolerance=PIXELS", the members of RoadViewSettings.
class ReaderWriterXodr : public osgTraversal::NodeReader
{
public:
    ReaderWriterXodr()
    {
        supportsExtension("xodr", "OpenDRIVE road network");
        supportsOption("farthest=METRES", "draw no road beyond (everywhere)");
        supportsOption("tolerance=PIXELS", "error target of the levels (1)");
    }

    const char* className() const override { return "osgRoads reader"; }

protected:
    ReadResult open(const std::string& file, const Options* options) const override
    {
        const auto settings = settingsOf(options);
        if (!settings) return ReadResult(settings.error().message());
        const auto node = osgRoads::openNetwork(file, *settings);
        if (!node) return ReadResult(node.error().message());
        for (const std::string& note : (*node)->getDescriptions())
            OSG_NOTICE << note << std::endl;
        return ReadResult(node->get(), ReadResult::FILE_LOADED);
    }

private:
    using Settings = osgRoads::core::RoadViewSettings;

    /// Words without one of our names are left to others.
    static foundation::Result<Settings> settingsOf(const Options* options)
    {
        Settings settings = osgRoads::settingsWithoutGround();
        std::istringstream words(options ? options->getOptionString() : std::string());
        for (std::string word; words >> word;)
        {
            const std::size_t equals = word.find('=');
            const std::string name = word.substr(0, equals);
            if (name != "farthest" && name != "tolerance") continue;
            const auto value = numberIn(equals == std::string::npos ? "" : word.substr(equals + 1));
            if (!value)
                return foundation::Error{"option " + word, "holds no number", "write " + name + "=NUMBER"};
            (name == "farthest" ? settings.farthestM : settings.tolerancePx) = *value;
        }
        return settings;
    }

    static std::optional<double> numberIn(const std::string& text)
    {
        double number = 0.0;
        const char* const end = text.data() + text.size();
        const auto [next, failure] = std::from_chars(text.data(), end, number);
        return failure == std::errc() && next == end ? std::optional(number) : std::nullopt;
    }
};

} // namespace

REGISTER_OSGPLUGIN(xodr, ReaderWriterXodr)
