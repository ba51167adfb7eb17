// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/HeadingWords.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace simulation
{
namespace
{

/// Words of one meaning, of all languages, without accents; blanks part them.
struct WordMeaning
{
    std::string_view english; ///< one word or two
    std::string_view others;
};

constexpr std::array<WordMeaning, 22> kWordMeanings{
    {{"time", "zeit uhrzeit zeitstempel zeitpunkt temps heure horodatage hora tiempo ora orario tempo tijd "
              "tijdstip tijdstempel horario"},
     {"date", "datum fecha data"},
     {"latitude", "breite breitengrad geobreite latitud latitudine breedte breedtegraad"},
     {"longitude", "lange laenge langengrad laengengrad geolange geolaenge longitud longitudine lengte "
                   "lengtegraad"},
     {"altitude", "altitud altitudine"},
     {"altitude msl", "meereshohe meereshoehe"},
     {"height", "hohe hoehe gpshohe gpshoehe hauteur altura altezza quota hoogte"},
     {"elevation", "elevacion elevazione elevacao"},
     {"pressure height", "druckhohe druckhoehe drukhoogte"},
     {"ellipsoid", "ellipsoidisch ellipsoidische ellipsoide ellissoide elipsoide elipsoidal ellipsoidale"},
     {"msl", "nn nhn meer meeresspiegel mer mar mare zee zeeniveau nap"},
     {"ground", "grund boden sol suelo suolo solo grond"},
     {"pressure", "druck pression presion pressione druk pressao"},
     {"speed", "geschwindigkeit vitesse velocidad velocita snelheid velocidade"},
     {"heading", "kurs richtung cap rumbo rotta prua koers rumo curso"},
     {"rate", "steigrate taux tasa tasso taxa"},
     {"accuracy",
      "genauigkeit precision exactitude exactitud precisione accuratezza nauwkeurigheid precisao"},
     {"error", "fehler erreur errore fout erro"},
     {"feet", "fuss pieds pies piedi voet pes"},
     {"ms", "millisekunden millisecondes milisegundos millisecondi milliseconden"},
     {"us", "mikrosekunden microsecondes microsegundos microsecondi microseconden"},
     {"status", "zustand etat estado stato toestand"}}};

/// The letters of Latin-1 from À on without their accents.
constexpr std::array<std::string_view, 64> kPlainLatin{
    "a", "a", "a", "a", "a", "a", "ae", "c", "e", "e", "e", "e", "i", "i", "i",  "i",
    "d", "n", "o", "o", "o", "o", "o",  "",  "o", "u", "u", "u", "u", "y", "th", "ss",
    "a", "a", "a", "a", "a", "a", "ae", "c", "e", "e", "e", "e", "i", "i", "i",  "i",
    "d", "n", "o", "o", "o", "o", "o",  "",  "o", "u", "u", "u", "u", "y", "th", "y"};

/// A letter of UTF-8 without its accent.
struct PlainLetter
{
    std::string_view plain; ///< empty: no letter
    bool isCapital = false;
    bool isAccent = false; ///< of the letter before it
    std::size_t bytes = 1;
};

PlainLetter letterAt(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i)
    { return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0); };
    const unsigned char first = byte(at), second = byte(at + 1);
    if (first < 0x80)
    {
        if (std::isalpha(first) == 0) return {};
        return {text.substr(at, 1), std::isupper(first) != 0, false, 1};
    }
    if (first == 0xC3 && second >= 0x80 && second < 0xC0)
        return {kPlainLatin[second - 0x80U], second < 0x9F, false, 2};
    if ((first == 0xCC && second >= 0x80) || (first == 0xCD && second >= 0x80 && second < 0xB0))
        return {{}, false, true, 2}; // combining
    return {};
}

/// Empty: it has no English one here.
std::string_view englishOf(std::string_view word)
{
    for (const WordMeaning& meaning : kWordMeanings)
        for (std::size_t at = meaning.others.find(word); at != std::string_view::npos;
             at = meaning.others.find(word, at + 1))
        {
            const std::size_t end = at + word.size();
            const bool begins = at == 0 || meaning.others[at - 1] == ' ';
            if (begins && (end == meaning.others.size() || meaning.others[end] == ' '))
                return meaning.english;
        }
    return {};
}

} // namespace

std::vector<std::string> headingWords(std::string_view name)
{
    std::vector<std::string> words(1);
    bool wasSmall = false;
    for (std::size_t at = 0; at < name.size();)
    {
        const PlainLetter letter = letterAt(name, at);
        at += letter.bytes;
        if (letter.isAccent) continue;
        const bool isLetter = !letter.plain.empty();
        if ((!isLetter || (wasSmall && letter.isCapital)) && !words.back().empty()) words.emplace_back();
        for (const char c : letter.plain)
            words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        wasSmall = isLetter && !letter.isCapital;
    }
    return words;
}

std::vector<std::string> inEnglish(const std::vector<std::string>& words)
{
    std::vector<std::string> english;
    for (const std::string& word : words)
    {
        const std::string_view meant = word.empty() ? std::string_view() : englishOf(word);
        const std::size_t blank = std::min(meant.find(' '), meant.size());
        english.emplace_back(meant.empty() ? std::string_view(word) : meant.substr(0, blank));
        if (blank < meant.size()) english.emplace_back(meant.substr(blank + 1));
    }
    return english;
}

} // namespace simulation
