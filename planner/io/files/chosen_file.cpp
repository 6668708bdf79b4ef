#include "planner/io/files/chosen_file.h"

#include "planner/core/text.h"
#include "planner/core/text_file.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;

std::string rootOfXml(std::string_view text) {
    std::size_t at = 0;
    while ((at = text.find('<', at)) != std::string_view::npos && at + 1 < text.size()) {
        if (text.substr(at).starts_with("<!--")) {
            at = text.find("-->", at);
            if (at == std::string_view::npos) {
                return {};
            }
        } else if (text[at + 1] == '?' || text[at + 1] == '!') {
            ++at;
        } else {
            const std::size_t end = text.find_first_of(" \t\r\n/>", at + 1);
            return std::string{text.substr(at + 1, end == std::string_view::npos ? end : end - at - 1)};
        }
    }
    return {};
}

}  // namespace

ChosenFile::ChosenFile(fs::path path, std::size_t startBytes, int depth)
    : path_{std::move(path)}, depth_{depth}, start_{fileStart(path_, startBytes)} {
    std::error_code failed;
    isDirectory_ = fs::is_directory(path_, failed);
}

std::string ChosenFile::name() const {
    return inSmallLetters(path_.filename().string());
}

bool ChosenFile::isFolder() const {
    return isDirectory_ && extensionInSmallLetters(path_) != ".gdb";
}

bool ChosenFile::isZip() const {
    return start_ && furrow::isZip(*start_);
}

bool ChosenFile::holdsFiles() const {
    return isFolder() || (isZip() && extensionInSmallLetters(path_) != ".kmz");
}

std::string_view ChosenFile::text() const {
    return start_ ? withoutByteOrderMark(*start_) : std::string_view{};
}

bool ChosenFile::isXml() const {
    return trimmed(text()).starts_with('<');
}

std::string ChosenFile::xmlRoot() const {
    return isXml() ? rootOfXml(text()) : std::string{};
}

bool ChosenFile::isPlainText() const {
    return start_ && !isXml() && std::ranges::none_of(text(), [](char letter) {
               return static_cast<unsigned char>(letter) < 0x20 && letter != '\t' && letter != '\r' &&
                      letter != '\n';
           });
}

const Result<FileFolder>& ChosenFile::inside() const {
    if (!inside_) {
        inside_ = FileFolder::open(path_, depth_);
    }
    return *inside_;
}

const Result<FileFolder>& ChosenFile::beside() const {
    if (!beside_) {
        beside_ = FileFolder::open(folderAround(), 0);
    }
    return *beside_;
}

fs::path ChosenFile::folderAround() const {
    return fs::absolute(path_).parent_path();
}

}  // namespace furrow
