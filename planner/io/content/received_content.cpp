#include "planner/io/content/received_content.h"

namespace furrow {

Message badLine(std::size_t number) {
    return message("line {} is not as this format has it", number);
}

Message isNot(std::string_view format) {
    return message("this is no {}", format);
}

Message cannotBeRead() {
    return "its content cannot be read";
}

Message isMissing(std::string_view what) {
    return message("{} is missing", what);
}

Message badCount(std::size_t announced, std::size_t found) {
    return message("{} entries are announced, and {} are there", announced, found);
}

}  // namespace furrow
