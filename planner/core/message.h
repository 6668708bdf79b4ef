#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace furrow {

struct MessageArgument;

/// What a number in a message measures: a window shows it in the units of its user.
enum class MessageUnit {
    None,
    Metres,
    SquareMetres,
    Hectares,
    MetresPerSecond,
    MetresPerSecondSquared,
    Degrees,
    Percent,
};

/// A text for people: complete in English, and still in parts for whoever shows it in another language or in
/// other units. Behaves as the English text wherever a text is wanted. DESIGN 27.
///
/// A plain string is a message too: a sentence of the program's, or words from elsewhere (names, paths), for
/// which no translation is found.
class Message {
public:
    Message();
    Message(const char* text);
    Message(std::string text);
    Message(std::string_view text);
    Message(const Message&);
    Message(Message&&) noexcept;
    Message& operator=(const Message&);
    Message& operator=(Message&&) noexcept;
    ~Message();

    /// In English, in metric units.
    const std::string& text() const { return text_; }
    operator const std::string&() const { return text_; }

    /// What a translation is looked up by: the sentence with %1, %2 ... for its arguments, units included,
    /// and %n for the count of a plural form.
    const std::string& key() const { return key_.empty() ? text_ : key_; }
    const std::vector<MessageArgument>& arguments() const { return arguments_; }
    /// The number that decides the plural form, where there is one.
    std::optional<std::int64_t> count() const { return count_; }
    bool isCapitalised() const { return capitalised_; }
    /// The English sentence with %1 for its arguments; differs from the key only in its plural form.
    const std::string& englishPattern() const { return pattern_.empty() ? key() : pattern_; }

    /// The same at the beginning of a sentence.
    Message capitalised() const;

    bool empty() const { return text_.empty(); }
    const char* c_str() const { return text_.c_str(); }
    bool contains(std::string_view part) const { return text_.contains(part); }
    bool starts_with(std::string_view part) const { return text_.starts_with(part); }
    std::size_t find(std::string_view part) const { return text_.find(part); }
    std::string substr(std::size_t from, std::size_t length) const { return text_.substr(from, length); }

    friend bool operator==(const Message&, const Message&);
    template <class T>
        requires(!std::same_as<T, Message> && std::convertible_to<const T&, std::string_view>)
    friend bool operator==(const Message& message, const T& text) {
        return message.text_ == std::string_view{text};
    }

private:
    friend Message madeMessage(std::string_view, std::string_view, std::optional<std::int64_t>,
                               std::vector<MessageArgument>);

    std::string text_;
    std::string key_;      ///< empty: as the text
    std::string pattern_;  ///< empty: as the key
    std::vector<MessageArgument> arguments_;
    std::optional<std::int64_t> count_;
    bool capitalised_ = false;
};

/// One value in a message: a number, words that stay as they are, or a message that is translated too.
struct MessageArgument {
    enum class Kind { Number, Words, Message };

    template <class T>
        requires std::is_arithmetic_v<T>
    MessageArgument(T value) : isWhole{std::integral<T>}, number{static_cast<double>(value)} {}
    MessageArgument(const char* text) : kind{Kind::Words}, message{text} {}
    MessageArgument(const std::string& text) : kind{Kind::Words}, message{text} {}
    MessageArgument(std::string_view text) : kind{Kind::Words}, message{text} {}
    MessageArgument(Message text) : kind{Kind::Message}, message{std::move(text)} {}

    Kind kind = Kind::Number;
    bool isWhole = false;
    double number = 0.0;
    MessageUnit unit = MessageUnit::None;
    int decimals = -1;  ///< -1: as many as the number has
    Message message;

    friend bool operator==(const MessageArgument&, const MessageArgument&) = default;
};

/// As message() and counted(), for arguments in a list.
Message madeMessage(std::string_view pattern, std::string_view manyPattern, std::optional<std::int64_t> count,
                    std::vector<MessageArgument> arguments);

/// A message from a pattern of std::format with {} and {:.2f}. A unit behind a number belongs to it: "{:.2f}
/// m",
/// "{} m²", "{:.1f} ha", "{:.0f} degrees", "{:.1f} %", "{:.1f} m/s", "{:.1f} m/s²".
template <class... Arguments>
Message message(std::string_view pattern, const Arguments&... arguments) {
    return madeMessage(pattern, {}, std::nullopt, {MessageArgument{arguments}...});
}

/// The same for one and for many of something; the first argument is their number.
template <std::integral Count, class... Arguments>
Message counted(std::string_view onePattern, std::string_view manyPattern, Count count,
                const Arguments&... arguments) {
    return madeMessage(count == 1 ? onePattern : manyPattern, manyPattern, static_cast<std::int64_t>(count),
                       {MessageArgument{count}, MessageArgument{arguments}...});
}

/// How a pattern looks in translations: values numbered from %1, the first as %n in `counted` ones.
std::string messageKey(std::string_view pattern, bool counted);

/// One after the other.
Message operator+(const Message& a, const Message& b);
Message operator+(const std::string& a, const Message& b);
Message operator+(const Message& a, const std::string& b);
Message operator+(const char* a, const Message& b);
Message operator+(const Message& a, const char* b);

std::ostream& operator<<(std::ostream& stream, const Message& message);

}  // namespace furrow
