// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/StreetLamps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include <foundation/Random.h>
#include <glm/glm.hpp>

namespace scenery
{

namespace
{

constexpr double kEveryM = 32.0, kBesideM = 0.9, kArmM = 1.2, kHousesM = 60.0, kFreeM = 0.3;
constexpr int kLeastHouses = 2;
constexpr double kStreetCd = 1800.0;
const glm::vec3 kWarmWhite(1.0F, 0.80F, 0.52F), kSodium(1.0F, 0.56F, 0.18F);

/// Things by squares of the plan, to find those near a place.
template<class Thing>
class Squares
{
public:
    explicit Squares(double sideM) : _sideM(sideM) {}

    void add(const glm::dvec2& place, const Thing& thing) { _squares[squareOf(place)].push_back(thing); }

    /// Calls `use` with all things in the square of a place and those around it.
    template<class Use>
    void near(const glm::dvec2& place, const Use& use) const
    {
        const auto [x, y] = squareOf(place);
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                if (const auto found = _squares.find({x + dx, y + dy}); found != _squares.end())
                    for (const Thing& thing : found->second)
                        use(thing);
    }

private:
    using Square = std::pair<std::int64_t, std::int64_t>;
    Square squareOf(const glm::dvec2& place) const
    {
        return {static_cast<std::int64_t>(std::floor(place.x / _sideM)),
                static_cast<std::int64_t>(std::floor(place.y / _sideM))};
    }

    double _sideM;
    std::map<Square, std::vector<Thing>> _squares;
};

struct PavedPlace
{
    glm::dvec2 place;
    double halfM;
    glm::dvec2 along{1.0, 0.0};
};

/// Calls `use(place, unit vector along, metres from the start)` along a line.
template<class Use>
void walk(const std::vector<glm::dvec2>& line, double firstM, double everyM, const Use& use)
{
    double nextM = firstM, beforeM = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
        const double lengthM = glm::distance(line[i], line[i + 1]);
        if (lengthM < 1e-6) continue;
        const glm::dvec2 along = (line[i + 1] - line[i]) / lengthM;
        for (; nextM <= beforeM + lengthM; nextM += everyM)
            use(line[i] + (nextM - beforeM) * along, along);
        beforeM += lengthM;
    }
}

double heightBeside(double widthM)
{
    return widthM > 8.0 ? 8.0 : 6.0;
}

/// What is known of the streets' places: paved ones, houses, and what the map says of lamps.
class StreetsWithLamps
{
public:
    StreetsWithLamps(std::span<const StreetLine> streets, std::span<const glm::dvec2> houses,
                     const MappedLamps& mapped)
    {
        for (const glm::dvec2& house : houses)
            _built.add(house, house);
        for (const StreetLine& street : streets)
            walk(street.middle, 0.0, kWalkedM,
                 [&](const glm::dvec2& place, const glm::dvec2& along) {
                     _paved.add(place, {place, 0.5 * street.widthM, along});
                 });
        for (const glm::dvec2& post : mapped.posts)
            _posts.add(post, post);
        for (const bool isLit : {true, false})
            for (const auto& line : isLit ? mapped.lit : mapped.unlit)
                walk(line, 0.0, kWalkedM,
                     [&](const glm::dvec2& place, const glm::dvec2&) {
                         _told.add(place, {place, isLit});
                     });
    }

    /// Whether a lamp is to stand at a place beside a street, whose middle is there.
    bool isLit(const glm::dvec2& middle, const glm::dvec2& place) const
    {
        bool isFree = true;
        _posts.near(place, [&](const glm::dvec2& post)
                    { isFree = isFree && glm::distance(post, place) > kMappedRoomM; });
        _paved.near(place, [&](const PavedPlace& other)
                    { isFree = isFree && glm::distance(other.place, place) > other.halfM + kFreeM; });
        return isFree && toldOf(middle).value_or(hasHouses(place));
    }

    /// A lamp of the map, beside the nearest street and towards it.
    StreetLamp mappedLamp(const glm::dvec2& post, std::size_t number) const
    {
        StreetLamp lamp{post};
        lamp.isSodium = foundation::mixedBits(number + 1) % 3 == 0;
        double nearestM = kPavedSquareM;
        _paved.near(post,
                    [&](const PavedPlace& street)
                    {
                        const double awayM = glm::distance(street.place, post);
                        if (awayM >= nearestM) return;
                        nearestM = awayM;
                        const glm::dvec2 left(-street.along.y, street.along.x);
                        const double leftM = glm::dot(post - street.place, left);
                        lamp.towards = leftM > 0.0 ? -left : left;
                        lamp.heightM = heightBeside(2.0 * street.halfM);
                        // Maps set lamps on the line of a street, too.
                        const double outM = std::max(street.halfM + kBesideM - std::abs(leftM), 0.0);
                        lamp.place =
                            post - (std::abs(leftM) < street.halfM + kFreeM ? outM : 0.0) * lamp.towards;
                    });
        return lamp;
    }

private:
    static constexpr double kWalkedM = 3.0, kSameStreetM = 8.0, kMappedRoomM = 48.0, kPavedSquareM = 16.0;

    struct Told
    {
        glm::dvec2 place;
        bool isLit;
    };

    /// What the map says of the street here; nothing: it does not tell.
    std::optional<bool> toldOf(const glm::dvec2& middle) const
    {
        std::optional<bool> told;
        double nearestM = kSameStreetM;
        _told.near(middle,
                   [&](const Told& one)
                   {
                       if (const double awayM = glm::distance(one.place, middle); awayM < nearestM)
                       {
                           nearestM = awayM;
                           told = one.isLit;
                       }
                   });
        return told;
    }

    bool hasHouses(const glm::dvec2& place) const
    {
        int count = 0;
        _built.near(place, [&](const glm::dvec2& house)
                    { count += glm::distance(house, place) < kHousesM ? 1 : 0; });
        return count >= kLeastHouses;
    }

    Squares<glm::dvec2> _built{kHousesM}, _posts{kMappedRoomM};
    Squares<PavedPlace> _paved{kPavedSquareM};
    Squares<Told> _told{kSameStreetM};
};

} // namespace

std::vector<StreetLamp> streetLampsAlong(std::span<const StreetLine> streets,
                                         std::span<const glm::dvec2> houses, const MappedLamps& mapped)
{
    const StreetsWithLamps known(streets, houses, mapped);
    std::vector<StreetLamp> lamps;
    for (std::size_t i = 0; i < mapped.posts.size(); ++i)
        lamps.push_back(known.mappedLamp(mapped.posts[i], i));
    for (std::size_t i = 0; i < streets.size(); ++i)
    {
        const StreetLine& street = streets[i];
        double side = 1.0;
        const bool isSodium = foundation::mixedBits(i + 1) % 3 == 0;
        walk(street.middle, 0.5 * kEveryM, kEveryM,
             [&](const glm::dvec2& middle, const glm::dvec2& along)
             {
                 const glm::dvec2 out = side * glm::dvec2(-along.y, along.x),
                                  place = middle + out * (0.5 * street.widthM + kBesideM);
                 side = -side;
                 if (known.isLit(middle, place))
                     lamps.push_back({place, -out, heightBeside(street.widthM), isSodium});
             });
    }
    return lamps;
}

LightPoint lightOf(const StreetLamp& lamp, double groundM)
{
    LightPoint light;
    light.place = {lamp.place + kArmM * lamp.towards, groundM + lamp.heightM - 0.1};
    light.colour = lamp.isSodium ? kSodium : kWarmWhite;
    light.candela = kStreetCd;
    light.beam = BeamKind::streetLamp;
    light.group = LightGroup::street;
    return light;
}

} // namespace scenery
