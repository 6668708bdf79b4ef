#include "planner/core/message.h"

#include <array>
#include <cctype>
#include <format>
#include <ostream>
#include <span>
#include <utility>

namespace furrow {

namespace {

struct Unit {
    std::string_view text;  ///< as it stands behind the slot
    MessageUnit unit;
};

// Longer ones first: "m/s" begins with "m".
constexpr std::array kUnits{
    Unit{" m/s²", MessageUnit::MetresPerSecondSquared},
    Unit{" m/s", MessageUnit::MetresPerSecond},
    Unit{" m²", MessageUnit::SquareMetres},
    Unit{" m", MessageUnit::Metres},
    Unit{" ha", MessageUnit::Hectares},
    Unit{" degrees", MessageUnit::Degrees},
    Unit{" %", MessageUnit::Percent},
};

bool isLetter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

Unit unitAt(std::string_view rest) {
    for (const Unit& unit : kUnits) {
        if (rest.starts_with(unit.text) &&
            (rest.size() == unit.text.size() ||
             (!isLetter(rest[unit.text.size()]) && rest[unit.text.size()] != '/'))) {
            return unit;
        }
    }
    return {"", MessageUnit::None};
}

/// A pattern as its plain stretches and slots.
struct Piece {
    std::string plain;
    std::string slot;  ///< "{:.2f}"; empty at the end
    Unit unit{"", MessageUnit::None};
};

std::vector<Piece> piecesOf(std::string_view pattern) {
    std::vector<Piece> pieces(1);
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const char c = pattern[i];
        if ((c == '{' || c == '}') && i + 1 < pattern.size() && pattern[i + 1] == c) {
            pieces.back().plain += c;
            ++i;
        } else if (c == '{') {
            const std::size_t end = pattern.find('}', i);
            pieces.back().slot = pattern.substr(i, end - i + 1);
            pieces.back().unit = unitAt(pattern.substr(end + 1));
            i = end + pieces.back().unit.text.size();
            pieces.emplace_back();
        } else {
            pieces.back().plain += c;
        }
    }
    return pieces;
}

std::string keyOf(const std::vector<Piece>& pieces, bool counted) {
    std::string key;
    int number = counted ? 0 : 1;
    for (const Piece& piece : pieces) {
        key += piece.plain;
        if (!piece.slot.empty()) {
            key += number == 0 ? std::string{"%n"} : std::format("%{}", number);
            // Counts keep what follows them; a unit becomes part of the value.
            if (number == 0) {
                key += piece.unit.text;
            }
            ++number;
        }
    }
    return key;
}

int decimalsOf(std::string_view slot) {
    const std::size_t point = slot.find('.');
    return point == std::string_view::npos ? -1 : slot[point + 1] - '0';
}

std::string english(const MessageArgument& argument, std::string_view slot) {
    if (argument.kind != MessageArgument::Kind::Number) {
        return argument.message.text();
    }
    if (argument.isWhole) {
        // Not by way of an integer: a file may state counts that fit into none.
        return std::format("{:.0f}", argument.number);
    }
    return std::vformat(slot, std::make_format_args(argument.number));
}

std::string capital(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text;
}

}  // namespace

Message::Message() = default;
Message::Message(const char* text) : text_{text} {}
Message::Message(std::string text) : text_{std::move(text)} {}
Message::Message(std::string_view text) : text_{text} {}
Message::Message(const Message&) = default;
Message::Message(Message&&) noexcept = default;
Message& Message::operator=(const Message&) = default;
Message& Message::operator=(Message&&) noexcept = default;
Message::~Message() = default;

// Written out: the default one asks for its own exception specification by way of the arguments, at which
// clang gives up.
bool operator==(const Message& a, const Message& b) {
    return a.text_ == b.text_ && a.key_ == b.key_ && a.pattern_ == b.pattern_ &&
           a.arguments_ == b.arguments_ && a.count_ == b.count_ && a.capitalised_ == b.capitalised_;
}

Message Message::capitalised() const {
    Message result = *this;
    result.key_ = key();
    result.text_ = capital(result.text_);
    result.capitalised_ = true;
    return result;
}

Message madeMessage(std::string_view pattern, std::string_view manyPattern, std::optional<std::int64_t> count,
                    std::vector<MessageArgument> arguments) {
    const std::vector<Piece> pieces = piecesOf(pattern);
    Message made;
    std::size_t next = 0;
    for (const Piece& piece : pieces) {
        made.text_ += piece.plain;
        if (piece.slot.empty() || next >= arguments.size()) {
            continue;
        }
        MessageArgument& argument = arguments[next++];
        argument.unit = piece.unit.unit;
        argument.decimals = decimalsOf(piece.slot);
        made.text_ += english(argument, piece.slot);
        made.text_ += piece.unit.text;
    }
    made.key_ = count ? messageKey(manyPattern, true) : keyOf(pieces, false);
    made.pattern_ = count ? keyOf(pieces, true) : std::string{};
    made.arguments_ = std::move(arguments);
    made.count_ = count;
    return made;
}

std::string messageKey(std::string_view pattern, bool counted) {
    return keyOf(piecesOf(pattern), counted);
}

Message operator+(const Message& a, const Message& b) {
    return message("{}{}", a, b);
}
Message operator+(const std::string& a, const Message& b) {
    return message("{}{}", a, b);
}
Message operator+(const Message& a, const std::string& b) {
    return message("{}{}", a, b);
}
Message operator+(const char* a, const Message& b) {
    return message("{}{}", Message{a}, b);
}
Message operator+(const Message& a, const char* b) {
    return message("{}{}", a, Message{b});
}

std::ostream& operator<<(std::ostream& stream, const Message& message) {
    return stream << message.text();
}

}  // namespace furrow
