// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/things/SignCodes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#include <foundation/SmallLetters.h>

#include <osgRoads/core/query/PaintedItem.h>

namespace scenery::roads
{

namespace
{

using models::RoadModel;
using models::SignFace;
using Shape = RoadModel::Shape;

struct SignCode
{
    std::string_view code;
    SignFace face;
    Shape shape;
};

constexpr std::array kGerman{SignCode{"101", SignFace::danger, Shape::triangle},
                             SignCode{"102", SignFace::crossroads, Shape::triangle},
                             SignCode{"103", SignFace::bendRight, Shape::triangle},
                             SignCode{"103-10", SignFace::bendLeft, Shape::triangle},
                             SignCode{"114", SignFace::slippery, Shape::triangle},
                             SignCode{"120", SignFace::narrow, Shape::triangle},
                             SignCode{"123", SignFace::roadWorks, Shape::triangle},
                             SignCode{"131", SignFace::lights, Shape::triangle},
                             SignCode{"133", SignFace::pedestrians, Shape::triangle},
                             SignCode{"205", SignFace::giveWay, Shape::triangleDown},
                             SignCode{"206", SignFace::stop, Shape::octagon},
                             SignCode{"209", SignFace::right, Shape::round},
                             SignCode{"209-10", SignFace::left, Shape::round},
                             SignCode{"209-30", SignFace::ahead, Shape::round},
                             SignCode{"215", SignFace::roundabout, Shape::round},
                             SignCode{"222", SignFace::keepRight, Shape::round},
                             SignCode{"250", SignFace::noVehicles, Shape::round},
                             SignCode{"267", SignFace::noEntry, Shape::round},
                             SignCode{"274", SignFace::limit, Shape::round},
                             SignCode{"275", SignFace::least, Shape::round},
                             SignCode{"276", SignFace::noOvertaking, Shape::round},
                             SignCode{"280", SignFace::overtakingEnd, Shape::round},
                             SignCode{"282", SignFace::allEnd, Shape::round},
                             SignCode{"306", SignFace::priority, Shape::diamond},
                             SignCode{"307", SignFace::priorityEnd, Shape::diamond},
                             SignCode{"314", SignFace::parking, Shape::square},
                             SignCode{"330", SignFace::motorway, Shape::square},
                             SignCode{"350", SignFace::crossing, Shape::square}};

constexpr std::array kSwedish{SignCode{"a20", SignFace::roadWorks, Shape::triangle},
                              SignCode{"a40", SignFace::danger, Shape::triangle},
                              SignCode{"b1", SignFace::giveWay, Shape::triangleDown},
                              SignCode{"b2", SignFace::stop, Shape::octagon},
                              SignCode{"b3", SignFace::crossing, Shape::square},
                              SignCode{"b4", SignFace::priority, Shape::diamond},
                              SignCode{"b5", SignFace::priorityEnd, Shape::diamond},
                              SignCode{"c1", SignFace::noEntry, Shape::round},
                              SignCode{"c2", SignFace::noVehicles, Shape::round},
                              SignCode{"c27", SignFace::noOvertaking, Shape::round},
                              SignCode{"c28", SignFace::overtakingEnd, Shape::round},
                              SignCode{"c31", SignFace::limit, Shape::round},
                              SignCode{"e1", SignFace::motorway, Shape::square},
                              SignCode{"e19", SignFace::parking, Shape::square}};

constexpr std::array kChinese{SignCode{"jin", SignFace::limit, Shape::round},
                              SignCode{"shi", SignFace::least, Shape::round}};

const SignCode* find(std::span<const SignCode> codes, const std::string& code)
{
    const auto found =
        std::find_if(codes.begin(), codes.end(), [&](const SignCode& c) { return c.code == code; });
    return found == codes.end() ? nullptr : &*found;
}

const SignCode* codeOf(const osgRoads::core::Signal& signal)
{
    const std::string country = foundation::inSmallLetters(signal.country),
                      type = foundation::inSmallLetters(signal.type);
    if (country == "se" || country == "swe") return find(kSwedish, type + signal.subtype);
    if (country == "cn" || country == "chn") return find(kChinese, type);
    // A file without a code may have it in the name, as "de_274-50".
    const std::string number =
        type.empty() && signal.name.starts_with("de_") ? signal.name.substr(3, 3) : type;
    const SignCode* exact = find(kGerman, number + "-" + signal.subtype);
    return exact ? exact : find(kGerman, number);
}

/// Returns the speed in the units of the sign: from the value, else from subtype 55 as "50" (Germany:
/// 274-55), else from the name.
int speedOf(const osgRoads::core::Signal& signal)
{
    const double value = signal.value.value_or(0.0);
    if (value > 0.0)
    {
        const bool isTens = foundation::inSmallLetters(signal.country) == "se" &&
                            value <= 12.0; // esmini numbers Sweden's C31 by tens
        return static_cast<int>(std::lround(isTens ? 10.0 * value : value));
    }
    const int subtype = std::atoi(signal.subtype.c_str());
    if (signal.country != "se" && subtype >= 51 && subtype <= 63)
        return 10 * (subtype - 50); // StVO numbers 274-51 (10 km/h) to 274-63 (130)
    const std::size_t dash = signal.name.rfind('-');
    return dash == std::string::npos ? 0 : std::max(0, std::atoi(signal.name.c_str() + dash + 1));
}

/// Returns a text as the atlas of signs has letters: capitals of Latin-1; "\\n" of the file parts lines.
/// Others than Latin letters are blank.
std::string lettersOf(const std::string& utf8)
{
    std::string letters;
    for (std::size_t i = 0; i < utf8.size(); ++i)
    {
        const auto byte = static_cast<unsigned char>(utf8[i]);
        if (utf8.compare(i, 2, "\\n") == 0)
        {
            letters += '\n';
            ++i;
        }
        else if (byte < 0x80)
            letters += static_cast<char>(std::toupper(byte));
        else if ((byte == 0xC2 || byte == 0xC3) && i + 1 < utf8.size())
        {
            const auto latin = static_cast<unsigned char>(((byte & 3U) << 6U) | (utf8[++i] & 0x3F));
            const bool isSmall = latin >= 0xE0 && latin != 0xF7;
            letters += static_cast<char>(isSmall ? latin - 0x20 : latin);
        }
        else if (byte >= 0xC0)
            letters += ' '; // its further bytes are passed over
    }
    return letters;
}

/// Places and directions of the StVO, its additional signs, and any other that has a text but no face.
std::optional<RoadModel> boardOf(const osgRoads::core::Signal& signal)
{
    const bool isPlace = signal.type == "310" || signal.type == "311";
    if (!isPlace && signal.text.empty()) return {};
    RoadModel model;
    model.kind = RoadModel::Kind::board;
    model.text = lettersOf(signal.text.empty() ? signal.name : signal.text);
    model.isWhite = !isPlace;
    return model;
}

/// The arrow of a light of type 1000010 to 1000012 by its subtype.
RoadModel::Arrow arrowOf(const osgRoads::core::Signal& signal)
{
    using Arrow = RoadModel::Arrow;
    if (signal.type != "1000010" && signal.type != "1000011" && signal.type != "1000012") return Arrow::none;
    switch (std::abs(std::atoi(signal.subtype.c_str())))
    {
    case 10:
        return Arrow::left;
    case 20:
        return Arrow::right;
    case 30:
        return Arrow::ahead;
    case 40:
        return Arrow::leftAhead;
    case 50:
        return Arrow::rightAhead;
    default:
        return Arrow::none;
    }
}

} // namespace

std::optional<models::RoadModel> signModel(const osgRoads::core::Signal& signal)
{
    RoadModel model;
    if (osgRoads::core::paintKind(signal)) return {};
    // 1000009 to 1000012 are lights with fewer lamps or with arrows in them; netconvert writes 1000011 for
    // all lights.
    constexpr std::array kLights{"1000001", "1000002", "1000009", "1000010", "1000011", "1000012"};
    if (std::find(kLights.begin(), kLights.end(), signal.type) != kLights.end())
    {
        model.kind =
            signal.type == "1000002" ? RoadModel::Kind::pedestrianLight : RoadModel::Kind::trafficLight;
        model.arrow = arrowOf(signal);
        return model;
    }
    const SignCode* code = codeOf(signal);
    if (!code) return boardOf(signal);
    model.kind = RoadModel::Kind::sign;
    model.face = code->face;
    model.shape = code->shape;
    if (code->face == SignFace::limit || code->face == SignFace::least) model.number = speedOf(signal);
    return model;
}

} // namespace scenery::roads
