// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <cmath>

#include "simulation/environment/DateTime.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackBuilder.h"
#include "simulation/track/TrackTimes.h"

namespace simulation
{
namespace
{

constexpr std::size_t kFixLength = 35;

/// A whole number of so many digits, the first of which may be a minus.
std::optional<int> digits(std::string_view text)
{
    const bool isNegative = !text.empty() && text.front() == '-';
    int value = 0;
    for (const char c : isNegative ? text.substr(1) : text)
    {
        if (c < '0' || c > '9') return std::nullopt;
        value = 10 * value + (c - '0');
    }
    return isNegative ? -value : value;
}

/// DDMMmmm and its hemisphere: degrees, minutes and thousandths of them.
std::optional<double> degrees(std::string_view text, std::size_t places, char positive, char negative)
{
    const auto whole = digits(text.substr(0, places));
    const auto minutes = digits(text.substr(places, 5));
    const char side = text.back();
    if (!whole || !minutes || *whole < 0 || *minutes < 0 || *minutes >= 60000 ||
        (side != positive && side != negative))
        return std::nullopt;
    const double angle = *whole + *minutes / 60000.0;
    return side == negative ? -angle : angle;
}

struct Fix
{
    TrackFix fix;
    double pressureM = 0.0, satelliteM = 0.0;
    bool hasSatelliteHeight = false;
};

class IgcReader
{
public:
    explicit IgcReader(const std::string& name) : _builder(name), _name(name) {}

    foundation::Result<TrackReading> run(const foundation::Utf8Text& read, std::string_view text)
    {
        _builder.note(read);
        text = read.in(text);
        for (int line = 1; !text.empty(); ++line)
        {
            const std::string_view record = takeLine(text);
            if (record.starts_with('B'))
                fix(record, line);
            else if (record.starts_with('H'))
                header(record, line);
        }
        build();
        return _builder.finish();
    }

private:
    void header(std::string_view record, int line)
    {
        if (record.substr(1).starts_with("FDTE")) date(record, line);
        if (record.find("ALG") == 2 && record.find(":GEO") != std::string_view::npos) _isGeoid = true;
        if (record.find("DTM") == 2 && record.find("84") == std::string_view::npos)
            _builder.note(line, "a datum other than WGS84 is taken as WGS84");
    }

    /// HFDTE and HFDTEDATE: with or without a colon.
    void date(std::string_view record, int line)
    {
        const std::size_t at = record.find_first_of("0123456789");
        const std::string_view text = at == std::string_view::npos ? "" : record.substr(at, 6);
        const auto day = digits(text.substr(0, std::min<std::size_t>(2, text.size())));
        if (text.size() == 6 && day)
        {
            const std::string century = text.substr(4) < "70" ? "20" : "19";
            const auto read = parseDateTime(century + std::string(text.substr(4, 2)) + "-" +
                                            std::string(text.substr(2, 2)) + "-" +
                                            std::string(text.substr(0, 2)) + "T00:00:00Z");
            if (read)
            {
                const double dayS = static_cast<double>(read->unixMilliseconds) / 1000.0;
                if (_fixes.empty())
                    _dayS = dayS;
                else
                    _laterDays.push_back({_fixes.size(), dayS - _dayS});
                return;
            }
        }
        _builder.problem(line, "the date is none");
    }

    void fix(std::string_view record, int line)
    {
        if (record.size() < kFixLength)
        {
            _builder.problem(line,
                             "a B record of " + std::to_string(record.size()) + " characters, but it has 35");
            return;
        }
        const auto hours = digits(record.substr(1, 2)), minutes = digits(record.substr(3, 2)),
                   seconds = digits(record.substr(5, 2));
        const auto latitude = degrees(record.substr(7, 8), 2, 'N', 'S');
        const auto longitude = degrees(record.substr(15, 9), 3, 'E', 'W');
        const auto pressure = digits(record.substr(25, 5)), satellite = digits(record.substr(30, 5));
        const char validity = record[24];
        const char* wrong = !hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || *seconds > 59
                                ? "time"
                            : !latitude || !longitude            ? "position"
                            : validity != 'A' && validity != 'V' ? "validity"
                            : !pressure || !satellite            ? "height"
                                                                 : nullptr;
        if (wrong)
        {
            _builder.problem(line, std::string("a B record whose ") + wrong + " cannot be read");
            return;
        }
        const double timeS = *hours * 3600.0 + *minutes * 60.0 + *seconds;
        _fixes.push_back({{timeS, *latitude, *longitude, {}, line},
                          static_cast<double>(*pressure),
                          static_cast<double>(*satellite),
                          validity == 'A' && *satellite != 0});
    }

    void build()
    {
        std::size_t withHeight = 0;
        for (const Fix& fix : _fixes)
            withHeight += fix.hasSatelliteHeight ? 1 : 0;
        const bool bySatellite = 2 * withHeight > _fixes.size();
        FlightTrack& track = _builder.begin(_name, !bySatellite ? HeightDatum::pressure
                                                   : _isGeoid   ? HeightDatum::meanSeaLevel
                                                                : HeightDatum::ellipsoid);
        track.kind = TrackKind::aircraft;
        double above = 0.0; // of the satellites' height over the pressure's
        for (const Fix& fix : _fixes)
            if (fix.hasSatelliteHeight)
            {
                above = fix.satelliteM - fix.pressureM;
                break;
            }
        std::vector<TrackFix> fixes;
        for (Fix& fix : _fixes)
        {
            if (fix.hasSatelliteHeight) above = fix.satelliteM - fix.pressureM;
            fix.fix.heightM = bySatellite ? fix.pressureM + above : fix.pressureM;
            fixes.push_back(fix.fix);
        }
        addDays(fixes);
        takeLaterDays(fixes);
        for (TrackFix& fix : fixes)
        {
            fix.timeS += _dayS;
            _builder.add(track, fix);
        }
    }

    /// Puts the fixes behind a later date on its day, where their times alone do not tell it. A date that
    /// stands a little before midnight is that of the fixes after midnight.
    void takeLaterDays(std::vector<TrackFix>& fixes) const
    {
        constexpr double kDayLengthS = 86400.0, kMostDaysS = 30.0 * kDayLengthS, kLittleS = 3600.0;
        for (const LaterDay& day : _laterDays)
        {
            if (day.first >= fixes.size()) continue;
            const double timeS = fixes[day.first].timeS, beforeS = fixes[day.first - 1].timeS;
            const double moreS = day.fromFirstS - kDayLengthS * std::floor(timeS / kDayLengthS);
            const bool goesOn = timeS >= beforeS && timeS - beforeS < kLittleS && moreS <= kDayLengthS;
            if (moreS <= 0.0 || moreS > kMostDaysS || goesOn) continue;
            for (std::size_t i = day.first; i < fixes.size(); ++i)
                fixes[i].timeS += moreS;
        }
    }

    /// A date among the fixes.
    struct LaterDay
    {
        std::size_t first = 0;   ///< fix behind it
        double fromFirstS = 0.0; ///< from the first date to this one
    };

    TrackBuilder _builder;
    std::string _name;
    std::vector<Fix> _fixes;
    std::vector<LaterDay> _laterDays;
    double _dayS = 0.0;
    bool _isGeoid = false;
};

} // namespace

foundation::Result<TrackReading> parseIgc(std::string_view text, const std::string& name)
{
    const auto read = foundation::Utf8Text::of(text, {}, name);
    if (!read) return read.error();
    return IgcReader(name).run(*read, text);
}

} // namespace simulation
