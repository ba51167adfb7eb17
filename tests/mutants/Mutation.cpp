// SPDX-License-Identifier: Apache-2.0
#include "Mutation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <random>
#include <vector>

namespace
{

/// A piece of the bytes.
struct Piece
{
    std::size_t at = 0, size = 0;
};

class Mutator
{
public:
    Mutator(std::string bytes, std::uint32_t seed) : _bytes(std::move(bytes)), _random(seed), _kind(seed % 7)
    {
    }

    std::string run()
    {
        if (_bytes.empty()) return _bytes;
        for (std::size_t n = 1 + below(4); n > 0 && !_bytes.empty(); --n)
            change();
        return _bytes;
    }

private:
    std::size_t below(std::size_t count) { return _random() % std::max<std::size_t>(count, 1); }

    bool isText() const { return _bytes.find('\0') == std::string::npos; }

    void change()
    {
        switch (_kind)
        {
        case 0:
            for (std::size_t n = 1 + below(8); n > 0; --n)
                _bytes[below(_bytes.size())] ^= static_cast<char>(1 << below(8));
            return;
        case 1:
            _bytes.resize(below(_bytes.size()));
            return;
        case 2:
            _bytes.erase(below(_bytes.size()), below(1 + _bytes.size() / 4));
            return;
        case 3:
            return repeatPiece();
        case 4:
            return exchange();
        default:
            return isText() ? extremeNumber() : extremeWord();
        }
    }

    void repeatPiece()
    {
        const std::size_t at = below(_bytes.size());
        const std::string piece = _bytes.substr(at, below(1 + _bytes.size() / 4));
        _bytes.insert(at, piece);
    }

    /// Returns the numbers of a text, or words of four bytes.
    std::vector<Piece> numbers() const
    {
        std::vector<Piece> all;
        if (!isText())
        {
            for (std::size_t at = 0; at + 4 <= _bytes.size(); at += 4)
                all.push_back({at, 4});
            return all;
        }
        const auto isOfNumber = [](char c)
        { return std::isdigit(static_cast<unsigned char>(c)) || c == '.'; };
        for (std::size_t at = 0; at < _bytes.size(); ++at)
        {
            Piece piece{at, 0};
            while (at < _bytes.size() && isOfNumber(_bytes[at]))
                ++at;
            piece.size = at - piece.at;
            if (piece.size > 0) all.push_back(piece);
        }
        return all;
    }

    void exchange()
    {
        const std::vector<Piece> all = numbers();
        if (all.size() < 2) return;
        Piece a = all[below(all.size())], b = all[below(all.size())];
        if (a.at == b.at) return;
        if (a.at > b.at) std::swap(a, b);
        const std::string first = _bytes.substr(a.at, a.size), second = _bytes.substr(b.at, b.size);
        _bytes.replace(b.at, b.size, first);
        _bytes.replace(a.at, a.size, second);
    }

    void extremeNumber()
    {
        constexpr std::array<const char*, 12> kExtremes = {
            "0",    "-1",  "1e38", "-1e38",      "nan",         "inf",
            "1e-9", "1e9", "2e5",  "2147483647", "99999999999", "18446744073709551615"};
        const std::vector<Piece> all = numbers();
        if (all.empty()) return;
        const Piece piece = all[below(all.size())];
        _bytes.replace(piece.at, piece.size, kExtremes[below(kExtremes.size())]);
    }

    void extremeWord()
    {
        constexpr std::array<std::uint32_t, 9> kExtremes = {
            0,          0xffffffff, 0x7fffffff, 0x80000000, 0x10000000,
            0x00100000, 0x7e000000, 0x7f800000, 0x49742400}; // the last ones as floats: 4e37, infinity, 10⁶
        if (_bytes.size() < 4) return;
        const std::size_t step = below(2) == 0 ? 1 : 4; // texts inside, and what is not aligned
        const std::size_t at = below((_bytes.size() - 4) / step + 1) * step;
        const std::uint32_t word = kExtremes[below(kExtremes.size())];
        std::memcpy(_bytes.data() + at, &word, sizeof word);
    }

    std::string _bytes;
    std::mt19937 _random;
    std::uint32_t _kind;
};

} // namespace

std::string mutated(const std::string& bytes, std::uint32_t seed)
{
    return Mutator(bytes, seed).run();
}
