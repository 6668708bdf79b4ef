#include "tests/support/test_program.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

namespace furrow {

namespace {

std::map<std::string, TestInProgram::Run>& tests() {
    static std::map<std::string, TestInProgram::Run> all;
    return all;
}

}  // namespace

TestInProgram::TestInProgram(std::string_view sourceFile, Run run) {
    tests().emplace(std::filesystem::path{sourceFile}.stem().string(), run);
}

}  // namespace furrow

int main(int argc, char** argv) {
    const std::string name = std::filesystem::path{argv[0]}.filename().string();
    const auto found = furrow::tests().find(name);
    if (found != furrow::tests().end()) {
        return found->second(argc, argv);
    }
    std::fprintf(stderr, "%s: there is no such test in this program. Call it by the link of one of these:\n",
                 name.c_str());
    for (const auto& [each, run] : furrow::tests()) {
        std::fprintf(stderr, "  %s\n", each.c_str());
    }
    return 2;
}
